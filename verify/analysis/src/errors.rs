//! Floor 3. The error of the curvature in a dual norm, and the right side of thm:conv.

use crate::distance::Distance;
use crate::fields::Dome;
use regge_curvature::Error;
use regge_curvature::field::Combination;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, distributional_curvature, smooth_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth, SmoothTensor};
use regge_curvature::norm::{DualNorm, Kind, Setting};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// The H⁻² norm of functionals on a mesh, for metrics of degree r.
///
/// # Errors
/// If the mesh is too large for it.
pub fn dual_norm<const N: usize>(mesh: &Mesh<N>, r: usize) -> Result<Box<dyn DualNorm<N>>, Error> {
    dual_norm_named("hm2", mesh, r)
}

/// A norm of the library's table, Euclidean, for metrics of degree r.
///
/// # Errors
/// If there is none, or the mesh is too large for it.
pub fn dual_norm_named<const N: usize>(
    name: &str,
    mesh: &Mesh<N>,
    r: usize,
) -> Result<Box<dyn DualNorm<N>>, Error> {
    let kind = Kind::<N>::named(name);
    let kind = kind.ok_or_else(|| Error::Solver(format!("there is no norm {name}")))?;
    (kind.new)(&Setting::new(mesh, (kind.degree)(r)))
}

/// Rules with which the functionals of a metric of degree r are integrated.
pub fn rules(n: usize, r: usize) -> Rules {
    Rules::new(n, 2 * (r + 2) + 2)
}

/// ‖(Rω)_dist(g_h) − (Rω)(g)‖ in a dual norm.
pub fn error<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    g_h: &ReggeFunction<f64, N>,
    norm: &dyn DualNorm<N>,
    formulas: Formulas,
) -> Result<f64, Error> {
    let rules = rules(N, g_h.space().degree()).with_formulas(formulas);
    let mut load = distributional_curvature(g_h, norm.space(), &rules).total();
    let smooth = smooth_curvature(g, norm.space(), &rules);
    load.iter_mut().zip(smooth).for_each(|(l, s)| *l -= s);
    Ok(norm.of(&load, None)?.total)
}

/// The factors of the right side of eq. (convN2) and (convN3): the prefactor, and the norm of g_h − g.
pub fn right_side<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    g_h: &ReggeFunction<f64, N>,
) -> [f64; 2] {
    let order = 2 * g_h.space().degree() + 4;
    let distance = Distance::new(g.mesh(), &Combination::new(-1.0, g, 1.0, g_h), order);
    let power = if N == 2 { 0 } else { -1 };
    let prefactor = 1.0 + distance.sup(0, power - 1) + distance.sup(1, power);
    [prefactor, distance.weighted(if N == 2 { 1 } else { 2 })]
}

/// The canonical interpolant of g plus so much of a smooth tensor. (A multiple of g would be no bias for N = 2, where R ω does not change
/// with it.)
pub fn biased<const N: usize>(
    g: &Smooth<Metric, N>,
    r: usize,
    size: f64,
) -> Result<ReggeFunction<f64, N>, Error> {
    let tensor = Smooth::new(g.mesh(), Dome)?;
    let shifted = Combination::new(1.0, g, size, &tensor);
    let canonical = Interpolant::canonical().with_order(2 * r + 6);
    canonical.apply(&ReggeSpace::new(g.mesh(), r), &shifted)
}
