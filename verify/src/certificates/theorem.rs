//! One result of a program that vanishes, as a theorem.

use super::names::identifiers;
use crate::exact::{Program, Recorded, Step};
use crate::harness::Variable;
use std::fmt::Write;

/// A program whose inputs have names.
pub(super) struct Named<'a> {
    program: &'a Program,
    variables: &'a [Variable],
    /// As Coq takes them.
    names: Vec<String>,
    /// By step, how many operations it takes, where what is used twice is counted twice.
    sizes: Vec<f64>,
}

/// Expressions with more operations take the tactic `field` seconds.
const SHORT: f64 = 300.0;

/// What the steps are written for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum For {
    /// The statement: real numbers.
    Statement,
    /// The proof: expressions, of which there is no quotient.
    Proof,
}

impl<'a> Named<'a> {
    pub fn new(program: &'a Program, variables: &'a [Variable]) -> Self {
        let mut sizes: Vec<f64> = Vec::with_capacity(program.steps().len());
        for step in program.steps() {
            let below: f64 = step.operands().map(|k| sizes[k as usize]).sum();
            sizes.push(1.0 + below);
        }
        Self {
            program,
            variables,
            names: identifiers(variables),
            sizes,
        }
    }

    /// How many operations a result takes.
    pub fn size(&self, result: Recorded) -> f64 {
        self.sizes[result.place()]
    }

    /// Does a result vanish because it is 0, or the difference of a number and itself?
    pub fn is_trivial(&self, result: Recorded) -> bool {
        match self.program.steps()[result.place()] {
            Step::Constant(n, _) => n == 0,
            Step::Difference(a, b) => a == b,
            _ => false,
        }
    }

    /// Statement and proof that a result vanishes.
    ///
    /// The statement is about real numbers, a `let` for each step. The proof says the same steps once more as an expression,
    /// whose polynomial coqc computes, and that the expression is the statement's. Of a short program, and where something is
    /// divided by parameters, the proof is the tactic `field`.
    pub fn theorem(&self, name: &str, result: Recorded) -> String {
        let needed = self.program.needed([result]);
        let used = self.program.inputs(&needed);
        let names: Vec<&str> = used.iter().map(|k| self.names[*k].as_str()).collect();
        let mut text = format!("Theorem {name} :");
        if !names.is_empty() {
            let _ = write!(text, " forall {} : R,", names.join(" "));
        }
        text.push('\n');
        let rational = self.is_rational(result);
        for k in used.iter().filter(|_| rational) {
            if self.variables[*k].group.is_empty() {
                let _ = writeln!(text, "0 < {} ->", self.names[*k]);
            }
        }
        self.steps(&mut text, &needed, result, For::Statement);
        let [left, right] = self.sides(result, For::Statement);
        let _ = writeln!(text, "{left} = {right}.\nProof.");
        if rational || self.size(result) <= SHORT {
            text += "by_field.\n";
        } else {
            self.by_expression(&mut text, &needed, &names, result);
        }
        text += "Qed.\n";
        text
    }

    /// Writes the expression beside the statement.
    fn by_expression(&self, text: &mut String, needed: &[bool], names: &[&str], result: Recorded) {
        if !names.is_empty() {
            let _ = writeln!(text, "intros {}.", names.join(" "));
        }
        text.push_str("vm_cast_no_check (\n");
        let _ = writeln!(text, "let numbers := ({} nil) in", cons(names));
        for (k, name) in names.iter().enumerate() {
            let _ = writeln!(text, "let {name} := input {} in", k + 1);
        }
        self.steps(text, needed, result, For::Proof);
        let [left, right] = self.sides(result, For::Proof);
        let _ = writeln!(
            text,
            "let left := ({left})%E in let right := ({right})%E in"
        );
        text.push_str("same numbers left right (eq_refl true <: agree left right = true)).\n");
    }

    /// Is anything divided by something that is no number?
    pub fn is_rational(&self, result: Recorded) -> bool {
        let needed = self.program.needed([result]);
        let constant = |k: u32| matches!(self.step(k), Step::Constant(..));
        let mut steps = self.program.steps().iter().zip(needed);
        steps.any(|(step, needed)| needed && matches!(step, Step::Quotient(_, b) if !constant(*b)))
    }

    fn step(&self, place: u32) -> Step {
        self.program.steps()[place as usize]
    }

    /// What is said to be equal: both sides of a last difference, or the result and 0.
    fn sides(&self, result: Recorded, language: For) -> [String; 2] {
        let place = result.place() as u32;
        match self.step(place) {
            Step::Difference(a, b) => [a, b].map(|k| self.operand(k, language)),
            _ => [self.operand(place, language), number(0, 1, language)],
        }
    }

    /// A `let` for each step but the last difference.
    fn steps(&self, text: &mut String, needed: &[bool], result: Recorded, language: For) {
        let scope = if language == For::Proof { "%E" } else { "" };
        for (place, step) in self.program.steps().iter().enumerate() {
            let last = place == result.place() && matches!(step, Step::Difference(..));
            if !needed[place] || last {
                continue;
            }
            let of = |k: &u32| self.operand(*k, language);
            let done = match step {
                Step::Input(_) | Step::Constant(..) => continue,
                Step::Sum(a, b) => format!("{} + {}", of(a), of(b)),
                Step::Difference(a, b) => format!("{} - {}", of(a), of(b)),
                Step::Product(a, b) => format!("{} * {}", of(a), of(b)),
                Step::Opposite(a) => format!("- {}", of(a)),
                Step::Quotient(a, b) => match self.step(*b) {
                    Step::Constant(n, d) => {
                        let inverse = number(d * n.signum(), n.abs(), language);
                        format!("{} * {inverse}", of(a))
                    }
                    _ => format!("{} / {}", of(a), of(b)),
                },
                Step::Root(a) => format!("sqrt {}", of(a)),
            };
            let _ = writeln!(text, "let k{place} := ({done}){scope} in");
        }
    }

    fn operand(&self, place: u32, language: For) -> String {
        match self.step(place) {
            Step::Input(k) => self.names[k as usize].clone(),
            Step::Constant(n, d) => number(n, d, language),
            _ => format!("k{place}"),
        }
    }
}

/// n/d.
fn number(n: i64, d: i64, language: For) -> String {
    match (language, d) {
        (For::Proof, _) => format!("(constant (({n}) # {d})%Q)"),
        (For::Statement, 1) if n >= 0 => n.to_string(),
        (For::Statement, 1) => format!("(IZR ({n}))"),
        (For::Statement, _) => format!("(IZR ({n}) / {d})"),
    }
}

fn cons(names: &[&str]) -> String {
    names
        .iter()
        .map(|name| format!("{name} ::"))
        .collect::<Vec<_>>()
        .join(" ")
}
