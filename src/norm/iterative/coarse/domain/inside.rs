//! Which boxes of a background lattice lie in Ω.

use super::super::patch::Patch;
use super::super::transfer::Transfer;
use crate::linalg::Vector;
use crate::parallel::collect;

/// What is known of a box.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// ∂Ω does not meet it, and no way that avoids ∂Ω is known into it from the inside.
    Unknown,
    /// ∂Ω may meet it.
    Cut,
    Inside,
}

/// The boxes of a lattice.
pub(super) struct Boxes<const N: usize> {
    /// All of them.
    pub whole: Patch<N>,
    places: Vec<Place>,
}

impl<const N: usize> Boxes<N> {
    /// Of the splines' lattice: what ∂Ω does not cut off from the cells' centres is inside.
    pub fn new(transfer: &Transfer<N>) -> Self {
        let whole = Patch {
            low: [0; N],
            high: transfer.grid.sides.map(|side| side - 3),
        };
        let mut boxes = Self {
            places: vec![Place::Unknown; whole.len()],
            whole,
        };
        let mesh = transfer.hhj.mesh();
        for face in (0..mesh.count(N - 1)).filter(|&f| !mesh.is_interior(N - 1, f)) {
            boxes.cut(transfer, face);
        }
        boxes.flood(transfer);
        boxes
    }

    /// Does a box lie in Ω?
    pub fn inside(&self, site: &[usize; N]) -> bool {
        self.places[self.whole.position(site)] == Place::Inside
    }

    /// Marks the boxes that meet both the least box around a face and the face's plane.
    fn cut(&mut self, transfer: &Transfer<N>, face: usize) {
        let (grid, normal) = (&transfer.grid, transfer.normal(face));
        let corners = transfer.corners(N - 1, face);
        let reached = transfer.reached(&corners);
        let half = grid.density.map(|density| 0.5 / density);
        // How far a box's corners are from its centre, along the normal.
        let width: f64 = (0..N).map(|i| normal[i].abs() * half[i]).sum();
        let boxes = Patch {
            low: reached.low,
            high: reached.high.map(|end| end - 3),
        };
        for site in boxes.sites() {
            let centre = Vector::from_fn(|i, _| {
                grid.lower[i] + (site[i] as f64 + 0.5) / grid.density[i] - corners[0][i]
            });
            if normal.dot(&centre).abs() <= width * (1.0 + 1e-6) {
                self.places[self.whole.position(&site)] = Place::Cut;
            }
        }
    }

    /// Goes from box to box, beginning at the centres of the cells.
    fn flood(&mut self, transfer: &Transfer<N>) {
        let mut waiting: Vec<[usize; N]> = Vec::new();
        let begin = |cell| transfer.reached(&[transfer.hhj.shape(cell).centre]).low;
        for site in collect(transfer.hhj.mesh().cell_count(), begin) {
            waiting.push(site);
            while let Some(site) = waiting.pop() {
                let place = &mut self.places[self.whole.position(&site)];
                if *place != Place::Unknown {
                    continue;
                }
                *place = Place::Inside;
                for axis in 0..N {
                    for step in [-1, 1] {
                        let mut next = site;
                        next[axis] = next[axis].wrapping_add_signed(step);
                        if next[axis] < self.whole.high[axis] {
                            waiting.push(next);
                        }
                    }
                }
            }
        }
    }
}
