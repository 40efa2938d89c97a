//! From the smooth metric g to the Regge metric g_h, by name.

use super::Named;
use super::printed_rules::printed_rule;
use regge_curvature::Error;
use regge_curvature::interpolate::{Interpolant, Projection, geodesic_interpolant};
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// How g_h is made from g.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// The canonical degrees of freedom agree.
    Canonical,
    /// The paper's appendix: local L² projection, canonical degrees of freedom averaged.
    Average,
    /// What the printed tables used: local L² projection, hierarchical coefficients averaged.
    AverageHierarchical,
    /// Edge lengths are geodesic distances; degree 0 only.
    Geodesic,
}

impl Named for Interpolation {
    const KIND: &'static str = "interpolant";
    const ALL: &'static [(&'static str, Self)] = &[
        ("canonical", Self::Canonical),
        ("average", Self::Average),
        ("average-hierarchical", Self::AverageHierarchical),
        ("geodesic", Self::Geodesic),
    ];
}

/// The local L² projection inside the averages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionKind {
    /// To rounding where the mesh resolves g.
    Exact,
    /// By a rule of exactness 2r only, as in the printed tables.
    Discrete,
}

impl Named for ProjectionKind {
    const KIND: &'static str = "projection";
    const ALL: &'static [(&'static str, Self)] =
        &[("exact", Self::Exact), ("discrete", Self::Discrete)];
}

impl ProjectionKind {
    fn projection<const N: usize>(self, degree: usize) -> Result<Projection, Error> {
        Ok(match self {
            Self::Exact => Projection::exact::<N>(degree),
            Self::Discrete => Projection::by(printed_rule(N, 2 * degree)?),
        })
    }
}

impl Interpolation {
    /// Does a projection take part?
    pub fn is_average(self) -> bool {
        matches!(self, Self::Average | Self::AverageHierarchical)
    }

    /// g_h.
    ///
    /// # Errors
    /// If g or g_h is not positive definite (names cell and point), or an edge has no geodesic (names the edge).
    pub fn apply<M: SmoothTensor<N>, const N: usize>(
        self,
        space: &ReggeSpace<N>,
        g: &Smooth<M, N>,
        projection: ProjectionKind,
    ) -> Result<ReggeFunction<f64, N>, Error> {
        let degree = space.degree();
        let interpolant = match self {
            // As many points as the exact projection has.
            Self::Canonical => Interpolant::Canonical {
                order: 2 * degree + 12,
            },
            Self::Average => Interpolant::Average(projection.projection::<N>(degree)?),
            Self::AverageHierarchical => {
                Interpolant::AverageHierarchical(projection.projection::<N>(degree)?)
            }
            Self::Geodesic => return geodesic_interpolant(space, g.formula()),
        };
        interpolant.apply(space, g)
    }
}
