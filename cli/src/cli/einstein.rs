//! `regge einstein`: the distributional Einstein tensor on a mesh from a file.

use super::files::{self, Files};
use super::given::{DETAILS, Given};
use super::phases::Phases;
use super::stop::{Out, Stop};
use regge_cli::curvature::{EinsteinReport, einstein};
use std::io::{self, Write};

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
        let phases = Phases::new(5);
        phases.begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        let report = einstein(&mesh, &source, degree, order, &|what| phases.begin(what))?;
        self.files.write(&report, table)?;
        drop(phases);
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
    writeln!(out, "simplex,index,element,face,hinge,total")?;
    for f in &report.functions {
        let simplex: Vec<String> = f.simplex.iter().map(u32::to_string).collect();
        write!(out, "{},{},", simplex.join("-"), f.index)?;
        files::parts(out, &f.sums)?;
    }
    Ok(())
}
