//! The order in which the solver goes through a mesh: cells along a curve that fills space, and their simplices as these cells
//! meet them. So what is near in space is near in memory, however the mesh is numbered.

use crate::linalg::Vector;
use crate::mesh::Mesh;
use crate::parallel::{collect, sort};
use std::ops::Range;

/// The cells and simplices of a mesh with points, by their places in the solver's order.
#[derive(Clone, Debug)]
pub(super) struct Order {
    /// The mesh's numbers of the cells.
    pub cells: Vec<u32>,
    /// The cells' shapes, see [`Mesh::mean_ratio`].
    pub ratios: Vec<f64>,
    /// By dimension k < N.
    pub layers: Vec<Layer>,
}

/// The k-simplices, those in ∂Ω last.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// The mesh's numbers.
    pub simplices: Vec<u32>,
    /// How many are interior.
    pub free: usize,
    /// Cell by cell, the places of its k-simplices in `simplices`.
    of_cell: Vec<u32>,
    /// How many a cell has.
    per_cell: usize,
    /// The cells that contain a simplex, with which of their simplices it is: `entries[offsets[s]..offsets[s + 1]]`, ascending.
    /// The cell stands above the lowest [`WHICH`] bits.
    offsets: Vec<u32>,
    entries: Vec<u32>,
}

impl Order {
    pub fn new<const N: usize>(mesh: &Mesh<N>) -> Self {
        let cells = along_curve(mesh);
        let layers = (0..N).map(|k| Layer::new(mesh, k, &cells)).collect();
        let ratio = |cell: usize| mesh.mean_ratio(cells[cell] as usize);
        let ratios = collect(cells.len(), |cell| ratio(cell).expect("a mesh with points"));
        Self {
            cells,
            ratios,
            layers,
        }
    }
}

impl Layer {
    fn new<const N: usize>(mesh: &Mesh<N>, k: usize, cells: &[u32]) -> Self {
        let per_cell = mesh.simplices_of(0, k).len();
        let (mut places, mut simplices) = (vec![u32::MAX; mesh.count(k)], Vec::new());
        let mut free = 0;
        for interior in [true, false] {
            for &cell in cells {
                for &simplex in mesh.simplices_of(cell as usize, k) {
                    let place = &mut places[simplex as usize];
                    if *place == u32::MAX && mesh.is_interior(k, simplex as usize) == interior {
                        *place = simplices.len() as u32;
                        simplices.push(simplex);
                    }
                }
            }
            free = if interior { simplices.len() } else { free };
        }
        let of_cells = cells
            .iter()
            .map(|&cell| mesh.simplices_of(cell as usize, k));
        let of_cell: Vec<u32> = of_cells.flatten().map(|&s| places[s as usize]).collect();
        let (offsets, entries) = stars(&of_cell, per_cell, simplices.len());
        Self {
            simplices,
            free,
            of_cell,
            per_cell,
            offsets,
            entries,
        }
    }

    /// How many a cell has.
    pub fn per_cell(&self) -> usize {
        self.per_cell
    }

    /// The places of a cell's k-simplices.
    #[inline]
    pub fn of_cell(&self, cell: usize) -> &[u32] {
        &self.of_cell[cell * self.per_cell..(cell + 1) * self.per_cell]
    }

    /// One of each cell's simplices, the same of all, if it is interior.
    pub fn free_of_cells(
        &self,
        cells: Range<usize>,
        which: usize,
    ) -> impl Iterator<Item = Option<usize>> + '_ {
        let list = &self.of_cell[cells.start * self.per_cell..cells.end * self.per_cell];
        let simplices = list.chunks_exact(self.per_cell);
        simplices.map(move |simplices| {
            let simplex = simplices[which] as usize;
            (simplex < self.free).then_some(simplex)
        })
    }

    /// One of a cell's simplices, if it is interior.
    #[inline]
    pub fn free_of_cell(&self, cell: usize, which: usize) -> Option<usize> {
        let simplex = self.of_cell(cell)[which] as usize;
        (simplex < self.free).then_some(simplex)
    }

    /// The first cell that contains a simplex, and which of its simplices it is.
    #[inline]
    pub fn first(&self, place: usize) -> (usize, usize) {
        split(self.entries[self.offsets[place] as usize])
    }

    /// The last cell that contains a simplex.
    pub fn last(&self, place: usize) -> usize {
        split(self.entries[self.offsets[place + 1] as usize - 1]).0
    }

    /// The cells that contain a simplex, ascending, with which of their simplices it is.
    #[inline]
    pub fn star(&self, place: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let range = self.offsets[place] as usize..self.offsets[place + 1] as usize;
        self.entries[range].iter().map(|&entry| split(entry))
    }
}

/// How many bits tell a cell's simplices of one dimension apart: a tetrahedron has six edges. They are shifted, since a division
/// takes longer than what is done with a simplex.
const WHICH: u32 = 3;

#[inline]
fn split(entry: u32) -> (usize, usize) {
    let which = entry & ((1 << WHICH) - 1);
    ((entry >> WHICH) as usize, which as usize)
}

