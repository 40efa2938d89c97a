//! The form a_h and the distributional Einstein tensor. Paper: thm:distcurvdot, def:distein.

use super::measure::{Density, Where, full_angle};
use super::seen::{OnCell, Seen, Sites, all_sites};
use super::walk::pair;
use super::{Rules, Sums, Three};
use crate::field::{Evaluate, TensorField};
use crate::formulas::{Formulas, times};
use crate::linalg::Mat;
use crate::mesh::Mesh;
use crate::scalar::Real;
use crate::simplex::subsets;
use crate::spaces::{Lagrange, ReggeSpace, Scalar, Symmetric, TestSpace, Value};

/// a_h(g; σ, v) = Σ_T ∫ ⟨G, σ⟩ v ω + Σ̊_F ∫ ⟨⟦II‾⟧, σ|_F⟩ v ω_F − Σ̊_S ∫ ⟨Θ_S g|_S, σ|_S⟩ v ω_S for every v.
///
/// Paper: thm:distcurvdot.
pub fn a_h<const N: usize, G: TensorField<N>, H: Evaluate<G::Wide, N>>(
    g: &G,
    sigma: &H,
    space: &impl TestSpace<N, Value = Scalar>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    tested_with::<G::Wide, N, G, H>(g, sigma, space, Where::Interior, rules)
}

/// What the faces and hinges of the boundary would have of a_h: Σ_{F⊂∂Ω} ∫ ⟨II‾, σ|_F⟩ v ω_F
/// − Σ_{S⊂∂Ω} ∫ (π − Σ_T θ_ST) ⟨g|_S, σ|_S⟩ v ω_S.
pub(super) fn boundary_a_h<const N: usize, G: TensorField<N>, H: Evaluate<G::Wide, N>>(
    g: &G,
    sigma: &H,
    space: &impl TestSpace<N, Value = Scalar>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    tested_with::<G::Wide, N, G, H>(g, sigma, space, Where::Boundary, rules)
}

fn tested_with<T: Real, const N: usize, G: Evaluate<T, N>, H: Evaluate<T, N>>(
    g: &G,
    sigma: &H,
    space: &dyn TestSpace<N, Value = Scalar>,
    on: Where,
    rules: &Rules,
) -> Sums<T::Sum> {
    let sites = all_sites(N, rules);
    let against = Field {
        sigma,
        tables: sites.each_ref().map(|sites| sites.tables(sigma)),
    };
    against_all::<T, N, G, _>(g, &against, space, &sites, on, rules)
}

/// ⟨(Gω)_dist(g), σ⟩ as its three sums: a_h with v = 1. Paper: def:distein.
pub fn einstein<const N: usize, G: TensorField<N>, H: Evaluate<G::Wide, N>>(
    g: &G,
    sigma: &H,
    mesh: &Mesh<N>,
    rules: &Rules,
) -> Three<G::Scalar> {
    // The hat functions add up to one.
    let hats = Lagrange::new(mesh, 1);
    a_h(g, sigma, &hats, rules).pair(&vec![1.0; hats.len()])
}

/// ⟨(Gω)_dist(g), ψ_i⟩ for every basis function ψ_i of a Regge space. Paper: def:distein.
///
/// Functions that do not vanish on the boundary are tested as they are: no boundary term is added. The same numbers as
/// [`einstein`] gives one by one.
pub fn einstein_against<const N: usize, G: TensorField<N>>(
    g: &G,
    space: &ReggeSpace<N>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    let sites = all_sites(N, rules);
    let against = EdgeComponents::new(&sites);
    against_all::<G::Wide, N, G, _>(g, &against, space, &sites, Where::Interior, rules)
}

/// What G ω, II‾ ω_F and −Θ g|_S ω_S are contracted with before they meet the test functions.
pub(super) trait Against<T: Real, const N: usize>: Sync {
    /// The values of the test functions that are left.
    type Value: Value;
    /// What is prepared for a cell.
    type Local;
    fn on_cell(&self, cell: usize) -> Self::Local;
    /// Is it constant on every cell?
    fn is_constant(&self) -> bool;
    /// Calls `take` with each of the tensors on a simplex of this codimension and place at a block of points.
    fn each(
        &self,
        at: &Self::Local,
        codimension: usize,
        place: usize,
        block: usize,
        take: impl FnMut(&Mat<T, N>),
    );
}

/// A field σ: numbers are left.
struct Field<'a, H, Table> {
    sigma: &'a H,
    tables: [Vec<Table>; 3],
}

impl<T: Real, const N: usize, H: Evaluate<T, N>> Against<T, N> for Field<'_, H, H::Table> {
    type Value = Scalar;
    type Local = H::Local;

    fn on_cell(&self, cell: usize) -> H::Local {
        self.sigma.on_cell(cell)
    }

    fn is_constant(&self) -> bool {
        self.sigma.is_constant()
    }

    #[inline]
    fn each(
        &self,
        at: &H::Local,
        codimension: usize,
        place: usize,
        block: usize,
        mut take: impl FnMut(&Mat<T, N>),
    ) {
        take(
            &self
                .sigma
                .value(at, &self.tables[codimension][place], block),
        );
    }
}

