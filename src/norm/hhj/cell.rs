//! One cell of the hybridised method: how its shape enters.
//!
//! With J = ∂x/∂ξ, g = JᵀJ, and S^{ij} the contravariant components of σ, σ = J S Jᵀ:
//!
//! - ∫_T σ:τ dx = |det J| ∫ g_ik g_jl S^{ij} T^{kl} dξ, whose inverse raises indices: S^{ij} = g^{ik} g^{jl} Y_kl;
//! - ∫_T τ:∇²v dx = |det J| ∫ T^{ij} ∂_i∂_j v dξ;
//! - N_f = g⁻¹ν_f/(ν_f g⁻¹ ν_f) is h_f times the unit normal, h_f the height of the cell over the face, and
//!   ds = |det J|/h_f dμ, so ∫_f τ_nn (∂_n v − q) ds = |det J| ∫ T(ν_f, ν_f) (∂_{N_f} v − h_f q) dμ.
//!
//! The change of unknown ŵ_f = h_f q − ∂_{N_f} v makes the last one the reference element's.

use super::element::{Element, conormal};
use super::layout::FaceMoment;
use crate::linalg::{Mat, Vector, apply, contract, inverse_and_det};
use crate::mesh::Mesh;
use crate::simplex::subsets;
use nalgebra::{DMatrix, DVector};
use std::ops::{Add, Mul};

/// The shape of one cell.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Shape<const N: usize> {
    /// The barycentre.
    pub centre: Vector<f64, N>,
    /// ∂x/∂ξ.
    pub jacobian: Mat<f64, N>,
    /// |det ∂x/∂ξ|.
    pub volume: f64,
    /// g⁻¹.
    pub inverse: Mat<f64, N>,
    /// Face by face, in the order of `subsets`.
    pub faces: Vec<FaceShape<N>>,
}

/// How the unknowns u, û of a face make ŵ.
#[derive(Clone, Copy, Debug)]
pub(in crate::norm) struct FaceShape<const N: usize> {
    /// ±h_f: û is the derivative along the normal that leaves the first of the face's cells.
    pub height: f64,
    /// Barycentric components of N_f at the vertices of the face, ascending. The one at the opposite vertex is −1.
    pub tangent: [f64; N],
}

impl<const N: usize> Shape<N> {
    /// The shape of a cell that has coordinates.
    pub fn new(mesh: &Mesh<N>, cell: usize) -> Option<Self> {
        let jacobian = mesh.jacobian(cell)?;
        let centre = mesh.corner(cell, 0)? + jacobian.column_sum() / (N + 1) as f64;
        let (inverse, det) = inverse_and_det(&(jacobian.transpose() * jacobian));
        let ids = mesh.simplices_of(cell, N - 1);
        let faces = subsets(N + 1, N)
            .into_iter()
            .enumerate()
            .map(|(place, face)| {
                let first = mesh.first_side(N - 1, ids[place] as usize).cell == cell;
                face_shape(&inverse, N - place, &face, if first { 1.0 } else { -1.0 })
            });
        Some(Self {
            centre,
            jacobian,
            volume: det.sqrt(),
            faces: faces.collect(),
            inverse,
        })
    }

    /// The unit normal that leaves the cell at a face, by the face's place in `faces`.
    pub fn normal(&self, place: usize) -> Vector<f64, N> {
        let nu = conormal::<N>(N - place).into();
        (self.jacobian * apply(&self.inverse, &nu)).normalize()
    }

    /// The coefficient of Y_b in s_a when S^{ij} = g^{ik} g^{jl} Y_kl: pairs a = (i, j), b = (k, l).
    fn raise(&self, (i, j): (usize, usize), (k, l): (usize, usize)) -> f64 {
        raise([(i, k), (j, l), (i, l), (j, k)].map(|pair| self.inverse[pair]))
    }

