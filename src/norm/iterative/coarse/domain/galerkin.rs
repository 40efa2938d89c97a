//! The form on the finest lattice: ∫|∇²s|² on the boxes inside Ω, and the discrete form of what P makes of s on the cells that
//! are not covered by them, or are flat: what P makes of a spline costs more there than the spline.
//!
//! Cells that reach into the boxes inside count twice there. The sum is equivalent to the discrete form of P s, with constants
//! that do not depend on the mesh's size, and has stored rows near ∂Ω and flat cells only.

use super::super::patch::Patch;
use super::super::stencil::Short;
use super::super::transfer::Transfer;
use super::energy::Energy;
use super::forms::{AT_ONCE, CellForm, FormRoom, places, size};
use super::inside::Boxes;
use super::level::{Kind, Level};
use super::rows::{Plane, from_site};
use crate::linalg::Vector;
use crate::norm::hhj::cell::root;
use crate::parallel::{for_chunks, for_chunks_in};

/// A cell whose mean ratio is below is flat. The largest eigenvalue with and without their form, by conjugate gradients on balls of
/// 17 000 tetrahedra: 1.2 and 1.7 where the least mean ratio is 0.20 (p = 3); 1.04 and 34 (p = 3), 1.3 and 95 (p = 4) where it is 0.05.
const FLAT: f64 = 0.3;

/// What the finest level is made from.
struct Finest<'a, const N: usize> {
    transfer: &'a Transfer<N>,
    boxes: Boxes<N>,
    energy: Energy,
    /// The form of a box's splines in units of the box's edge becomes that of the mesh's units.
    scale: f64,
    /// The cells that the boxes inside do not cover, and the flat ones.
    near: Vec<u32>,
}

/// The finest level.
pub(super) fn finest<const N: usize>(transfer: &Transfer<N>) -> Level<N> {
    let boxes = Boxes::new(transfer);
    let edge = 1.0 / transfer.grid.density[0];
    let mut finest = Finest {
        transfer,
        energy: Energy::new::<N>(),
        scale: edge.powi(N as i32 - 4),
        near: Vec::new(),
        boxes,
    };
    let cells = 0..transfer.skeleton.order.cells.len();
    finest.near = (cells.map(|cell| cell as u32))
        .filter(|&cell| {
            transfer.skeleton.order.ratios[cell as usize] < FLAT || !finest.covered(cell)
        })
        .collect();
    let (kinds, patches) = finest.classify();
    let mut planes = planes(&transfer.grid.sides, &kinds, &patches);
    drop(patches);
    finest.add_boxes(&mut planes);
    finest.add_cells(&mut planes);
    let stencil = finest.energy.around.iter().map(|x| x * finest.scale);
    Level::new(transfer.grid.sides, kinds, planes, stencil.collect())
}

/// The rows, by planes across the last axis: those of the stored splines.
pub(super) fn planes<const N: usize>(
    sides: &[usize; N],
    kinds: &[Kind],
    patches: &[Patch<N>],
) -> Vec<Plane<N>> {
    let unit: usize = sides[..N - 1].iter().product();
    let whole = Patch::whole(sides);
    let plane = |(plane, (kinds, patches)): (usize, (&[Kind], &[Patch<N>]))| {
        let rows = kinds.iter().zip(patches).enumerate();
        let stored = rows.filter(|(_, (kind, _))| **kind == Kind::Stored);
        Plane::new(stored.map(|(spline, (_, patch))| {
            let (patch, first) = from_site(patch, &whole.site(plane * unit + spline));
            (spline as u32, patch, first)
        }))
    };
    let chunks = kinds.chunks(unit).zip(patches.chunks(unit));
    chunks.enumerate().map(plane).collect()
}

