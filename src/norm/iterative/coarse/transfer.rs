//! The transfer P from splines to the mesh's unknowns, and its transpose.
//!
//! On each simplex u is the polynomial of degree p through the values of s at the nodes of P_p, û the one of degree p−1 that
//! fits ∂s/∂n there best. Nodes and normals are those of the mesh as it is, moved or not.

use super::patch::Patch;
use super::slabs::Slabs;
use super::stencil::{Grid, Short, Stencil};
use crate::linalg::Vector;
use crate::norm::hhj::Hhj;
use crate::norm::iterative::skeleton::Skeleton;
use crate::parallel::for_chunks;
use crate::simplex::{Bernstein, Points, multi_indices};
use nalgebra::DMatrix;
use std::sync::Arc;

/// How many simplices make one piece of work.
const SIMPLICES: usize = 512;

/// The transfer for one mesh and degree, N ≤ 3.
#[derive(Clone, Debug)]
pub(super) struct Transfer<const N: usize> {
    pub hhj: Arc<Hhj<N>>,
    pub skeleton: Arc<Skeleton>,
    /// The splines' lattice.
    pub grid: Grid<N>,
    /// By dimension of the simplex.
    functionals: Vec<Functional>,
    /// The k-simplices by the planes of coefficients that they reach.
    slabs: Vec<Slabs>,
    /// The faces' unit normals, along which û is the derivative.
    normals: Vec<Vector<Short, N>>,
}

/// How the unknowns of a k-simplex are made of a function's values and derivatives at points.
#[derive(Clone, Debug)]
struct Functional {
    points: Points,
    /// u from values, `[(unknown, point)]`.
    values: DMatrix<f64>,
    /// û from normal derivatives.
    normals: DMatrix<f64>,
}

/// A simplex on which unknowns are made.
struct Frame<const N: usize> {
    corners: [Vector<f64, N>; N],
    normal: Vector<f64, N>,
}