    /// The energy of (u, û) after the moments are condensed: uᵀ A u = |σ(u)|² over the cell. Symmetric.
    pub fn energy(&self, element: &Element<N>) -> DMatrix<f64> {
        let weight =
            |a: usize, b: usize| self.volume * self.raise(element.pairs[a], element.pairs[b]);
        let mut energy = element.condensed(weight);
        // Â in (u, ŵ) becomes Tᵀ Â T in (u, û): first the columns, then by symmetry the rows.
        for (moment, shape) in self.moments(element) {
            combine_columns(&mut energy, element, moment, shape);
        }
        energy.transpose_mut();
        for (moment, shape) in self.moments(element) {
            combine_columns(&mut energy, element, moment, shape);
        }
        energy
    }

    /// The coefficients of σ in a cell from those of (u, û): component a along φ_k in `[(k, a)]`.
    pub fn tensor(&self, element: &Element<N>, local: &[f64]) -> DMatrix<f64> {
        let mut reference = DVector::from_column_slice(local);
        for (moment, shape) in self.moments(element) {
            reference[moment.slope] *= shape.height;
            for (index, factor) in shape.derivative(element, moment) {
                reference[moment.slope] -= factor * local[index];
            }
        }
        let y = &element.pairing * reference;
        let (count, size) = (element.pairs.len(), element.moments.len());
        let mut s = DMatrix::zeros(size, count);
        for a in 0..count {
            for b in 0..count {
                let raise = self.raise(element.pairs[a], element.pairs[b]);
                for k in 0..size {
                    s[(k, a)] += raise * y[b * size + k];
                }
            }
        }
        s
    }

    /// All ŵ_β, with the faces that they belong to.
    fn moments<'a>(
        &'a self,
        element: &'a Element<N>,
    ) -> impl Iterator<Item = (&'a FaceMoment, &'a FaceShape<N>)> {
        let faces = element.layout.faces.iter().zip(&self.faces);
        faces.flat_map(move |(moments, shape)| moments.iter().map(move |m| (m, shape)))
    }
}

/// ½ (g^{ik} g^{jl} + g^{il} g^{jk}) from the four factors in this order.
#[inline]
pub(in crate::norm) fn raise<T>([ik, jl, il, jk]: [T; 4]) -> T
where
    T: Copy + From<f32> + Add<Output = T> + Mul<Output = T>,
{
    T::from(0.5) * (ik * jl + il * jk)
}

impl<const N: usize> FaceShape<N> {
    /// ŵ_β = ±h û_β − p (Σ_v τ_v u_{β+e_v} − u_{β+e_f}), v the vertices of the face and f the other one: the u in the bracket, without
    /// bubbles, and what they are multiplied by. The derivative of a Bernstein polynomial B_α of degree p along τ is p Σ_v τ_v B_{α−e_v}.
    fn derivative(
        &self,
        element: &Element<N>,
        moment: &FaceMoment,
    ) -> impl Iterator<Item = (usize, f64)> {
        let p = element.degree as f64;
        let of_face = moment.raised.iter().zip(self.tangent);
        let opposite = element.layout.opposite(moment).map(|index| (index, -p));
        of_face
            .map(move |(&index, tau)| (index, p * tau))
            .chain(opposite)
    }
}

/// The face opposite to vertex `f`.
fn face_shape<const N: usize>(
    inverse: &Mat<f64, N>,
    f: usize,
    face: &[usize],
    sign: f64,
) -> FaceShape<N> {
    let nu = conormal::<N>(f).into();
    let raised = apply(inverse, &nu);
    let norm = contract(&nu, &raised);
    let normal: [f64; N] = std::array::from_fn(|i| raised[i] / norm);
    let tangent = std::array::from_fn(|v| match face[v] {
        0 => -normal.iter().sum::<f64>(),
        vertex => normal[vertex - 1],
    });
    FaceShape {
        height: sign / norm.sqrt(),
        tangent,
    }
}

