//! The files of a report, and what its first lines on the terminal say: shared by the commands for meshes from files.

use regge_cli::curvature::{About, Parts};
use regge_terminal::{Out, Stop, output};
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;

/// Where a report goes.
#[derive(clap::Args)]
#[group(skip)]
pub struct Files {
    /// Write everything to this file
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Write the table of the sums, or of the gradient, to this file
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
}

impl Files {
    /// Those that were asked for.
    pub fn list(&self) -> impl Iterator<Item = &PathBuf> {
        self.json.iter().chain(&self.csv)
    }

    /// Writes them.
    pub fn write<R: Serialize>(
        &self,
        report: &R,
        table: impl FnOnce(&R, &mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Stop> {
        if let Some(path) = &self.json {
            output::json(path, report)?;
        }
        match &self.csv {
            Some(path) => output::write_by(path, |out| table(report, out)),
            None => Ok(()),
        }
    }
}

/// Refuses, before anything is computed, files that cannot be written or are one and the same.
pub fn check<'a>(files: impl Iterator<Item = &'a PathBuf>) -> Result<(), Stop> {
    let mut seen = Vec::new();
    for path in files {
        if seen.contains(&path) {
            let reason = format!("two things are to be written to {}", path.display());
            return Err(Stop::Usage(reason));
        }
        output::check(path)?;
        seen.push(path);
    }
    Ok(())
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

/// What was written.
pub fn show_written<'a>(
    out: &mut Out,
    mut files: impl Iterator<Item = &'a PathBuf>,
) -> Result<(), Stop> {
    files.try_for_each(|path| writeln!(out, "written: {}", path.display()))?;
    Ok(())
}

/// The end of a row of a table, in a form that reads back to the same bits.
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
    writeln!(out, ",{total:e}")
}
