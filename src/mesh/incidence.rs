//! All simplices of a complex and who contains whom.

use crate::Error;
use crate::parallel::{collect, sort};
use crate::simplex::{binomial, subsets};
use std::ops::{BitOr, Shl};

/// The simplices of one dimension k < N.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// k+1 ascending vertices a simplex.
    pub vertices: Vec<u32>,
    /// The simplices of each cell, in the order of [`subsets`] of its vertices.
    pub of_cell: Vec<u32>,
    /// How many a cell has.
    pub per_cell: usize,
    /// Not contained in the boundary?
    pub interior: Vec<bool>,
    /// Compressed rows: the cells that contain each simplex, with the simplex' place in the cell.
    pub stars: Stars,
}

/// For each simplex the cells around it: `entries[offsets[s]..offsets[s + 1]]` = (cell, place in the cell).
#[derive(Clone, Debug)]
pub(super) struct Stars {
    pub offsets: Vec<usize>,
    pub entries: Vec<(u32, u8)>,
}

impl Layer {
    /// The cells that contain a simplex, with its place in the cell.
    fn star(&self, s: usize) -> &[(u32, u8)] {
        &self.stars.entries[self.stars.offsets[s]..self.stars.offsets[s + 1]]
    }
}

/// Every layer k = 0…N−1 of a list of cells with N+1 ascending vertices each.
pub(super) fn layers(n: usize, cells: &[u32], vertices: usize) -> Result<Vec<Layer>, Error> {
    let bits = (usize::BITS - vertices.leading_zeros()).max(1) as usize;
    if bits * n > 128 || cells.len() > u32::MAX as usize {
        return Err(Error::Input(format!(
            "a mesh of {vertices} vertices in dimension {n} is too large"
        )));
    }
    // Short keys are sorted in half the time and memory.
    let of = |k: usize| match bits * (k + 1) {
        0..=64 => layer::<u64>(n, k, cells, bits),
        _ => layer::<u128>(n, k, cells, bits),
    };
    Ok((0..n).map(of).collect())
}

/// A number that holds the vertices of a simplex, one after the other.
trait Key: Copy + Ord + Send + From<u32> + Shl<usize, Output = Self> + BitOr<Output = Self> {}

impl<K: Copy + Ord + Send + From<u32> + Shl<usize, Output = K> + BitOr<Output = K>> Key for K {}

/// One layer: every cell lists its k-simplices by a packed key; equal keys are one simplex.
fn layer<K: Key>(n: usize, k: usize, cells: &[u32], bits: usize) -> Layer {
    let local = subsets(n + 1, k + 1);
    let count = cells.len() / (n + 1);
    let mut keyed: Vec<(K, u32, u8)> = Vec::with_capacity(count * local.len());
    for (c, cell) in cells.chunks_exact(n + 1).enumerate() {
        for (place, subset) in local.iter().enumerate() {
            let key = subset
                .iter()
                .fold(K::from(0), |key, &v| (key << bits) | K::from(cell[v]));
            keyed.push((key, c as u32, place as u8));
        }
    }
    sort(&mut keyed);
    let mut layer = Layer {
        vertices: Vec::new(),
        of_cell: vec![0; count * local.len()],
        per_cell: local.len(),
        interior: Vec::new(),
        stars: Stars {
            offsets: Vec::new(),
            entries: Vec::with_capacity(keyed.len()),
        },
    };
    let mut last = None;
    for (key, c, place) in keyed {
        if last != Some(key) {
            last = Some(key);
            layer.stars.offsets.push(layer.stars.entries.len());
            let cell = &cells[c as usize * (n + 1)..];
            layer
                .vertices
                .extend(local[place as usize].iter().map(|&v| cell[v]));
        }
        layer.of_cell[c as usize * local.len() + place as usize] =
            layer.stars.offsets.len() as u32 - 1;
        layer.stars.entries.push((c, place));
    }
    layer.interior = vec![true; layer.stars.offsets.len()];
    layer.stars.offsets.push(layer.stars.entries.len());
    layer
}

/// Marks the simplices that lie in a face with one cell only.
pub(super) fn mark_boundary(n: usize, layers: &mut [Layer]) {
    let faces = &layers[n - 1].stars;
    let boundary: Vec<(u32, u8)> = (0..faces.offsets.len() - 1)
        .filter(|&f| faces.offsets[f + 1] - faces.offsets[f] == 1)
        .map(|f| faces.entries[faces.offsets[f]])
        .collect();
    for (k, layer) in layers.iter_mut().enumerate() {
        let per_cell = binomial(n + 1, k + 1);
        let local = subsets(n + 1, k + 1);
        for &(cell, place) in &boundary {
            let opposite = n - place as usize;
            for (s, subset) in local.iter().enumerate() {
                if !subset.contains(&opposite) {
                    let id = layer.of_cell[cell as usize * per_cell + s];
                    layer.interior[id as usize] = false;
                }
            }
        }
    }
}

/// The first simplex of codimension ≥ 2 whose cells are not connected through faces that contain it.
pub(super) fn pinched(n: usize, layers: &[Layer]) -> Option<(Vec<usize>, usize)> {
    for (k, layer) in layers[..n - 1].iter().enumerate() {
        let (count, local) = (layer.interior.len(), subsets(n + 1, k + 1));
        let first = |piece: usize| {
            let (from, mut parent) = (piece * PIECE, Vec::new());
            let mut simplices = from..(from + PIECE).min(count);
            simplices.find(|&s| !connected(layer.star(s), &layers[n - 1], &local, &mut parent))
        };
        if let Some(s) = collect(count.div_ceil(PIECE), first)
            .into_iter()
            .flatten()
            .next()
        {
            let vertices = layer.vertices[s * (k + 1)..(s + 1) * (k + 1)].iter();
            let cell = layer.star(s)[0].0;
            return Some((vertices.map(|&v| v as usize).collect(), cell as usize));
        }
    }
    None
}

/// How many simplices are looked at one after the other; a thread takes sixteen such lists at a time, or more.
const PIECE: usize = 1 << 6;

/// Are the cells around a simplex connected through faces that contain it? `local` are the vertices of a cell's simplices of its
/// dimension, `parent` is overwritten.
fn connected(
    star: &[(u32, u8)],
    faces: &Layer,
    local: &[Vec<usize>],
    parent: &mut Vec<usize>,
) -> bool {
    parent.clear();
    parent.extend(0..star.len());
    let (n, mut parts) = (faces.per_cell - 1, star.len());
    for (i, &(cell, place)) in star.iter().enumerate() {
        for opposite in (0..=n).filter(|o| !local[place as usize].contains(o)) {
            let face = faces.of_cell[cell as usize * (n + 1) + n - opposite];
            for &(other, _) in faces.star(face as usize) {
                // Star entries ascend by cell, as the sort made them.
                if let Ok(j) = star.binary_search_by_key(&other, |e| e.0) {
                    parts -= usize::from(unite(parent, i, j));
                }
            }
        }
    }
    parts == 1
}

/// Joins the classes of i and j; false if they were one already.
fn unite(parent: &mut [usize], i: usize, j: usize) -> bool {
    fn root(parent: &mut [usize], mut i: usize) -> usize {
        while parent[i] != i {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        i
    }
    let (i, j) = (root(parent, i), root(parent, j));
    parent[i] = j;
    i != j
}
