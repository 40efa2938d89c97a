//! The names that a formula may use.

use super::code::{Function, Op};

/// Coordinates x1…xN (and x, y, z up to N = 3) and the constants pi and e.
#[derive(Clone, Debug)]
pub struct Names {
    dimension: usize,
}

impl Names {
    /// Those of a formula in N coordinates.
    pub fn new(dimension: usize) -> Self {
        Self { dimension }
    }

    /// The coordinate or constant with this name.
    pub fn value(&self, name: &str) -> Option<Op> {
        let mut values = self.values();
        values.find(|value| value.0 == name).map(|value| value.1)
    }

    fn values(&self) -> impl Iterator<Item = (String, Op)> + '_ {
        let constants = [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];
        let letters = ["x", "y", "z"].into_iter().enumerate();
        let letters = letters.take(if self.dimension <= 3 {
            self.dimension
        } else {
            0
        });
        let numbered = (0..self.dimension).map(|i| (format!("x{}", i + 1), Op::Coordinate(i)));
        letters
            .map(|(i, letter)| (letter.to_string(), Op::Coordinate(i)))
            .chain(numbered)
            .chain(constants.map(|(name, value)| (name.to_string(), Op::Constant(value))))
    }

    /// What to say of a name that is none of them.
    pub fn unknown(&self, name: &str) -> String {
        let functions = Function::ALL.iter().map(|f| f.0.to_string());
        let known = self.values().map(|value| value.0).chain(functions);
        let short: String = name.chars().take(40).collect();
        let nearest = known.min_by_key(|known| distance(known, &short));
        let nearest = nearest.expect("there are functions");
        format!(
            "unknown name '{short}': the nearest known one in dimension {} is '{nearest}'",
            self.dimension
        )
    }
}

/// How many letters must be inserted, removed or replaced (Levenshtein).
pub fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