impl<const N: usize> Transfer<N> {
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>, grid: Grid<N>) -> Self {
        let p = hhj.space().degree();
        let mut transfer = Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            grid,
            functionals: (0..N)
                .map(|k| Functional::new::<N>(k, p, skeleton))
                .collect(),
            slabs: Vec::new(),
            normals: Vec::new(),
        };
        let faces = &transfer.skeleton.order.layers[N - 1].simplices;
        let normal = |&face: &u32| transfer.normal(face as usize).map(|x| x as Short);
        transfer.normals = faces.iter().map(normal).collect();
        transfer.slabs = (0..N).map(|k| transfer.sorted(k)).collect();
        transfer
    }

    /// The k-simplices by the planes that they reach.
    fn sorted(&self, k: usize) -> Slabs {
        let span = |(place, &simplex): (usize, &u32)| {
            let reached = self.reached(&self.corners(k, simplex as usize));
            (place as u32, reached.low[N - 1], reached.high[N - 1])
        };
        let simplices = match self.skeleton.widths[k] {
            0 => &[][..],
            _ => &self.skeleton.order.layers[k].simplices,
        };
        let spans = simplices.iter().enumerate().map(span).collect();
        Slabs::new(self.grid.sides[N - 1], spans)
    }

    /// factor · Pᵀ r.
    pub fn restrict(&self, r: &[f64], factor: f64) -> Vec<Short> {
        let plane = self.grid.plane();
        let mut spline = vec![0.0; self.grid.len()];
        for (k, slabs) in self.slabs.iter().enumerate() {
            slabs.add_up(&mut spline, plane, |simplices, chunk, first| {
                self.restrict_some(r, factor, k, simplices, chunk, first * plane);
            });
        }
        spline
    }

    /// Coefficient i is at i − shift in the chunk.
    fn restrict_some(
        &self,
        r: &[f64],
        factor: f64,
        k: usize,
        simplices: &[u32],
        chunk: &mut [Short],
        shift: usize,
    ) {
        let (functional, mut stencil) = (&self.functionals[k], Stencil::new(&self.grid));
        for simplex in simplices.iter().map(|&s| s as usize) {
            let first = self.skeleton.first(k, simplex);
            let r = &r[first..first + self.skeleton.widths[k]];
            let frame = self.frame(k, simplex);
            for q in 0..functional.points.len() {
                let (value, gradient) = functional.transposed(q, r, &frame);
                stencil.locate(&self.grid, &frame.point(functional.points.lambda(q)));
                stencil.first -= shift;
                let gradient = std::array::from_fn(|i| (factor * gradient[i]) as Short);
                stencil.spread((factor * value) as Short, gradient, chunk);
            }
        }
    }

    /// The rows of P for a simplex, on a lattice that is a part of the splines': row i is `rows[i·len..]`, `zero` before.
    pub fn rows(&self, k: usize, simplex: usize, part: &Grid<N>, rows: &mut [Short]) {
        let (functional, mut stencil) = (&self.functionals[k], Stencil::new(part));
        let frame = self.frame(k, simplex);
        let (u, normal) = (functional.values.nrows(), frame.normal);
        for q in 0..functional.points.len() {
            stencil.locate(part, &frame.point(functional.points.lambda(q)));
            for (i, row) in rows.chunks_exact_mut(part.len()).enumerate() {
                match i.checked_sub(u) {
                    None => stencil.spread(functional.values[(i, q)] as Short, [0.0; N], row),
                    Some(beta) => {
                        let slope = functional.normals[(beta, q)];
                        let gradient = std::array::from_fn(|i| (slope * normal[i]) as Short);
                        stencil.spread(0.0, gradient, row);
                    }
                }
            }
        }
    }

    /// The splines that live at some of these points or between them.
    pub fn reached(&self, points: &[Vector<f64, N>]) -> Patch<N> {
        let mut patch = Patch::EMPTY;
        for axis in 0..N {
            let along = points.iter().map(|x| x[axis]);
            let low = along.clone().fold(f64::INFINITY, f64::min);
            let high = along.fold(f64::NEG_INFINITY, f64::max);
            (patch.low[axis], patch.high[axis]) = self.grid.span(axis, low, high);
        }
        patch
    }

    /// z += factor · P s.
    pub fn prolong(&self, spline: &[Short], factor: f64, z: &mut [f64]) {
        for (k, functional) in self.functionals.iter().enumerate() {
            let width = self.skeleton.widths[k];
            if width == 0 {
                continue;
            }
            for_chunks(
                self.skeleton.layer_mut(k, z),
                SIMPLICES * width,
                |piece, z| {
                    let mut stencil = Stencil::new(&self.grid);
                    for (i, z) in z.chunks_exact_mut(width).enumerate() {
                        let frame = self.frame(k, piece * SIMPLICES + i);
                        for q in 0..functional.points.len() {
                            stencil.locate(&self.grid, &frame.point(functional.points.lambda(q)));
                            let (value, gradient) = stencil.evaluate(spline);
                            let gradient = Vector::from_fn(|i, _| factor * f64::from(gradient[i]));
                            functional.add(q, factor * f64::from(value), &gradient, &frame, z);
                        }
                    }
                },
            );
        }
    }

    fn frame(&self, k: usize, simplex: usize) -> Frame<N> {
        let of_mesh = self.skeleton.order.layers[k].simplices[simplex] as usize;
        Frame {
            corners: std::array::from_fn(|v| self.corner(k, of_mesh, v.min(k))),
            normal: match k + 1 == N {
                true => self.normals[simplex].map(f64::from),
                false => Vector::zeros(),
            },
        }
    }

    /// The unit normal of one of the mesh's faces that leaves the first of its cells.
    pub fn normal(&self, face: usize) -> Vector<f64, N> {
        let side = self.hhj.mesh().first_side(N - 1, face);
        self.hhj.shape(side.cell).normal(side.place)
    }

    /// A vertex of one of the mesh's simplices.
    fn corner(&self, k: usize, simplex: usize, v: usize) -> Vector<f64, N> {
        let mesh = self.hhj.mesh();
        let points = mesh.points().expect("a lattice has points");
        points[mesh.vertices(k, simplex)[v] as usize]
    }

    /// The vertices of one of the mesh's simplices.
    pub fn corners(&self, k: usize, simplex: usize) -> Vec<Vector<f64, N>> {
        (0..=k).map(|v| self.corner(k, simplex, v)).collect()
    }
}

