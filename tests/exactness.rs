//! What holds on one mesh, to rounding, without refinement.

use crate::common::{crooked_cube, largest, random_regge};
use approx::assert_abs_diff_eq;
use nalgebra::SVector;
use num_dual::Dual64;
use regge_curvature::field::{Combination, Evaluate, TensorField};
use regge_curvature::functional::{Rules, Sums, a_h, b_h, distributional_curvature};
use regge_curvature::interpolate::Canonical;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::simplex::{Bernstein, Points};
use regge_curvature::spaces::{Lagrange, ReggeSpace};

fn curvature<const N: usize, G: TensorField<N, Scalar = f64>>(
    g: &G,
    space: &Lagrange<N>,
    order: usize,
) -> Sums<f64> {
    distributional_curvature(g, space, &Rules::new(N, order))
}

/// ⟨Rω_dist, 1⟩ = 4πχ for every Regge metric on a closed surface (Gauss and Bonnet). The sums over cells and over
/// edges are integrals of functions that are no polynomials: order 40 leaves rounding errors.
#[test]
fn gauss_bonnet_on_torus_and_sphere() {
    let meshes = [
        (Mesh::<2>::torus(3), 0.0),
        (Mesh::<2>::simplex_boundary(), 2.0),
    ];
    for (mesh, characteristic) in meshes.map(|(m, c)| (m.expect("a closed surface"), c)) {
        assert_eq!(mesh.euler_characteristic() as f64, characteristic);
        for degree in 0..=2 {
            let space = ReggeSpace::new(&mesh, degree);
            let g = random_regge(&space, 0.2, 7 + degree as u64);
            let hats = Lagrange::new(&mesh, 1);
            let sums = curvature(&g, &hats, 40).pair(&vec![1.0; hats.len()]);
            let off = sums.total() - 4.0 * std::f64::consts::PI * characteristic;
            assert!(off.abs() < 1e-11, "r = {degree}: {off}");
            if degree > 0 {
                assert!(
                    sums.faces.abs() > 1e-3,
                    "the edges must contribute for the test to mean something: {sums:?}"
                );
            }
        }
    }
}

/// A smooth metric has no angle defects and no jumps of H; nothing is integrated here but exact zeros.
fn smooth_has_no_jumps<const N: usize>(side: usize) {
    let mesh = crooked_cube::<N>(side, 3);
    let g = Smooth::new(&mesh, Metric::Trig).expect("coordinates");
    let space = Lagrange::new(&mesh, 2);
    let sums = curvature(&g, &space, 4);
    for (name, sum) in [("face", &sums.faces), ("hinge", &sums.hinges)] {
        let inner = (0..space.len()).filter(|&d| space.vanishes_on_boundary(d));
        let worst = inner.fold(0.0, |m: f64, d| m.max(sum[d].abs()));
        assert!(worst < 1e-13, "N = {N}, {name}: {worst:e}");
    }
    assert!(largest(&sums.cells) > 1e-3, "the metric is curved");
}

#[test]
fn smooth_metrics_have_no_jumps() {
    smooth_has_no_jumps::<2>(4);
    smooth_has_no_jumps::<3>(2);
    smooth_has_no_jumps::<4>(1);
}

/// φ*δ for a continuous piecewise polynomial φ: g_mn = ∂_mφ·∂_nφ.
struct PullBack<const N: usize> {
    space: Lagrange<N>,
    /// φ's values as coefficients, by basis function.
    phi: Vec<SVector<f64, N>>,
}

impl<const N: usize> PullBack<N> {
    /// The identity at the control points, moved at random.
    fn new(mesh: &Mesh<N>, degree: usize, noise: f64) -> Self {
        let space = Lagrange::new(mesh, degree);
        let mut random = SplitMix64::new(11);
        let mut phi = vec![SVector::zeros(); space.len()];
        let moves: Vec<SVector<f64, N>> = phi
            .iter()
            .map(|_| SVector::from_fn(|_, _| noise * random.symmetric()))
            .collect();
        let basis = space.basis(N);
        for cell in 0..mesh.cell_count() {
            for (i, dof) in space.cell_dofs(cell).enumerate() {
                // The control point of B_α is Σ α_v x_v / q.
                let mut x = SVector::zeros();
                for (v, &e) in basis.exponents()[i].iter().enumerate() {
                    x += mesh.corner(cell, v).expect("coordinates") * (e as f64 / degree as f64);
                }
                phi[dof] = x + moves[dof];
            }
        }
        Self { space, phi }
    }
}

