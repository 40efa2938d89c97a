//! The discrete biharmonic problem: its unknowns, cell operators and moment tensors.

pub(super) mod cell;
pub(super) mod element;
pub(super) mod layout;
mod size;

pub(super) use size::Size;

use super::dual::Representative;
use crate::Error;
use crate::linalg::{Mat, Vector};
use crate::mesh::Mesh;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, Points};
use crate::spaces::Lagrange;
use cell::{Shape, eliminate};
use element::Element;
use layout::{Layout, slopes};
use nalgebra::DMatrix;

/// The hybridised Hellan–Herrmann–Johnson discretisation of Δ²u = f, u ∈ H²₀, on a mesh in ℝ^N.
///
/// Unknowns: u in [`Lagrange`] of degree p, zero on ∂Ω; on each interior face the slope û ∈ P_{p−1}, which is
/// ∂u/∂n for the normal that leaves the first (lowest) of its two cells, in the face's Bernstein basis. The moments
/// σ ∈ P_{p−1} are eliminated cell by cell, σ(u, û); û makes their normal-normal components continuous. The problem is
/// Σ_T |σ(u, û)|²_{L²(T)}/2 − f(u) → min.
///
/// A solution is a [`Representative`]: the coefficients of u in the Lagrange space, then face by face those of û; zero
/// where clamped.
#[derive(Clone, Debug)]
pub struct Hhj<const N: usize> {
    space: Lagrange<N>,
    element: Element<N>,
}

