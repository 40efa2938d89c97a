//! Floor 5. From a field to a Regge function: the interpolants of the paper, in one table.
//!
//! | name | what agrees or is averaged | degrees |
//! |---|---|---|
//! | `canonical` | the canonical degrees of freedom of g and g_h agree | all |
//! | `average` | local L² projection, its canonical degrees of freedom averaged: the paper's appendix | all |
//! | `average-hierarchical` | local L² projection, its hierarchical coefficients averaged: the printed tables | all |
//! | `geodesic` | the edge lengths are geodesic distances | 0 |
//!
//! What lists interpolants, or knows them by name, reads [`Interpolant::ALL`]. A new one is a file of its own, a line in
//! the table (`table.rs`) and a line in `Interpolant::coefficients`, on which the compiler insists
//! (docs/how-to/interpolant.md).

mod average;
mod canonical;
mod curve;
mod geodesic;
mod hierarchical;
mod projection;
mod table;

pub use canonical::Canonical;
pub use geodesic::geodesic_length;

use crate::Error;
use crate::field::{Evaluate, TensorField};
use crate::quadrature::Rule;
use crate::spaces::{ReggeFunction, ReggeSpace, check_positive};
use projection::LocalProjection;
use table::{Method, TABLE};

/// Chooses the rule of the local projection from the dimension N and the degree r.
pub type ProjectionRule = fn(dimension: usize, degree: usize) -> Result<Rule, Error>;

/// How a Regge metric g_h is made from a metric g.
///
/// ```
/// use regge_curvature::interpolate::Interpolant;
/// use regge_curvature::mesh::Mesh;
/// use regge_curvature::metrics::{Metric, Smooth};
/// use regge_curvature::spaces::ReggeSpace;
///
/// # fn main() -> Result<(), regge_curvature::Error> {
/// let mesh = Mesh::<2>::cube(2)?;
/// let space = ReggeSpace::new(&mesh, 1);
/// let g = Smooth::new(&mesh, Metric::Sphere)?;
/// let g_h = Interpolant::canonical().apply(&space, &g)?;
/// // The same by its name, with integrals by rules of another order.
/// let by_name = Interpolant::named("canonical").expect("a name of the table");
/// let same = by_name.with_order(20).apply(&space, &g)?;
/// assert!((g_h.coefficients()[0] - same.coefficients()[0]).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Interpolant {
    method: Method,
    order: Option<usize>,
    rule: Option<ProjectionRule>,
}

impl Interpolant {
    /// All of them, in the order of the table.
    pub const ALL: [Self; TABLE.len()] = {
        let mut all = [Self::canonical(); TABLE.len()];
        let mut i = 0;
        while i < TABLE.len() {
            all[i] = Self::of(TABLE[i].method);
            i += 1;
        }
        all
    };

    const fn of(method: Method) -> Self {
        Self {
            method,
            order: None,
            rule: None,
        }
    }

    /// The canonical degrees of freedom of g and g_h agree: moments of q_ab on edges, faces, …, cells.
    /// For r = 0, q_ab is kept in the mean on every edge. Paper: appendix; Li 2018.
    pub const fn canonical() -> Self {
        Self::of(Method::Canonical)
    }

    /// g is projected onto P_r on every cell, and the canonical degrees of freedom of the projections are averaged over
    /// the cells that share them. Paper: appendix, "the" interpolant of optimal order in L².
    pub const fn average() -> Self {
        Self::of(Method::Average)
    }

    /// g is projected onto P_r on every cell, and the coefficients of the projections in a hierarchical basis of edge,
    /// face and cell functions are averaged over the cells that share them. Paper: tables and figures of section 5, which
    /// were computed by this one. It is [`Interpolant::average`] for r = 0 and another interpolant for every r ≥ 1.
    pub const fn average_hierarchical() -> Self {
        Self::of(Method::AverageHierarchical)
    }

    /// The edge lengths of g_h are the geodesic distances of g between vertices: classical Regge calculus, r = 0 only.
    /// The field must have a formula in ℝ^N ([`Evaluate::ambient`]).
    pub const fn geodesic() -> Self {
        Self::of(Method::Geodesic)
    }

