//! Every case of tests/oracle (computed by an unrelated code, see its README): the three sums of def:distcurv.

use approx::abs_diff_eq;
use regge_curvature::field::Combination;
use regge_curvature::functional::{
    Rules, Three, a_h, b_h, distributional_curvature, smooth_curvature,
};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::spaces::Lagrange;
use regge_oracle::{Oracle, all as load_all};

/// NGSolve differentiates by differences, which its README puts at 1e-9 to 1e-7 of an entry; a third code agrees to
/// 1e-9 of the largest entry.
const TOLERANCE: f64 = 1e-8;

fn compare<const N: usize>(oracle: &Oracle) {
    let mesh = oracle.mesh::<N>();
    let space = oracle.space(&mesh);
    let g = oracle.metric(&space);
    let hats = Lagrange::new(&mesh, 1);
    let sums = distributional_curvature(&g, &hats, &Rules::new(N, 20));
    let scale = oracle.curvature.largest();
    for (i, &vertex) in oracle.curvature.vertex.iter().enumerate() {
        let ours = sums.of(vertex);
        let theirs = Three {
            cells: oracle.curvature.element[i],
            faces: oracle.curvature.face[i],
            hinges: oracle.curvature.angle[i],
        };
        assert!(
            abs_diff_eq!(ours, theirs, epsilon = TOLERANCE * scale),
            "{}: vertex {vertex}: {ours:?} against {theirs:?}",
            oracle.name
        );
    }
}

#[test]
fn three_sums_agree_with_every_oracle() {
    for oracle in load_all() {
        match oracle.dimension {
            2 => compare::<2>(&oracle),
            3 => compare::<3>(&oracle),
            n => panic!("no oracle of dimension {n}"),
        }
    }
}

/// eq. integralformula: ⟨(Rω)_dist(g_h) − (Rω)(g), v⟩ = ∫₀¹ (b_h − a_h)((1−t)g + t g_h; g_h − g, v) dt. At order 24
/// the quadrature error is below 2e-12 of sums of size 0.1 (1e-9 at order 16, 4e-11 at order 20).
#[test]
fn the_integral_formula_holds_on_an_oracle() {
    let oracle = load_all()
        .into_iter()
        .find(|o| o.name == "n3-structured-k1-r2")
        .expect("the case");
    let mesh = oracle.mesh::<3>();
    let space = oracle.space(&mesh);
    let g_h = oracle.metric(&space);
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let test = Lagrange::new(&mesh, 4);
    let rules = Rules::new(3, 24);
    let mut difference = distributional_curvature(&g_h, &test, &rules).total();
    let smooth = smooth_curvature(&g, &test, &rules);
    let sigma = Combination::new(-1.0, &g, 1.0, &g_h);
    let (nodes, weights) = gauss_legendre(6);
    for (t, w) in nodes.into_iter().zip(weights) {
        let segment = Combination::segment(&g, &g_h, t);
        let b = b_h(&segment, &sigma, &test, &rules).total();
        let a = a_h(&segment, &sigma, &test, &rules).total();
        for (i, d) in difference.iter_mut().enumerate() {
            *d -= w * (b[i] - a[i]);
        }
    }
    for dof in (0..test.len()).filter(|&d| test.vanishes_on_boundary(d)) {
        assert!(
            (difference[dof] - smooth[dof]).abs() < 5e-12,
            "test function {dof}"
        );
    }
}
