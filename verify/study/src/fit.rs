//! Orders of convergence fitted over several levels.

use crate::printed;
use crate::row::{ROUNDING, Row};
use crate::study::Study;
use regge_curvature::interpolate::Interpolant;
use serde::{Deserialize, Serialize};

/// Over so many of the finest levels.
pub const LEVELS: usize = 3;

/// The order of one sequence of errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// r.
    pub degree: usize,
    /// The interpolant's name.
    pub interpolant: String,
    /// The levels that the fit is over.
    pub levels: Vec<u32>,
    /// The slope of log e over log h by least squares.
    pub order: f64,
    /// The same of the errors that the paper has for these levels, with the mesh sizes of its tables.
    pub printed: Option<f64>,
}

/// The order of each sequence, over its finest levels; none where there are fewer than three.
pub fn fits(study: &Study, rows: &[Row]) -> Vec<Fit> {
    let mut fits: Vec<Fit> = Vec::new();
    for row in rows {
        let known = |fit: &Fit| (fit.degree, &fit.interpolant) == (row.degree, &row.interpolant);
        if !fits.iter().any(known) {
            fits.extend(fit(study, row, rows));
        }
    }
    fits
}

fn fit(study: &Study, first: &Row, rows: &[Row]) -> Option<Fit> {
    let of = |row: &&Row| {
        (row.degree, &row.interpolant) == (first.degree, &first.interpolant) && row.error > ROUNDING
    };
    let mut last: Vec<&Row> = rows.iter().filter(of).collect();
    last.sort_by_key(|row| row.level);
    let last = last.split_off(last.len().checked_sub(LEVELS)?);
    let ours: Vec<_> = last.iter().map(|r| (r.mesh_size, r.error)).collect();
    let interpolant = Interpolant::named(&first.interpolant)?;
    let series = printed::series(
        study.metric,
        study.dimension,
        study.quantity,
        first.degree,
        &interpolant,
    );
    let printed = last.iter().map(|r| series?.point(r.level)).collect();
    Some(Fit {
        degree: first.degree,
        interpolant: first.interpolant.clone(),
        levels: last.iter().map(|row| row.level).collect(),
        order: slope(&ours)?,
        printed: Option::<Vec<_>>::and_then(printed, |points| slope(&points)),
    })
}

/// d log y / d log x by least squares.
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| [p.0.ln(), p.1.ln()]).collect();
    let mean = |i: usize| logs.iter().map(|p| p[i]).sum::<f64>() / logs.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let [xy, xx] = logs.iter().fold([0.0; 2], |[xy, xx], p| {
        [xy + (p[0] - x) * (p[1] - y), xx + (p[0] - x) * (p[0] - x)]
    });
    Some(xy / xx).filter(|slope| slope.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_have_their_order_and_one_point_has_none() {
        let points = [1.0, 0.5, 0.2].map(|h: f64| (h, 3.0 * h.powf(2.5)));
        assert!((slope(&points).unwrap() - 2.5).abs() < 1e-13);
        // Off a line by (0, e, 0): the slope of three evenly spaced points is that of the outer two.
        let points = [(1.0, 1.0), (0.5, 0.7), (0.25, 0.0625)];
        assert!((slope(&points).unwrap() - 2.0).abs() < 1e-13);
        assert_eq!(slope(&points[..1]), None);
    }
}
