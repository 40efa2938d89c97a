//! The transfer P from splines to the mesh's unknowns, and its transpose.
//!
//! On each simplex u is the polynomial of degree p through the values of s at the nodes of P_p, û the one of degree p−1 that
//! fits ∂s/∂n there best. Nodes and normals are those of the mesh as it is, moved or not.

use super::lattice::{Lattice, REACH};
use super::stencil::{Grid, Short, Stencil};
use crate::linalg::{Vector, apply};
use crate::mesh::Mesh;
use crate::norm::hhj::Hhj;
use crate::norm::hhj::element::conormal;
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
    hhj: Arc<Hhj<N>>,
    skeleton: Arc<Skeleton>,
    lattice: Lattice<N>,
    /// How many spline cells a side of a box.
    refinement: usize,
    /// The splines' own lattice.
    grid: Grid<N>,
    /// By dimension of the simplex.
    functionals: Vec<Functional>,
    /// The first k-simplex of each layer of boxes across the last axis: that of its first vertex.
    layers: Vec<Vec<usize>>,
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
    pub fn new(
        hhj: &Arc<Hhj<N>>,
        skeleton: &Arc<Skeleton>,
        lattice: Lattice<N>,
        refinement: usize,
    ) -> Self {
        let p = hhj.space().degree();
        Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            refinement,
            grid: Grid {
                side: lattice.side * refinement + 3,
                lower: lattice.lower,
                density: lattice.steps.map(|step| refinement as f64 / step),
            },
            functionals: (0..N)
                .map(|k| Functional::new::<N>(k, p, skeleton))
                .collect(),
            layers: (0..N)
                .map(|k| layers(hhj.mesh(), k, lattice.side))
                .collect(),
            lattice,
        }
    }

    /// factor · Pᵀ r.
    ///
    /// Layers of simplices that are far apart touch different coefficients and are taken at the same time.
    pub fn restrict(&self, r: &[f64], factor: f64) -> Vec<Short> {
        let plane = self.grid.side.pow(N as u32 - 1);
        let box_planes = self.refinement * plane;
        // A layer of boxes reaches from one box below it to less than this many boxes above that.
        let apart = (2.0 + REACH + 3.0 / self.refinement as f64) as usize + 1;
        // One box of planes before the first, for the first layer to reach into.
        let mut padded = vec![0.0; box_planes + plane * self.grid.side];
        for colour in 0..apart.min(self.lattice.side) {
            let chunks = &mut padded[colour * box_planes..];
            for_chunks(chunks, apart * box_planes, |i, chunk| {
                let layer = colour + i * apart;
                if layer < self.lattice.side {
                    let shift = (box_planes, layer * box_planes);
                    self.restrict_layer(r, factor, layer, chunk, shift);
                }
            });
        }
        padded.split_off(box_planes)
    }

    /// Coefficient i is at i + shift.0 − shift.1 in the chunk.
    fn restrict_layer(
        &self,
        r: &[f64],
        factor: f64,
        layer: usize,
        chunk: &mut [Short],
        shift: (usize, usize),
    ) {
        let mut stencil = Stencil::new(&self.grid);
        for (k, functional) in self.functionals.iter().enumerate() {
            let simplices = self.layers[k][layer]..self.layers[k][layer + 1];
            for simplex in simplices.filter(|&s| self.hhj.mesh().is_interior(k, s)) {
                let first = self.skeleton.first(k, simplex);
                let r = &r[first..first + self.skeleton.widths[k]];
                let frame = self.frame(k, simplex);
                for q in 0..functional.points.len() {
                    let (value, gradient) = functional.transposed(q, r, &frame);
                    stencil.locate(&self.grid, &frame.point(functional.points.lambda(q)));
                    stencil.first = stencil.first + shift.0 - shift.1;
                    let gradient = std::array::from_fn(|i| (factor * gradient[i]) as Short);
                    stencil.spread((factor * value) as Short, gradient, chunk);
                }
            }
        }
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
                        let simplex = piece * SIMPLICES + i;
                        if !self.hhj.mesh().is_interior(k, simplex) {
                            continue;
                        }
                        let frame = self.frame(k, simplex);
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
        let mesh = self.hhj.mesh();
        let points = mesh.points().expect("a lattice has points");
        let vertices = mesh.vertices(k, simplex);
        let normal = if k + 1 == N {
            let side = mesh.first_side(k, simplex);
            let shape = &self.hhj.shapes()[side.cell];
            let nu = conormal::<N>(N - side.place).into();
            (shape.jacobian * apply(&shape.inverse, &nu)).normalize()
        } else {
            Vector::zeros()
        };
        Frame {
            corners: std::array::from_fn(|v| points[vertices[v.min(k)] as usize]),
            normal,
        }
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

/// The first k-simplex of each layer, and the number of all before the one beyond the last.
fn layers<const N: usize>(mesh: &Mesh<N>, k: usize, side: usize) -> Vec<usize> {
    let plane = (side + 1).pow(N as u32 - 1);
    let mut layers = vec![0; side + 1];
    for simplex in 0..mesh.count(k) {
        // Simplices are sorted by their vertices, the first of which is the least.
        let layer = mesh.vertices(k, simplex)[0] as usize / plane;
        if layer < side {
            layers[layer + 1] = simplex + 1;
        }
    }
    layers
}
