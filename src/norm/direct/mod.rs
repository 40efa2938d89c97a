//! The direct solver: bubbles condensed cell by cell, then a sparse Cholesky factorisation.

mod dissection;
mod unknowns;

use super::dual::{Representative, Step};
use super::hhj::{Hhj, Size};
use super::solver::BiharmonicSolver;
use crate::Error;
use crate::parallel::in_order;
use crate::sparse::{Factor, Lower};
use std::sync::Arc;
use unknowns::Unknowns;

/// How many cells' matrices are held at a time.
const CHUNK: usize = 1024;

/// A Cholesky factorisation of the condensed system. Its bits do not depend on the number of threads.
#[derive(Debug)]
pub struct Direct<const N: usize> {
    hhj: Arc<Hhj<N>>,
    /// Where in a solution the unknowns of the factor are.
    places: Vec<usize>,
    /// The columns of the bubbles in each cell's elimination, cell after cell.
    bubbles: Vec<f64>,
    /// None where no unknown is left.
    factor: Option<Factor>,
}

impl<const N: usize> Direct<N> {
    /// Assembles and factorises; many loads can be solved for afterwards. The discretisation is taken as it is or shared.
    ///
    /// # Errors
    /// If memory does not suffice, or rounding makes the system indefinite (cells that are all but flat).
    pub fn new(hhj: impl Into<Arc<Hhj<N>>>) -> Result<Self, Error> {
        let hhj = hhj.into();
        let (mesh, layout) = (hhj.mesh(), hhj.layout());
        let unknowns = Unknowns::new(mesh, layout, &hhj.centres());
        let blocks = |cell| unknowns.of_cell(mesh, layout, cell);
        let mut matrix = Lower::new(unknowns.offsets.clone(), mesh.cell_count(), &blocks)?;
        let mut places = vec![0; unknowns.len()];
        let mut bubbles = Vec::with_capacity(mesh.cell_count() * layout.bubbles * layout.len);
        for begin in (0..mesh.cell_count()).step_by(CHUNK) {
            let count = CHUNK.min(mesh.cell_count() - begin);
            in_order(
                count,
                |i| hhj.condensed(begin + i),
                |i, local| {
                    let (cell, blocks) = (begin + i, blocks(begin + i));
                    bubbles.extend_from_slice(&local.as_slice()[..layout.bubbles * layout.len]);
                    unknowns.locate(&blocks, &hhj.cell_unknowns(cell), &mut places);
                    matrix.add(&blocks, &local);
                },
            );
        }
        let factor = match places.is_empty() {
            true => None,
            false => Some(Factor::new(&matrix)?),
        };
        Ok(Self {
            hhj,
            places,
            bubbles,
            factor,
        })
    }

    /// The bubbles of each cell with their columns of L: (indices in a solution, column after column).
    fn eliminations(&self) -> impl Iterator<Item = (Vec<usize>, &[f64])> {
        let layout = self.hhj.layout();
        let size = layout.bubbles * layout.len;
        let cells = match size == 0 {
            true => 0,
            false => self.hhj.mesh().cell_count(),
        };
        (0..cells).map(move |cell| {
            let lower = &self.bubbles[cell * size..(cell + 1) * size];
            (self.hhj.cell_unknowns(cell), lower)
        })
    }

    /// L y = f for the bubbles of all cells, and what they hand on to the other unknowns.
    fn eliminate_bubbles(&self, x: &mut [f64]) {
        let (bubbles, len) = (self.hhj.layout().bubbles, self.hhj.layout().len);
        for (index, lower) in self.eliminations() {
            for j in 0..bubbles {
                x[index[j]] /= lower[j * len + j];
                for i in j + 1..len {
                    x[index[i]] -= lower[j * len + i] * x[index[j]];
                }
            }
        }
    }

    /// Lᵀ x = y for the bubbles of all cells, where the other unknowns are there.
    fn substitute_bubbles(&self, y: &[f64], x: &mut [f64]) {
        let (bubbles, len) = (self.hhj.layout().bubbles, self.hhj.layout().len);
        for (index, lower) in self.eliminations() {
            for j in (0..bubbles).rev() {
                let sum: f64 = (j + 1..len).map(|i| lower[j * len + i] * x[index[i]]).sum();
                x[index[j]] = (y[index[j]] - sum) / lower[j * len + j];
            }
        }
    }
}

impl<const N: usize> BiharmonicSolver<N> for Direct<N> {
    fn hhj(&self) -> &Hhj<N> {
        &self.hhj
    }

    fn name(&self) -> &'static str {
        "cholesky"
    }

    fn solve(&self, load: &[f64], _: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        assert_eq!(
            load.len(),
            self.hhj.space().len(),
            "a load of another space"
        );
        let mut y = load.to_vec();
        y.resize(self.hhj.len(), 0.0);
        self.eliminate_bubbles(&mut y);
        let mut rest: Vec<f64> = self.places.iter().map(|&place| y[place]).collect();
        if let Some(factor) = &self.factor {
            factor.solve(&mut rest);
        }
        let mut coefficients = vec![0.0; self.hhj.len()];
        for (&place, value) in self.places.iter().zip(&rest) {
            coefficients[place] = *value;
        }
        self.substitute_bubbles(&y, &mut coefficients);
        Ok(Representative { coefficients })
    }
}

/// The bytes that a factorisation with its assembly takes after nested dissection: n log n entries in the plane, with a
/// constant that was measured, n^(4/3) in space, where the direct solver is for small meshes only.
pub(super) fn memory(size: &Size) -> f64 {
    let unknowns = size.unknowns() as f64;
    8.0 * match size.dimension() {
        2 => 15.0 * unknowns * unknowns.max(2.0).log2(),
        _ => 12.0 * unknowns.powf(4.0 / 3.0),
    }
}