/// Column ŵ_β handed on to the columns of û_β and of the u that it contains.
fn combine_columns<const N: usize>(
    a: &mut DMatrix<f64>,
    element: &Element<N>,
    moment: &FaceMoment,
    shape: &FaceShape<N>,
) {
    for (index, factor) in shape.derivative(element, moment) {
        let (mut target, source) = a.columns_range_pair_mut(index, moment.slope);
        target.axpy(-factor, &source, 1.0);
    }
    a.column_mut(moment.slope).scale_mut(shape.height);
}

/// A after `bubbles` steps of Cholesky's elimination: their columns hold L, the lower triangle of the rest the Schur
/// complement. The bubbles' block is positive definite: a bubble is not affine.
pub(in crate::norm) fn eliminate(a: &mut DMatrix<f64>, bubbles: usize) {
    let n = a.nrows();
    for j in 0..bubbles {
        let pivot = a[(j, j)].sqrt();
        for i in j..n {
            a[(i, j)] /= pivot;
        }
        for k in j + 1..n {
            let l = a[(k, j)];
            for i in k..n {
                a[(i, k)] -= l * a[(i, j)];
            }
        }
    }
}

/// The part of the greatest pivot below which nothing but rounding is left.
const EXHAUSTED: f64 = 1e-14;

/// Rᵀ with Rᵀ R = A and `rank` columns, fewer if there are fewer rows, for the rows and columns that are `kept` of what [`eliminate`]
/// leaves of a matrix, bubbles not among them: symmetric, positive semidefinite, of this rank or less. Cholesky's elimination, which
/// takes the greatest pivot each time.
pub(in crate::norm) fn root(a: &DMatrix<f64>, kept: &[usize], rank: usize) -> DMatrix<f64> {
    let n = kept.len();
    // Its lower triangle is that of what is not eliminated yet.
    let mut rest = DMatrix::zeros(n, n);
    for (j, &column) in kept.iter().enumerate() {
        for (i, &row) in kept.iter().enumerate().skip(j) {
            rest[(i, j)] = a[(row.max(column), row.min(column))];
        }
    }
    let mut columns = DMatrix::zeros(n, rank.min(n));
    let greatest = rest.diagonal().max();
    for step in 0..columns.ncols() {
        let (at, pivot) = rest.diagonal().argmax();
        if pivot <= EXHAUSTED * greatest {
            break;
        }
        let (rest, scale) = (rest.as_mut_slice(), 1.0 / pivot.sqrt());
        let column = &mut columns.as_mut_slice()[step * n..][..n];
        for (i, x) in column.iter_mut().enumerate() {
            *x = rest[i.min(at) * n + i.max(at)] * scale;
        }
        for j in 0..n {
            let (factor, below) = (column[j], &column[j..]);
            for (x, y) in rest[j * n + j..(j + 1) * n].iter_mut().zip(below) {
                *x -= factor * y;
            }
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::norm::hhj::Hhj;

    /// Rᵀ R is the condensed matrix, with as many columns of Rᵀ as there are moments that are not the bubbles', for all degrees.
    #[test]
    fn roots() {
        let mesh = Mesh::<3>::cube(1).unwrap();
        for degree in 1..=5 {
            let hhj = Hhj::new(&mesh, degree).unwrap();
            let (element, bubbles) = (hhj.element(), hhj.layout().bubbles);
            let mut energy = hhj.energy(0);
            eliminate(&mut energy, bubbles);
            let rank = element.rank();
            let kept: Vec<usize> = (bubbles..energy.nrows()).collect();
            let root = root(&energy, &kept, rank);
            let product = &root * root.transpose();
            let scale = product.amax();
            for i in 0..product.nrows() {
                for j in 0..=i {
                    let difference = product[(i, j)] - energy[(bubbles + i, bubbles + j)];
                    assert!(
                        difference.abs() < 1e-13 * scale,
                        "degree {degree}: {difference:e}"
                    );
                }
            }
        }
    }
}
