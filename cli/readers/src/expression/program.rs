//! Formulas that are evaluated together, over any real scalar, in as many places as hold what is still needed.

use super::graph::{Graph, Step};
use regge_curvature::scalar::Real;

/// The steps of formulas, and where their values are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Each with the place where its value goes; operands are places.
    steps: Vec<(Step, u32)>,
    /// How many places there are.
    places: usize,
    /// Where the values of the formulas are at the end.
    results: Vec<u32>,
}

/// Needed to the end.
const ALWAYS: usize = usize::MAX;

impl Program {
    /// The formulas whose values these steps of a graph give.
    pub fn new(graph: &Graph, results: &[u32]) -> Self {
        let needed = last_uses(graph, results);
        let mut at = vec![0; needed.len()];
        let (mut free, mut places) = (Vec::new(), 0);
        let mut steps = Vec::new();
        for (i, step) in graph.steps().iter().enumerate() {
            if needed[i].is_none() {
                continue;
            }
            // An operand that is needed no more makes room for the value.
            for (k, operand) in step.operands().enumerate() {
                // a · a names one operand twice.
                let again = step.operands().take(k).any(|before| before == operand);
                if needed[operand as usize] == Some(i) && !again {
                    free.push(at[operand as usize]);
                }
            }
            at[i] = free.pop().unwrap_or_else(|| {
                places += 1;
                places - 1
            });
            steps.push((step.renamed(|operand| at[operand as usize]), at[i]));
        }
        Self {
            steps,
            places: places as usize,
            results: results.iter().map(|&i| at[i as usize]).collect(),
        }
    }

    /// The values at x, in the order of the formulas.
    #[inline]
    pub fn run<S: Real>(&self, x: &[S], take: impl FnMut(usize, S)) {
        // Places are filled with zeros: no more of them than are needed, and no memory but this for most formulas.
        match self.places {
            0..=4 => self.run_on(&mut [S::zero(); 4], x, take),
            5..=8 => self.run_on(&mut [S::zero(); 8], x, take),
            9..=16 => self.run_on(&mut [S::zero(); 16], x, take),
            places => self.run_on(&mut vec![S::zero(); places], x, take),
        }
    }

    #[inline]
    fn run_on<S: Real>(&self, places: &mut [S], x: &[S], mut take: impl FnMut(usize, S)) {
        self.fill(places, x);
        for (formula, &place) in self.results.iter().enumerate() {
            take(formula, places[place as usize]);
        }
    }

    fn fill<S: Real>(&self, places: &mut [S], x: &[S]) {
        for (step, to) in &self.steps {
            places[*to as usize] = step.value(|place| places[place as usize], x);
        }
    }
}

/// By step: the last step that needs its value; None if nothing does.
fn last_uses(graph: &Graph, results: &[u32]) -> Vec<Option<usize>> {
    let mut last = vec![None; graph.steps().len()];
    for &result in results {
        last[result as usize] = Some(ALWAYS);
    }
    for (i, step) in graph.steps().iter().enumerate().rev() {
        if last[i].is_none() {
            continue;
        }
        for operand in step.operands() {
            // The steps are visited from the last on: the first to name it is its last use.
            last[operand as usize].get_or_insert(i);
        }
    }
    last
}

#[cfg(test)]
mod tests {
    use super::super::Expression;
    use super::super::code::Op;
    use super::*;

    fn program(formulas: &[&str]) -> Program {
        let mut graph = Graph::default();
        let results: Vec<u32> = formulas
            .iter()
            .map(|text| graph.add(&Expression::parse(text, 3).expect("a formula").code))
            .collect();
        Program::new(&graph, &results)
    }

    fn counted(program: &Program, is: fn(&Step) -> bool) -> usize {
        program.steps.iter().filter(|(step, _)| is(step)).count()
    }

    /// The components of the metric of a graph: each square, each quotient is computed once.
    #[test]
    fn what_formulas_share_is_computed_once() {
        let (x, y) = ("(x - x^3/3)", "(y - y^3/3)");
        let [xx, xy, yx] = [format!("1 + {x}^2"), format!("{x}*{y}"), format!("{y}*{x}")];
        let shared = program(&[&xx, &xy, &yx]);
        // x², x³ and (x − x³/3)² of x, x² and x³ of y, and the product of both.
        assert_eq!(counted(&shared, |s| matches!(s, Step::Multiply(..))), 6);
        assert_eq!(counted(&shared, |s| matches!(s, Step::Divide(..))), 2);
        assert_eq!(shared.results[1], shared.results[2]);
    }

    /// What depends on no coordinate is a number, and what nobody needs is gone.
    #[test]
    fn constants_are_folded() {
        let folded = program(&["2*pi/360*x + cos(pi)^2 - sqrt(4)"]);
        let left = |s: &Step| matches!(s, Step::Elementary(..) | Step::Divide(..));
        assert_eq!(counted(&folded, left), 0);
        assert_eq!(counted(&folded, |s| matches!(s, Step::Constant(_))), 3);
    }

    /// Places are used again: a long sum needs three, a formula of many results one for each.
    #[test]
    fn places_are_used_again() {
        let long = vec!["sin(x)*y"; 50].join("+");
        assert!(program(&[&long]).places <= 3);
        let many: Vec<String> = (1..=20).map(|n| format!("x^{n}")).collect();
        let many: Vec<&str> = many.iter().map(String::as_str).collect();
        let powers = program(&many);
        powers.run(&[2.0, 0.0, 0.0], |n, value| {
            assert_eq!(value, 2f64.powi(n as i32 + 1));
        });
        assert!(powers.places <= 21);
    }

    /// A value that is a result is kept, though others are computed from it afterwards.
    #[test]
    fn a_result_may_be_an_operand_and_a_coordinate() {
        let both = program(&["x", "x + y", "x", "(x + y)*z", "1"]);
        let mut values = Vec::new();
        both.run(&[1.0, 2.0, 3.0], |_, value| values.push(value));
        assert_eq!(values, [1.0, 3.0, 1.0, 9.0, 1.0]);
        let mut graph = Graph::default();
        let one = graph.add(&[Op::Coordinate(0)]);
        assert_eq!(Program::new(&graph, &[one]).places, 1);
    }
}
