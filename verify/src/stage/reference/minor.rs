//! Minors of a metric by elimination: squares of volumes.

use regge_curvature::linalg::Mat;
use regge_curvature::scalar::Field;

/// The determinant of the first k rows and columns, by elimination.
pub fn leading_minor<F: Field, const N: usize>(g: &Mat<F, N>, k: usize) -> F {
    let (mut a, mut product) = (*g, F::one());
    for p in 0..k {
        let pivot = a[(p, p)];
        product *= pivot;
        for i in p + 1..k {
            let factor = a[(i, p)] / pivot;
            for j in p..k {
                let x = a[(p, j)];
                a[(i, j)] -= factor * x;
            }
        }
    }
    product
}
