//! The walk over the cells: a measure is evaluated once, cell by cell, and paired with as many test spaces as there are.
//!
//! Cells are evaluated in batches and by several threads; their contributions are added up in the order of the cells, so that
//! the sums do not depend on the number of threads. Hinges come last, when all angles around them are known.

use super::around::Around;
use super::measure::{CellByCell, Cells, Density, Part, Where};
use super::pairing::Pairing;
use super::seen::all_sites;
use super::{Rules, Sums};
use crate::mesh::Mesh;
use crate::parallel::{rows_in_order, two_rows_in_order};
use crate::scalar::{Field, Real};
use crate::spaces::{TestSpace, Value};

/// ∫ v dμ for the measure μ of this density and every function v of every space, evaluated once.
pub(super) fn pair<T: Real, D: Density<T, N>, const N: usize>(
    mesh: &Mesh<N>,
    density: &D,
    on: Where,
    spaces: &[&dyn TestSpace<N, Value = D::Value>],
    rules: &Rules,
) -> Vec<Sums<T::Sum>> {
    let cells = Cells::new::<T>(mesh, density, on, rules);
    let (sites, parts) = (all_sites(N, rules), *cells.parts());
    let pairing =
        |space: &&dyn TestSpace<N, Value = D::Value>| Pairing::new(*space, &sites, rules, &parts);
    let tested = Tested {
        mesh,
        spaces,
        pairings: spaces.iter().map(pairing).collect(),
        parts,
    };
    let mut sums: Vec<Sums<T::Sum>> = spaces.iter().map(|s| Sums::zero(s.len())).collect();
    let around = tested.cells_and_faces(&cells, &mut sums);
    if parts[2].present {
        tested.hinges(&around, on, &mut sums);
    }
    sums
}

/// The functions of test spaces and their traces.
struct Tested<'a, T, V, const N: usize> {
    mesh: &'a Mesh<N>,
    spaces: &'a [&'a dyn TestSpace<N, Value = V>],
    pairings: Vec<Pairing<T>>,
    parts: [Part; 3],
}

/// What a thread needs for a cell.
struct Room<T> {
    densities: Vec<T>,
    acc: Vec<T>,
}

impl<T: Real, V: Value, const N: usize> Tested<'_, T, V, N> {
    /// Adds the sums over cells and faces, and gathers what there is around hinges.
    fn cells_and_faces(&self, cells: &dyn CellByCell<T>, sums: &mut [Sums<T::Sum>]) -> Around<T> {
        let [_, _, hinges] = &self.parts;
        let mut around = Around::new(self.mesh, hinges, cells.full_angle());
        let width = self.pairings.iter().map(Pairing::width).sum();
        let hinges = (around.width(), T::zero());
        let room = || Room {
            densities: vec![T::zero(); self.parts[..2].iter().map(Part::len).sum()],
            acc: Vec::new(),
        };
        let on_cell =
            |cell: usize, mut row: &mut [T::Sum], hinges: &mut [T], room: &mut Room<T>| {
                cells.evaluate(cell, &mut room.densities, hinges);
                for pairing in &self.pairings {
                    let own = split(&mut row, pairing.width());
                    pairing.row(&self.parts, &room.densities, &mut room.acc, own);
                }
            };
        let mut dofs = Vec::new();
        let add = |cell: usize, row: &[T::Sum], hinges: &[T]| {
            self.add(cell, row, &mut dofs, sums);
            around.add(self.mesh, cell, hinges);
        };
        if width + hinges.0 > 0 {
            let (row, count) = ((width, T::Sum::zero()), self.mesh.cell_count());
            two_rows_in_order(count, row, hinges, room, on_cell, add);
        }
        around
    }

    /// Adds a row of a cell to the sums over cells and faces.
    fn add(
        &self,
        cell: usize,
        mut row: &[T::Sum],
        dofs: &mut Vec<usize>,
        sums: &mut [Sums<T::Sum>],
    ) {
        if row.is_empty() {
            return;
        }
        for ((space, pairing), sums) in self.spaces.iter().zip(&self.pairings).zip(sums) {
            let own = row
                .split_off(..pairing.width())
                .expect("a row has all widths");
            dofs.clear();
            space.push_dofs(cell, dofs);
            let lists = [&mut sums.cells, &mut sums.faces].into_iter();
            let present = lists.zip(&self.parts).filter(|(_, part)| part.present);
            for ((sum, _), own) in present.zip(own.chunks_exact(dofs.len())) {
                for (&dof, value) in dofs.iter().zip(own) {
                    sum[dof] += *value;
                }
            }
        }
    }

    /// Adds the sums over hinges.
    fn hinges(&self, around: &Around<T>, on: Where, sums: &mut [Sums<T::Sum>]) {
        let all = 0..self.mesh.count(N - 2);
        let hinges: Vec<usize> = all
            .filter(|&hinge| on.has(self.mesh.is_interior(N - 2, hinge)))
            .collect();
        let room = || Room {
            densities: Vec::new(),
            acc: Vec::new(),
        };
        let on_hinge = |i: usize, mut row: &mut [T::Sum], room: &mut Room<T>| {
            around.densities(hinges[i], &mut room.densities);
            for pairing in &self.pairings {
                let own = split(&mut row, pairing.on_hinge(0).len());
                pairing.hinge_row(&room.densities, &mut room.acc, own);
            }
        };
        let mut dofs = Vec::new();
        let add = |i: usize, mut row: &[T::Sum]| {
            let side = self.mesh.first_side(N - 2, hinges[i]);
            for ((space, pairing), sums) in self.spaces.iter().zip(&self.pairings).zip(&mut *sums) {
                dofs.clear();
                space.push_dofs(side.cell, &mut dofs);
                let numbers = pairing.on_hinge(side.place);
                let own = row
                    .split_off(..numbers.len())
                    .expect("a row has all widths");
                for (&number, value) in numbers.iter().zip(own) {
                    sums.hinges[dofs[number]] += *value;
                }
            }
        };
        let width = self.pairings.iter().map(|p| p.on_hinge(0).len()).sum();
        rows_in_order(hinges.len(), width, T::Sum::zero(), room, on_hinge, add);
    }
}

/// The next entries of a row.
fn split<'a, S>(row: &mut &'a mut [S], width: usize) -> &'a mut [S] {
    row.split_off_mut(..width).expect("a row has all widths")
}
