//! ∫|∇²s|² of tensor-product cubic splines in units of a box's edge, from the integrals of one axis.

use super::super::spline::{Piece, pieces};

/// The integrals over one box, and over all of ℝ^N.
#[derive(Clone, Debug)]
pub(super) struct Energy {
    /// Of the 4^N splines of a box: row by row.
    pub on_box: Vec<f64>,
    /// Of a spline with those at most three sites away from it: 7^N numbers.
    pub around: Vec<f64>,
}

impl Energy {
    pub fn new<const N: usize>() -> Self {
        let pieces = pieces();
        let splines = 1 << (2 * N);
        let digit = |index: usize, axis: usize| index >> (2 * axis) & 3;
        let on_box = (0..splines * splines).map(|ij| {
            let (i, j) = (ij / splines, ij % splines);
            product((0..N).map(|axis| pieces.map(|piece| piece[digit(i, axis)][digit(j, axis)])))
        });
        let whole = pieces.map(|piece| overlaps(&piece));
        let around = (0..7_usize.pow(N as u32)).map(|index| {
            let place = |axis| index / 7_usize.pow(axis as u32) % 7;
            product((0..N).map(|axis| [0, 1, 2].map(|form: usize| whole[form][place(axis)])))
        });
        Self {
            on_box: on_box.collect(),
            around: around.collect(),
        }
    }
}

/// ∫|∇²s|² = Σ_i ∫ s_ii² + 2 Σ_{i<j} ∫ s_ij² of products, from ∫ v², ∫ v′² and ∫ v″² by axis.
fn product(axes: impl Iterator<Item = [f64; 3]>) -> f64 {
    let (mut values, mut slopes, mut bends) = (1.0, 0.0, 0.0);
    for [mass, stiffness, bending] in axes {
        bends = bends * mass + 2.0 * slopes * stiffness + values * bending;
        slopes = slopes * mass + values * stiffness;
        values *= mass;
    }
    bends
}

/// A spline's integrals with itself, at 3, and with those 3, 2, 1 sites before and behind it.
fn overlaps(piece: &Piece) -> [f64; 7] {
    std::array::from_fn(|place| {
        let pairs = (0..4).map(|i| (i, i + place));
        let inside = pairs.filter(|(_, j)| (3..7).contains(j));
        inside.map(|(i, j)| piece[i][j - 3]).sum()
    })
}
