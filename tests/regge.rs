//! Regge spaces and interpolants.

use crate::common::{crooked_cube, largest, random_regge};
use nalgebra::SVector;
use regge_curvature::field::Evaluate;
use regge_curvature::interpolate::{
    Canonical, Interpolant, Projection, geodesic_interpolant, geodesic_length,
};
use regge_curvature::linalg::{Mat, Vector, form};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::{binomial, subsets};
use regge_curvature::spaces::{ReggeSpace, dofs_per_simplex};
use regge_oracle::{Oracle, all as load_all};

/// I28: Σ_k C(N+1, k+1) dofs(k) = dim P_r · N(N+1)/2 on one simplex.
#[test]
fn dimension_formula() {
    for n in 2..=6 {
        for r in 0..=6 {
            let sum: usize = (1..=n)
                .map(|k| binomial(n + 1, k + 1) * dofs_per_simplex(r, k))
                .sum();
            assert_eq!(
                sum,
                binomial(n + r, n) * n * (n + 1) / 2,
                "N = {n}, r = {r}"
            );
        }
    }
}

/// N04: the numbers of degrees of freedom that the paper plots, k = 0…2.
#[test]
fn the_papers_numbers_of_degrees_of_freedom() {
    for (k, plotted) in [[5, 16, 33], [16, 56, 120], [56, 208, 456]]
        .iter()
        .enumerate()
    {
        let mesh = Mesh::<2>::cube(1 << k).expect("a square");
        for r in 0..3 {
            assert_eq!(ReggeSpace::new(&mesh, r).len(), plotted[r]);
        }
    }
    for (k, plotted) in [[19, 92, 255], [98, 556, 1662], [604, 3800, 11892]]
        .iter()
        .enumerate()
    {
        let mesh = Mesh::<3>::cube(1 << k).expect("a cube");
        for r in 0..3 {
            assert_eq!(ReggeSpace::new(&mesh, r).len(), plotted[r]);
        }
    }
}

/// I29: ℓ_i(ψ_j) = δ_ij, both ways around; 1e-10 allows for the condition of high degrees.
fn duality<const N: usize>(mesh: &Mesh<N>, degree: usize) {
    let space = ReggeSpace::new(mesh, degree);
    let canonical = Canonical::new(&space);
    for j in (0..space.len()).step_by(1 + space.len() / 40) {
        let mut unit = vec![0.0; space.len()];
        unit[j] = 1.0;
        let psi = space.function(canonical.solve(&unit)).expect("as many");
        let values: Vec<f64> = canonical.evaluate(&psi, 2 * degree + 1);
        for (i, value) in values.iter().enumerate() {
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!(
                (value - expected).abs() < 1e-10,
                "N = {N}, r = {degree}: ℓ_{i}(ψ_{j}) = {value}"
            );
        }
    }
}

#[test]
fn basis_is_dual_to_the_degrees_of_freedom() {
    for degree in 0..=4 {
        duality(&crooked_cube::<2>(2, 1), degree);
        duality(&crooked_cube::<3>(1, 1), degree);
    }
    duality(&Mesh::<4>::simplex_boundary().expect("a sphere"), 2);
    duality(&Mesh::<5>::single().expect("a simplex"), 3);
}

/// Tangential-tangential values agree from both sides of a face, and nothing else does (or the test would not see
/// a space that is too continuous).
fn continuity<const N: usize>(degree: usize) {
    let mesh = crooked_cube::<N>(2, 8);
    let space = ReggeSpace::new(&mesh, degree);
    let g = random_regge(&space, 0.3, 5);
    let rule = Rule::new(N - 1, 3);
    let mut normal_jump: f64 = 0.0;
    for face in mesh.interior_faces() {
        let mut seen: Vec<Vec<Mat<f64, N>>> = Vec::new();
        for side in mesh.star(N - 1, face) {
            let on = &subsets(N + 1, N)[side.place];
            let table = Evaluate::<f64, N>::tabulate(&g, &rule.points().embed(on, N + 1));
            let local = Evaluate::<f64, N>::on_cell(&g, side.cell);
            let to_x = mesh
                .jacobian(side.cell)
                .and_then(|j| j.try_inverse())
                .expect("regular");
            let at = |q: usize| -> Mat<f64, N> {
                to_x.transpose() * Evaluate::<f64, N>::value(&g, &local, &table, q) * to_x
            };
            seen.push((0..rule.len()).map(at).collect());
        }
        let v: Vec<Vector<f64, N>> = mesh
            .vertices(N - 1, face)
            .iter()
            .map(|&v| mesh.points().expect("coordinates")[v as usize])
            .collect();
        for q in 0..rule.len() {
            let jump = seen[0][q] - seen[1][q];
            for a in 1..N {
                for b in 1..N {
                    let tt: f64 = form(&jump, &(v[a] - v[0]), &(v[b] - v[0]));
                    assert!(tt.abs() < 1e-13, "N = {N}, r = {degree}: {tt:e}");
                }
            }
            normal_jump = normal_jump.max(jump.amax());
        }
    }
    assert!(normal_jump > 1e-2);
}

