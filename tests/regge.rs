//! Regge spaces: dimensions, dual bases, continuity.

use crate::common::{crooked_cube, random_regge};
use regge_curvature::field::Evaluate;
use regge_curvature::interpolate::Canonical;
use regge_curvature::linalg::{Mat, Vector, form};
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::{binomial, subsets};
use regge_curvature::spaces::{ReggeSpace, dofs_per_simplex};

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

/// What is no metric is refused by place.
#[test]
fn what_is_no_metric_is_refused_by_place() {
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
}