impl<const N: usize> Frame<N> {
    #[inline]
    fn point(&self, lambda: &[f64]) -> Vector<f64, N> {
        let mut x = Vector::zeros();
        for (lambda, corner) in lambda.iter().zip(&self.corners) {
            x += corner * *lambda;
        }
        x
    }
}

impl Functional {
    fn new<const N: usize>(k: usize, p: usize, skeleton: &Skeleton) -> Self {
        let inside = |alpha: &[usize]| alpha.iter().all(|&e| e > 0);
        let bernstein = multi_indices(k + 1, p);
        let own: Vec<usize> = (0..bernstein.len())
            .filter(|&a| inside(&bernstein[a]))
            .collect();
        let has_normals = k + 1 == N;
        // Where u has no unknown, the nodes of û alone are enough, and half as many; P_0 has none to speak of.
        let degree = match own.is_empty() && has_normals && p > 1 {
            true => p - 1,
            false => p,
        };
        let nodes = multi_indices(k + 1, degree);
        let lambda = nodes.iter().flatten().map(|&a| a as f64 / degree as f64);
        let points = Points::new(k + 1, lambda.collect());
        let values = match own.is_empty() {
            true => DMatrix::zeros(0, points.len()),
            false => fit(&Bernstein::new(k + 1, p), &points).select_rows(&own),
        };
        let normals = match has_normals {
            true => fit(&Bernstein::new(k + 1, p - 1), &points),
            false => DMatrix::zeros(0, points.len()),
        };
        debug_assert_eq!(own.len() + normals.nrows(), skeleton.widths[k]);
        Self {
            values,
            normals,
            points,
        }
    }

    /// Adds what s and its gradient at point q give to the unknowns.
    #[inline]
    fn add<const N: usize>(
        &self,
        q: usize,
        value: f64,
        gradient: &Vector<f64, N>,
        frame: &Frame<N>,
        z: &mut [f64],
    ) {
        let (u, slopes) = z.split_at_mut(self.values.nrows());
        add(u, self.values.column(q).as_slice(), value);
        add(
            slopes,
            self.normals.column(q).as_slice(),
            gradient.dot(&frame.normal),
        );
    }

    /// What point q gets from the unknowns' dual vector: the transpose of [`Functional::add`].
    #[inline]
    fn transposed<const N: usize>(
        &self,
        q: usize,
        r: &[f64],
        frame: &Frame<N>,
    ) -> (f64, Vector<f64, N>) {
        let (u, slopes) = r.split_at(self.values.nrows());
        let slope = dot(self.normals.column(q).as_slice(), slopes);
        (
            dot(self.values.column(q).as_slice(), u),
            frame.normal * slope,
        )
    }
}

#[inline]
fn add(z: &mut [f64], column: &[f64], factor: f64) {
    for (z, c) in z.iter_mut().zip(column) {
        *z += c * factor;
    }
}

#[inline]
fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// The coefficients of the polynomial that fits values at points best, `[(α, point)]`.
fn fit(basis: &Bernstein, points: &Points) -> DMatrix<f64> {
    let table = basis.tabulate::<f64>(points);
    let a = DMatrix::from_fn(points.len(), basis.len(), |q, alpha| table[q][alpha]);
    let gram = a.tr_mul(&a);
    let fitted = gram.lu().solve(&a.transpose());
    fitted.expect("on the nodes of P_p polynomials of degree ≤ p are independent")
}
