//! Floor 3. Clamped splines as functions on a mesh, for the norms of section 4.

use crate::best::HELD;
use crate::norms::Basis;
use crate::splines::Clamped;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::mesh::Mesh;
use regge_curvature::simplex::Points;
use std::borrow::Cow;

/// Splines of H²_0 on the mesh of their grid.
pub struct OnMesh<'a, const N: usize> {
    /// The splines.
    pub splines: &'a Clamped<N>,
    /// The mesh of their grid, or a refinement of it.
    pub mesh: &'a Mesh<N>,
}

impl<const N: usize> OnMesh<'_, N> {
    fn place(&self, cell: usize, lambda: &[f64]) -> Vector<f64, N> {
        let corner = |i: usize| self.mesh.corner(cell, i).expect("there are coordinates");
        (0..=N).map(|i| corner(i) * lambda[i]).sum()
    }

    fn box_of(&self, cell: usize) -> [usize; N] {
        let centre = self.place(cell, &vec![1.0 / (N + 1) as f64; N + 1]);
        self.splines.box_of(&centre)
    }
}

impl<const N: usize> Basis<N> for OnMesh<'_, N> {
    type Table = Points;

    fn size(&self) -> usize {
        self.splines.len()
    }

    fn on(&self, cell: usize) -> Vec<usize> {
        let all = self.splines.on_box(self.box_of(cell)).into_iter();
        all.map(|number| number.unwrap_or(HELD)).collect()
    }

    fn table(&self, points: &Points) -> Points {
        points.clone()
    }

    fn jets<'t>(&self, cell: usize, table: &'t Points, point: usize) -> Cow<'t, [Jet2<f64, N>]> {
        let x = self.place(cell, table.lambda(point));
        let jacobian = self.mesh.jacobian(cell).expect("there are coordinates");
        let pulled_back = |v: Jet2<f64, N>| {
            let d = jacobian.transpose() * Vector::<f64, N>::from(v.d);
            let dd = jacobian.transpose() * Mat::<f64, N>::from(v.dd) * jacobian;
            Jet2 {
                value: v.value,
                d: d.into(),
                dd: dd.into(),
            }
        };
        let all = self.splines.jets(self.box_of(cell), &x).into_iter();
        Cow::Owned(all.map(pulled_back).collect())
    }
}
