//! Floor 1. What is claimed of a series of numbers, and the verdict on it and on its forgeries.

use crate::series::Series;
use serde::Serialize;

/// An order may fall short of the claimed one by this much: three levels of random meshes scatter by as much.
pub const SLACK: f64 = 0.2;

/// Rounding: what is at most 1 in exact arithmetic may be this much more.
const ROUNDING: f64 = 1e-9;

/// What is claimed of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Every value is at most this constant.
    AtMost(f64),
    /// Every value is at most this constant, and the greatest is at least this share of it.
    Sharp(f64, f64),
    /// The values do not grow with the level.
    Bounded,
    /// The values fall at least as this power of 1/level: an upper bound, judged from one side.
    Order(f64),
    /// The values do not fall: their order is less than this.
    Stalls(f64),
    /// Nothing: what is seen is reported.
    Seen,
}

impl Rule {
    /// bound, sharp, rate or observation.
    pub fn kind(self) -> &'static str {
        match self {
            Self::AtMost(_) | Self::Bounded => "bound",
            Self::Sharp(..) => "sharp",
            Self::Order(_) | Self::Stalls(_) => "rate",
            Self::Seen => "observation",
        }
    }

    /// The claimed constant or order.
    pub fn claimed(self) -> Option<f64> {
        match self {
            Self::AtMost(c) | Self::Sharp(c, _) | Self::Order(c) | Self::Stalls(c) => Some(c),
            Self::Bounded => Some(0.0),
            Self::Seen => None,
        }
    }

    /// What is claimed, in words.
    pub fn words(self) -> String {
        match self {
            Self::AtMost(c) => format!("≤ {c}"),
            Self::Sharp(c, share) => format!("≤ {c}, and {} is reached", c * share),
            Self::Bounded => "bounded: grows by no power".to_owned(),
            Self::Order(order) => format!("order ≥ {order}"),
            Self::Stalls(order) => format!("order < {order}"),
            Self::Seen => "no claim".to_owned(),
        }
    }

    /// Constants are compared with the greatest value, orders with the mean of the runs' orders.
    fn is_constant(self) -> bool {
        matches!(self, Self::AtMost(_) | Self::Sharp(..))
    }

    /// What is compared with the claim, and its spread over the runs.
    pub fn seen(self, series: &Series) -> (f64, f64) {
        if self.is_constant() {
            return (series.greatest(), 0.0);
        }
        let (growth, spread) = series.growth();
        match self {
            Self::Bounded => (growth, spread),
            _ => (-growth, spread),
        }
    }

    /// Does it hold?
    pub fn holds(self, series: &Series) -> bool {
        let (seen, _) = self.seen(series);
        match self {
            Self::AtMost(c) => seen <= c * (1.0 + ROUNDING),
            Self::Sharp(c, share) => seen <= c * (1.0 + ROUNDING) && seen >= share * c,
            Self::Bounded => seen <= SLACK,
            Self::Order(order) => seen >= order - SLACK,
            Self::Stalls(order) => seen < order,
            Self::Seen => series.runs.iter().flatten().all(|x| x.is_finite()),
        }
    }

    /// How far what is seen is from where the claim would fail: relative to a constant, in orders for a power. There is none where
    /// nothing is claimed.
    pub fn room(self, series: &Series) -> Option<f64> {
        let (seen, _) = self.seen(series);
        match self {
            Self::AtMost(c) | Self::Sharp(c, _) => Some(1.0 - seen / c),
            Self::Bounded => Some(SLACK - seen),
            Self::Order(order) => Some(seen - (order - SLACK)),
            Self::Stalls(order) => Some(order - seen),
            Self::Seen => None,
        }
    }
}

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

    fn powers(order: f64) -> Series {
        let run = [1.0, 0.5, 0.25].map(|h: f64| (h, h.powf(order)));
        Series::over_h(&[run.to_vec()])
    }

    #[test]
    fn a_rate_is_judged_from_one_side() {
        assert!(Rule::Order(1.0).holds(&powers(2.0)));
        assert!(Rule::Order(1.0).holds(&powers(0.9)));
        assert!(!Rule::Order(1.0).holds(&powers(0.7)));
        assert!(Rule::Bounded.holds(&powers(1.0)) && !Rule::Bounded.holds(&powers(-0.5)));
        assert!(Rule::Stalls(0.3).holds(&powers(0.1)) && !Rule::Stalls(0.3).holds(&powers(0.8)));
    }

    #[test]
    fn a_sharp_constant_is_reached_and_not_passed() {
        let rule = Rule::Sharp(1.0, 0.99);
        assert!(rule.holds(&Series::samples(vec![0.2, 0.995])));
        assert!(!rule.holds(&Series::samples(vec![0.2, 0.9])));
        assert!(!rule.holds(&Series::samples(vec![1.1, 0.995])));
        let entry = Finding::new("", rule, Series::samples(vec![0.995])).entry();
        assert!(entry.is_good() && entry.forgeries.len() == 1);
    }

    /// A claim fails where no room is left, but for rounding.
    #[test]
    fn room_is_what_is_left_until_a_claim_fails() {
        let rules = [
            Rule::Order(1.0),
            Rule::Stalls(1.0),
            Rule::Bounded,
            Rule::AtMost(0.8),
        ];
        for rule in rules {
            for order in [-0.5, 0.1, 0.7, 0.9, 1.2] {
                let series = powers(order);
                let room = rule.room(&series).expect("something is claimed");
                assert_eq!(
                    rule.holds(&series),
                    room >= 0.0,
                    "{rule:?}, {order}: {room}"
                );
            }
        }
        assert_eq!(Rule::Seen.room(&powers(1.0)), None);
    }

    #[test]
    fn a_number_that_is_none_holds_nowhere() {
        let broken = Series::over_h(&[vec![(1.0, 1.0), (0.5, f64::NAN), (0.25, 1.0)]]);
        for rule in [
            Rule::Bounded,
            Rule::Order(0.0),
            Rule::Stalls(1.0),
            Rule::Seen,
        ] {
            assert!(!rule.holds(&broken), "{rule:?}");
        }
        let greatest = Series::samples(vec![f64::NAN]);
        assert!(!Rule::Sharp(1.0, 0.5).holds(&greatest));
    }
}
