//! Names of numbers as Coq takes them.

use crate::harness::Variable;

/// `∂1σ12` is `d1sigma12`, Ẋ is `Xdot`. No two are the same.
pub(super) fn identifiers(variables: &[Variable]) -> Vec<String> {
    let mut all: Vec<String> = Vec::with_capacity(variables.len());
    for variable in variables {
        let mut name: String = variable.name.chars().map(spelt).collect();
        while all.contains(&name) {
            name.push('_');
        }
        all.push(name);
    }
    all
}

fn spelt(c: char) -> String {
    let word = match c {
        '∂' => "d",
        'σ' => "sigma",
        'φ' => "phi",
        'α' => "alpha",
        'ν' => "nu",
        'τ' => "tau",
        // Combining marks.
        '\u{303}' => "tilde",
        '\u{304}' | '\u{305}' => "bar",
        '\u{307}' => "dot",
        c if c.is_ascii_alphanumeric() || c == '_' => return c.to_string(),
        _ => "_",
    };
    word.to_owned()
}
