//! `regge action`: Regge's action on a mesh from a file, and its gradient.

use super::super::common::Common;
use super::files::{self, Files};
use super::given::{Given, details, stopped};
use super::memory::{self, Listed};
use regge_cli::curvature::{ActionReport, action};
use regge_terminal::{Out, Stop, output};
use std::io::{self, Write};

/// About how many phases the command has.
const PHASES: u64 = 6;

const SHORT: &str =
    "Example: regge action --mesh m.msh --lengths l.csv --csv gradient.csv (more: --help)";

const EXAMPLES: &str = "\
Examples:
  regge action --mesh m.json --lengths l.csv --csv gradient.csv
  regge action --mesh ball.msh --metric g.toml --degree 2 --json -";

/// Regge's action: half the curvature's total and the boundary's angles; for degree 0 with its gradient.
#[derive(clap::Args)]
#[command(after_help = SHORT, after_long_help = format!("{}\n\n{EXAMPLES}", details()))]
pub struct Args {
    #[command(flatten)]
    given: Given,
    /// Also intervals that provably contain the action, its gradient and all angles (degree 0)
    #[arg(long)]
    certified: bool,
    #[command(flatten)]
    files: Files,
}

impl Args {
    /// Runs the command.
    pub fn run(self, common: &Common) -> Result<(), Stop> {
        let files = self.files.list();
        self.given.check(&files)?;
        if self.files.csv.is_some() && self.given.degree > 0 {
            let reason = "the gradient in the edge lengths is for degree 0: see regge einstein";
            return Err(Stop::Usage(reason.into()));
        }
        files::check_certified(self.certified, self.given.degree)?;
        let voice = common.voice(&files);
        let phases = voice.phases(PHASES);
        let begin = |what: &str| phases.begin(what);
        begin("reading the mesh");
        let (mesh, source) = (self.given.mesh()?, self.given.source()?);
        let (degree, order) = (self.given.degree, self.given.quadrature());
        memory::check(common, &mesh, degree, Listed::Vertices, None)?;
        let report =
            action(&mesh, &source, degree, order, self.certified, &begin).map_err(stopped)?;
        begin("writing");
        self.files.write(&report, table)?;
        drop(phases);
        files::notes(&voice, &report.about);
        self.show(&report, &mut voice.out())
    }

    fn show(&self, report: &ActionReport, out: &mut Out) -> Result<(), Stop> {
        files::show_metric(out, &report.about)?;
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
        if let Some(enclosures) = &report.enclosures {
            let [low, high] = enclosures.action;
            writeln!(out, "certified: action in [{low:.15e}, {high:.15e}]")?;
            files::show_certified(out, enclosures)?;
        }
        Ok(output::show_written(out, &self.files.list())?)
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
