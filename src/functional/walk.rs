//! The walk over the cells: a measure is evaluated once, cell by cell, and paired with as many test spaces as there are.
//!
//! Cells are evaluated in batches and by several threads; their contributions are added up in the order of the cells, so that
//! the sums do not depend on the number of threads.

use super::measure::{CellByCell, Cells, Density, Part, Where};
use super::pairing::Pairing;
use super::seen::all_sites;
use super::{Rules, Sums};
use crate::mesh::Mesh;
use crate::parallel::rows_in_order;
use crate::scalar::{Field, Real};
use crate::spaces::{TestSpace, Value};

/// What a thread needs for a cell.
struct Room<T> {
    densities: Vec<T>,
    acc: Vec<T>,
}

/// ∫ v dμ for the measure μ of this density and every function v of every space, evaluated once.
pub(super) fn pair<T: Real, D: Density<T, N>, const N: usize>(
    mesh: &Mesh<N>,
    density: &D,
    on: Where,
    spaces: &[&dyn TestSpace<N, Value = D::Value>],
    rules: &Rules,
) -> Vec<Sums<T::Sum>> {
    let cells = Cells::new::<T>(mesh, density, on, rules);
    gather::<T, D::Value, N>(mesh.cell_count(), &cells, spaces, rules)
}

/// The same, the kind of density forgotten.
fn gather<T: Real, V: Value, const N: usize>(
    count: usize,
    cells: &dyn CellByCell<T>,
    spaces: &[&dyn TestSpace<N, Value = V>],
    rules: &Rules,
) -> Vec<Sums<T::Sum>> {
    let (sites, parts) = (all_sites(N, rules), cells.parts());
    let pairings: Vec<Pairing<T>> = (spaces.iter())
        .map(|space| Pairing::new(*space, &sites, rules, parts))
        .collect();
    let room = || Room {
        densities: vec![T::zero(); parts.iter().map(Part::len).sum()],
        acc: Vec::new(),
    };
    let on_cell = |cell: usize, mut row: &mut [T::Sum], room: &mut Room<T>| {
        cells.evaluate(cell, &mut room.densities);
        for pairing in &pairings {
            let own = row
                .split_off_mut(..pairing.width())
                .expect("a row has all widths");
            pairing.row(parts, &room.densities, &mut room.acc, own);
        }
    };
    let mut sums: Vec<Sums<T::Sum>> = spaces.iter().map(|s| Sums::zero(s.len())).collect();
    let width = pairings.iter().map(Pairing::width).sum();
    if width == 0 {
        // A measure without any density: R of what is constant.
        return sums;
    }
    let mut dofs = Vec::new();
    let zero = T::Sum::zero();
    rows_in_order(count, width, zero, room, on_cell, |cell, mut row| {
        for ((space, pairing), sums) in spaces.iter().zip(&pairings).zip(&mut sums) {
            let own = row
                .split_off(..pairing.width())
                .expect("a row has all widths");
            dofs.clear();
            space.push_dofs(cell, &mut dofs);
            let lists = [&mut sums.cells, &mut sums.faces, &mut sums.hinges];
            let present = lists
                .into_iter()
                .zip(parts)
                .filter(|(_, part)| part.present);
            for ((sum, _), own) in present.zip(own.chunks_exact(dofs.len())) {
                for (&dof, value) in dofs.iter().zip(own) {
                    sum[dof] += *value;
                }
            }
        }
    });
    sums
}
