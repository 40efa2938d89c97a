//! The direct solver: bubbles condensed cell by cell, then a sparse Cholesky factorisation.

use super::cell::eliminate;
use super::factor::Factor;
use super::hhj::{Deflection, Hhj};
use super::sparse::Upper;
use super::unknowns::Unknowns;
use super::{BiharmonicSolver, Step};
use crate::Error;
use crate::parallel::in_order;

/// How many cells' matrices are held at a time.
const CHUNK: usize = 1024;

/// A Cholesky factorisation of the condensed system. Its bits do not depend on the number of threads.
#[derive(Debug)]
pub struct Direct {
    /// Where in a [`Deflection`] the unknowns of the factor are.
    places: Vec<usize>,
    /// The columns of the bubbles in each cell's elimination, cell after cell.
    bubbles: Vec<f64>,
    /// None where no unknown is left.
    factor: Option<Factor>,
}

impl Direct {
    /// Assembles and factorises; many loads can be solved for afterwards.
    ///
    /// # Errors
    /// If memory does not suffice, or rounding makes the system indefinite (cells that are all but flat).
    pub fn new<const N: usize>(hhj: &Hhj<N>) -> Result<Self, Error> {
        let (mesh, layout) = (hhj.mesh(), hhj.layout());
        let unknowns = Unknowns::new(mesh, layout, &hhj.centres());
        let mut matrix = Upper::new(mesh, layout, &unknowns);
        let mut places = vec![0; unknowns.len()];
        let mut bubbles = Vec::with_capacity(mesh.cell_count() * layout.bubbles * layout.len);
        for begin in (0..mesh.cell_count()).step_by(CHUNK) {
            let eliminated = |i: usize| {
                let mut energy = hhj.energy(begin + i);
                eliminate(&mut energy, layout.bubbles);
                energy
            };
            in_order(
                CHUNK.min(mesh.cell_count() - begin),
                eliminated,
                |i, local| {
                    let cell = begin + i;
                    bubbles.extend_from_slice(&local.as_slice()[..layout.bubbles * layout.len]);
                    let blocks: Vec<_> = unknowns.of_cell(mesh, layout, cell).collect();
                    unknowns.locate(layout, &blocks, &hhj.cell_unknowns(cell), &mut places);
                    matrix.add(layout, &unknowns, &blocks, &local);
                },
            );
        }
        let factor = if places.is_empty() {
            None
        } else {
            Some(Factor::new(&matrix)?)
        };
        Ok(Self {
            places,
            bubbles,
            factor,
        })
    }

    /// The bubbles of each cell with their columns of L: (indices in a [`Deflection`], column after column).
    fn eliminations<const N: usize>(
        &self,
        hhj: &Hhj<N>,
    ) -> impl Iterator<Item = (Vec<usize>, &[f64])> {
        let size = hhj.layout().bubbles * hhj.layout().len;
        let cells = if size == 0 {
            0
        } else {
            hhj.mesh().cell_count()
        };
        (0..cells).map(move |cell| {
            (
                hhj.cell_unknowns(cell),
                &self.bubbles[cell * size..(cell + 1) * size],
            )
        })
    }
}

impl<const N: usize> BiharmonicSolver<N> for Direct {
    fn name(&self) -> &'static str {
        "cholesky"
    }

    fn solve(
        &self,
        hhj: &Hhj<N>,
        load: &[f64],
        _: &mut dyn FnMut(Step),
    ) -> Result<Deflection, Error> {
        let (bubbles, len) = (hhj.layout().bubbles, hhj.layout().len);
        let mut x = load.to_vec();
        x.resize(hhj.len(), 0.0);
        // L y = f for the bubbles, and what they hand on to the others.
        for (index, lower) in self.eliminations(hhj) {
            for j in 0..bubbles {
                x[index[j]] /= lower[j * len + j];
                for i in j + 1..len {
                    x[index[i]] -= lower[j * len + i] * x[index[j]];
                }
            }
        }
        let mut rest: Vec<f64> = self.places.iter().map(|&place| x[place]).collect();
        if let Some(factor) = &self.factor {
            factor.solve(&mut rest);
        }
        let mut coefficients = vec![0.0; hhj.len()];
        for (&place, value) in self.places.iter().zip(&rest) {
            coefficients[place] = *value;
        }
        // Lᵀ x = y for the bubbles.
        for (index, lower) in self.eliminations(hhj) {
            for j in (0..bubbles).rev() {
                let sum: f64 = (j + 1..len)
                    .map(|i| lower[j * len + i] * coefficients[index[i]])
                    .sum();
                coefficients[index[j]] = (x[index[j]] - sum) / lower[j * len + j];
            }
        }
        Ok(Deflection { coefficients })
    }
}
