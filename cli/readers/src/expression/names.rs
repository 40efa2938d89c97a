//! The names that a formula may use.

use super::code::Op;
use super::function::FUNCTIONS;

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

    /// What to say of a name that is none of them: the nearest one if it is near, or all of them.
    pub fn unknown(&self, name: &str) -> String {
        let n = self.dimension;
        let short: String = name.chars().take(40).collect();
        let values: Vec<String> = self.values().map(|value| value.0).collect();
        if is_coordinate(&short) {
            let known = values[..values.len() - 2].join(", ");
            return format!("unknown name '{short}': the coordinates in dimension {n} are {known}");
        }
        let functions = FUNCTIONS.map(|f| f.0);
        let known = functions.iter().copied().chain(["pi"]);
        match nearest(&short, known) {
            Some(nearest) => format!("unknown name '{short}': did you mean '{nearest}'?"),
            None => format!(
                "unknown name '{short}': known are {} and the functions {}",
                values.join(", "),
                functions.join(", ")
            ),
        }
    }
}

/// Is it written as a coordinate is?
fn is_coordinate(name: &str) -> bool {
    let number = name.strip_prefix('x').unwrap_or("no");
    ["x", "y", "z", "w", "t"].contains(&name) || number.chars().all(|c| c.is_ascii_digit())
}

/// Of those that are near a name the nearest, and of two that are equally near the one that it is an abbreviation of.
pub fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let lower = name.to_lowercase();
    // One slip in three letters.
    let far = lower.chars().count().div_ceil(3);
    let measured = known.map(|known| {
        let abbreviated = known.starts_with(&lower) || lower.starts_with(known);
        let steps = match abbreviated && known.len() > 2 && lower.len() > 2 {
            true => 0,
            false => distance(known, &lower),
        };
        (steps, !is_inside(&lower, known), known)
    });
    let best = measured.min_by_key(|(steps, apart, _)| (*steps, *apart))?;
    (best.0 <= far).then_some(best.2)
}

/// Are the letters of `short` in `long`, in their order?
fn is_inside(short: &str, long: &str) -> bool {
    let mut left = long.chars();
    short.chars().all(|c| left.any(|other| other == c))
}

/// How many letters must be inserted, removed or replaced (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
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
