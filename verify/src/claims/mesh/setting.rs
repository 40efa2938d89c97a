//! Where a mesh claim is tried: meshes, degrees, orders of quadrature; and how a claim becomes entries of the run.

use crate::claim::seed::Key;
use crate::claim::{Budget, Case, Check, Equation, Excuses, Judgement, Method, Record, Tally};
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::formulas::Formulas;
use regge_curvature::mesh::Mesh;
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
            Self::Oracle(number) => Ok(regge_oracle::case(number).mesh()),
        };
        // N ≥ 2 and side ≥ 1 (3 on a torus); a tenth of a cell inverts nothing.
        mesh.unwrap_or_else(|e| panic!("{self:?} in dimension {N}: {e}"))
    }

    /// How large it is, roughly: meshes of one dimension in the order of their numbers of cells.
    fn size(self) -> usize {
        match self {
            Self::Single => 0,
            Self::Alfeld => 1,
            Self::Sphere => 2,
            Self::Cube(side) | Self::Torus(side) => 2 + side,
            Self::Oracle(number) => number,
        }
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
    /// Which of a few: of formulas or interpolants, where a claim has them; else which repetition.
    pub pick: usize,
}

impl Setting {
    /// With test functions of degree 2.
    pub const fn new(shape: Shape, degree: usize, order: usize) -> Self {
        Self {
            shape,
            degree,
            order,
            test: 2,
            pick: 0,
        }
    }

    /// The simplest case first: by degree, then by the size of the mesh.
    fn complexity(&self) -> (usize, usize) {
        (self.degree, self.shape.size())
    }
}

/// Every shape with every degree, lowest degree first, `orders[r]` for degree r; each `times` times.
pub fn grid(shapes: &[Shape], orders: &[usize], times: usize) -> Vec<Setting> {
    let mut all = Vec::new();
    for (degree, order) in orders.iter().enumerate() {
        for shape in shapes {
            let at = Setting::new(*shape, degree, *order);
            all.extend((0..times).map(|pick| Setting { pick, ..at }));
        }
    }
    all
}

/// Random numbers of one case.
pub struct Draw {
    runner: TestRunner,
    /// What was drawn.
    drawn: Vec<f64>,
    /// What is to be drawn instead, when a case is replayed.
    given: Option<Vec<f64>>,
}

impl Draw {
    /// The numbers of a case.
    pub fn new(key: &Key<'_>) -> Self {
        Self {
            runner: key.runner(),
            drawn: Vec::new(),
            given: None,
        }
    }

    /// These numbers; further ones as the case has them.
    fn replay(key: &Key<'_>, given: &[f64]) -> Self {
        Self {
            given: Some(given.to_vec()),
            ..Self::new(key)
        }
    }

    /// So many numbers from −1…1.
    pub fn numbers(&mut self, len: usize) -> Vec<f64> {
        let strategy = proptest::collection::vec(-1.0..1.0, len);
        let mut numbers: Vec<f64> = strategy
            .new_tree(&mut self.runner)
            .unwrap_or_else(|e| panic!("{e}"))
            .current();
        if let Some(given) = &self.given {
            for (x, y) in numbers.iter_mut().zip(given.iter().skip(self.drawn.len())) {
                *x = *y;
            }
        }
        self.drawn.extend(&numbers);
        numbers
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
    /// Why there is one method only, or why there are few cases.
    const EXCUSES: Excuses = Excuses::NONE;

    /// The cases in dimension N. The harness runs the simplest first, so that the first failure is the simplest. None
    /// where the claim is not meaningful.
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

    fn cases(&self, budget: &Budget) -> usize {
        C::settings(N, budget.quick).len()
    }
    fn excuses(&self) -> Excuses {
        C::EXCUSES
    }

    fn run(&self, budget: &Budget) -> Entry {
        let mut tally = Tally::new(C::JUDGEMENT);
        let mut settings = C::settings(N, budget.quick);
        settings.sort_by_key(Setting::complexity);
        for (number, at) in settings.into_iter().enumerate() {
            let key = Key {
                seed: budget.seed,
                label: C::RECORD.label,
                dimension: N,
                method: C::METHOD.name(),
                case: number,
            };
            let detail = format!("{:?}, r = {}, order {}", at.shape, at.degree, at.order);
            let mut draw = Draw::new(&key);
            let equations = C::equations::<K, N>(&at, &mut draw);
            if !tally.add(&Case { number, detail }, &equations) {
                tally.shrunk(Self::shrink(&at, &key, draw.drawn));
                break;
            }
        }
        tally.finish(&C::RECORD, N, "f64", C::METHOD)
    }
}

/// How often a failing case is tried with fewer numbers.
const SHRINKS: usize = 32;

impl<C: OnMesh, K: Formulas, const N: usize> MeshCheck<C, K, N> {
    fn equations(at: &Setting, key: &Key<'_>, numbers: &[f64]) -> Vec<Equation<f64>> {
        C::equations::<K, N>(at, &mut Draw::replay(key, numbers))
    }

    /// Sets numbers to zero that the failure does not need: halves of them, quarters, and so on, as long as the budget
    /// lasts. (The mesh and r need no shrinking: the simplest cases come first.)
    fn shrink(at: &Setting, key: &Key<'_>, mut numbers: Vec<f64>) -> Vec<String> {
        let failed = Self::equations(at, key, &numbers);
        let fails = |numbers: &[f64]| {
            let tried = Self::equations(at, key, numbers);
            let mut pairs = tried.iter().zip(&failed);
            pairs.any(|(e, whole)| e.fails_like(whole, C::JUDGEMENT.tolerance()))
        };
        let (mut tries, mut chunk) = (0, numbers.len().div_ceil(2));
        while chunk > 0 && tries < SHRINKS {
            for start in (0..numbers.len()).step_by(chunk) {
                let end = numbers.len().min(start + chunk);
                if tries == SHRINKS || numbers[start..end].iter().all(|x| *x == 0.0) {
                    continue;
                }
                tries += 1;
                let kept = numbers[start..end].to_vec();
                numbers[start..end].fill(0.0);
                if !fails(&numbers) {
                    numbers[start..end].copy_from_slice(&kept);
                }
            }
            chunk /= 2;
        }
        let nonzero = numbers.iter().enumerate().filter(|(_, x)| **x != 0.0);
        nonzero.map(|(k, x)| format!("#{k} = {x:?}")).collect()
    }
}
