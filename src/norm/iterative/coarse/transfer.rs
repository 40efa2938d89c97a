//! The transfer P from splines to the mesh's unknowns, and its transpose.
//!
//! On each simplex u is the polynomial of degree p through the values of s at the nodes of P_p, û the one of degree p−1 that
//! fits ∂s/∂n there best. Nodes and normals are those of the mesh as it is, moved or not. At a node s and ∇s are evaluated once,
//! however many simplices have it.

use super::nodes::Nodes;
use super::patch::Patch;
use super::stencil::{Grid, Jet, Short, Stencil};
use crate::linalg::Vector;
use crate::norm::hhj::Hhj;
use crate::norm::iterative::skeleton::Skeleton;
use crate::parallel::{collect, for_chunks};
use crate::simplex::{Bernstein, Points, multi_indices};
use nalgebra::DMatrix;
use std::sync::Arc;

/// How many simplices or nodes make one piece of work.
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
    nodes: Nodes<N>,
    /// The interior faces' unit normals, along which û is the derivative.
    normals: Vec<Vector<Short, N>>,
}

/// How the unknowns of a k-simplex are made of a function's values and derivatives at nodes.
#[derive(Clone, Debug)]
struct Functional {
    /// The degree of the nodes.
    degree: usize,
    /// u from values, `[(unknown, node)]`.
    values: DMatrix<Short>,
    /// û from normal derivatives.
    slopes: DMatrix<Short>,
}