#[test]
fn regge_functions_are_tangentially_continuous() {
    for degree in 0..=3 {
        continuity::<2>(degree);
        continuity::<3>(degree);
    }
    continuity::<4>(1);
}

/// Every interpolant reproduces Regge functions of its degree (it is a projector).
fn projector<const N: usize>(degree: usize) {
    let mesh = crooked_cube::<N>(2, 3);
    let space = ReggeSpace::new(&mesh, degree);
    let g = random_regge(&space, 0.05, 6);
    let discrete = Projection::by(Rule::new(N, 2 * degree));
    for interpolant in [
        Interpolant::Canonical {
            order: 2 * degree + 1,
        },
        Interpolant::Average(Projection::exact::<N>(degree)),
        Interpolant::Average(discrete.clone()),
        Interpolant::AverageHierarchical(Projection::exact::<N>(degree)),
        Interpolant::AverageHierarchical(discrete),
    ] {
        let h = interpolant.apply(&space, &g).expect("a metric");
        for (a, b) in g.coefficients().iter().zip(h.coefficients()) {
            assert!(
                (a - b).abs() < 1e-11,
                "N = {N}, r = {degree}, {interpolant:?}: {a} {b}"
            );
        }
    }
}

#[test]
fn interpolants_are_projectors() {
    for degree in 0..=3 {
        projector::<2>(degree);
    }
    for degree in 0..=2 {
        projector::<3>(degree);
    }
}

/// The oracles' metrics again, from the formula. Their g_h is NGSolve's, of another basis and quadrature: 1e-9 of the
/// largest coefficient is what its integration of a non-polynomial metric leaves.
fn interpolates_as_oracle<const N: usize>(oracle: &Oracle) {
    let mesh = oracle.mesh::<N>();
    let space = oracle.space(&mesh);
    let theirs = oracle.metric(&space);
    let named = Metric::ALL
        .iter()
        .find(|m| m.0 == oracle.metric)
        .expect("a known metric")
        .1;
    let g = Smooth::new(&mesh, named).expect("coordinates");
    let interpolant = match oracle.interpolant.as_str() {
        "canonical" => Interpolant::Canonical { order: 20 },
        _ => Interpolant::AverageHierarchical(Projection::by(Rule::new(N, 20))),
    };
    let ours = interpolant.apply(&space, &g).expect("a metric");
    let scale = largest(theirs.coefficients());
    for (a, b) in ours.coefficients().iter().zip(theirs.coefficients()) {
        assert!((a - b).abs() < 1e-9 * scale, "{}: {a} {b}", oracle.name);
    }
}

#[test]
fn interpolants_are_those_of_the_oracles() {
    for oracle in load_all() {
        match oracle.dimension {
            2 => interpolates_as_oracle::<2>(&oracle),
            _ => interpolates_as_oracle::<3>(&oracle),
        }
    }
}

/// The appendix's average and the hierarchical one are different interpolants for r ≥ 1, and one for r = 0.
#[test]
fn the_two_averages_differ() {
    let mesh = crooked_cube::<3>(2, 3);
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let exact = Projection::exact::<3>(degree);
        let one = Interpolant::Average(exact.clone())
            .apply(&space, &g)
            .expect("a metric");
        let other = Interpolant::AverageHierarchical(exact)
            .apply(&space, &g)
            .expect("a metric");
        let difference = one.coefficients().iter().zip(other.coefficients());
        let difference = difference.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(
            if degree == 0 {
                difference < 1e-13
            } else {
                difference > 1e-4
            },
            "{degree}: {difference:e}"
        );
    }
}

