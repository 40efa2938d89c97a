//! How much memory a case takes.

use crate::case::Case;
use crate::case_mesh::NORM;
use crate::study::Study;
use regge_curvature::norm::{Census, Kind};
use regge_curvature::simplex::binomial;

impl Study {
    /// The memory in bytes that a case takes at its height: 20 to 30 % more than was measured for N = 3, k = 5 (275 and
    /// 889 MiB for r = 0 and 2), 5 % more for N = 2, k = 7, r = 2 (747 MiB).
    ///
    /// By its terms: the mesh with all incidences; g_h with the local projections, or the functional's sums; the norm with
    /// its solver, which the library estimates.
    pub fn memory(&self, case: Case) -> f64 {
        let n = self.dimension;
        let census = Census::cube(n, 1 << case.level);
        // Counts have no dimension in their types, and neither has the estimate.
        let kind = Kind::<2>::named(NORM).expect("the norm of the tables is the library's first");
        let degree = (kind.degree)(case.degree);
        let cells = census.simplices[n] as f64;
        let mesh = cells * if n == 2 { 300.0 } else { 500.0 };
        let (edges, coefficients) = (binomial(n + 1, 2), binomial(case.degree + n, n));
        let regge = cells * (edges * coefficients) as f64 * 8.0 * 2.0;
        let test_functions: usize = (0..=n)
            .map(|k| census.simplices[k] * binomial(degree - 1, k))
            .sum();
        let sums = 32.0 * test_functions as f64;
        mesh + regge.max(sums) + (kind.memory)(&census, degree) + 2e7
    }
}
