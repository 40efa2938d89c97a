//! `regge action`: Regge's action on a mesh from a file, and its gradient.

use super::given::{DETAILS, Given};
use super::output;
use super::phases::Phases;
use super::stop::{Out, Stop};
use regge_verify::curvature::{ActionReport, action};
use std::io::{self, Write};
use std::path::PathBuf;

/// Regge's action: half the curvature's total and the boundary's angles; for degree 0 with its gradient.
#[derive(clap::Args)]
#[command(after_help = DETAILS)]
pub struct Args {
    #[command(flatten)]
    given: Given,
    /// Write everything to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the gradient in the lengths of the inner edges to this file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Args {
    /// Runs the command.
    pub fn run(self) -> Result<(), Stop> {
        self.given.check()?;
        if self.csv.is_some() && self.given.degree > 0 {
            let reason = "the gradient in the edge lengths is for degree 0: see regge einstein";
            return Err(Stop::Usage(reason.into()));
        }
        self.files().try_for_each(|path| output::check(path))?;
        let phases = Phases::new(6);
        phases.begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        let report = action(&mesh, &source, degree, order, &|what| phases.begin(what))?;
        if let Some(path) = &self.json {
            output::json(path, &report)?;
        }
        if let Some(path) = &self.csv {
            output::write_by(path, |out| table(&report, out))?;
        }
        drop(phases);
        self.show(&report)
    }

    fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.json.iter().chain(&self.csv)
    }

    fn show(&self, report: &ActionReport) -> Result<(), Stop> {
        let mut out = Out::new();
        writeln!(
            out,
            "{}: N = {}, Regge metric: {}, degree {}",
            report.mesh, report.dimension, report.interpolant, report.degree
        )?;
        writeln!(out, "action {:.12e}", report.action)?;
        writeln!(
            out,
            "interior {:.12e}, boundary {:.12e}",
            report.interior, report.boundary
        )?;
        if let (Some(largest), Some(residual)) = (report.largest, report.schlaefli) {
            writeln!(out, "largest derivative in an inner edge {largest:.6e}")?;
            writeln!(out, "Schlaefli's identity holds to {residual:.1e}")?;
        }
        for path in self.files() {
            writeln!(out, "written: {}", path.display())?;
        }
        Ok(())
    }
}

fn table(report: &ActionReport, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "i,j,length,derivative")?;
    for e in report.gradient.iter().flatten() {
        let [i, j] = [e.vertices[0], e.vertices[1]];
        writeln!(out, "{i},{j},{:e},{:e}", e.length, e.derivative)?;
    }
    Ok(())
}
