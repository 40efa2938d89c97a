//! Checks whose cases are settings: a mesh, a degree and an order, with fields that are drawn while they are made.

use crate::harness::case::{Draw, Key, Setting};
use crate::harness::equation::Equation;
use crate::harness::judgement::Judgement;
use crate::harness::tally::{Case, Tally};
use regge_curvature::formulas::Formulas;

/// Equations between integrals over meshes.
#[derive(Clone, Copy, Debug)]
pub struct OnMeshes {
    /// How the residuals are judged.
    pub judgement: Judgement,
    /// The cases in a dimension, of a quick run or of a full one.
    pub settings: fn(usize, bool) -> Vec<Setting>,
    /// The equations of one case.
    pub equations: fn(&Setting, &mut Draw) -> Vec<Equation<f64>>,
}

/// How often a failing case is tried with fewer numbers.
const SHRINKS: usize = 32;

impl OnMeshes {
    /// The cases, simplest first, so that the first failure is the simplest.
    pub(super) fn settings(&self, dimension: usize, quick: bool) -> Vec<Setting> {
        let mut settings = (self.settings)(dimension, quick);
        settings.sort_by_key(Setting::complexity);
        settings
    }

    /// Does all cases, each with randomness of its own.
    pub(super) fn run(&self, first: Key<'_>, quick: bool, formulas: &Formulas) -> Tally {
        let mut tally = Tally::new(self.judgement);
        let settings = self.settings(first.dimension, quick);
        for (number, at) in settings.into_iter().enumerate() {
            let at = Setting {
                formulas: *formulas,
                ..at
            };
            let key = Key {
                case: number,
                ..first
            };
            let detail = format!("{:?}, r = {}, order {}", at.shape, at.degree, at.order);
            let mut draw = Draw::new(&key);
            let equations = (self.equations)(&at, &mut draw);
            if !tally.add(&Case { number, detail }, &equations) {
                tally.shrunk(self.shrink(&at, &key, draw.drawn));
                break;
            }
        }
        tally
    }

    fn replay(&self, at: &Setting, key: &Key<'_>, numbers: &[f64]) -> Vec<Equation<f64>> {
        (self.equations)(at, &mut Draw::replay(key, numbers))
    }

    /// Sets numbers to zero that the failure does not need: halves of them, quarters, and so on, as long as the budget
    /// lasts. (The mesh and r need no shrinking: the simplest cases come first.)
    fn shrink(&self, at: &Setting, key: &Key<'_>, mut numbers: Vec<f64>) -> Vec<String> {
        let failed = self.replay(at, key, &numbers);
        let fails = |numbers: &[f64]| {
            let tried = self.replay(at, key, numbers);
            let mut pairs = tried.iter().zip(&failed);
            pairs.any(|(e, whole)| e.fails_like(whole, self.judgement.tolerance()))
        };
        let (mut tries, mut chunk) = (0, numbers.len().div_ceil(2));
        while chunk > 0 && tries < SHRINKS {
            for start in (0..numbers.len()).step_by(chunk) {
                let end = numbers.len().min(start + chunk);
                if tries == SHRINKS || numbers[start..end].iter().all(|x| *x == 0.0) {
                    continue;
                }
                tries += 1;
                let kept = numbers[start..end].to_vec();
                numbers[start..end].fill(0.0);
                if !fails(&numbers) {
                    numbers[start..end].copy_from_slice(&kept);
                }
            }
            chunk /= 2;
        }
        let nonzero = numbers.iter().enumerate().filter(|(_, x)| **x != 0.0);
        nonzero.map(|(k, x)| format!("#{k} = {x:?}")).collect()
    }
}
