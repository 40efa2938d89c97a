//! Floor 1. What was found of a case of a claim: the verdict on it, and on its forgeries.

use crate::rule::Rule;
use crate::series::Series;
use serde::Serialize;

/// A wrong version of what is claimed.
#[derive(Clone, Debug)]
pub struct Forgery {
    /// What is wrong with it.
    pub name: &'static str,
    /// By which rule it is judged.
    pub rule: Rule,
    /// What is measured for it.
    pub series: Series,
}

/// What was found of one case of a claim.
#[derive(Clone, Debug)]
pub struct Finding {
    /// `N = 3, r = 1`.
    pub case: String,
    /// What is claimed.
    pub rule: Rule,
    /// What was measured.
    pub series: Series,
    /// What must be caught.
    pub forgeries: Vec<Forgery>,
    /// Of the claim's labels those that it is about; all of them if none is named.
    pub about: &'static [&'static str],
}

impl Finding {
    /// Without forgeries yet, but for the smaller constant of a sharp one.
    pub fn new(case: impl Into<String>, rule: Rule, series: Series) -> Self {
        let forgeries = match rule {
            Rule::Sharp(c, share) => vec![Forgery {
                name: "a smaller constant",
                rule: Rule::AtMost(c * share),
                series: series.clone(),
            }],
            _ => Vec::new(),
        };
        Self {
            case: case.into(),
            rule,
            series,
            forgeries,
            about: &[],
        }
    }

    /// About these of the claim's labels only.
    pub fn about(self, labels: &'static [&'static str]) -> Self {
        Self {
            about: labels,
            ..self
        }
    }

    /// With a wrong version that the same rule must catch.
    pub fn forge(mut self, name: &'static str, series: Series) -> Self {
        let rule = match self.rule {
            Rule::Sharp(c, _) => Rule::AtMost(c),
            rule => rule,
        };
        self.forgeries.push(Forgery { name, rule, series });
        self
    }

    /// With a wrong claim about the same numbers.
    pub fn forge_claim(mut self, name: &'static str, rule: Rule) -> Self {
        let series = self.series.clone();
        self.forgeries.push(Forgery { name, rule, series });
        self
    }

    /// As data.
    pub fn entry(&self) -> Entry {
        let (seen, spread) = self.rule.seen(&self.series);
        let forgeries = self.forgeries.iter().map(|forgery| Caught {
            name: forgery.name.to_owned(),
            seen: forgery.rule.seen(&forgery.series).0,
            values: forgery.series.runs.clone(),
            caught: !forgery.rule.holds(&forgery.series),
        });
        let verdict = match (self.rule.holds(&self.series), self.rule) {
            (true, Rule::Seen) => "observed",
            (true, _) => "holds",
            (false, _) => "fails",
        };
        Entry {
            case: self.case.clone(),
            about: self.about,
            kind: self.rule.kind(),
            claim: self.rule.words(),
            claimed: self.rule.claimed(),
            seen,
            spread,
            room: self.rule.room(&self.series),
            axis: self.series.axis,
            levels: self.series.levels.clone(),
            values: self.series.runs.clone(),
            verdict,
            forgeries: forgeries.collect(),
        }
    }
}

/// What a report has of a finding.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    /// `N = 3, r = 1`.
    pub case: String,
    /// The labels of the paper that it is about.
    pub about: &'static [&'static str],
    /// bound, sharp, rate or observation.
    pub kind: &'static str,
    /// In words.
    pub claim: String,
    /// The claimed constant or order; 0 for a power by which something may grow.
    pub claimed: Option<f64>,
    /// What was seen of it.
    pub seen: f64,
    /// The greatest less the least of the runs' orders.
    pub spread: f64,
    /// How far that is from where the claim would fail: relative to a constant, in orders for a power.
    pub room: Option<f64>,
    /// What the levels are.
    pub axis: &'static str,
    /// The levels.
    pub levels: Vec<f64>,
    /// What was measured, by run and level.
    pub values: Vec<Vec<f64>>,
    /// holds, fails or observed.
    pub verdict: &'static str,
    /// The wrong versions.
    pub forgeries: Vec<Caught>,
}

/// What became of a forgery.
#[derive(Clone, Debug, Serialize)]
pub struct Caught {
    /// What is wrong with it.
    pub name: String,
    /// What was seen of it.
    pub seen: f64,
    /// What was measured for it, by run and level.
    pub values: Vec<Vec<f64>>,
    /// Was it caught?
    pub caught: bool,
}

impl Entry {
    /// Does the claim hold, and was every forgery caught?
    pub fn is_good(&self) -> bool {
        self.verdict != "fails" && self.forgeries.iter().all(|f| f.caught)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sharp_constant_is_reached_and_not_passed() {
        let rule = Rule::Sharp(1.0, 0.99);
        assert!(rule.holds(&Series::samples(vec![0.2, 0.995])));
        assert!(!rule.holds(&Series::samples(vec![0.2, 0.9])));
        assert!(!rule.holds(&Series::samples(vec![1.1, 0.995])));
        let entry = Finding::new("", rule, Series::samples(vec![0.995])).entry();
        assert!(entry.is_good() && entry.forgeries.len() == 1);
    }
}