impl<const N: usize> Transfer<N> {
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>, grid: Grid<N>) -> Self {
        let (mesh, p, order) = (hhj.mesh(), hhj.space().degree(), &skeleton.order);
        let functionals: Vec<_> = (0..N)
            .map(|k| Functional::new::<N>(k, p, skeleton))
            .collect();
        let degrees: Vec<usize> = functionals.iter().map(|f| f.degree).collect();
        let mut transfer = Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            nodes: Nodes::new(mesh, order, p, &degrees, &grid),
            grid,
            functionals,
            normals: Vec::new(),
        };
        let layer = &order.layers[N - 1];
        let normal = |face: usize| transfer.normal(layer.simplices[face] as usize);
        transfer.normals = collect(layer.free, |face| normal(face).map(|x| x as Short));
        transfer
    }

    /// Pᵀ r.
    pub fn restrict(&self, r: &[Short]) -> Vec<Short> {
        let (plane, jets) = (self.grid.plane(), self.duals(r));
        let mut spline = vec![0.0; self.grid.len()];
        let spread = |nodes: &[u32], chunk: &mut [Short], first: usize| {
            let mut stencil = Stencil::new(&self.grid);
            for &node in nodes {
                let spot = &self.nodes.spots[node as usize];
                stencil.place(&self.grid, spot.first as usize - first * plane, &spot.at);
                stencil.spread(jets[node as usize], chunk);
            }
        };
        self.nodes.slabs.add_up(&mut spline, plane, spread);
        spline
    }

    /// What the nodes get from the unknowns' dual vector.
    fn duals(&self, r: &[Short]) -> Vec<Jet<N>> {
        let mut jets = vec![Jet::ZERO; self.nodes.spots.len()];
        let mut rest = &mut jets[..];
        for (k, layer) in self.skeleton.order.layers.iter().enumerate() {
            let own = self.nodes.own[k];
            let of_layer = rest.split_off_mut(..own * layer.simplices.len());
            let of_layer = of_layer.expect("every simplex has its nodes");
            for_chunks(of_layer, SIMPLICES * own.max(1), |piece, jets| {
                for (i, jets) in jets.chunks_exact_mut(own.max(1)).enumerate() {
                    self.duals_of(r, k, piece * SIMPLICES + i, jets);
                }
            });
        }
        jets
    }

    /// Adds the same for the own nodes of a k-simplex.
    fn duals_of(&self, r: &[Short], k: usize, simplex: usize, jets: &mut [Jet<N>]) {
        let order = &self.skeleton.order;
        for (cell, which) in order.layers[k].star(simplex) {
            for user in self.nodes.users(k, cell, which) {
                let at = order.layers[user.k].of_cell(cell)[user.which] as usize;
                let r = &r[self.skeleton.of_simplex(user.k, at)];
                let normal = self.along(user.k, at);
                for (jet, &q) in jets.iter_mut().zip(&user.points) {
                    let (u, slope) = self.functionals[user.k].transposed(q, r);
                    jet.value += u;
                    for (gradient, n) in jet.gradient.iter_mut().zip(&normal) {
                        *gradient += n * slope;
                    }
                }
            }
        }
    }

    /// The direction of a simplex' slopes: only faces have some.
    #[inline]
    fn along(&self, k: usize, simplex: usize) -> Vector<Short, N> {
        match k + 1 == N {
            true => self.normals[simplex],
            false => Vector::zeros(),
        }
    }

    /// The rows of P for an interior simplex, on a box of the lattice's sites: row i is `rows[i·len..]`, `zero` before.
    pub fn rows(&self, k: usize, simplex: usize, patch: &Patch<N>, rows: &mut [Short]) {
        let functional = &self.functionals[k];
        let (u, normal) = (functional.values.nrows(), self.along(k, simplex));
        let part = Grid {
            sides: patch.sides(),
            ..self.grid.clone()
        };
        let (mut stencil, whole) = (Stencil::new(&part), Patch::whole(&self.grid.sides));
        for (q, node) in self.nodes_of(k, simplex).enumerate() {
            let spot = &self.nodes.spots[node];
            let first = patch.position(&whole.site(spot.first as usize));
            stencil.place(&part, first, &spot.at);
            for (i, row) in rows.chunks_exact_mut(patch.len()).enumerate() {
                let mut jet = Jet::ZERO;
                match i.checked_sub(u) {
                    None => jet.value = functional.values[(i, q)],
                    Some(beta) => {
                        let slope = functional.slopes[(beta, q)];
                        jet.gradient = std::array::from_fn(|i| slope * normal[i]);
                    }
                }
                stencil.spread(jet, row);
            }
        }
    }

    /// The nodes on a simplex, as its first cell has them.
    #[inline]
    fn nodes_of(&self, k: usize, simplex: usize) -> impl Iterator<Item = usize> {
        let order = &self.skeleton.order;
        let (cell, which) = order.layers[k].first(simplex);
        self.nodes.of_block(order, k, cell, which)
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

    /// z += P s.
    pub fn prolong(&self, spline: &[Short], z: &mut [Short]) {
        let mut jets = vec![Jet::ZERO; self.nodes.spots.len()];
        for_chunks(&mut jets, SIMPLICES, |piece, jets| {
            let mut stencil = Stencil::new(&self.grid);
            for (spot, jet) in self.nodes.spots[piece * SIMPLICES..].iter().zip(jets) {
                stencil.place(&self.grid, spot.first as usize, &spot.at);
                *jet = stencil.evaluate(spline);
            }
        });
        for (k, functional) in self.functionals.iter().enumerate() {
            let (width, layer) = (self.skeleton.widths[k], self.skeleton.layer_mut(k, z));
            for_chunks(layer, SIMPLICES * width.max(1), |piece, z| {
                for (i, z) in z.chunks_exact_mut(width).enumerate() {
                    let simplex = piece * SIMPLICES + i;
                    let normal = self.along(k, simplex);
                    for (q, node) in self.nodes_of(k, simplex).enumerate() {
                        let Jet { value, gradient } = &jets[node];
                        functional.add(q, *value, dot(normal.as_slice(), gradient), z);
                    }
                }
            });
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

impl Functional {
    fn new<const N: usize>(k: usize, p: usize, skeleton: &Skeleton) -> Self {
        let inside = |alpha: &[usize]| alpha.iter().all(|&e| e > 0);
        let bernstein = multi_indices(k + 1, p);
        let own: Vec<usize> = (0..bernstein.len())
            .filter(|&a| inside(&bernstein[a]))
            .collect();
        let has_slopes = k + 1 == N;
        // Where u has no unknown, the nodes of û alone are enough, and half as many; P_0 has none to speak of.
        let degree = match own.is_empty() && has_slopes && p == 2 {
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
        let slopes = match has_slopes {
            true => fit(&Bernstein::new(k + 1, p - 1), &points),
            false => DMatrix::zeros(0, points.len()),
        };
        debug_assert_eq!(own.len() + slopes.nrows(), skeleton.widths[k]);
        Self {
            degree,
            values: values.map(|x| x as Short),
            slopes: slopes.map(|x| x as Short),
        }
    }

    /// Adds what a value and a normal derivative at node q give to the unknowns.
    #[inline]
    fn add(&self, q: usize, value: Short, slope: Short, z: &mut [Short]) {
        let (u, slopes) = z.split_at_mut(self.values.nrows());
        add(u, self.values.column(q).as_slice(), value);
        add(slopes, self.slopes.column(q).as_slice(), slope);
    }

    /// What node q gets from the unknowns' dual vector: the transpose of [`Functional::add`].
    #[inline]
    fn transposed(&self, q: usize, r: &[Short]) -> (Short, Short) {
        let (u, slopes) = r.split_at(self.values.nrows());
        (
            dot(self.values.column(q).as_slice(), u),
            dot(self.slopes.column(q).as_slice(), slopes),
        )
    }
}

#[inline]
fn add(z: &mut [Short], column: &[Short], factor: Short) {
    for (z, c) in z.iter_mut().zip(column) {
        *z += c * factor;
    }
}

#[inline]
fn dot(x: &[Short], y: &[Short]) -> Short {
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
