//! `regge action`: Regge's action on a mesh from a file, and its gradient.

use super::files::{self, Files};
use super::given::{DETAILS, Given, stopped};
use regge_cli::curvature::{ActionReport, action};
use regge_terminal::{Bar, Out, Stop};
use std::io::{self, Write};

/// About how many phases the command has.
const PHASES: u64 = 6;

/// Regge's action: half the curvature's total and the boundary's angles; for degree 0 with its gradient.
#[derive(clap::Args)]
#[command(after_help = DETAILS)]
pub struct Args {
    #[command(flatten)]
    given: Given,
    #[command(flatten)]
    files: Files,
}

impl Args {
    /// Runs the command.
    pub fn run(self) -> Result<(), Stop> {
        self.given.check()?;
        if self.files.csv.is_some() && self.given.degree > 0 {
            let reason = "the gradient in the edge lengths is for degree 0: see regge einstein";
            return Err(Stop::Usage(reason.into()));
        }
        files::check(self.files.list())?;
        let bar = Bar::new(PHASES);
        let begin = |what: &'static str| bar.advance(PHASES, what);
        begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        let report = action(&mesh, &source, degree, order, &begin).map_err(stopped)?;
        self.files.write(&report, table)?;
        drop(bar);
        self.show(&report)
    }

    fn show(&self, report: &ActionReport) -> Result<(), Stop> {
        let mut out = Out::new();
        files::show_metric(&mut out, &report.about)?;
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
        files::show_written(&mut out, self.files.list())
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
