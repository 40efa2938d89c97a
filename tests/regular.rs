//! Regular simplices and their boundaries, all edges 1 long: closed forms for N = 2…5.
//!
//! N = 5 is the first dimension where N−2 and N/2 differ that is not the plane.

use crate::common::dense;
use approx::assert_relative_eq;
use regge_curvature::field::{Evaluate, TensorField};
use regge_curvature::functional::{
    HingeDefect, Rules, Three, action_gradient, action_hessian, angle_defects, boundary_curvature,
    distributional_curvature, einstein, einstein_against, regge_action,
};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::{Lagrange, ReggeFunction, ReggeSpace};
use std::f64::consts::{PI, TAU};

/// Everything is constant: some roundings of numbers up to 10².
const ROUNDING: f64 = 1e-13;

/// The regular simplex of dimension N: its dihedral angle, and the volume of a hinge.
struct Regular<const N: usize>;

impl<const N: usize> Regular<N> {
    fn angle() -> f64 {
        (1.0 / N as f64).acos()
    }

    /// √(k+1) / (k! 2^{k/2}) for k = N − 2.
    fn hinge() -> f64 {
        let factorial: f64 = (1..=N - 2).map(|i| i as f64).product();
        (N as f64 - 1.0).sqrt() / (factorial * 2f64.powf((N as f64 - 2.0) / 2.0))
    }

    /// Around each hinge of ∂Δ^{N+1} are three cells.
    fn defect() -> f64 {
        TAU - 3.0 * Self::angle()
    }
}

/// The metric with all edges 1.
fn unit<const N: usize>(space: &ReggeSpace<N>) -> ReggeFunction<f64, N> {
    (space.function(vec![1.0; space.len()])).expect("as many as there are edges")
}

fn near(a: f64, b: f64) {
    assert_relative_eq!(a, b, epsilon = ROUNDING, max_relative = ROUNDING);
}

fn defects_and_total<const N: usize>() {
    let mesh = Mesh::<N>::simplex_boundary().expect("a sphere");
    let space = ReggeSpace::new(&mesh, 0);
    let (g, hats) = (unit(&space), Lagrange::new(&mesh, 1));
    let (theta, volume) = (Regular::<N>::defect(), Regular::<N>::hinge());
    let defects = angle_defects(&g, &mesh, 3);
    assert_eq!(defects.len(), mesh.count(N - 2));
    for (i, at) in defects.iter().enumerate() {
        let expected = HingeDefect {
            hinge: i,
            defect: theta,
            size: volume,
        };
        assert_relative_eq!(*at, expected, epsilon = ROUNDING, max_relative = ROUNDING);
    }
    let sums = distributional_curvature(&g, &hats, &Rules::new(N, 3));
    let Three {
        cells,
        faces,
        hinges,
    } = sums.pair(&vec![1.0; hats.len()]);
    assert_eq!([cells, faces], [0.0; 2]);
    near(hinges, 2.0 * theta * volume * defects.len() as f64);
}

#[test]
fn angle_defects_of_regular_spheres() {
    defects_and_total::<2>();
    defects_and_total::<3>();
    defects_and_total::<4>();
    defects_and_total::<5>();
}

/// ⟨Gω, g⟩ = −(N−2) Σ Θ |S|, in equal parts from all edges.
fn einstein_tensor<const N: usize>() {
    let mesh = Mesh::<N>::simplex_boundary().expect("a sphere");
    let space = ReggeSpace::new(&mesh, 0);
    let (g, rules) = (unit(&space), Rules::new(N, 1));
    let hinges = mesh.count(N - 2) as f64 * Regular::<N>::defect() * Regular::<N>::hinge();
    let expected = -(N as f64 - 2.0) * hinges;
    let whole = einstein(&g, &g, &mesh, &rules);
    near(whole.total(), expected);
    for part in einstein_against(&g, &space, &rules).total() {
        near(part, expected / mesh.count(1) as f64);
    }
}

#[test]
fn einstein_tensor_of_regular_spheres() {
    einstein_tensor::<2>();
    einstein_tensor::<3>();
    einstein_tensor::<4>();
    einstein_tensor::<5>();
}

/// The action Σ Θ |S| is homogeneous of degree N−2 in the lengths, and all edges are alike: Euler gives the gradient's
/// entries and the sums of the Hessian's rows.
fn action_and_derivatives<const N: usize>() {
    let mesh = Mesh::<N>::simplex_boundary().expect("a sphere");
    let space = ReggeSpace::new(&mesh, 0);
    let (g, rules) = (unit(&space), Rules::new(N, 1));
    let action = mesh.count(N - 2) as f64 * Regular::<N>::defect() * Regular::<N>::hinge();
    let ours = regge_action(&g, &mesh, &rules);
    near(ours.interior, action);
    assert_eq!(ours.boundary, 0.0);
    let slope = (N as f64 - 2.0) * action / mesh.count(1) as f64;
    let all = action_gradient(&g).expect("degree 0");
    all.gradient.iter().for_each(|entry| near(*entry, slope));
    assert!(all.schlaefli < ROUNDING, "{}", all.schlaefli);
    let hessian = dense(&mesh, &action_hessian(&g).expect("degree 0"));
    for row in hessian.row_iter() {
        near(row.sum(), (N as f64 - 3.0) * slope);
    }
}

#[test]
fn action_of_regular_spheres() {
    action_and_derivatives::<3>();
    action_and_derivatives::<4>();
    action_and_derivatives::<5>();
}

/// One simplex: its boundary turns by π − θ at each hinge.
fn boundary<const N: usize>() {
    let mesh = Mesh::<N>::single().expect("a simplex");
    let space = ReggeSpace::new(&mesh, 0);
    let (g, hats) = (unit(&space), Lagrange::new(&mesh, 1));
    let outer = boundary_curvature(&g, &hats, &Rules::new(N, 1)).total();
    let hinges = mesh.count(N - 2) as f64 * Regular::<N>::hinge();
    near(
        outer.iter().sum(),
        2.0 * (PI - Regular::<N>::angle()) * hinges,
    );
}

#[test]
fn boundary_of_a_regular_simplex() {
    boundary::<2>();
    boundary::<3>();
    boundary::<4>();
    boundary::<5>();
}

/// On cell c the metric that makes all edges c + 1 long: no Regge metric, its cells do not fit.
struct Misfit;

impl<const N: usize> Evaluate<f64, N> for Misfit {
    type Table = ();
    type Local = f64;

    fn tabulate(&self, _: &Points) -> Self::Table {}
    fn on_cell(&self, cell: usize) -> f64 {
        cell as f64 + 1.0
    }
    fn jet2(&self, length: &f64, (): &(), _: usize) -> Mat<Jet2<f64, N>, N> {
        symmetric(|i, j| Jet2::constant(length * length * if i == j { 1.0 } else { 0.5 }))
    }
}

impl<const N: usize> TensorField<N> for Misfit {
    type Scalar = f64;
    type Wide = f64;
}

/// Where cells disagree about |S|, the first of them counts, as documented: a sceptic who breaks the continuity of g must
/// know what is computed.
#[test]
fn hinges_are_measured_by_their_first_cell() {
    let mesh = Mesh::<3>::simplex_boundary().expect("a sphere");
    let defects = angle_defects(&Misfit, &mesh, 1);
    assert_eq!(defects.len(), mesh.count(1));
    for at in defects {
        near(at.size, mesh.first_side(1, at.hinge).cell as f64 + 1.0);
        near(at.defect, Regular::<3>::defect());
    }
}
