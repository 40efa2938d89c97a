//! The sums of the curvature simplex by simplex: ∫R and the volume of cells, ∫⟦H⟧ of faces, θ and ω_S of corners.

use crate::field::TensorField;
use crate::formulas::{Formulas, Paper};
use crate::hinge::Hinge;
use crate::hypersurface::{Normal, mean_curvature, outward};
use crate::jet::{Jet1, Jet2, lower};
use crate::linalg::{Mat, Vector, inverse_and_det};
use crate::mesh::{Mesh, Side};
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::riemann::{Connection, Curvature};
use crate::scalar::{Field, Real};
use crate::simplex::subsets;

/// ∫_T R ω of every cell, by a rule on cells. They add up to the first sum of def:distcurv at v = 1.
pub fn cell_curvatures<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    if g.is_constant() {
        return vec![T::Sum::zero(); mesh.cell_count()];
    }
    over_cells::<T, N, G>(g, mesh, rule, |local, table, block| {
        let (r, omega) = scalar_and_omega(&g.jet2(local, table, block));
        r * omega
    })
}

/// ∫_T ω of every cell: its volume, by a rule on cells.
pub fn cell_volumes<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    over_cells::<T, N, G>(g, mesh, rule, |local, table, block| {
        inverse_and_det(&g.value(local, table, block)).1.sqrt()
    })
}

/// R and ω at a point.
fn scalar_and_omega<T: Real, const N: usize>(g: &Mat<Jet2<T, N>, N>) -> (T, T) {
    let connection = Connection::new(&lower(g));
    (
        Curvature::new(g, &connection).scalar(),
        connection.det.sqrt(),
    )
}

/// The integral of a density over every cell.
fn over_cells<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
    density: impl Fn(&G::Local, &G::Table, usize) -> T + Sync,
) -> Vec<T::Sum> {
    let (table, weights) = (g.tabulate(rule.points()), super::site::weights::<T>(rule));
    let mut all = Vec::with_capacity(mesh.cell_count());
    let on_cell = |cell: usize| {
        let local = g.on_cell(cell);
        let mut sum = T::zero();
        for (block, weight) in weights.iter().enumerate() {
            sum += density(&local, &table, block) * *weight;
        }
        sum.reduce()
    };
    in_order(mesh.cell_count(), on_cell, |_, value| all.push(value));
    all
}

/// (F, ∫_F ⟦H⟧ ω_F) for every interior face, in the order of the mesh, by a rule on faces.
///
/// Twice their sum is the second sum of def:distcurv at v = 1.
pub fn face_jumps<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
) -> Vec<(usize, T::Sum)> {
    over_faces::<T, N, G>(g, mesh, rule, mesh.interior_faces().collect())
}

/// (F, ∫_F H ω_F) for every face of the boundary, with the outward normal: in the plane the geodesic curvature.
pub fn boundary_mean_curvatures<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
) -> Vec<(usize, T::Sum)> {
    let outer = (0..mesh.count(N - 1)).filter(|&f| !mesh.is_interior(N - 1, f));
    over_faces::<T, N, G>(g, mesh, rule, outer.collect())
}

/// ∫_F H ω_F from all cells around each face, each with its own outward normal.
fn over_faces<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rule: &Rule,
    faces: Vec<usize>,
) -> Vec<(usize, T::Sum)> {
    let mut all = Vec::with_capacity(faces.len());
    if g.is_constant() {
        all.extend(faces.into_iter().map(|face| (face, T::Sum::zero())));
        return all;
    }
    let sides = Sides::<T, N, G>::new(g, rule);
    let on_face = |i: usize| {
        let mut sum = T::zero();
        for side in mesh.star(N - 1, faces[i]) {
            let local = g.on_cell(side.cell);
            for block in 0..sides.weights.len() {
                sum += sides.mean_curvature(&local, side, block) * sides.weights[block];
            }
        }
        sum.reduce()
    };
    in_order(faces.len(), on_face, |i, value| all.push((faces[i], value)));
    all
}

/// The faces of a cell at the points of a rule.
pub(super) struct Sides<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    tables: Vec<G::Table>,
    outward: Vec<Vector<T, N>>,
    /// The rule's weights by blocks.
    pub weights: Vec<T>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> Sides<'a, T, N, G> {
    /// At the points of a rule on faces.
    pub fn new(g: &'a G, rule: &Rule) -> Self {
        let seen = |on: &Vec<usize>| g.tabulate(&rule.points().embed(on, N + 1));
        Self {
            g,
            tables: subsets(N + 1, N).iter().map(seen).collect(),
            // The face at place p is opposite to vertex N − p.
            outward: (0..=N).map(|place| outward(N - place)).collect(),
            weights: super::site::weights(rule),
        }
    }

    /// H ω_F as one cell sees it.
    pub fn mean_curvature(&self, local: &G::Local, side: Side, block: usize) -> T {
        let connection = Connection::new(&self.g.jet1(local, &self.tables[side.place], block));
        let nu = &self.outward[side.place];
        let normal = Normal::new(&connection.inverse, nu);
        let form = Paper::second_form(&connection, &nu.map(Jet1::constant), &normal);
        mean_curvature(&normal, &form) * normal.length * connection.det.sqrt()
    }
}

/// The corners of a cell at its hinges, at the points of a rule.
pub(super) struct Wedges<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    tables: Vec<G::Table>,
    outward: Vec<[Vector<T, N>; 2]>,
    /// The rule's weights by blocks.
    pub weights: Vec<T>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> Wedges<'a, T, N, G> {
    /// At the points of a rule on hinges.
    pub fn new(g: &'a G, rule: &Rule) -> Self {
        let places = subsets(N + 1, N - 1);
        let seen = |on: &Vec<usize>| g.tabulate(&rule.points().embed(on, N + 1));
        let faces = |on: &Vec<usize>| {
            let mut nu = (0..=N).filter(|v| !on.contains(v)).map(outward);
            // A hinge misses two vertices of its cell.
            std::array::from_fn(|_| nu.next().unwrap_or_else(|| outward(0)))
        };
        Self {
            g,
            tables: places.iter().map(seen).collect(),
            outward: places.iter().map(faces).collect(),
            weights: super::site::weights(rule),
        }
    }

    /// (θ_ST, ω_S) as one cell sees its hinge at this place.
    pub fn at(&self, local: &G::Local, place: usize, block: usize) -> (T, T) {
        let (inverse, det) = inverse_and_det(&self.g.value(local, &self.tables[place], block));
        let [a, b] = &self.outward[place];
        let corner = Hinge::new(&inverse, [a, b]);
        let (sin, cos) = Paper::dihedral(&corner);
        (T::angle(sin, cos), corner.omega_s(det))
    }

    /// (Σ_T θ_ST, ω_S as the first cell has it) at each block of points of a hinge.
    pub fn around(&self, mesh: &Mesh<N>, hinge: usize) -> Vec<(T, T)> {
        let mut sums = vec![(T::zero(), T::zero()); self.weights.len()];
        for (first, side) in mesh.star(N - 2, hinge).enumerate() {
            let local = self.g.on_cell(side.cell);
            for (block, (angle, omega)) in sums.iter_mut().enumerate() {
                let (theta, omega_s) = self.at(&local, side.place, block);
                *angle += theta;
                if first == 0 {
                    *omega = omega_s;
                }
            }
        }
        sums
    }
}
