//! Orders of convergence of the H⁻² error, for every interpolant, inside bands that a wrong order would miss.

use regge_curvature::functional::{Rules, distributional_curvature, smooth_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::norm::HMinus2;
use regge_curvature::spaces::ReggeSpace;

/// h and the H⁻² error of the densitized curvature on the paper's perturbed mesh.
fn error<const N: usize>(way: Interpolant, degree: usize, level: u32) -> (f64, f64) {
    let mesh = Mesh::<N>::cube(1 << level).expect("a cube");
    let mesh = mesh
        .perturbed_as_in_paper(level, 40 + u64::from(level))
        .expect("a mesh");
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let space = ReggeSpace::new(&mesh, degree);
    let g_h = way.apply(&space, &g);
    let hm2 = HMinus2::new(&mesh, degree + 2).expect("a norm");
    let rules = Rules::new(N, Rules::default_order(degree));
    let g_h = g_h.expect("a metric");
    let mut load = distributional_curvature(&g_h, hm2.space(), &rules).total();
    let smooth = smooth_curvature(&g, hm2.space(), &rules);
    for (l, s) in load.iter_mut().zip(smooth) {
        *l -= s;
    }
    (
        mesh.mesh_size(),
        hm2.norm(&load, None).expect("a solution").total(),
    )
}

/// The order between the two finest levels lies in the band around the expected one.
fn converges<const N: usize>(way: Interpolant, degree: usize, levels: [u32; 2], band: (f64, f64)) {
    let [(h, e), (finer_h, finer_e)] = levels.map(|k| error::<N>(way, degree, k));
    let order = (e / finer_e).ln() / (h / finer_h).ln();
    let name = way.name();
    println!("N = {N}, r = {degree}, {name}: {e:.3e}, {finer_e:.3e}, order {order:.2}");
    assert!(
        band.0 < order && order < band.1,
        "N = {N}, r = {degree}, {name}: order {order}"
    );
}

/// thm:conv (i): O(h^{r+1}). For r = 0 the averages come down to 1 slowly (the paper prints 1.57, 1.41, 1.14, 1.03 for
/// k = 3…6), while the canonical and the geodesic interpolant are one order better than the theorem says for all.
#[test]
fn plane() {
    for way in [Interpolant::average(), Interpolant::average_hierarchical()] {
        converges::<2>(way, 0, [3, 4], (0.8, 1.75));
    }
    for way in [Interpolant::canonical(), Interpolant::geodesic()] {
        converges::<2>(way, 0, [3, 4], (1.8, 2.2));
    }
    for way in [
        Interpolant::canonical(),
        Interpolant::average(),
        Interpolant::average_hierarchical(),
    ] {
        converges::<2>(way, 1, [3, 4], (1.65, 2.3));
        converges::<2>(way, 2, [3, 4], (2.8, 3.5));
    }
}

/// thm:conv (ii) for r = 1; for r = 0 the order 1 is seen before it stagnates (paper, section 5).
#[test]
fn space() {
    for way in [
        Interpolant::canonical(),
        Interpolant::average(),
        Interpolant::average_hierarchical(),
    ] {
        converges::<3>(way, 0, [1, 3], (0.75, 1.7));
        converges::<3>(way, 1, [1, 3], (1.2, 2.5));
    }
    converges::<3>(Interpolant::geodesic(), 0, [1, 3], (0.75, 1.7));
}
