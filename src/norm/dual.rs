//! The seam for norms of functionals, and what every such norm speaks of.

use crate::Error;
use crate::quadrature::Rule;
use crate::spaces::Lagrange;

/// A norm ‖f‖ of functionals f, dual to a Hilbert norm of functions on a mesh in ℝ^N.
///
/// A functional is given by its *load*, the numbers f(v) for the basis functions v of [`DualNorm::space`]. Such a norm is
/// taken in two steps: a boundary value problem is solved for the function u that represents f (Riesz), and u is measured.
/// A norm is set up once, for as many functionals as you like; [`super::Kind`] makes those that have a name.
///
/// ```
/// use regge_curvature::mesh::Mesh;
/// use regge_curvature::norm::{DualNorm, Kind, Setting};
///
/// # fn main() -> Result<(), regge_curvature::Error> {
/// let mesh = Mesh::<2>::cube(4)?;
/// let kind = Kind::named("hm2").expect("the norm of the paper's tables");
/// // For the curvature of a Regge metric of degree 1.
/// let norm = (kind.new)(&Setting::new(&mesh, (kind.degree)(1)))?;
/// let load = vec![1.0; norm.space().len()];
/// let value = norm.of(&load, None)?;
/// assert!(value.total > 0.0);
/// let names: Vec<_> = value.parts.iter().map(|part| part.name).collect();
/// assert_eq!(names, ["u_l2", "grad_l2", "sigma_l2"]);
/// # Ok(())
/// # }
/// ```
pub trait DualNorm<const N: usize>: std::fmt::Debug + Send + Sync {
    /// The space of the test functions v: a load has an entry for each basis function. Whether those count that do not
    /// vanish on ∂Ω is the norm's affair.
    fn space(&self) -> &Lagrange<N>;

    /// What solves the problem, as reports call it.
    fn solver(&self) -> &'static str;

    /// How many unknowns the problem has, clamped ones included: the test functions, if the norm has no others.
    fn unknowns(&self) -> usize {
        self.space().len()
    }

    /// The function that represents the functional with this load. An iterative solver tells `watch` of each of its steps.
    ///
    /// # Errors
    /// If the load has the wrong length or an entry that is not finite, or the solver gives up.
    fn represent(&self, load: &[f64], watch: &mut dyn FnMut(Step))
    -> Result<Representative, Error>;

    /// The norm of the functional that has this representative. Integrals are by `rule`, exact if there is none.
    ///
    /// # Errors
    /// If the representative is of another norm, or the rule is not one for N-simplices.
    fn measure(
        &self,
        representative: &Representative,
        rule: Option<&Rule>,
    ) -> Result<NormValue, Error>;

    /// ‖f‖ for the functional with this load.
    ///
    /// # Errors
    /// As [`DualNorm::represent`] and [`DualNorm::measure`].
    fn of(&self, load: &[f64], rule: Option<&Rule>) -> Result<NormValue, Error> {
        self.measure(&self.represent(load, &mut |_| ())?, rule)
    }
}

/// The function that represents a functional, by its coefficients; which these are is said by the norm that made it.
#[derive(Clone, Debug, PartialEq)]
pub struct Representative {
    /// The coefficients; first those in the basis of [`DualNorm::space`].
    pub coefficients: Vec<f64>,
}

/// A norm with the parts that it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct NormValue {
    /// ‖f‖.
    pub total: f64,
    /// Its parts, in the order in which the norm names them.
    pub parts: Vec<Part>,
}

/// A part of a norm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its name, as in reports: `grad_l2` for ‖∇u‖ in L².
    pub name: &'static str,
    /// It itself, not its square.
    pub value: f64,
}

impl NormValue {
    /// The norm whose square is the sum of the squares of its parts.
    pub fn of_parts(parts: Vec<Part>) -> Self {
        let squares: f64 = parts.iter().map(|part| part.value.powi(2)).sum();
        Self {
            total: squares.sqrt(),
            parts,
        }
    }
}

/// A step of an iterative solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its number, from 1.
    pub number: usize,
    /// The residual after it over that of u = 0, in the norm of the preconditioner: about the relative error of the
    /// solution in the norm of the energy, which for H⁻² is that of σ.
    pub residual: f64,
}

/// When an iterative solver stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// It is done when [`Step::residual`] is not larger than this.
    pub residual: f64,
    /// It gives up after this many steps.
    pub steps: usize,
}

impl Target {
    /// What the library's norms stop at. The residual is 10⁻⁸, since the error of ‖σ‖², which is the energy and minimal, is
    /// of the order of its square; 1000 steps are far more than any mesh needs.
    pub const DEFAULT: Self = Self {
        residual: 1e-8,
        steps: 1000,
    };

    /// How much of the way to the residual is done after a step, from 0 to 1: the residual falls by about the same factor in
    /// every step.
    pub fn share(&self, step: Step) -> f64 {
        (step.residual.ln() / self.residual.ln()).clamp(0.0, 1.0)
    }
}

impl Default for Target {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Refuses loads that are not of a space.
///
/// # Errors
/// If the load has the wrong length or an entry that is not finite.
pub fn check_load<const N: usize>(space: &Lagrange<N>, load: &[f64]) -> Result<(), Error> {
    let (length, functions) = (load.len(), space.len());
    if length != functions {
        let reason = format!("a load of length {length} for {functions} functions");
        return Err(Error::Input(reason));
    }
    match load.iter().position(|f| !f.is_finite()) {
        Some(dof) => Err(Error::Input(format!(
            "entry {dof} of the load is {}",
            load[dof]
        ))),
        None => Ok(()),
    }
}