impl<const N: usize> Finest<'_, N> {
    /// Are all vertices of a cell in boxes inside?
    fn covered(&self, cell: u32) -> bool {
        let corners = self.corners(cell);
        let inside = |corner| {
            let low = self.transfer.reached(&[corner]).low;
            self.boxes.inside(&low)
        };
        corners.into_iter().all(inside)
    }

    fn corners(&self, cell: u32) -> Vec<Vector<f64, N>> {
        let of_mesh = self.transfer.skeleton.order.cells[cell as usize];
        self.transfer.corners(N, of_mesh as usize)
    }

    /// What the rows are, and for the stored ones which splines they couple to.
    fn classify(&self) -> (Vec<Kind>, Vec<Patch<N>>) {
        let sides = self.transfer.grid.sides;
        let whole = Patch::whole(&sides);
        let mut patches = vec![Patch::EMPTY; whole.len()];
        for &cell in &self.near {
            let patch = self.transfer.reached(&self.corners(cell));
            for site in patch.sites() {
                patches[whole.position(&site)].join(&patch);
            }
        }
        let kind = |(site, patch): (_, &mut Patch<N>)| {
            let inside = self.support(&site).filter(|b| self.boxes.inside(b)).count();
            let touched = !patch.is_empty();
            if inside > 0 {
                patch.join(&Patch::around(&site, 3, &sides));
            }
            match (touched, inside) {
                (false, 0) => Kind::Idle,
                (false, all) if all == 1 << (2 * N) => Kind::Deep,
                _ => Kind::Stored,
            }
        };
        let kinds = whole.sites().zip(&mut patches).map(kind).collect();
        (kinds, patches)
    }

    /// The boxes of the lattice in which a spline lives.
    fn support(&self, site: &[usize; N]) -> impl Iterator<Item = [usize; N]> + use<N> {
        let whole = self.boxes.whole;
        let support = Patch {
            low: site.map(|i| i.saturating_sub(3)),
            high: std::array::from_fn(|axis| (site[axis] + 1).min(whole.high[axis])),
        };
        support.sites()
    }

    /// Adds what the boxes inside have for the stored rows.
    fn add_boxes(&self, planes: &mut [Plane<N>]) {
        let whole = Patch::whole(&self.transfer.grid.sides);
        let unit = self.transfer.grid.plane();
        let convert = |x: f64| (self.scale * x) as Short;
        for_chunks(planes, 1, |plane, planes| {
            let Plane { rows, values, .. } = &mut planes[0];
            for row in rows {
                let site = whole.site(plane * unit + row.spline as usize);
                let inside = self.support(&site).filter(|b| self.boxes.inside(b));
                let inside: Vec<_> = inside.collect();
                if inside.len() == 1 << (2 * N) {
                    let patch = Patch::around(&site, 3, &whole.high);
                    row.add(&site, &patch, &self.energy.around, values, convert);
                    continue;
                }
                for corner in inside {
                    let box_splines = Patch {
                        low: corner,
                        high: corner.map(|i| i + 4),
                    };
                    let at = box_splines.position(&site);
                    let size = box_splines.len();
                    let energy = &self.energy.on_box[at * size..(at + 1) * size];
                    row.add(&site, &box_splines, energy, values, convert);
                }
            }
        });
    }

    /// Adds what the cells near ∂Ω and the flat ones have: some forms at a time, and these plane by plane.
    fn add_cells(&self, planes: &mut [Plane<N>]) {
        let (mut numbers, mut rest) = (Vec::new(), &self.near[..]);
        while !rest.is_empty() {
            let patches = self.at_once(rest);
            let (cells, after) = rest.split_at(patches.len());
            rest = after;
            let mut forms = places(patches, &mut numbers, rest.is_empty());
            for_chunks_in(&mut forms, 1, FormRoom::default, |i, form, room| {
                self.make(cells[i], &mut form[0], room);
            });
            for_chunks(planes, 1, |at, plane| {
                for form in &forms {
                    self.add_cell(form, at, &mut plane[0]);
                }
            });
        }
    }

    /// What the first of these cells reach, of as many as have their forms made at a time.
    fn at_once(&self, cells: &[u32]) -> Vec<Patch<N>> {
        let reached = |&cell: &u32| self.transfer.reached(&self.corners(cell));
        let mut numbers = 0;
        let fits = |(before, patch): &(usize, Patch<N>)| {
            numbers += size(patch);
            *before == 0 || numbers <= AT_ONCE
        };
        let patches = cells.iter().map(reached).enumerate().take_while(fits);
        patches.map(|(_, patch)| patch).collect()
    }

    /// Adds what a cell has for the rows of a plane.
    fn add_cell(
        &self,
        CellForm { patch, form }: &CellForm<'_, N>,
        at: usize,
        plane: &mut Plane<N>,
    ) {
        let mut part = *patch;
        (part.low[N - 1], part.high[N - 1]) = (at, at + 1);
        if !(patch.low[N - 1]..patch.high[N - 1]).contains(&at) {
            return;
        }
        let grid = &self.transfer.grid;
        let (whole, unit) = (Patch::whole(&grid.sides), grid.plane());
        for site in part.sites() {
            let row = plane.row(whole.position(&site) % unit);
            let row = *row.expect("what such cells reach is stored");
            let numbers = &form[patch.position(&site) * patch.len()..][..patch.len()];
            row.add(&site, patch, numbers, &mut plane.values, |x: Short| x);
        }
    }

    /// The form of the splines that reach a cell.
    fn make(&self, cell: u32, to: &mut CellForm<'_, N>, room: &mut FormRoom) {
        let Transfer { hhj, skeleton, .. } = self.transfer;
        let (layout, splines) = (hhj.layout(), to.patch.len());
        let cell = cell as usize;
        room.kept.clear();
        room.rows.clear();
        for block in &layout.blocks {
            let simplex = skeleton.order.layers[block.k].free_of_cell(cell, block.place);
            if let Some(simplex) = simplex.filter(|_| block.width > 0) {
                let begin = room.rows.len();
                room.kept.extend(block.start..block.start + block.width);
                room.rows.resize(begin + block.width * splines, 0.0);
                let rows = &mut room.rows[begin..];
                self.transfer.rows(block.k, simplex, &to.patch, rows);
            }
        }
        let energy = hhj.condensed(skeleton.order.cells[cell] as usize);
        let root = root(&energy, &room.kept, hhj.element().rank());
        room.root.clear();
        room.root.extend(root.iter().map(|&x| x as Short));
        room.gram(splines, to.form);
    }
}
