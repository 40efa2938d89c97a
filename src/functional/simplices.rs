//! What single simplices have: the volume of cells, the angle defect and the size of hinges.

use super::Rules;
use super::measure::{Density, Where};
use super::seen::{OnCell, Seen, all_sites, weights};
use super::walk::pair;
use crate::field::{Evaluate, TensorField};
use crate::formulas::PAPER;
use crate::mesh::Mesh;
use crate::parallel::collect;
use crate::scalar::Real;
use crate::spaces::{Indicators, Scalar};
use std::f64::consts::TAU;

/// An interior hinge S with its defect and its size.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HingeDefect {
    /// Its number in the mesh.
    pub hinge: usize,
    /// Θ_S = 2π − Σ_T θ_ST at its barycentre, in radians.
    pub defect: f64,
    /// |S| = ∫_S ω_S; 1 when N = 2.
    pub size: f64,
}

/// Θ_S at the barycentre and |S|, by a rule of this order, of each interior hinge in the order of the mesh.
pub fn angle_defects<const N: usize, G: TensorField<N, Scalar = f64>>(
    g: &G,
    mesh: &Mesh<N>,
    order: usize,
) -> Vec<HingeDefect> {
    let (middle, around) = (Rules::new(N, 1), Rules::new(N, order));
    let hinges: Vec<usize> = mesh.interior_hinges().collect();
    let at = Seen::<f64, N, G>::new(g, &all_sites(N, &middle), &PAPER);
    let along = Seen::<f64, N, G>::new(g, &all_sites(N, &around), &PAPER);
    let weights = weights::<f64>(&around.hinges);
    collect(hinges.len(), |i| {
        let hinge = hinges[i];
        let angle = |side: crate::mesh::Side| {
            let local = at.on_cell(side.cell);
            at.corner(&local, side.place, 0, |corner| corner.angle())
        };
        let first = mesh.first_side(N - 2, hinge);
        let local = along.on_cell(first.cell);
        let size = |(block, weight): (usize, &f64)| {
            along.corner(&local, first.place, block, |corner| corner.omega()) * weight
        };
        HingeDefect {
            hinge,
            defect: TAU - mesh.star(N - 2, hinge).map(angle).sum::<f64>(),
            size: weights.iter().enumerate().map(size).sum(),
        }
    })
}

/// ∫_T ω of every cell: its volume.
pub fn cell_volumes<const N: usize, G: TensorField<N>>(
    g: &G,
    mesh: &Mesh<N>,
    rules: &Rules,
) -> Vec<G::Scalar> {
    volumes::<G::Wide, N, G>(g, mesh, rules)
}

fn volumes<T: Real, const N: usize, G: Evaluate<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rules: &Rules,
) -> Vec<T::Sum> {
    let density = Volumes::<T, N, G>(Seen::new(g, &all_sites(N, rules), &rules.formulas));
    let each = Indicators::new(mesh);
    let sums = pair(mesh, &density, Where::Interior, &[&each], rules);
    let mut cells = sums
        .into_iter()
        .next()
        .expect("one space, one result")
        .cells;
    cells.truncate(mesh.cell_count());
    cells
}

/// ω in cells alone.
struct Volumes<'a, T: Real, const N: usize, G: Evaluate<T, N>>(Seen<'a, T, N, G>);

impl<T: Real, const N: usize, G: Evaluate<T, N>> Density<T, N> for Volumes<'_, T, N, G> {
    type Value = Scalar;
    type Local = OnCell<G::Local, T, N>;

    fn sums(&self) -> [bool; 3] {
        [true, false, false]
    }

    fn is_constant_on_hinges(&self) -> bool {
        self.0.g.is_constant()
    }

    fn full_angle(&self) -> T {
        T::zero()
    }

    fn on_cell(&self, cell: usize) -> Self::Local {
        self.0.on_cell(cell)
    }

    fn in_cell(&self, at: &Self::Local, block: usize, out: &mut [T]) {
        out[0] = self.0.volume(at, block);
    }

    fn on_face(&self, _: &Self::Local, _: usize, _: usize, _: &mut [T]) {
        unreachable!("there is no sum over faces")
    }

    fn at_hinge(&self, _: &Self::Local, _: usize, _: usize, _: Option<&mut [T]>) -> T {
        unreachable!("there is no sum over hinges")
    }
}
