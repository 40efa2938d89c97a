//! `regge einstein`: the distributional Einstein tensor on a mesh from a file.

use super::given::{DETAILS, Given};
use super::output;
use super::phases::Phases;
use super::stop::{Out, Stop};
use regge_verify::curvature::{EinsteinReport, einstein};
use std::io::{self, Write};
use std::path::PathBuf;

/// The distributional Einstein tensor against Regge functions that vanish on the boundary, N >= 3.
#[derive(clap::Args)]
#[command(after_help = DETAILS)]
pub struct Args {
    #[command(flatten)]
    given: Given,
    /// Write everything to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the sums to this file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Args {
    /// Runs the command.
    pub fn run(self) -> Result<(), Stop> {
        self.given.check()?;
        self.files().try_for_each(|path| output::check(path))?;
        let phases = Phases::new(5);
        phases.begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        let report = einstein(&mesh, &source, degree, order, &|what| phases.begin(what))?;
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

    fn show(&self, report: &EinsteinReport) -> Result<(), Stop> {
        let mut out = Out::new();
        writeln!(
            out,
            "{}: N = {}, Regge metric: {}, degree {}",
            report.mesh, report.dimension, report.interpolant, report.degree
        )?;
        let state = match report.quadrature.settled {
            Some(false) => ", the sums have NOT settled",
            _ => "",
        };
        writeln!(
            out,
            "quadrature of order {}{state}",
            report.quadrature.order
        )?;
        writeln!(
            out,
            "{} Regge functions that vanish on the boundary",
            report.functions.len()
        )?;
        writeln!(out, "largest |<G omega, psi>| {:.12e}", report.largest)?;
        for path in self.files() {
            writeln!(out, "written: {}", path.display())?;
        }
        Ok(())
    }
}

fn table(report: &EinsteinReport, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "simplex,index,element,face,hinge,total")?;
    for f in &report.functions {
        let simplex: Vec<String> = f.simplex.iter().map(u32::to_string).collect();
        writeln!(
            out,
            "{},{},{:e},{:e},{:e},{:e}",
            simplex.join("-"),
            f.index,
            f.element,
            f.face,
            f.hinge,
            f.total
        )?;
    }
    Ok(())
}
