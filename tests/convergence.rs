//! Orders of convergence of the H⁻² error, for every interpolant: fitted to three levels and two seeds, and so near to what the
//! theorem says that half an order less is seen, and half an order more. Upper bounds and best constants: verify/analysis.

use regge_curvature::functional::{Rules, distributional_curvature, smooth_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::norm::HMinus2;
use regge_curvature::spaces::ReggeSpace;

/// ln h and the logarithm of the H⁻² error of the densitized curvature on a perturbed mesh.
fn error<const N: usize>(way: Interpolant, degree: usize, side: usize, seed: u64) -> [f64; 2] {
    let mesh = Mesh::<N>::cube(side).expect("a cube");
    let mesh = mesh.perturbed(0.25 / side as f64, seed).expect("a mesh");
    let g = Smooth::new(&mesh, Metric::Trig).expect("coordinates");
    let g_h = way.apply(&ReggeSpace::new(&mesh, degree), &g);
    let hm2 = HMinus2::new(&mesh, degree + 2).expect("a norm");
    let rules = Rules::new(N, Rules::default_order(degree));
    let g_h = g_h.expect("a metric");
    let mut load = distributional_curvature(&g_h, hm2.space(), &rules).total();
    let smooth = smooth_curvature(&g, hm2.space(), &rules);
    for (l, s) in load.iter_mut().zip(smooth) {
        *l -= s;
    }
    let error = hm2.norm(&load, None).expect("a solution").total();
    [mesh.mesh_size().ln(), error.ln()]
}

/// The slope of the line that is nearest to some points.
fn slope(points: &[[f64; 2]]) -> f64 {
    let mean = |i: usize| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let above: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    above / points.iter().map(|p| (p[0] - x).powi(2)).sum::<f64>()
}

/// What is as near as this to the expected order would not be with half an order more or less.
const NEAR: f64 = 0.25;

/// The order of a metric of degree r: r + 1 by thm:conv, and 2 for these two at r = 0, as everybody sees and nobody has proved
/// (paper, section 5, for N = 2).
fn expected(way: Interpolant, degree: usize) -> f64 {
    let better = [
        Interpolant::canonical().name(),
        Interpolant::geodesic().name(),
    ];
    match degree {
        0 if better.contains(&way.name()) => 2.0,
        r => r as f64 + 1.0,
    }
}

/// The order over meshes of so many cubes a side, the mean of two seeds.
fn converges<const N: usize>(way: Interpolant, degree: usize, sides: [usize; 3]) {
    let orders = [40, 41].map(|seed| slope(&sides.map(|side| error::<N>(way, degree, side, seed))));
    let (order, expected) = (0.5 * (orders[0] + orders[1]), expected(way, degree));
    let name = way.name();
    println!("N = {N}, r = {degree}, {name}: {orders:?}");
    assert!(
        (order - expected).abs() < NEAR,
        "N = {N}, r = {degree}, {name}: order {order}, not {expected}"
    );
}

const AVERAGES: fn() -> [Interpolant; 2] =
    || [Interpolant::average(), Interpolant::average_hierarchical()];

/// thm:conv (i). For r = 0 the averages come down to 1 slowly (the paper prints 1.57, 1.41, 1.14, 1.03 for k = 3…6), so their
/// meshes are finer.
#[test]
fn plane() {
    for way in AVERAGES() {
        converges::<2>(way, 0, [16, 32, 64]);
    }
    for way in [Interpolant::canonical(), Interpolant::geodesic()] {
        converges::<2>(way, 0, [8, 16, 32]);
    }
    for way in AVERAGES().into_iter().chain([Interpolant::canonical()]) {
        converges::<2>(way, 1, [8, 16, 32]);
        converges::<2>(way, 2, [8, 12, 16]);
    }
}

/// thm:conv (ii) for r = 1 and 2. For r = 0 the averages still have order 1 on meshes as coarse as these, before they stagnate (paper,
/// section 5).
#[test]
fn space() {
    for way in [
        Interpolant::average(),
        Interpolant::canonical(),
        Interpolant::geodesic(),
    ] {
        converges::<3>(way, 0, [4, 6, 8]);
    }
    for way in [Interpolant::canonical(), Interpolant::average()] {
        converges::<3>(way, 1, [4, 6, 8]);
        converges::<3>(way, 2, [4, 5, 6]);
    }
}
