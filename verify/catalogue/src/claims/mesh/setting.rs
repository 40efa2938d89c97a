//! Where a mesh claim is tried: meshes, degrees, orders of quadrature; and how a claim becomes entries of the run.

use crate::claim::seed::Key;
use crate::claim::{Budget, Case, Check, Equation, Judgement, Method, Record, Tally};
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge::formulas::Formulas;
use regge::mesh::Mesh;
use std::marker::PhantomData;

/// A mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One simplex.
    Single,
    /// One simplex cut at its barycentre: a boundary, one interior vertex, obtuse dihedral angles.
    Alfeld,
    /// (−1, 1)^N with this many cubes a side, inner vertices moved.
    Cube(usize),
    /// The flat torus with this many cubes a side.
    Torus(usize),
    /// ∂Δ^{N+1}.
    Sphere,
    /// The mesh of a reference case, by its number.
    Oracle(usize),
}

impl Shape {
    /// The mesh.
    pub fn mesh<const N: usize>(self) -> Mesh<N> {
        let mesh = match self {
            Self::Single => Mesh::single(),
            Self::Alfeld => Mesh::alfeld(),
            Self::Cube(side) => {
                Mesh::cube(side).and_then(|m| m.perturbed(0.2 / side as f64, side as u64))
            }
            Self::Torus(side) => Mesh::torus(side),
            Self::Sphere => Mesh::simplex_boundary(),
            Self::Oracle(number) => Ok(crate::oracle::case(number).mesh()),
        };
        // N ≥ 2 and side ≥ 1 (3 on a torus); a tenth of a cell inverts nothing.
        mesh.unwrap_or_else(|e| panic!("{self:?} in dimension {N}: {e}"))
    }

    /// Without boundary?
    pub fn is_closed(self) -> bool {
        matches!(self, Self::Torus(_) | Self::Sphere)
    }
}

/// One case: a mesh, the degree r of the fields, the order of the quadrature.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The mesh.
    pub shape: Shape,
    /// r.
    pub degree: usize,
    /// Exactness of the rules on cells, faces and hinges.
    pub order: usize,
    /// The degree of the test functions.
    pub test: usize,
}

impl Setting {
    /// With test functions of degree 2.
    pub const fn new(shape: Shape, degree: usize, order: usize) -> Self {
        Self {
            shape,
            degree,
            order,
            test: 2,
        }
    }
}

/// Every shape with every degree, lowest degree first, `orders[r]` for degree r; each `times` times.
pub fn grid(shapes: &[Shape], orders: &[usize], times: usize) -> Vec<Setting> {
    let mut all = Vec::new();
    for (degree, order) in orders.iter().enumerate() {
        for shape in shapes {
            all.extend((0..times).map(|_| Setting::new(*shape, degree, *order)));
        }
    }
    all
}

/// Random numbers of one case.
pub struct Draw(TestRunner);

impl Draw {
    /// The numbers of a case.
    pub fn new(key: &Key<'_>) -> Self {
        Self(key.runner())
    }

    /// So many numbers from −1…1.
    pub fn numbers(&mut self, len: usize) -> Vec<f64> {
        let strategy = proptest::collection::vec(-1.0..1.0, len);
        strategy
            .new_tree(&mut self.0)
            .unwrap_or_else(|e| panic!("{e}"))
            .current()
    }
}

/// A statement about fields on a mesh.
pub trait OnMesh: Send + Sync + 'static {
    /// What the page says.
    const RECORD: Record;
    /// How.
    const METHOD: Method = Method::Ad;
    /// How the residuals are judged.
    const JUDGEMENT: Judgement;

    /// The cases in dimension N, simplest first: the first failure that is reported is the simplest. None where the
    /// claim is not meaningful.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting>;

    /// The equations of one case.
    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>>;
}

/// The judgement of identities that hold at every quadrature point: sums of 10⁴ terms at the most, each with an
/// error of a few hundred ulps (inverse of g, derivatives of products).
pub const ROUNDING: Judgement = Judgement::Rounding { tolerance: 1e-12 };
/// The judgement of identities between integrals of functions that are no polynomials: at the order of the case the
/// rules' errors have fallen below this.
pub const QUADRATURE: Judgement = Judgement::Quadrature { tolerance: 1e-11 };

/// A mesh claim in dimension N by the formulas K.
pub struct MeshCheck<C, K, const N: usize>(PhantomData<fn() -> (C, K)>);

impl<C, K, const N: usize> Default for MeshCheck<C, K, N> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<C: OnMesh, K: Formulas, const N: usize> Check for MeshCheck<C, K, N> {
    fn record(&self) -> &'static Record {
        &C::RECORD
    }
    fn dimension(&self) -> usize {
        N
    }
    fn method(&self) -> Method {
        C::METHOD
    }

    fn run(&self, budget: &Budget) -> Entry {
        let mut tally = Tally::new(C::JUDGEMENT);
        for (number, at) in C::settings(N, budget.quick).into_iter().enumerate() {
            let key = Key {
                seed: budget.seed,
                label: C::RECORD.label,
                dimension: N,
                method: C::METHOD.name(),
                case: number,
            };
            let detail = format!("{:?}, r = {}, order {}", at.shape, at.degree, at.order);
            let equations = C::equations::<K, N>(&at, &mut Draw::new(&key));
            if !tally.add(&Case { number, detail }, &equations) {
                break;
            }
        }
        tally.finish(&C::RECORD, N, "f64", C::METHOD)
    }
}
