//! `regge einstein`: the distributional Einstein tensor on a mesh from a file.

use super::super::common::Common;
use super::files::{self, Files};
use super::given::{Given, details, stopped};
use super::memory::{self, Listed};
use regge_cli::curvature::{EinsteinReport, einstein};
use regge_terminal::{Out, Stop, output};
use std::io::{self, Write};

/// About how many phases the command has.
const PHASES: u64 = 5;

const SHORT: &str =
    "Example: regge einstein --mesh m.msh --lengths l.csv --json e.json (more: --help)";

const EXAMPLES: &str = "\
Examples:
  regge einstein --mesh ball.msh --metric g.toml --degree 1 --csv e.csv
  regge einstein --mesh m.json --lengths l.csv --npz e.npz";

/// The distributional Einstein tensor against Regge functions that vanish on the boundary, N >= 3.
#[derive(clap::Args)]
#[command(after_help = SHORT, after_long_help = format!("{}\n\n{EXAMPLES}", details()))]
pub struct Args {
    #[command(flatten)]
    given: Given,
    #[command(flatten)]
    files: Files,
}

impl Args {
    /// Runs the command.
    pub fn run(self, common: &Common) -> Result<(), Stop> {
        let files = self.files.list();
        self.given.check(&files)?;
        let voice = common.voice(&files);
        let phases = voice.phases(PHASES);
        let begin = |what: &str| phases.begin(what);
        begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        memory::check(common, &mesh, degree, Listed::Regge(degree), None)?;
        let report = einstein(&mesh, &source, degree, order, &begin).map_err(stopped)?;
        begin("writing");
        self.files.write(&report, table)?;
        drop(phases);
        files::notes(&voice, &report.about);
        self.show(&report, &mut voice.out())
    }

    fn show(&self, report: &EinsteinReport, out: &mut Out) -> Result<(), Stop> {
        files::show_metric(out, &report.about)?;
        files::show_quadrature(out, &report.about)?;
        writeln!(
            out,
            "{} Regge functions that vanish on the boundary",
            report.functions.len()
        )?;
        writeln!(out, "largest |<G omega, psi>| {:.12e}", report.largest)?;
        Ok(output::show_written(out, &self.files.list())?)
    }
}

fn table(report: &EinsteinReport, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "simplex,index,cells,faces,hinges,total")?;
    for f in &report.functions {
        let simplex: Vec<String> = f.simplex.iter().map(u32::to_string).collect();
        write!(out, "{},{},", simplex.join("-"), f.index)?;
        files::parts(out, &f.sums)?;
        writeln!(out)?;
    }
    Ok(())
}
