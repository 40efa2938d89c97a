//! The files of a report, and what its first lines on the terminal say: shared by the commands for meshes from files.

use regge_cli::curvature::{About, Arrays, Enclosures, Everywhere, Parts, Signs, SimplexBounds};
use regge_cli::npz;
use regge_terminal::output::{self, Named};
use regge_terminal::{Out, Stop, Voice};
use std::io::{self, Write};
use std::path::PathBuf;

/// Where a report goes.
#[derive(clap::Args)]
#[group(skip)]
pub struct Files {
    /// Write everything to this file; - is standard output, for the other files too
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Write the table of the sums, or of the gradient, to this file
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Write everything to this file as NumPy arrays by name (numpy.load)
    #[arg(long, value_name = "FILE.npz")]
    pub npz: Option<PathBuf>,
}

impl Files {
    /// Those that were asked for, with the options that name them.
    pub fn list(&self) -> Vec<Named<'_>> {
        output::given([
            ("--json", &self.json),
            ("--csv", &self.csv),
            ("--npz", &self.npz),
        ])
    }

    /// Writes them.
    pub fn write<R: Arrays>(
        &self,
        report: &R,
        table: impl FnOnce(&R, &mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Stop> {
        if let Some(path) = &self.json {
            output::json(path, report)?;
        }
        if let Some(path) = &self.csv {
            output::write_by(path, |out| table(report, out))?;
        }
        match &self.npz {
            Some(path) => output::write_by(path, |out| npz::write(&arrays(report)?, out)),
            None => Ok(()),
        }
    }

    /// Is everything wanted that a report can have?
    pub fn want_details(&self) -> bool {
        self.json.is_some() || self.npz.is_some()
    }
}

/// The enclosures of an action are for edge lengths.
pub fn check_certified(certified: bool, degree: usize) -> Result<(), Stop> {
    if certified && degree > 0 {
        let reason = format!("--certified is for degree 0, not {degree}");
        return Err(Stop::Usage(reason));
    }
    Ok(())
}

/// What is proven of a metric.
pub fn show_certified(out: &mut Out, enclosures: &Enclosures) -> io::Result<()> {
    if let Some([low, high]) = enclosures.over_two_pi {
        match enclosures.euler_characteristic {
            Some(chi) => writeln!(
                out,
                "certified: Euler characteristic {chi}, the only integer in [{low:.15}, {high:.15}]"
            )?,
            None => writeln!(
                out,
                "certified: Euler characteristic in [{low:e}, {high:e}], which is too wide"
            )?,
        }
    }
    let count = enclosures.hinges.len();
    let widest = enclosures.widest_angle;
    writeln!(
        out,
        "certified: {count} angle defects, each to {widest:.1e} at most"
    )
}

/// What is proven of a metric of higher degree at every point.
pub fn show_everywhere(out: &mut Out, all: &Everywhere) -> io::Result<()> {
    let cells = all.cells.len();
    writeln!(
        out,
        "certified: the metric is positive definite everywhere on its {cells} cells"
    )?;
    let inside =
        |all: &[SimplexBounds]| Signs::of(all.iter().filter(|s| s.interior).map(|s| &s.bounds));
    let lists = [
        ("R", "cells", Signs::of(all.cells.iter())),
        ("the jump of H", "inner faces", inside(&all.faces)),
        ("the angle defect", "inner hinges", inside(&all.hinges)),
    ];
    for (what, simplices, signs) in lists {
        let Signs {
            positive,
            negative,
            unknown,
        } = signs;
        writeln!(
            out,
            "certified: {what} is positive everywhere on {positive} {simplices}, negative everywhere on {negative}, neither is shown on {unknown}"
        )?;
    }
    Ok(())
}

/// The lists of a report, and what stands alone in it as text.
fn arrays(report: &impl Arrays) -> io::Result<Vec<(String, npz::Array)>> {
    let mut all = report.arrays();
    all.insert(0, ("report".into(), npz::Array::text(&report.rest()?)));
    Ok(all)
}

/// What is to be known of the files beside the numbers.
pub fn notes(voice: &Voice, about: &About) {
    about.notes.iter().for_each(|note| voice.note(note));
}

/// The metric that a report is about.
pub fn show_metric(out: &mut Out, about: &About) -> Result<(), Stop> {
    writeln!(
        out,
        "{}: N = {}, Regge metric: {}, degree {}",
        about.mesh, about.dimension, about.interpolant, about.degree
    )?;
    Ok(())
}

/// By which order its sums were integrated.
pub fn show_quadrature(out: &mut Out, about: &About) -> Result<(), Stop> {
    let state = match about.quadrature.is_unsettled() {
        true => ", the sums have NOT settled",
        false => "",
    };
    writeln!(out, "quadrature of order {}{state}", about.quadrature.order)?;
    Ok(())
}

/// The sums in a row of a table, in a form that reads back to the same bits.
pub fn parts(out: &mut dyn Write, sums: &Parts) -> io::Result<()> {
    let Parts {
        cells,
        faces,
        hinges,
        total,
        ..
    } = sums;
    write!(out, "{cells:e},{faces:e},{hinges:e}")?;
    if let Some(boundary) = sums.boundary {
        write!(out, ",{boundary:e}")?;
    }
    write!(out, ",{total:e}")
}
