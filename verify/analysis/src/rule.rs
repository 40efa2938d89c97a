//! Floor 1. What can be claimed of a series of numbers, and whether it holds.

use crate::series::Series;

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