impl<const N: usize> Evaluate<f64, N> for PullBack<N> {
    type Table = Vec<Vec<Jet2<f64, N>>>;
    type Local = Vec<SVector<f64, N>>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        Bernstein::new(N + 1, self.space.degree()).tabulate_jets(points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.space.cell_dofs(cell).map(|d| self.phi[d]).collect()
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let d = |m: usize| -> SVector<f64, N> {
            local.iter().zip(&table[q]).map(|(c, b)| c * b.d[m]).sum()
        };
        // Only the canonical degrees of freedom are taken of it: they ask for values.
        symmetric(|m, n| Jet2::constant(d(m).dot(&d(n))))
    }
}

impl<const N: usize> TensorField<N> for PullBack<N> {
    type Scalar = f64;
    type Wide = f64;
}

/// The pull-back of a flat metric by a piecewise polynomial homeomorphism is flat as a distribution. For φ of
/// degree s it is a Regge metric of degree 2(s−1), so that interpolating it changes nothing.
fn pull_back_is_flat<const N: usize>(side: usize, s: usize, order: usize, tolerance: f64) {
    let mesh = crooked_cube::<N>(side, 5);
    let field = PullBack::new(&mesh, s, 0.1 / side as f64);
    let space = ReggeSpace::new(&mesh, 2 * (s - 1));
    let canonical = Canonical::new(&space);
    let g = space
        .function(canonical.solve(&canonical.evaluate(&field, 4 * s)))
        .expect("as many as there are");
    let test = Lagrange::new(&mesh, 2);
    let sums = curvature(&g, &test, order);
    let total = sums.total();
    let inner = (0..test.len()).filter(|&d| test.vanishes_on_boundary(d));
    let worst = inner.fold(0.0, |m: f64, d| m.max(total[d].abs()));
    assert!(worst < tolerance, "N = {N}, s = {s}: {worst:e}");
    if s > 1 {
        let coefficients = g.coefficients();
        let spread = coefficients
            .iter()
            .map(|c| (c - coefficients[0]).abs())
            .fold(0.0, f64::max);
        assert!(spread > 1e-3, "the metric is not constant on cells");
    }
}

#[test]
fn pulled_back_flat_metrics_are_flat() {
    pull_back_is_flat::<2>(3, 1, 2, 1e-13);
    pull_back_is_flat::<3>(2, 1, 2, 1e-13);
    pull_back_is_flat::<4>(1, 1, 2, 1e-13);
    // R = 0, ⟦H⟧ = 0 and Θ = 0 point by point: any quadrature will do.
    pull_back_is_flat::<2>(3, 2, 6, 1e-12);
    pull_back_is_flat::<3>(2, 2, 6, 1e-12);
}

/// g → c²g multiplies R ω by c^{N−2}.
fn scales<const N: usize>(degree: usize) {
    let mesh = crooked_cube::<N>(2, 9);
    let space = ReggeSpace::new(&mesh, degree);
    let g = random_regge(&space, 0.1, 1);
    let c: f64 = 1.7;
    let scaled = g.coefficients().iter().map(|x| c * c * x).collect();
    let scaled = space.function(scaled).expect("as many");
    let test = Lagrange::new(&mesh, 2);
    let (mut one, other) = (
        curvature(&g, &test, 6).total(),
        curvature(&scaled, &test, 6).total(),
    );
    let size = largest(&one);
    one.iter_mut().for_each(|x| *x *= c.powi(N as i32 - 2));
    assert_abs_diff_eq!(one[..], other[..], epsilon = 1e-12 * size);
}

#[test]
fn curvature_scales_as_length_to_the_n_minus_2() {
    scales::<2>(1);
    scales::<3>(1);
    scales::<3>(2);
    scales::<4>(0);
}

