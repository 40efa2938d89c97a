//! A study, computed.

use super::{Case, Interpolation, Named, Row, Study, StudyRules};
use crate::printed;
use regge::Error;
use regge::mesh::{Mesh, SplitMix64};
use regge::norm::HMinus2;
use regge::regge::ReggeSpace;
use regge::smooth::Smooth;
use std::fmt;
use std::time::Instant;

/// What a study is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Makes the mesh.
    Mesh,
    /// Factorises the biharmonic system.
    Factorise,
    /// Makes g_h.
    Interpolate,
    /// Integrates the functional.
    Load,
    /// Solves and takes the norm.
    Norm,
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Mesh => "mesh",
            Self::Factorise => "factorisation",
            Self::Interpolate => "interpolation",
            Self::Load => "functional",
            Self::Norm => "norm",
        })
    }
}

/// What an observer is told.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A phase of a case begins.
    Phase(Case, Phase),
    /// A row is there.
    Row(&'a Row),
    /// All rows of a case are there.
    Done(Case),
}

/// Why and where a study stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The case, if one had begun.
    pub case: Option<Case>,
    /// The reason.
    pub error: Error,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Case { degree, level }) = self.case {
            write!(f, "degree {degree}, level {level}: ")?;
        }
        write!(f, "{}", self.error)
    }
}

impl std::error::Error for Failure {}

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

impl Study {
    /// Computes all rows.
    ///
    /// # Errors
    /// The first thing that fails; rows before have been shown to the observer.
    pub fn run(&self, observe: &mut dyn FnMut(Event<'_>)) -> Result<Vec<Row>, Failure> {
        self.check()
            .map_err(|error| Failure { case: None, error })?;
        let mut rows = Vec::new();
        for &case in &self.cases {
            let done = match self.dimension {
                2 => self.run_case::<2>(case, &mut rows, observe),
                _ => self.run_case::<3>(case, &mut rows, observe),
            };
            done.map_err(|error| Failure {
                case: Some(case),
                error,
            })?;
            observe(Event::Done(case));
        }
        Ok(rows)
    }

    fn run_case<const N: usize>(
        &self,
        case: Case,
        rows: &mut Vec<Row>,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<(), Error> {
        let mut start = Instant::now();
        observe(Event::Phase(case, Phase::Mesh));
        let mesh = mesh::<N>(case.level, mesh_seed(self.seed, case.level))?;
        observe(Event::Phase(case, Phase::Factorise));
        let norm = HMinus2::new(&mesh, case.degree + 2)?;
        let rules = self.quadrature.rules::<N>(case)?;
        for &interpolant in &self.interpolants {
            let mut phase = |phase| observe(Event::Phase(case, phase));
            let error = self.norm_of_quantity(case, interpolant, &norm, &rules, &mut phase)?;
            let mut row = self.row(case, interpolant, &mesh, error);
            row.seconds = start.elapsed().as_secs_f64();
            row.set_order(rows);
            observe(Event::Row(&row));
            rows.push(row);
            start = Instant::now();
        }
        Ok(())
    }

    /// The number that all is about.
    fn norm_of_quantity<const N: usize>(
        &self,
        case: Case,
        interpolant: Interpolation,
        norm: &HMinus2<'_, N>,
        rules: &StudyRules,
        phase: &mut dyn FnMut(Phase),
    ) -> Result<f64, Error> {
        let mesh = norm.space().mesh();
        let g = Smooth::new(mesh, self.metric)?;
        let space = ReggeSpace::new(mesh, case.degree);
        phase(Phase::Interpolate);
        let g_h = interpolant.apply(&space, &g, self.projection)?;
        phase(Phase::Load);
        let load = self.quantity.load(&g, &g_h, norm.space(), &rules.load);
        phase(Phase::Norm);
        let error = norm.norm(&load, rules.norm.as_ref())?.total();
        if error.is_finite() {
            Ok(error)
        } else {
            Err(Error::Solver(format!("the norm is {error}")))
        }
    }

    /// The row without what only the sequence knows.
    fn row<const N: usize>(
        &self,
        case: Case,
        interpolant: Interpolation,
        mesh: &Mesh<N>,
        error: f64,
    ) -> Row {
        Row {
            dimension: N,
            degree: case.degree,
            level: case.level,
            interpolant: interpolant.name_of().into(),
            seed: mesh_seed(self.seed, case.level),
            cells: mesh.cells(),
            ndof: ReggeSpace::new(mesh, case.degree).len(),
            mesh_size: mesh.mesh_size(),
            error,
            order: None,
            printed: printed::series(self.metric, N, self.quantity, case.degree, interpolant)
                .and_then(|series| series.error(case.level)),
            seconds: 0.0,
        }
    }
}
