//! The same bits for any number of threads.
#![cfg(feature = "parallel")]

use crate::common::{crooked_cube, random_regge};
use regge_curvature::functional::{Rules, Sums, a_h, b_h, distributional_curvature};
use regge_curvature::spaces::{Lagrange, ReggeSpace};

fn with_threads(threads: usize) -> [Sums<f64>; 3] {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("a pool");
    pool.install(|| {
        let mesh = crooked_cube::<3>(3, 1);
        let space = ReggeSpace::new(&mesh, 1);
        let (g, sigma) = (random_regge(&space, 0.1, 1), random_regge(&space, 1.0, 2));
        let test = Lagrange::new(&mesh, 2);
        let rules = Rules::new(3, 5);
        [
            distributional_curvature(&g, &test, &rules),
            a_h(&g, &sigma, &test, &rules),
            b_h(&g, &sigma, &test, &rules),
        ]
    })
}

#[test]
fn sums_do_not_depend_on_threads() {
    let one = with_threads(1);
    for threads in [2, 3, 7] {
        assert!(one == with_threads(threads), "{threads} threads");
    }
}