/// Numbering the vertices differently, which changes every cell's reference coordinates, changes nothing: vertex
/// functions are found again under their new numbers.
fn relabels<const N: usize>(degree: usize) {
    let mesh = crooked_cube::<N>(2, 4);
    let count = mesh.count(0);
    let new_of = |v: usize| (v * 7 + 3) % count;
    let mut points = vec![SVector::zeros(); count];
    for v in 0..count {
        points[new_of(v)] = mesh.points().expect("coordinates")[v];
    }
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|c| {
            mesh.vertices(N, c)
                .iter()
                .map(|&v| new_of(v as usize))
                .collect()
        })
        .collect();
    let other = Mesh::new(points, &cells).expect("the same mesh");
    // The rules on tetrahedra are not symmetric: their error must be at rounding level too.
    let order = if degree == 0 { 2 } else { 22 };
    let on = |mesh: &Mesh<N>| -> Vec<f64> {
        let space = ReggeSpace::new(mesh, degree);
        let canonical = Canonical::new(&space);
        let smooth = Smooth::new(mesh, Metric::Trig).expect("coordinates");
        let values: Vec<f64> = canonical.evaluate(&smooth, 12);
        let g = space.function(canonical.solve(&values)).expect("as many");
        curvature(&g, &Lagrange::new(mesh, 1), order).total()
    };
    let (ours, theirs) = (on(&mesh), on(&other));
    for v in 0..count {
        let (a, b) = (ours[v], theirs[new_of(v)]);
        assert!(
            (a - b).abs() < 1e-12 * largest(&ours),
            "N = {N}, r = {degree}: {a} {b}"
        );
    }
}

#[test]
fn labels_do_not_matter() {
    relabels::<2>(0);
    relabels::<2>(2);
    relabels::<3>(0);
    relabels::<3>(1);
}

/// thm:distcurvdot: d/dt by dual numbers through the whole functional against b_h − a_h, for every test function of
/// degree 2 that vanishes on the boundary. The two agree in the limit of exact quadrature.
fn first_variation<const N: usize>(mesh: &Mesh<N>, degree: usize, order: usize, tolerance: f64) {
    let space = ReggeSpace::new(mesh, degree);
    // Alfeld's cells are thin: in N = 4 a noise of 0.1 can make them degenerate.
    let noise = if N == 4 { 0.02 } else { 0.1 };
    let (g, sigma) = (
        random_regge(&space, noise, 21),
        random_regge(&space, 1.0, 22),
    );
    let test = Lagrange::new(mesh, 2);
    let rules = Rules::new(N, order);
    let moving = Combination::new(Dual64::from(1.0), &g, Dual64::new(0.0, 1.0), &sigma);
    let left = distributional_curvature(&moving, &test, &rules).total();
    let b = b_h(&g, &sigma, &test, &rules).total();
    let a = a_h(&g, &sigma, &test, &rules).total();
    let scale = largest(&b).max(largest(&a));
    let mut tested = 0;
    for dof in (0..test.len()).filter(|&d| test.vanishes_on_boundary(d)) {
        let residual = left[dof].eps - (b[dof] - a[dof]);
        assert!(
            residual.abs() < tolerance * scale,
            "N = {N}, r = {degree}, dof {dof}: {residual:e} of {scale:e}"
        );
        tested += 1;
    }
    assert!(tested > 0 && scale > 1e-3, "something must be tested");
    assert!(
        N == 2 || largest(&a) > 1e-3 * scale,
        "a_h must matter when N > 2"
    );
}

#[test]
fn first_variation_is_b_minus_a() {
    for degree in 0..=2 {
        let order = [2, 24, 28][degree];
        first_variation::<2>(&crooked_cube::<2>(2, 1), degree, order, 1e-11);
        first_variation::<2>(&Mesh::torus(3).expect("a torus"), degree, order, 1e-11);
        let order = [2, 16, 20][degree];
        let tolerance = [1e-12, 1e-9, 1e-9][degree];
        first_variation::<3>(&crooked_cube::<3>(2, 1), degree, order, tolerance);
        first_variation::<3>(
            &Mesh::simplex_boundary().expect("a sphere"),
            degree,
            order,
            tolerance,
        );
        let order = [2, 14, 18][degree];
        let tolerance = [1e-12, 1e-8, 1e-8][degree];
        first_variation::<4>(
            &Mesh::alfeld().expect("Alfeld's split"),
            degree,
            order,
            tolerance,
        );
    }
}
