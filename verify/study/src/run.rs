//! A study, computed.

use crate::case::Case;
use crate::case_mesh::{CaseMesh, Facts, OnMesh, mesh_seed};
use crate::event::{Event, Failure, Phase};
use crate::pace::Pace;
use crate::printed;
use crate::row::Row;
use crate::study::Study;
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use std::time::Instant;

impl Study {
    /// Computes all rows.
    ///
    /// # Errors
    /// The first thing that fails; rows before have been shown to the observer.
    pub fn run(&self, observe: &mut dyn FnMut(Event<'_>)) -> Result<Vec<Row>, Failure> {
        self.resume(&[], Pace::Single, observe)
    }

    /// The rows of a case; its mesh is not made if an earlier run has them all.
    pub(super) fn run_case(
        &self,
        case: Case,
        earlier: &[Row],
        rows: &mut Vec<Row>,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<(), Error> {
        let mut on_mesh: Option<Box<dyn CaseMesh>> = None;
        let mut start = Instant::now();
        for interpolant in &self.interpolants {
            let mut row = match known(earlier, case, interpolant) {
                Some(row) => row.clone(),
                None => {
                    let on_mesh = match &mut on_mesh {
                        Some(on_mesh) => on_mesh,
                        none => none.insert(self.case_mesh(case, observe)?),
                    };
                    let mut row = self.compute(case, interpolant, &**on_mesh, observe)?;
                    row.seconds = start.elapsed().as_secs_f64();
                    start = Instant::now();
                    row
                }
            };
            row.set_order(rows);
            observe(Event::Row(&row));
            rows.push(row);
        }
        Ok(())
    }

    fn case_mesh(
        &self,
        case: Case,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Box<dyn CaseMesh>, Error> {
        let mut watch = |phase| observe(Event::Phase(case, phase));
        match self.dimension {
            2 => Ok(Box::new(OnMesh::<2>::new(self, case, &mut watch)?)),
            3 => Ok(Box::new(OnMesh::<3>::new(self, case, &mut watch)?)),
            n => Err(Error::Input(format!("dimension {n} is not 2 or 3"))),
        }
    }

    /// The number that all is about, and how it was found.
    fn compute(
        &self,
        case: Case,
        interpolant: &Interpolant,
        on_mesh: &dyn CaseMesh,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Row, Error> {
        let mut row = self.row(case, interpolant, on_mesh.facts());
        let projected = self.projection.inside(*interpolant);
        let load = on_mesh.load(self.quantity, &projected, &mut |phase| {
            observe(Event::Phase(case, phase));
        })?;
        observe(Event::Phase(case, Phase::Solve));
        let solution = on_mesh.solve(&load, &mut |step| {
            row.steps = Some(step.number);
            observe(Event::Step(case, step));
        })?;
        drop(load);
        observe(Event::Phase(case, Phase::Norm));
        row.error = on_mesh.norm(&solution)?;
        match row.error.is_finite() {
            true => Ok(row),
            false => Err(Error::Solver(format!("the norm is {}", row.error))),
        }
    }

    /// The row before anything is computed.
    fn row(&self, case: Case, interpolant: &Interpolant, mesh: Facts) -> Row {
        let (n, degree) = (self.dimension, case.degree);
        Row {
            dimension: n,
            degree,
            level: case.level,
            interpolant: interpolant.name().into(),
            seed: mesh_seed(self.seed, case.level),
            cells: mesh.cells,
            ndof: mesh.ndof,
            mesh_size: mesh.mesh_size,
            error: f64::NAN,
            order: None,
            printed: printed::series(self.metric, n, self.quantity, degree, interpolant)
                .and_then(|series| series.error(case.level)),
            seconds: 0.0,
            solver: mesh.solver.into(),
            steps: None,
        }
    }
}

impl Study {
    /// Has an earlier run all rows of a case?
    pub(super) fn knows(&self, earlier: &[Row], case: Case) -> bool {
        let mut all = self.interpolants.iter();
        all.all(|interpolant| known(earlier, case, interpolant).is_some())
    }
}

/// The row of a case that an earlier run has.
fn known<'a>(earlier: &'a [Row], case: Case, interpolant: &Interpolant) -> Option<&'a Row> {
    earlier.iter().find(|row| {
        (row.degree, row.level) == (case.degree, case.level)
            && row.interpolant == interpolant.name()
    })
}