/// For each of so many simplices the cells that have it in their list of `per_cell`, in compressed rows.
fn stars(list: &[u32], per_cell: usize, count: usize) -> (Vec<u32>, Vec<u32>) {
    assert!(
        per_cell <= 1 << WHICH && list.len() / per_cell <= (u32::MAX >> WHICH) as usize,
        "more cells than a place has bits for"
    );
    let mut offsets = vec![0; count + 1];
    for &s in list {
        offsets[s as usize + 1] += 1;
    }
    for s in 0..count {
        offsets[s + 1] += offsets[s];
    }
    let mut next = offsets.clone();
    let mut entries = vec![0; list.len()];
    for (i, &s) in list.iter().enumerate() {
        let (cell, which) = (i / per_cell, i % per_cell);
        entries[next[s as usize] as usize] = (cell << WHICH | which) as u32;
        next[s as usize] += 1;
    }
    (offsets, entries)
}

/// The cells by the places of their centres on Morton's curve through a box around the mesh.
fn along_curve<const N: usize>(mesh: &Mesh<N>) -> Vec<u32> {
    let centre = |cell: usize| -> Vector<f64, N> {
        let corners = (0..=N).map(|i| mesh.corner(cell, i).expect("a mesh with points"));
        corners.sum::<Vector<f64, N>>() / (N + 1) as f64
    };
    let centres = collect(mesh.cell_count(), centre);
    let (mut lower, mut upper) = (centres[0], centres[0]);
    for centre in &centres {
        (lower, upper) = (lower.inf(centre), upper.sup(centre));
    }
    let extent = (upper - lower).max().max(f64::MIN_POSITIVE);
    let key = |cell: usize| interleaved(&((centres[cell] - lower) / extent));
    let mut keyed = collect(mesh.cell_count(), |cell| (key(cell), cell as u32));
    sort(&mut keyed);
    keyed.into_iter().map(|(_, cell)| cell).collect()
}

/// The binary digits of N numbers between 0 and 1 in turn, the leading ones first.
fn interleaved<const N: usize>(x: &Vector<f64, N>) -> u64 {
    let digits = 63 / N;
    let whole = x.map(|x| (x * (1_u64 << digits) as f64) as u64);
    (0..digits).rev().fold(0, |key, digit| {
        whole.iter().fold(key, |key, x| key << 1 | (x >> digit & 1))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::SplitMix64;

    /// Every cell and every simplex has one place, the interior ones before the others; a cell's simplices and a simplex' cells are
    /// the mesh's.
    #[test]
    fn nothing_is_lost() {
        let mesh = Mesh::<3>::cube(3).unwrap().perturbed(0.08, 5).unwrap();
        let order = Order::new(&mesh);
        let sorted = |list: &[u32]| {
            let mut sorted: Vec<usize> = list.iter().map(|&s| s as usize).collect();
            sorted.sort_unstable();
            sorted
        };
        assert!(sorted(&order.cells).into_iter().eq(0..mesh.cell_count()));
        for (k, layer) in order.layers.iter().enumerate() {
            assert!(sorted(&layer.simplices).into_iter().eq(0..mesh.count(k)));
            let free = &layer.simplices[..layer.free];
            assert!(sorted(free).into_iter().eq(mesh.interior(k)));
            for (at, &cell) in order.cells.iter().enumerate() {
                let places = layer.of_cell(at).iter();
                let simplices = places.map(|&place| layer.simplices[place as usize]);
                assert!(simplices.eq(mesh.simplices_of(cell as usize, k).iter().copied()));
            }
            for (place, &simplex) in layer.simplices.iter().enumerate() {
                assert_eq!(layer.star(place).next(), Some(layer.first(place)));
                let found = layer
                    .star(place)
                    .map(|(at, i)| (order.cells[at] as usize, i));
                let mut found: Vec<_> = found.collect();
                found.sort_unstable();
                let star = mesh.star(k, simplex as usize);
                assert!(
                    found
                        .into_iter()
                        .eq(star.map(|side| (side.cell, side.place)))
                );
            }
        }
    }

    /// However the mesh is numbered, a simplex is met soon after the cell before the first one that has it: 64 cells in a row
    /// share most of their vertices.
    #[test]
    fn near_in_space_is_near_in_memory() {
        let cube = Mesh::<3>::cube(16).unwrap();
        let points = cube.points().unwrap().to_vec();
        let mut cells: Vec<Vec<usize>> = (0..cube.cell_count())
            .map(|c| cube.vertices(3, c).iter().map(|&v| v as usize).collect())
            .collect();
        let mut random = SplitMix64::new(1);
        for i in (1..cells.len()).rev() {
            let j = ((random.symmetric() + 1.0) * 0.5 * (i + 1) as f64) as usize;
            cells.swap(i, j.min(i));
        }
        let mesh = Mesh::new(points, &cells).unwrap();
        let order = Order::new(&mesh);
        let distinct = |batch: &[u32]| {
            let vertices = batch.iter().flat_map(|&c| mesh.vertices(3, c as usize));
            vertices.collect::<std::collections::BTreeSet<_>>().len()
        };
        let mean = |cells: &[u32]| {
            let batches = cells.chunks(64).map(distinct);
            batches.sum::<usize>() as f64 / cells.len().div_ceil(64) as f64
        };
        // Ten boxes and two thirds have 64 cells; a cube of eight boxes has 27 vertices. Shuffled, there are 256 or nearly so.
        let unsorted: Vec<u32> = (0..mesh.cell_count() as u32).collect();
        assert!(mean(&unsorted) > 200.0);
        assert!(mean(&order.cells) < 60.0, "{}", mean(&order.cells));
    }
}