/// Stereographic coordinates of the unit sphere: |x−y|_chord = 2|x−y|/√((1+|x|²)(1+|y|²)), distance 2 asin(chord/2).
#[test]
fn geodesics_of_the_sphere() {
    for (a, b) in [
        ([-0.9, 0.4], [0.3, 0.8]),
        ([0.1, 0.2], [0.15, 0.18]),
        ([-0.6, -0.6], [0.7, 0.5]),
    ] {
        let (a, b): (Vector<f64, 2>, Vector<f64, 2>) = (a.into(), b.into());
        let product: f64 = (1.0 + a.norm_squared()) * (1.0 + b.norm_squared());
        let chord: f64 = 2.0 * (a - b).norm() / product.sqrt();
        let known: f64 = 2.0 * (chord / 2.0).asin();
        let length = geodesic_length(&Metric::Sphere, a, b).expect("a geodesic");
        assert!((length - known).abs() < 1e-12 * known, "{length} {known}");
    }
}

/// The ball model of radius ρ = √12 in N = 3: cosh(d/ρ) = 1 + 2ρ²|x−y|²/((ρ²−|x|²)(ρ²−|y|²)).
#[test]
fn geodesics_of_hyperbolic_space() {
    let (a, b) = (
        Vector::<f64, 3>::from([0.9, -0.8, 0.1]),
        Vector::from([-0.5, 0.7, 0.6]),
    );
    let square: f64 = 12.0;
    let ratio: f64 = 2.0 * square * (a - b).norm_squared()
        / ((square - a.norm_squared()) * (square - b.norm_squared()));
    let known = square.sqrt() * (1.0 + ratio).acosh();
    let length = geodesic_length(&Metric::Hyperbolic, a, b).expect("a geodesic");
    assert!((length - known).abs() < 1e-12 * known, "{length} {known}");
}

#[test]
fn geodesic_interpolant_has_the_geodesic_lengths() {
    let mesh = crooked_cube::<3>(2, 3);
    let space = ReggeSpace::new(&mesh, 0);
    let g = geodesic_interpolant(&space, &Metric::GraphQuartic).expect("a metric");
    let points = mesh.points().expect("coordinates");
    for edge in (0..mesh.count(1)).step_by(7) {
        let ends = mesh.vertices(1, edge);
        let [a, b] = [points[ends[0] as usize], points[ends[1] as usize]];
        let length = geodesic_length(&Metric::GraphQuartic, b, a).expect("a geodesic");
        assert!((g.coefficients()[edge] - length * length).abs() < 1e-12);
    }
    let flat = geodesic_interpolant(&space, &Metric::Flat).expect("a metric");
    assert!((flat.coefficients()[0] - (points[1] - points[0]).norm_squared()).abs() < 1e-13);
    assert!(geodesic_interpolant(&ReggeSpace::new(&mesh, 1), &Metric::Flat).is_err());
}

/// What is no metric, or leaves its domain, is refused by place.
#[test]
fn refusals_name_the_place() {
    let mesh = Mesh::<2>::cube(2).expect("a square");
    let space = ReggeSpace::new(&mesh, 0);
    let mut lengths = vec![1.0; space.len()];
    lengths[3] = 9.0;
    let g = space.function(lengths).expect("as many");
    let error = g
        .check_positive(Rule::new(2, 1).points())
        .expect_err("the triangle inequality")
        .to_string();
    assert!(
        error.contains("cell") && error.contains("barycentric point"),
        "{error}"
    );
    // Twice the square: its corners are outside of the ball |x|² < 8 of the hyperbolic plane.
    let corners = [[-3.0, -3.0], [3.0, -3.0], [-3.0, 3.0], [3.0, 3.0]];
    let large = Mesh::<2>::new(
        corners.map(SVector::from).to_vec(),
        &[vec![0, 1, 2], vec![1, 2, 3]],
    )
    .expect("a square");
    let error = geodesic_interpolant(&ReggeSpace::new(&large, 0), &Metric::Hyperbolic)
        .expect_err("outside")
        .to_string();
    assert!(
        error.contains("edge 0-1") && error.contains("leaves the domain"),
        "{error}"
    );
}
