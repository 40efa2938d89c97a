//! Nothing is silently under-integrated: at the default order, raising it changes the H⁻² error by less than 10⁻³ of
//! itself. A mesh whose cells are as large as the domain (k = 0) needs 20 orders more.

use regge_curvature::functional::{Rules, distributional_curvature, smooth_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::norm::HMinus2;
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// The H⁻² error with all rules of the curvature of this order.
fn error<const N: usize>(g_h: &ReggeFunction<f64, N>, hm2: &HMinus2<N>, order: usize) -> f64 {
    let rules = Rules::new(N, order);
    let g = Smooth::new(hm2.space().mesh(), Metric::GraphQuartic).expect("coordinates");
    let mut load = distributional_curvature(g_h, hm2.space(), &rules).total();
    let smooth = smooth_curvature(&g, hm2.space(), &rules);
    for (l, s) in load.iter_mut().zip(smooth) {
        *l -= s;
    }
    hm2.norm(&load, None).expect("a solution").total()
}

fn settled<const N: usize>(degree: usize, level: u32) {
    let default = Rules::default_order(degree) + if level == 0 { 20 } else { 0 };
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 3))
        .expect("a mesh");
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let space = ReggeSpace::new(&mesh, degree);
    let g_h = Interpolant::average_hierarchical()
        .apply(&space, &g)
        .expect("a metric");
    let hm2 = HMinus2::new(&mesh, degree + 2).expect("a norm");
    let [one, more] = [default, default + 8].map(|order| error(&g_h, &hm2, order));
    let change = (one - more).abs() / more;
    println!("N = {N}, r = {degree}, k = {level}: order {default} is off by {change:.1e}");
    assert!(
        change < 1e-3,
        "N = {N}, r = {degree}, k = {level}: {change:e}"
    );
}

#[test]
fn default_orders_are_enough() {
    for degree in 0..=2 {
        for level in 0..=4 {
            settled::<2>(degree, level);
        }
        for level in 0..=2 {
            settled::<3>(degree, level);
        }
    }
}
