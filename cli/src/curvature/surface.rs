//! Formulas in the coordinates of space, on surfaces in it and on curved cells.

use super::{CurvatureError, input};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::spaces::{Immersed, Immersion, ReggeFunction, ReggeSpace};
use regge_readers::mesh::MeshFile;
use regge_readers::metric::MetricFile;

/// Is it a formula in the file's own coordinates, more than the mesh has dimensions, or on curved cells?
pub fn is_in_space(file: &MeshFile, metric: &MetricFile) -> bool {
    let more = metric.dimension == 3 && file.dimension == 2 && file.width == 3;
    more || (file.curved.is_some() && metric.dimension == file.dimension)
}

/// A dimension that a program is built for.
pub struct Dimension<const N: usize>;

/// The metric that a mesh inherits from a formula in space. Surfaces do, and only for them it is compiled.
pub trait InSpace<const N: usize> {
    /// The Regge interpolant of degree r of the formula, and the surface that it is on.
    ///
    /// # Errors
    /// Whether the input is to blame, and what is wrong where.
    fn interpolate(
        file: &MeshFile,
        metric: &MetricFile,
        interpolant: Interpolant,
        degree: usize,
    ) -> Result<(ReggeFunction<f64, N>, Immersion<N>), CurvatureError>;
}

impl InSpace<2> for Dimension<2> {
    fn interpolate(
        file: &MeshFile,
        metric: &MetricFile,
        interpolant: Interpolant,
        degree: usize,
    ) -> Result<(ReggeFunction<f64, 2>, Immersion<2>), CurvatureError> {
        let points = file.immersion::<2>()?;
        let g = Immersed::<_, 2, 3>::new(points, metric.in_space()).map_err(input)?;
        let space = ReggeSpace::new(g.immersion().mesh(), degree);
        let g_h = interpolant.apply(&space, &g).map_err(input)?;
        Ok((g_h, g.immersion().clone()))
    }
}

macro_rules! refuse {
    ($n:literal) => {
        impl InSpace<$n> for Dimension<$n> {
            fn interpolate(
                file: &MeshFile,
                _: &MetricFile,
                _: Interpolant,
                _: usize,
            ) -> Result<(ReggeFunction<f64, $n>, Immersion<$n>), CurvatureError> {
                Err(refused(file))
            }
        }
    };
}
refuse!(3);
refuse!(4);
refuse!(5);

/// A solid with curved cells.
fn refused(file: &MeshFile) -> CurvatureError {
    CurvatureError::Input(format!(
        "{}: formulas on curved cells are for dimension 2; without --metric the cells have the metric of their points",
        file.file.display()
    ))
}
