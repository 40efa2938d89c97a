//! Rows as a table, each beside what the paper has.

use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;
use regge_study::printed;
use regge_study::{Fit, Row, Study};
use std::io::{self, Write};

/// Writes the table's head.
pub fn head(out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "{:>2} {:>2}  {:20} {:>8} {:>9} {:>8}  {:>10} {:>6}  {:>10} {:>6} {:>7} {:>8}  solver",
        "r",
        "k",
        "interpolant",
        "cells",
        "ndof",
        "h",
        "error",
        "order",
        "printed",
        "order",
        "ratio",
        "seconds"
    )
}

/// Writes a row; ratio is that of our error to the printed one, the solver that of the biharmonic problem.
pub fn line(out: &mut dyn Write, study: &Study, row: &Row) -> io::Result<()> {
    writeln!(
        out,
        "{:>2} {:>2}  {:20} {:>8} {:>9} {:>8.4}  {:>10} {:>6}  {:>10} {:>6} {:>7} {:>8.2}  {}",
        row.degree,
        row.level,
        row.interpolant,
        row.cells,
        row.ndof,
        row.mesh_size,
        format!("{:.4e}", row.error),
        number(row.order, 2),
        row.printed.map_or("-".into(), |e| format!("{e:.4e}")),
        number(printed_order(study.metric, row, study), 2),
        number(row.printed.map(|e| row.error / e), 3),
        row.seconds,
        row.steps.map_or(row.solver.clone(), |steps| format!(
            "{}, {steps} steps",
            row.solver
        ))
    )
}

/// Writes the fitted orders, in the columns of the others.
pub fn fits(out: &mut dyn Write, fits: &[Fit]) -> io::Result<()> {
    if fits.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nFitted orders")?;
    for fit in fits {
        let levels: Vec<String> = fit.levels.iter().map(u32::to_string).collect();
        writeln!(
            out,
            "{:>2}     {:20} {:40}{:>6}  {:>17}",
            fit.degree,
            fit.interpolant,
            format!("k = {}", levels.join(", ")),
            number(Some(fit.order), 2),
            number(fit.printed, 2)
        )?;
    }
    Ok(())
}

fn number(x: Option<f64>, digits: usize) -> String {
    x.map_or("-".into(), |x| format!("{x:.digits$}"))
}

fn printed_order(metric: Metric, row: &Row, study: &Study) -> Option<f64> {
    let interpolant = Interpolant::named(&row.interpolant)?;
    printed::series(
        metric,
        row.dimension,
        study.quantity,
        row.degree,
        &interpolant,
    )?
    .order(row.level)
}
