//! B̂ without the bubbles' columns, as products of its blocks that are not zero: less than half of it in space.

use super::number::Number;
use super::product::Product;
use crate::norm::hhj::element::Element;
use nalgebra::DMatrix;

/// B̂ for a batch's rows.
#[derive(Clone, Debug)]
pub(super) struct Pairing<T> {
    /// From the unknowns to the moments, to all of them by the first one.
    blocks: Vec<Product<T>>,
    /// Their transposes, of which none reaches what another does.
    transposes: Vec<Product<T>>,
    /// B̂ of the bubbles.
    pub bubbles: DMatrix<T>,
}

impl<T: Number> Pairing<T> {
    pub fn new<const N: usize>(element: &Element<N>) -> Self {
        let bubbles = element.layout.bubbles;
        let entry = |row: usize, unknown: usize| T::of(element.pairing[(row, bubbles + unknown)]);
        let (mut of_blocks, mut transposes) = (Vec::new(), Vec::new());
        for (unknowns, moments) in blocks(element) {
            of_blocks.push(Product::new(&unknowns, &moments, &entry));
            transposes.push(Product::new(&moments, &unknowns, &|i, j| entry(j, i)));
        }
        Self {
            blocks: of_blocks,
            transposes,
            bubbles: element.pairing.columns(0, bubbles).map(T::of),
        }
    }

    /// y = B̂ x for rows of lanes.
    pub fn multiply(&self, x: &[T], y: &mut [T], lanes: usize) {
        let (first, others) = self.blocks.split_first().expect("a cell has faces");
        first.set(x, y, lanes);
        for block in others {
            block.add(x, y, lanes);
        }
    }

    /// x = B̂ᵀ y for rows of lanes.
    pub fn transposed(&self, y: &[T], x: &mut [T], lanes: usize) {
        for block in &self.transposes {
            block.set(y, x, lanes);
        }
    }

    /// How many numbers the blocks have.
    pub fn len(&self) -> usize {
        self.blocks.iter().map(Product::len).sum()
    }
}

/// The blocks of B̂ that are not zero: unknowns, without bubbles, and moments. u meets those of P_{p−2}, and the slopes of a face the
/// pairs (i, j) with ν_i ν_j ≠ 0: all of them on one face, and one on each of the others. The first block is that with the most
/// moments, made one of all.
fn blocks<const N: usize>(element: &Element<N>) -> Vec<(Vec<usize>, Vec<usize>)> {
    let layout = &element.layout;
    let is_slope = |i: &usize| layout.faces.iter().flatten().any(|m| m.slope == *i);
    let u = (layout.bubbles..layout.len).filter(|i| !is_slope(i));
    let faces = layout.faces.iter();
    let slopes = faces.map(|face| face.iter().map(|moment| moment.slope).collect());
    let columns = std::iter::once(u.collect()).chain(slopes);
    let block = |columns: Vec<usize>| {
        let is_zero = |row: usize| columns.iter().all(|&c| element.pairing[(row, c)] == 0.0);
        let rows = 0..element.pairing.nrows();
        let rows = rows.filter(|&row| !is_zero(row)).collect();
        let unknowns = columns.iter().map(|i| i - layout.bubbles).collect();
        (unknowns, rows)
    };
    let mut blocks: Vec<_> = columns.map(block).collect();
    blocks.sort_by_key(|(_, moments): &(_, Vec<usize>)| std::cmp::Reverse(moments.len()));
    blocks[0].1 = (0..element.pairing.nrows()).collect();
    blocks
}