impl<const N: usize> Hhj<N> {
    /// The problem with u of degree p and moments of degree p−1.
    ///
    /// # Errors
    /// If p = 0, the mesh has no coordinates, or it has no boundary to be clamped at.
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Result<Self, Error> {
        if degree == 0 {
            return Err(Error::Input(
                "the method of Hellan, Herrmann and Johnson needs degree ≥ 1".into(),
            ));
        }
        if mesh.is_closed() {
            return Err(Error::Input(
                "a mesh without boundary cannot be clamped".into(),
            ));
        }
        if !mesh.has_coordinates() {
            return Err(Error::NoCoordinates("the biharmonic problem"));
        }
        let space = Lagrange::new(mesh, degree);
        Ok(Self {
            element: Element::new(&space),
            space,
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        self.space.mesh()
    }

    /// The space of u, in whose basis loads are given.
    pub fn space(&self) -> &Lagrange<N> {
        &self.space
    }

    /// How many coefficients a solution has.
    pub fn len(&self) -> usize {
        self.space.len() + self.mesh().count(N - 1) * slopes(N, self.space.degree())
    }

    /// Whether there are none, which no mesh is small enough for.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Where in a solution the unknowns of a cell are, in the order of [`Hhj::energy`].
    pub fn cell_unknowns(&self, cell: usize) -> Vec<usize> {
        let layout = self.layout();
        let mut unknowns = vec![0; layout.len];
        for (&local, dof) in layout.bernstein.iter().zip(self.space.cell_dofs(cell)) {
            unknowns[local] = dof;
        }
        let per_face = slopes(N, self.space.degree());
        for (moments, &face) in layout
            .faces
            .iter()
            .zip(self.mesh().simplices_of(cell, N - 1))
        {
            for (beta, moment) in moments.iter().enumerate() {
                unknowns[moment.slope] = self.space.len() + face as usize * per_face + beta;
            }
        }
        unknowns
    }

    /// The matrix of |σ(u, û)|²_{L²(T)}, a cell's contribution to the system: symmetric, positive semidefinite, zero
    /// on affine u with its û.
    pub fn energy(&self, cell: usize) -> DMatrix<f64> {
        self.shape(cell).energy(&self.element)
    }

    /// [`Hhj::energy`] without the bubbles, as [`eliminate`] leaves it.
    pub(in crate::norm) fn condensed(&self, cell: usize) -> DMatrix<f64> {
        let mut energy = self.energy(cell);
        eliminate(&mut energy, self.layout().bubbles);
        energy
    }

    /// A solver's error with the cell that is most likely its reason: the one that is flattest for its size.
    pub(in crate::norm) fn blame(&self, error: Error) -> Error {
        let Error::Solver(reason) = error else {
            return error;
        };
        let flatness = |cell: usize| {
            let shape = self.shape(cell);
            let heights = shape.faces.iter().map(|face| face.height.abs());
            // |J|, from which the longest edge is not far.
            heights.fold(f64::INFINITY, f64::min) / shape.jacobian.norm()
        };
        let cells = (0..self.mesh().cell_count()).map(|cell| (cell, flatness(cell)));
        let worst = cells.min_by(|(_, a), (_, b)| a.total_cmp(b));
        let (cell, flatness) = worst.expect("a mesh has cells");
        let vertices = self.mesh().vertices(N, cell);
        Error::Solver(format!(
            "{reason}; the flattest cell is number {cell} with the vertices {vertices:?}, its height {flatness:.1e} of its size"
        ))
    }

    /// σ at points of a cell, Cartesian components; symmetric.
    pub fn moment(
        &self,
        solution: &Representative,
        cell: usize,
        points: &Points,
    ) -> Vec<Mat<f64, N>> {
        let phi = self.element.moments.tabulate(points);
        let shape = self.shape(cell);
        let s = self.tensor(solution, cell, &shape);
        phi.iter()
            .map(|phi| self.cartesian(&shape, &s, phi))
            .collect()
    }

    /// |u|², |∇u|² and |σ|² integrated over a cell by a rule that comes with its table.
    pub(in crate::norm) fn squares(
        &self,
        solution: &Representative,
        cell: usize,
        table: &Table<N>,
    ) -> [f64; 3] {
        let shape = self.shape(cell);
        let s = self.tensor(solution, cell, &shape);
        let u: Vec<f64> = self
            .space
            .cell_dofs(cell)
            .map(|dof| solution.coefficients[dof])
            .collect();
        let mut squares = [0.0; 3];
        for (q, weight) in table.weights.iter().enumerate() {
            let (mut value, mut d) = (0.0, Vector::<f64, N>::zeros());
            for (c, (b, db)) in u.iter().zip(&table.u[q]) {
                value += c * b;
                d += *db * *c;
            }
            // |∇u|² = g^{ij} ∂_i u ∂_j u.
            let slope = d.dot(&(shape.inverse * d));
            let sigma = self.cartesian(&shape, &s, &table.phi[q]).norm_squared();
            for (sum, square) in squares.iter_mut().zip([value * value, slope, sigma]) {
                *sum += weight * shape.volume * square;
            }
        }
        squares
    }

    /// The basis functions at the points of a rule.
    pub(in crate::norm) fn table(&self, rule: &Rule) -> Table<N> {
        let jets =
            Bernstein::new(N + 1, self.space.degree()).tabulate_jets::<f64, N>(rule.points());
        Table {
            weights: rule.weights().to_vec(),
            u: jets
                .iter()
                .map(|row| row.iter().map(|b| (b.value, b.d.into())).collect())
                .collect(),
            phi: self.element.moments.tabulate(rule.points()),
        }
    }

    /// The numbering in a cell.
    pub(in crate::norm) fn layout(&self) -> &Layout {
        &self.element.layout
    }

    /// The reference element.
    pub(in crate::norm) fn element(&self) -> &Element<N> {
        &self.element
    }

    /// The shape of a cell, made anew each time.
    pub(in crate::norm) fn shape(&self, cell: usize) -> Shape<N> {
        Shape::new(self.mesh(), cell).expect("there are coordinates")
    }

    /// The barycentres of the cells.
    pub(in crate::norm) fn centres(&self) -> Vec<Vector<f64, N>> {
        let cells = 0..self.mesh().cell_count();
        cells.map(|cell| self.shape(cell).centre).collect()
    }

    /// The coefficients of σ in a cell: reference component a along φ_k in `[(k, a)]`.
    fn tensor(&self, solution: &Representative, cell: usize, shape: &Shape<N>) -> DMatrix<f64> {
        let local: Vec<f64> = self
            .cell_unknowns(cell)
            .into_iter()
            .map(|i| solution.coefficients[i])
            .collect();
        shape.tensor(&self.element, &local)
    }

    /// σ = J S Jᵀ with S = Σ_a (Σ_k `s[(k, a)]` φ_k) E_a.
    fn cartesian(&self, shape: &Shape<N>, s: &DMatrix<f64>, phi: &[f64]) -> Mat<f64, N> {
        let mut tensor = Mat::<f64, N>::zeros();
        for (a, &(i, j)) in self.element.pairs.iter().enumerate() {
            let component: f64 = phi.iter().enumerate().map(|(k, phi)| s[(k, a)] * phi).sum();
            tensor[(i, j)] = component;
            tensor[(j, i)] = component;
        }
        shape.jacobian * tensor * shape.jacobian.transpose()
    }
}

/// The bases at the points of a rule.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Table<const N: usize> {
    weights: Vec<f64>,
    /// `[point][α]`: B_α and its derivatives in reference coordinates.
    u: Vec<Vec<(f64, Vector<f64, N>)>>,
    /// `[point][k]`.
    phi: Vec<Vec<f64>>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

    /// The counts are those of the problem itself, bubbles or not.
    #[test]
    fn of_a_problem() {
        fn check<const N: usize>(mesh: &Mesh<N>, degree: usize) {
            let counts: Vec<usize> = (0..=N).map(|k| mesh.count(k)).collect();
            let (size, hhj) = (Size::new(&counts, degree), Hhj::new(mesh, degree).unwrap());
            let layout = hhj.layout();
            assert_eq!(size.coefficients(), hhj.len());
            assert_eq!(size.functions(), hhj.space().len());
            assert_eq!(size.outer(), layout.len - layout.bubbles);
            let bubbles = layout.bubbles * mesh.cell_count();
            assert_eq!(size.unknowns(), hhj.len() - bubbles);
        }
        for degree in 1..=5 {
            check(&Mesh::<2>::cube(3).unwrap(), degree);
            check(&Mesh::<3>::cube(2).unwrap(), degree);
        }
    }
}
