//! `regge einstein`: the distributional Einstein tensor on a mesh from a file.

use super::files::{self, Files};
use super::given::{DETAILS, Given, stopped};
use regge_cli::curvature::{EinsteinReport, einstein};
use regge_terminal::{Bar, Out, Stop};
use std::io::{self, Write};

/// About how many phases the command has.
const PHASES: u64 = 5;

/// The distributional Einstein tensor against Regge functions that vanish on the boundary, N >= 3.
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
        files::check(self.files.list())?;
        let bar = Bar::new(PHASES);
        let begin = |what: &'static str| bar.advance(PHASES, what);
        begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        let report = einstein(&mesh, &source, degree, order, &begin).map_err(stopped)?;
        self.files.write(&report, table)?;
        drop(bar);
        self.show(&report)
    }

    fn show(&self, report: &EinsteinReport) -> Result<(), Stop> {
        let mut out = Out::new();
        files::show_metric(&mut out, &report.about)?;
        files::show_quadrature(&mut out, &report.about)?;
        writeln!(
            out,
            "{} Regge functions that vanish on the boundary",
            report.functions.len()
        )?;
        writeln!(out, "largest |<G omega, psi>| {:.12e}", report.largest)?;
        files::show_written(&mut out, self.files.list())
    }
}

fn table(report: &EinsteinReport, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "simplex,index,cells,faces,hinges,total")?;
    for f in &report.functions {
        let simplex: Vec<String> = f.simplex.iter().map(u32::to_string).collect();
        write!(out, "{},{},", simplex.join("-"), f.index)?;
        files::parts(out, &f.sums)?;
    }
    Ok(())
}
