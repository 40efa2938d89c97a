//! The same bits for any number of threads.
#![cfg(feature = "parallel")]

use crate::common::{crooked_cube, random_regge};
use regge_curvature::functional::{Rules, Sums, a_h, b_h, distributional_curvature};
use regge_curvature::spaces::{Lagrange, ReggeSpace};
use regge_curvature::{Interpolant, Metric, Smooth};

fn pool(threads: usize) -> rayon::ThreadPool {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().expect("a pool")
}

fn with_threads(threads: usize) -> [Sums<f64>; 3] {
    pool(threads).install(|| {
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

/// The coefficients of every interpolant there is of this degree.
fn interpolated(threads: usize, degree: usize) -> Vec<Vec<f64>> {
    pool(threads).install(|| {
        let mesh = crooked_cube::<3>(3, 1);
        let space = ReggeSpace::new(&mesh, degree);
        let g = Smooth::new(&mesh, Metric::Trig).expect("coordinates");
        let there = Interpolant::ALL
            .into_iter()
            .filter(|one| one.check_degree(degree).is_ok());
        there
            .map(|one| one.apply(&space, &g).expect("a metric"))
            .map(|g_h| g_h.coefficients().to_vec())
            .collect()
    })
}

#[test]
fn interpolants_do_not_depend_on_threads() {
    for degree in 0..=2 {
        let one = interpolated(1, degree);
        for threads in [2, 3, 7] {
            assert!(one == interpolated(threads, degree), "{threads} threads");
        }
    }
}
