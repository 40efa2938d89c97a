//! A study, computed.

use super::{Case, Interpolation, Named, Row, Study, StudyRules};
use crate::printed;
use regge_curvature::Error;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::Smooth;
use regge_curvature::norm::{HMinus2, Step};
use regge_curvature::spaces::ReggeSpace;
use std::fmt;
use std::time::Instant;

/// What a study is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Makes the mesh.
    Mesh,
    /// Sets up the solver of the biharmonic problem.
    SetUp,
    /// Makes g_h.
    Interpolate,
    /// Integrates the functional.
    Load,
    /// Solves the biharmonic problem.
    Solve,
    /// Takes the norm.
    Norm,
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Mesh => "mesh",
            Self::SetUp => "set-up of the solver",
            Self::Interpolate => "interpolation",
            Self::Load => "functional",
            Self::Solve => "solution",
            Self::Norm => "norm",
        })
    }
}

/// What an observer is told.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A phase of a case begins.
    Phase(Case, Phase),
    /// A step of an iterative solver.
    Step(Case, Step),
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
        self.resume(&[], observe)
    }

    /// Computes the rows that are not among those of an earlier run, which the observer sees in their places.
    ///
    /// # Errors
    /// As [`Study::run`].
    pub fn resume(
        &self,
        earlier: &[Row],
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Vec<Row>, Failure> {
        self.check()
            .map_err(|error| Failure { case: None, error })?;
        let mut rows = Vec::new();
        for &case in &self.cases {
            let done = match self.dimension {
                2 => self.run_case::<2>(case, earlier, &mut rows, observe),
                _ => self.run_case::<3>(case, earlier, &mut rows, observe),
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
        earlier: &[Row],
        rows: &mut Vec<Row>,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<(), Error> {
        let known = |interpolant: Interpolation| {
            let name = interpolant.name_of();
            let same = |row: &&Row| (row.degree, row.level) == (case.degree, case.level);
            earlier
                .iter()
                .filter(same)
                .find(|row| row.interpolant == name)
        };
        let mut emit = |mut row: Row, observe: &mut dyn FnMut(Event<'_>)| {
            row.set_order(rows);
            observe(Event::Row(&row));
            rows.push(row);
        };
        if self.interpolants.iter().all(|&i| known(i).is_some()) {
            let all = self.interpolants.iter().filter_map(|&i| known(i));
            all.for_each(|row| emit(row.clone(), observe));
            return Ok(());
        }
        let mut start = Instant::now();
        observe(Event::Phase(case, Phase::Mesh));
        let mesh = mesh::<N>(case.level, mesh_seed(self.seed, case.level))?;
        observe(Event::Phase(case, Phase::SetUp));
        let norm = HMinus2::new(&mesh, case.degree + 2)?;
        let rules = self.quadrature.rules::<N>(case)?;
        for &interpolant in &self.interpolants {
            if let Some(row) = known(interpolant) {
                emit(row.clone(), observe);
                continue;
            }
            let mut row = self.row(case, interpolant, &norm);
            self.compute(case, interpolant, &norm, &rules, &mut row, observe)?;
            row.seconds = start.elapsed().as_secs_f64();
            emit(row, observe);
            start = Instant::now();
        }
        Ok(())
    }

    /// The number that all is about, and how it was found.
    fn compute<const N: usize>(
        &self,
        case: Case,
        interpolant: Interpolation,
        norm: &HMinus2<N>,
        rules: &StudyRules,
        row: &mut Row,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<(), Error> {
        let load = self.load(case, interpolant, norm, rules, observe)?;
        observe(Event::Phase(case, Phase::Solve));
        let solution = norm.solve_watched(&load, &mut |step| {
            row.steps = Some(step.number);
            observe(Event::Step(case, step));
        })?;
        drop(load);
        observe(Event::Phase(case, Phase::Norm));
        row.error = norm.norm_of(&solution, rules.norm.as_ref())?.total();
        match row.error.is_finite() {
            true => Ok(()),
            false => Err(Error::Solver(format!("the norm is {}", row.error))),
        }
    }

    /// The functional; g_h is gone when it is there.
    fn load<const N: usize>(
        &self,
        case: Case,
        interpolant: Interpolation,
        norm: &HMinus2<N>,
        rules: &StudyRules,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Vec<f64>, Error> {
        let mesh = norm.space().mesh();
        let g = Smooth::new(mesh, self.metric)?;
        let space = ReggeSpace::new(mesh, case.degree);
        observe(Event::Phase(case, Phase::Interpolate));
        let g_h = interpolant.apply(&space, &g, self.projection)?;
        observe(Event::Phase(case, Phase::Load));
        Ok(self.quantity.load(&g, &g_h, norm.space(), &rules.load))
    }

    /// The row before anything is computed.
    fn row<const N: usize>(
        &self,
        case: Case,
        interpolant: Interpolation,
        norm: &HMinus2<N>,
    ) -> Row {
        let mesh = norm.space().mesh();
        Row {
            dimension: N,
            degree: case.degree,
            level: case.level,
            interpolant: interpolant.name_of().into(),
            seed: mesh_seed(self.seed, case.level),
            cells: mesh.cell_count(),
            ndof: ReggeSpace::new(mesh, case.degree).len(),
            mesh_size: mesh.mesh_size(),
            error: f64::NAN,
            order: None,
            printed: printed::series(self.metric, N, self.quantity, case.degree, interpolant)
                .and_then(|series| series.error(case.level)),
            seconds: 0.0,
            solver: norm.solver().into(),
            steps: None,
        }
    }
}