/// The tensors with one edge component 1 and all others 0, of each edge of the simplex: the directions of [`Symmetric`].
pub(super) struct EdgeComponents<T: Real, const N: usize> {
    /// By codimension, place and edge.
    units: [Vec<Vec<Mat<T, N>>>; 3],
}

impl<T: Real, const N: usize> EdgeComponents<T, N> {
    /// Of the edges of these simplices.
    pub fn new(sites: &[Sites; 3]) -> Self {
        Self {
            units: sites.each_ref().map(unit_tensors),
        }
    }
}

impl<T: Real, const N: usize> Against<T, N> for EdgeComponents<T, N> {
    type Value = Symmetric;
    type Local = ();

    fn on_cell(&self, _cell: usize) {}

    fn is_constant(&self) -> bool {
        true
    }

    #[inline]
    fn each(
        &self,
        (): &(),
        codimension: usize,
        place: usize,
        _block: usize,
        take: impl FnMut(&Mat<T, N>),
    ) {
        self.units[codimension][place].iter().for_each(take);
    }
}

fn unit_tensors<T: Real, const N: usize>(sites: &Sites) -> Vec<Vec<Mat<T, N>>> {
    let edges = |on: &Vec<usize>| {
        let pairs = subsets(on.len(), 2).into_iter();
        pairs.map(|e| unit_tensor(on[e[0]], on[e[1]])).collect()
    };
    sites.vertices.iter().map(edges).collect()
}

/// The tensor whose edge component q_ab is 1 and all others 0: g_ij = ½(q_0i + q_0j − q_ij).
fn unit_tensor<T: Real, const N: usize>(a: usize, b: usize) -> Mat<T, N> {
    Mat::from_fn(|i, j| {
        let (i, j) = (i + 1, j + 1);
        let q = |v: usize, w: usize| T::from_int(i64::from((v.min(w), v.max(w)) == (a, b)));
        (q(0, i) + q(0, j) - q(i, j)) * T::half()
    })
}

fn against_all<T: Real, const N: usize, G: Evaluate<T, N>, A: Against<T, N>>(
    g: &G,
    against: &A,
    space: &dyn TestSpace<N, Value = A::Value>,
    sites: &[Sites; 3],
    on: Where,
    rules: &Rules,
) -> Sums<T::Sum> {
    let formulas = &rules.formulas;
    let seen = Seen::<T, N, G>::new(g, sites, formulas);
    let density = Einstein {
        seen,
        against,
        on,
        formulas,
    };
    let mut sums = pair(space.mesh(), &density, on, &[space], rules);
    sums.pop().expect("one space, one result")
}

/// G ω, II‾ ω_F, −Θ_S g|_S ω_S, contracted.
struct Einstein<'a, T: Real, const N: usize, G: Evaluate<T, N>, A> {
    seen: Seen<'a, T, N, G>,
    against: &'a A,
    on: Where,
    formulas: &'a Formulas,
}

impl<T, const N: usize, G, A> Density<T, N> for Einstein<'_, T, N, G, A>
where
    T: Real,
    G: Evaluate<T, N>,
    A: Against<T, N>,
{
    type Value = A::Value;
    type Local = (OnCell<G::Local, T, N>, A::Local);

    fn sums(&self) -> [bool; 3] {
        let curved = !self.seen.g.is_constant();
        [curved && self.on == Where::Interior, curved, true]
    }

    fn is_constant_on_hinges(&self) -> bool {
        self.seen.g.is_constant() && self.against.is_constant()
    }

    fn full_angle(&self) -> T {
        full_angle(self.formulas, self.on)
    }

    fn on_cell(&self, cell: usize) -> Self::Local {
        (self.seen.on_cell(cell), self.against.on_cell(cell))
    }

    #[inline]
    fn in_cell(&self, (g, at): &Self::Local, block: usize, out: &mut [T]) {
        self.seen.inside(g, block, |inside, connection| {
            let (einstein, omega) = inside.einstein();
            let factor = times(self.formulas.a_cells, omega);
            let mut out = out.iter_mut();
            self.against.each(at, 0, 0, block, |psi| {
                *out.next().expect("a number for each tensor") =
                    connection.inner(&einstein, psi) * factor;
            });
        });
    }

    #[inline]
    fn on_face(&self, (g, at): &Self::Local, place: usize, block: usize, out: &mut [T]) {
        self.seen.side(g, place, block, |side| {
            let reversed = side.trace_reversed();
            let factor = times(self.formulas.a_faces, side.normal.omega);
            let mut out = out.iter_mut();
            self.against.each(at, 1, place, block, |psi| {
                *out.next().expect("a number for each tensor") =
                    side.normal.inner(&reversed, psi) * factor;
            });
        });
    }

    #[inline]
    fn at_hinge(
        &self,
        (g, at): &Self::Local,
        place: usize,
        block: usize,
        factors: Option<&mut [T]>,
    ) -> T {
        self.seen.corner(g, place, block, |corner| {
            if let Some(factors) = factors {
                let factor = times(self.formulas.a_hinges, corner.omega());
                let mut factors = factors.iter_mut();
                self.against.each(at, 2, place, block, |psi| {
                    *factors.next().expect("a number for each tensor") = corner.trace(psi) * factor;
                });
            }
            corner.angle()
        })
    }
}
