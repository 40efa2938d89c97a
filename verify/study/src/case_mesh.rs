//! The mesh of a case with all that is computed on it: the one place of a study that knows the dimension when it is
//! compiled.

use crate::case::Case;
use crate::event::Phase;
use crate::quantity::Quantity;
use crate::rules::StudyRules;
use crate::study::Study;
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::norm::{DualNorm, Kind, Representative, Setting, Step};
use regge_curvature::spaces::ReggeSpace;

/// The norm of the studies.
pub(super) const NORM: &str = "hm2";

/// The seed of a level's mesh: a number of 32 bits, which every JSON reader keeps.
pub fn mesh_seed(seed: u64, level: u32) -> u64 {
    let mut stream = SplitMix64::new(seed);
    (0..=level).fold(0, |_, _| stream.next_u64() >> 32)
}

/// The mesh of a level: Freudenthal's cube, its interior vertices moved as in the paper. Paper: section 5.
///
/// # Errors
/// If the move inverts a cell, which another seed cures.
pub fn mesh<const N: usize>(level: u32, mesh_seed: u64) -> Result<Mesh<N>, Error> {
    Mesh::cube(1 << level)?.perturbed_as_in_paper(level, mesh_seed)
}

/// What a row says of its mesh.
pub(super) struct Facts {
    pub(super) cells: usize,
    /// The dimension of the Regge space.
    pub(super) ndof: usize,
    pub(super) mesh_size: f64,
    /// The solver's name.
    pub(super) solver: &'static str,
}

/// A case on its mesh, of whatever dimension.
pub(super) trait CaseMesh {
    /// What a row says of the mesh.
    fn facts(&self) -> Facts;

    /// The functional; g_h is gone when it is there.
    fn load(
        &self,
        quantity: Quantity,
        interpolant: &Interpolant,
        watch: &mut dyn FnMut(Phase),
    ) -> Result<Vec<f64>, Error>;

    /// The solution of the biharmonic problem.
    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error>;

    /// The H⁻² norm that belongs to a solution.
    fn norm(&self, solution: &Representative) -> Result<f64, Error>;
}

/// A case on its mesh of dimension N.
pub(super) struct OnMesh<const N: usize> {
    g: Smooth<Metric, N>,
    space: ReggeSpace<N>,
    norm: Box<dyn DualNorm<N>>,
    rules: StudyRules,
}

impl<const N: usize> OnMesh<N> {
    pub(super) fn new(
        study: &Study,
        case: Case,
        watch: &mut dyn FnMut(Phase),
    ) -> Result<Self, Error> {
        watch(Phase::Mesh);
        let mesh = mesh::<N>(case.level, mesh_seed(study.seed, case.level))?;
        watch(Phase::SetUp);
        let kind = Kind::named(NORM).expect("the library has the norm of the paper");
        Ok(Self {
            norm: (kind.new)(&Setting::new(&mesh, (kind.degree)(case.degree)))?,
            g: Smooth::new(&mesh, study.metric)?,
            space: ReggeSpace::new(&mesh, case.degree),
            rules: study.quadrature.rules(N, case)?,
        })
    }
}

impl<const N: usize> CaseMesh for OnMesh<N> {
    fn facts(&self) -> Facts {
        let mesh = self.space.mesh();
        Facts {
            cells: mesh.cell_count(),
            ndof: self.space.len(),
            mesh_size: mesh.mesh_size(),
            solver: self.norm.solver(),
        }
    }

    fn load(
        &self,
        quantity: Quantity,
        interpolant: &Interpolant,
        watch: &mut dyn FnMut(Phase),
    ) -> Result<Vec<f64>, Error> {
        watch(Phase::Interpolate);
        let g_h = interpolant.apply(&self.space, &self.g)?;
        watch(Phase::Load);
        Ok(quantity.load(&self.g, &g_h, self.norm.space(), &self.rules.load))
    }

    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        self.norm.represent(load, watch)
    }

    fn norm(&self, solution: &Representative) -> Result<f64, Error> {
        let norm = self.norm.measure(solution, self.rules.norm.as_ref())?;
        Ok(norm.total)
    }
}
