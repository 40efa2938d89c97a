//! Floor 5. Certificates: what a proof by a determining set rests on, for a judge who is not of this house.
//!
//! In normal position both sides of a claim are polynomials, which the points of a lattice show to be equal. That they are equal
//! can be seen by any program that computes with polynomials: here as theorems about real numbers for Coq, one for each
//! component. What is written is the program that the production kernel executed, step by step.

mod names;
mod theorem;

use crate::claims::Catalogue;
use crate::exact::Recorded;
use crate::harness::{Budget, Check, Goal, Wrong};
use std::fmt::Write;
use theorem::Named;

/// A file to be written, its path relative to the folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// With folders.
    pub path: String,
    /// The text.
    pub content: String,
}

/// Larger dimensions take hours.
const DIMENSIONS: [usize; 2] = [2, 3];

/// An expression with more operations, what is used twice counted twice, is not written: coqc would take minutes for it.
const MOST: f64 = 2e5;
/// The same where something is divided by parameters, which takes the tactic `field`.
const MOST_RATIONAL: f64 = 5e3;

const HEAD: &str =
    "From Coq Require Import List QArith Reals.\nRequire Import Straight.\nOpen Scope R_scope.\n";

/// Theorems, forged ones, the file that all of them require, and a script that has coqc check them.
pub fn certificates(catalogue: &Catalogue, budget: &Budget) -> Vec<File> {
    let mut files = vec![
        file("Straight.v", include_str!("Straight.v")),
        file("check.sh", include_str!("check.sh")),
    ];
    for check in catalogue
        .iter()
        .filter(|c| DIMENSIONS.contains(&c.dimension))
    {
        let goals = check.goals(budget);
        let name = format!("{}_{}.v", check.record.label, check.dimension);
        if let Some(content) = accepted(check, &goals) {
            files.push(file(&name, &content));
            if let Some(content) = forged(check, &goals) {
                files.push(file(&format!("forged/{name}"), &content));
            }
        }
    }
    files
}

fn file(path: &str, content: &str) -> File {
    File {
        path: path.to_owned(),
        content: content.to_owned(),
    }
}

fn title(check: &Check) -> String {
    let record = check.record;
    format!(
        "(* {}, N = {}. {} *)\n",
        record.label, check.dimension, record.title
    )
}

fn is_large(named: &Named<'_>, result: Recorded) -> bool {
    let most = if named.is_rational(result) {
        MOST_RATIONAL
    } else {
        MOST
    };
    named.size(result) > most
}

/// All theorems of a claim; none if one is too large, or if all say that something is itself.
fn accepted(check: &Check, goals: &[Goal]) -> Option<String> {
    let mut text = title(check) + HEAD;
    let mut any = false;
    for (e, goal) in goals.iter().enumerate() {
        let _ = writeln!(text, "\n(* {}, where {}. *)", goal.equation, goal.position);
        let named = Named::new(&goal.program, &goal.variables);
        let results = goal.vanishing.iter().enumerate();
        for (k, result) in results.filter(|(_, result)| !named.is_trivial(**result)) {
            if is_large(&named, *result) {
                return None;
            }
            any = true;
            let (label, dimension) = (check.record.label, check.dimension);
            let name = format!("{label}_{dimension}_{}_{}", e + 1, k + 1);
            text += &named.theorem(&name, *result);
        }
    }
    any.then_some(text)
}

/// A wrong version of the first equation that has one, as a theorem that must be rejected. Those that were thought of come last,
/// after what is dropped, flipped or doubled.
fn forged(check: &Check, goals: &[Goal]) -> Option<String> {
    goals.iter().find_map(|goal| {
        let named = Named::new(&goal.program, &goal.variables);
        let small = |w: &&Wrong| !is_large(&named, w.difference);
        let wrong = goal.wrong.iter().rev().find(small)?;
        let forged = format!("(* Forged: {} *)\n", wrong.name);
        Some(title(check) + &forged + HEAD + &named.theorem("forged", wrong.difference))
    })
}
