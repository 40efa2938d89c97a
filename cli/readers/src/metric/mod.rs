//! Metrics by formulas, from TOML.

mod formula;
#[cfg(test)]
mod tests;

pub use formula::{Formula, FormulaMetric, InSpace};

use super::error::{Fault, InputError, Place, text_of};
use super::expression::{Expression, nearest};
use serde::Deserialize;
use std::path::Path;
use toml::Spanned;

/// The largest dimension that a metric file may state.
const LARGEST_DIMENSION: i64 = 9;

const KEYS: [&str; 6] = [
    "dimension",
    "g",
    "graph",
    "conformal",
    "embedding",
    "exact_scalar_curvature",
];

type Text = Spanned<String>;

/// The file as it stands.
#[derive(Deserialize)]
struct Raw {
    dimension: Spanned<i64>,
    g: Option<Spanned<Vec<Spanned<Vec<Text>>>>>,
    graph: Option<Text>,
    conformal: Option<Text>,
    embedding: Option<Spanned<Vec<Text>>>,
    exact_scalar_curvature: Option<Text>,
}

/// A metric file that has been read, of whatever dimension.
#[derive(Clone, Debug)]
pub struct MetricFile {
    /// N.
    pub dimension: usize,
    /// g.
    pub formula: Formula,
    /// R(g), if the file states it.
    pub exact_scalar_curvature: Option<Expression>,
}

impl MetricFile {
    /// The names of the functions in the metric that have a kink or a jump, each once.
    pub fn kinks(&self) -> Vec<&'static str> {
        let all = self.formula.expressions().into_iter();
        let mut names: Vec<&str> = all.flat_map(Expression::kinks).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
}

/// Reads a metric from a TOML file: `dimension`, one of `g`, `graph`, `conformal` (g = c δ), `embedding`, and perhaps
/// `exact_scalar_curvature`.
///
/// # Errors
/// Names file, line, key and what is wrong.
pub fn read_metric(file: &Path) -> Result<MetricFile, InputError> {
    metric_from(file, &text_of(file)?)
}

/// [`read_metric`] of a text that is in memory; `file` is what refusals call it.
///
/// # Errors
/// As [`read_metric`].
pub fn metric_from(file: &Path, text: &str) -> Result<MetricFile, InputError> {
    parse_metric(text).map_err(|fault| fault.of(file))
}

fn parse_metric(text: &str) -> Result<MetricFile, Fault> {
    let source = Source(text);
    source.check_keys()?;
    let raw: Raw = toml::from_str(text).map_err(|error| source.syntax(&error))?;
    let stated = *raw.dimension.get_ref();
    if !(2..=LARGEST_DIMENSION).contains(&stated) {
        let reason = format!("dimension: {stated} is not in 2..={LARGEST_DIMENSION}");
        return Err(source.fault(raw.dimension.span().start, reason));
    }
    let dimension = stated as usize;
    let formula = source.formula(&raw, dimension)?;
    let exact = raw.exact_scalar_curvature.as_ref();
    let exact = exact.map(|text| source.expression("exact_scalar_curvature", text, dimension));
    Ok(MetricFile {
        dimension,
        formula,
        exact_scalar_curvature: exact.transpose()?,
    })
}

/// The text, to find lines in.
struct Source<'a>(&'a str);

impl Source<'_> {
    fn fault(&self, at: usize, reason: impl Into<String>) -> Fault {
        let before = &self.0.as_bytes()[..at.min(self.0.len())];
        let line = before.iter().filter(|b| **b == b'\n').count() as u64 + 1;
        Fault::new(Place::Line(line), reason)
    }

    fn syntax(&self, error: &toml::de::Error) -> Fault {
        let at = error.span().map_or(0, |span| span.start);
        self.fault(at, error.message())
    }

    /// Refuses a key that has no meaning, with the nearest one that has.
    fn check_keys(&self) -> Result<(), Fault> {
        let table = toml::de::DeTable::parse(self.0).map_err(|error| self.syntax(&error))?;
        for key in table.get_ref().keys() {
            let name: &str = key.get_ref();
            if !KEYS.contains(&name) {
                let advice = match nearest(name, KEYS.into_iter()) {
                    Some(nearest) => format!("did you mean '{nearest}'?"),
                    None => format!("known are {}", KEYS.join(", ")),
                };
                let reason = format!("unknown key '{name}': {advice}");
                return Err(self.fault(key.span().start, reason));
            }
        }
        Ok(())
    }

    fn expression(&self, key: &str, text: &Text, dimension: usize) -> Result<Expression, Fault> {
        Expression::parse(text.get_ref(), dimension)
            .map_err(|error| self.fault(text.span().start, format!("{key}: {error}")))
    }

    /// The one of g, graph, conformal and embedding that is there.
    fn formula(&self, raw: &Raw, n: usize) -> Result<Formula, Fault> {
        let given = [
            raw.g.is_some(),
            raw.graph.is_some(),
            raw.conformal.is_some(),
            raw.embedding.is_some(),
        ];
        let count = given.iter().filter(|g| **g).count();
        if count != 1 {
            let reason =
                format!("exactly one of g, graph, conformal, embedding is needed, not {count}");
            return Err(Fault::new(Place::Whole, reason));
        }
        if let Some(graph) = &raw.graph {
            let f = self.expression("graph", graph, n)?;
            return Ok(Formula::of_graph(f, n));
        }
        if let Some(factor) = &raw.conformal {
            return Ok(Formula::Conformal(self.expression(
                "conformal",
                factor,
                n,
            )?));
        }
        match (&raw.embedding, &raw.g) {
            (Some(map), _) => self.embedding(map, n),
            (_, Some(rows)) => self.components(rows, n),
            _ => unreachable!("one of the four keys is there"),
        }
    }

    fn embedding(&self, map: &Spanned<Vec<Text>>, n: usize) -> Result<Formula, Fault> {
        let parts = map.get_ref();
        if parts.len() < n {
            let reason = format!(
                "embedding: {} components; an immersion of dimension {n} needs {n} at least",
                parts.len()
            );
            return Err(self.fault(map.span().start, reason));
        }
        let parts = parts
            .iter()
            .map(|text| self.expression("embedding", text, n));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        Ok(Formula::of_embedding(parts, n))
    }

    fn components(
        &self,
        rows: &Spanned<Vec<Spanned<Vec<Text>>>>,
        n: usize,
    ) -> Result<Formula, Fault> {
        if rows.get_ref().len() != n {
            let reason = format!("g: {} rows, dimension is {n}", rows.get_ref().len());
            return Err(self.fault(rows.span().start, reason));
        }
        let mut g = Vec::with_capacity(n);
        for (i, row) in rows.get_ref().iter().enumerate() {
            if row.get_ref().len() != n {
                let reason = format!(
                    "g: row {} has {} entries, dimension is {n}",
                    i + 1,
                    row.get_ref().len()
                );
                return Err(self.fault(row.span().start, reason));
            }
            let entries = row
                .get_ref()
                .iter()
                .map(|text| self.expression("g", text, n));
            g.push(entries.collect::<Result<Vec<_>, _>>()?);
        }
        if let Some((i, j, reason)) = formula::asymmetry(&g) {
            return Err(self.fault(rows.get_ref()[i].get_ref()[j].span().start, reason));
        }
        Ok(Formula::of_components(&g))
    }
}