    /// The one of this name, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|one| one.name() == name)
    }

    /// Its name.
    pub fn name(&self) -> &'static str {
        self.method.record().name
    }

    /// What it does, in a line.
    pub fn about(&self) -> &'static str {
        self.method.record().about
    }

    /// Does it begin with a local L² projection, so that [`Interpolant::projected_by`] makes sense?
    pub fn projects(&self) -> bool {
        self.method.record().projects
    }

    /// Is it the same as another, by whatever rules they integrate?
    pub fn is(&self, other: &Self) -> bool {
        self.method == other.method
    }

    /// The order of the rules by which g is integrated unless another is asked for: 2r + 12, with which moments and
    /// projections of a smooth metric are there to rounding on meshes that resolve it.
    pub const fn default_order(degree: usize) -> usize {
        2 * degree + 12
    }

    /// With g integrated by rules of this order, on edges to cells or in the local projection.
    pub const fn with_order(self, order: usize) -> Self {
        Self {
            order: Some(order),
            ..self
        }
    }

    /// With the local projection by a rule of one's own, for the rules behind printed numbers. A rule of as many points
    /// as dim P_r interpolates there.
    pub const fn projected_by(self, rule: ProjectionRule) -> Self {
        Self {
            rule: Some(rule),
            ..self
        }
    }

    /// Is it there for Regge metrics of this degree?
    ///
    /// # Errors
    /// Says in one line for which degrees it is.
    pub fn check_degree(&self, degree: usize) -> Result<(), Error> {
        match self.method.record().highest_degree {
            Some(highest) if degree > highest => Err(Error::Input(format!(
                "the {} interpolant has degree {highest}, not {degree}",
                self.name()
            ))),
            _ => Ok(()),
        }
    }

    /// g_h.
    ///
    /// # Errors
    /// If the degree is none of its, or g lacks the formula that it needs; if g or g_h is not positive definite at the
    /// points of a rule of order 2r + 2 (named by cell and point), an edge has no geodesic (named by its vertices), or
    /// the projection's rule has too few points.
    pub fn apply<const N: usize, G: TensorField<N, Scalar = f64>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Result<ReggeFunction<f64, N>, Error> {
        self.check_degree(space.degree())?;
        self.check_settings()?;
        let rule = Rule::new(N, 2 * space.degree() + 2);
        if self.method != Method::Geodesic {
            // Geodesics look at g along their way, and name the edge.
            check_positive(g, space.mesh(), rule.points())?;
        }
        let function = space.function(self.coefficients(space, g)?)?;
        function.check_positive(rule.points())?;
        Ok(function)
    }

    /// What has no projection must not be told how to project, and a geodesic settles by itself.
    fn check_settings(&self) -> Result<(), Error> {
        let refuse = |what: &str| {
            let reason = format!("the {} interpolant has no {what}", self.name());
            Err(Error::Input(reason))
        };
        match (self.rule.is_some(), self.order.is_some()) {
            (true, _) if !self.projects() => refuse("local projection"),
            (_, true) if self.method == Method::Geodesic => refuse("order of integration"),
            _ => Ok(()),
        }
    }

    fn coefficients<const N: usize, G: TensorField<N, Scalar = f64>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Result<Vec<f64>, Error> {
        let projected = || Ok(self.projection::<N>(space.degree())?.project(space, g));
        match self.method {
            Method::Canonical => {
                let order = self.order_for(space.degree());
                Ok(canonical::coefficients(space, g, order))
            }
            Method::Average => Ok(average::coefficients(space, &projected()?)),
            Method::AverageHierarchical => hierarchical::coefficients(space, &projected()?),
            Method::Geodesic => geodesic::coefficients(space, self.formula(g)?),
        }
    }

    fn order_for(&self, degree: usize) -> usize {
        self.order.unwrap_or(Self::default_order(degree))
    }

    fn projection<const N: usize>(&self, degree: usize) -> Result<LocalProjection, Error> {
        let rule = match self.rule {
            Some(rule) => rule(N, degree)?,
            None => Rule::new(N, self.order_for(degree)),
        };
        LocalProjection::by::<N>(rule, degree)
    }

    fn formula<'a, const N: usize, G: Evaluate<f64, N>>(
        &self,
        g: &'a G,
    ) -> Result<&'a dyn crate::field::Ambient<N>, Error> {
        g.ambient().ok_or_else(|| {
            let name = self.name();
            Error::Input(format!(
                "the {name} interpolant needs a formula in ℝ^{N}, which this field does not have"
            ))
        })
    }
}
