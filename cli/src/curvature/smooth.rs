//! ∫ R(g) v ω of the smooth metric, where R(g) is stated by a formula.

use rayon::prelude::*;
use regge_curvature::density::Volume;
use regge_curvature::field::Evaluate;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::jet::{Jet2, lower};
use regge_curvature::linalg::{Mat, indefinite_pivot};
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::simplex::{Points, subsets};
use regge_curvature::spaces::Lagrange;
use regge_curvature::{Error, linalg::inverse_and_det};
use regge_readers::expression::Expression;

/// Σ_T ∫_T R v ω for every basis function v, with R by its own formula.
pub fn stated_curvature<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    exact: &Expression,
    space: &Lagrange<N>,
    rule: &Rule,
) -> Vec<f64> {
    let mesh = space.mesh();
    let basis = space.basis(N).tabulate::<f64>(rule.points());
    let table = Evaluate::<f64, N>::tabulate(g, rule.points());
    let mut load = vec![0.0; space.len()];
    for cell in 0..mesh.cell_count() {
        let local = Evaluate::<f64, N>::on_cell(g, cell);
        for (q, weight) in rule.weights().iter().enumerate() {
            let x = place(g, cell, rule.points().lambda(q));
            let (_, det) = inverse_and_det(&g.value(&local, &table, q));
            let density = exact.at(&x) * Volume::from_det(det) * weight;
            for (dof, value) in space.cell_dofs(cell).zip(&basis[q]) {
                load[dof] += density * value;
            }
        }
    }
    load
}

/// The point with these barycentric coordinates in ℝ^N.
fn place<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    cell: usize,
    lambda: &[f64],
) -> [f64; N] {
    let mut x = [0.0; N];
    for (i, l) in lambda.iter().enumerate() {
        let corner = g.mesh().corner(cell, i);
        let corner = corner.expect("`Smooth::new` refuses meshes without coordinates");
        for a in 0..N {
            x[a] += l * corner[a];
        }
    }
    x
}

/// By how much a stated R may differ from that of the metric: by the rounding of a formula, relatively, and by that of the terms
/// that the kernel's R is made of, which may cancel.
const STATED: f64 = 1e-6;
const ROUNDED: f64 = 1e-10;

/// Is the stated R that of the metric, at the points of a rule in every cell?
///
/// # Errors
/// Names the first cell and point where it is not, with both values.
pub fn check_stated<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    exact: &Expression,
    rule: &Rule,
) -> Result<(), Error> {
    let table = Evaluate::<f64, N>::tabulate(g, rule.points());
    let on_cell = |cell: usize| {
        let local = Evaluate::<f64, N>::on_cell(g, cell);
        (0..rule.points().len()).find_map(|q| {
            let x = place(g, cell, rule.points().lambda(q));
            let (stated, jets) = (exact.at(&x), g.jet2(&local, &table, q));
            let connection = Connection::new(&lower(&jets));
            let own = Curvature::new(&jets, &connection).scalar();
            let rounding = ROUNDED * size_of_terms(&jets, &connection);
            let allowed = STATED * own.abs().max(stated.abs()) + rounding;
            // A metric that has no R is refused elsewhere.
            let agrees = (own - stated).abs() <= allowed;
            let differs = own.is_finite() && !agrees;
            differs.then(|| {
                let reason = format!(
                    "exact_scalar_curvature is {stated} at x = {x:?}, but the metric's own scalar curvature is {own}: \
                     correct the formula, leave it out, or insist with --trust-exact-curvature"
                );
                Error::Cell { cell, reason }
            })
        })
    };
    first_of(g.mesh().cell_count(), &on_cell).map_or(Ok(()), Err)
}

/// |g⁻¹|² |∂²g| + |g⁻¹|³ |∂g|², by largest entries.
fn size_of_terms<const N: usize>(
    jets: &Mat<Jet2<f64, N>, N>,
    connection: &Connection<f64, N>,
) -> f64 {
    let largest = |of: &dyn Fn(&Jet2<f64, N>) -> f64| jets.iter().map(of).fold(0.0, f64::max);
    let first = largest(&|jet| jet.d.iter().fold(0.0, |a: f64, b| a.max(b.abs())));
    let second = largest(&|jet| {
        jet.dd
            .iter()
            .flatten()
            .fold(0.0, |a: f64, b| a.max(b.abs()))
    });
    let inverse = connection
        .inverse
        .iter()
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    inverse.powi(2) * second + inverse.powi(3) * first * first
}

/// Is the formula, with its derivatives, finite and positive definite at the points of a rule in every cell?
///
/// # Errors
/// Names the first cell and point where it is not.
pub fn check_formula<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    rule: &Rule,
) -> Result<(), Error> {
    let parts = |jet: &Jet2<f64, N>| {
        let all = jet.dd.iter().flatten().chain(&jet.d).chain([&jet.value]);
        all.fold(0.0, |sum: f64, part| sum + part.abs())
    };
    check_at(g, rule.points(), |x| {
        let x = std::array::from_fn(|i| Jet2::coordinate(x[i], i));
        let jets = g.formula().at(&x);
        let finite = jets.iter().all(|jet| parts(jet).is_finite());
        finite.then(|| jets.map(|jet| jet.value))
    })
}

/// Is the formula finite and positive definite at the points of a rule in every cell?
///
/// # Errors
/// As [`check_formula`].
pub fn check_values<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    rule: &Rule,
) -> Result<(), Error> {
    check_at(g, rule.points(), |x| finite_value(g, x))
}

fn finite_value<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    x: &[f64; N],
) -> Option<Mat<f64, N>> {
    let value = g.formula().at(x);
    value.iter().all(|x: &f64| x.is_finite()).then_some(value)
}

/// Is the formula finite and positive definite on the edges, at the points where interpolants of degree r look?
///
/// # Errors
/// As [`check_formula`].
pub fn check_edges<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    degree: usize,
) -> Result<(), Error> {
    let rule = Rule::new(1, Interpolant::default_order(degree));
    subsets(N + 1, 2).iter().try_for_each(|edge| {
        let points = rule.points().embed(edge, N + 1);
        check_at(g, &points, |x| finite_value(g, x))
    })
}

/// `finite` answers with g at x, if all that is wanted there is finite. It is the formula that is looked at, in the coordinates
/// that it is written in: in those of a thin cell the Euclidean metric itself may lose its sign to rounding.
fn check_at<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    points: &Points,
    finite: impl Fn(&[f64; N]) -> Option<Mat<f64, N>> + Sync,
) -> Result<(), Error> {
    let on_cell = |cell: usize| {
        (0..points.len()).find_map(|q| {
            let x = place(g, cell, points.lambda(q));
            let what = match finite(&x) {
                None => "is not finite, or divides by zero,".to_string(),
                Some(value) => {
                    let pivot = indefinite_pivot(&value)?;
                    format!("is not positive definite (pivot {pivot:e})")
                }
            };
            let reason = format!("the metric {what} at x = {x:?}: check the formula there");
            Some(Error::Cell { cell, reason })
        })
    };
    first_of(g.mesh().cell_count(), &on_cell).map_or(Ok(()), Err)
}

/// The first error among so many; not generic, so that the threads' machinery is compiled once.
fn first_of(count: usize, error_at: &(dyn Fn(usize) -> Option<Error> + Sync)) -> Option<Error> {
    (0..count).into_par_iter().find_map_first(error_at)
}
