//! Values of arguments: levels, and things known by name.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use regge_study::Named;
use std::str::FromStr;

/// How a Regge metric is made unless told otherwise; the paper's tables have their own.
pub const DEFAULT_INTERPOLANT: &str = "canonical";

/// A list without what is in it already.
pub fn unique<T: Clone>(list: &[T], same: impl Fn(&T, &T) -> bool) -> Vec<T> {
    let mut all: Vec<T> = Vec::with_capacity(list.len());
    for one in list {
        if !all.iter().any(|other| same(one, other)) {
            all.push(one.clone());
        }
    }
    all
}

/// Levels k, ascending: `0..=7`, `0..8` or `3`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Levels(pub Vec<u32>);

impl FromStr for Levels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| {
            let part = part.trim();
            part.parse::<u32>()
                .map_err(|_| format!("'{part}' is no level: write 0..=7, 0..8 or 3"))
        };
        // Far more than any mesh can have; a range must not become a list of billions.
        let bounded = |level: u32| match level {
            0..=99 => Ok(level),
            _ => Err(format!("level {level} is out of reach")),
        };
        let levels: Vec<u32> = if let Some((from, to)) = text.split_once("..=") {
            (number(from)?..=bounded(number(to)?)?).collect()
        } else if let Some((from, to)) = text.split_once("..") {
            (number(from)?..bounded(number(to)?)?).collect()
        } else {
            vec![bounded(number(text)?)?]
        };
        if levels.is_empty() {
            Err("there is no level in this range".into())
        } else {
            Ok(Self(levels))
        }
    }
}

/// Parses one of the names of a list; clap shows the list to those who miss it.
pub fn named<T: Named>() -> impl TypedValueParser<Value = T> {
    let names = T::all().iter().map(T::name_of).collect::<Vec<_>>();
    PossibleValuesParser::new(names)
        .try_map(|name| T::from_name(&name).ok_or_else(|| format!("no such {}", T::KIND)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_ranges_or_numbers() {
        assert_eq!("0..=2".parse(), Ok(Levels(vec![0, 1, 2])));
        assert_eq!("1..3".parse(), Ok(Levels(vec![1, 2])));
        assert_eq!("3".parse(), Ok(Levels(vec![3])));
        for bad in ["", "x", "3..=2", "2..2", "-1", "0..=4000000000", "1...3"] {
            assert!(bad.parse::<Levels>().is_err(), "{bad}");
        }
    }
}
