//! One equation of a claim at one instance: named terms on both sides, and forgeries made by hand.
//!
//! ```text
//! Equation::new("∂_t(Rω)")
//!     .left("∂_t(Rω)", …)
//!     .right("(div div 𝕊σ) ω", …)
//!     .right("−⟨G,σ⟩ω", …).vanishes(N == 2, "G = 0 when N = 2")
//!     .forge("Ric for G", "−⟨G,σ⟩ω", …)
//! ```

use super::judgement::Method;
use super::scalar::{Components, Ground};

/// How the two sides are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// left = right, component by component.
    Equal,
    /// left ≤ right, for scalars; the residual is left/right.
    AtMost,
}

/// A named term, its sign included.
#[derive(Clone, Debug)]
pub struct Term<B> {
    /// As the page shows it.
    pub name: &'static str,
    /// Its components.
    pub value: Vec<B>,
    /// Why it vanishes here, if it does: dropping it is then no forgery.
    pub vanishes: Option<&'static str>,
}

impl<B> Term<B> {
    fn new(name: &'static str, value: Vec<B>) -> Self {
        Self {
            name,
            value,
            vanishes: None,
        }
    }
}

/// A wrong version of an equation, made by hand.
#[derive(Clone, Debug)]
pub struct Forged<B> {
    /// What is wrong.
    pub name: &'static str,
    /// The terms that it replaces.
    pub replaced: Vec<(&'static str, Vec<B>)>,
    /// Is one instance that catches it enough? Otherwise every instance must.
    pub somewhere: bool,
    /// Why it cannot be caught here.
    pub vacuous: Option<&'static str>,
}

/// Two sides with named terms.
#[derive(Clone, Debug)]
pub struct Equation<B> {
    /// Which equation of the claim.
    pub name: &'static str,
    /// Equal, or at most.
    pub relation: Relation,
    /// The terms on the left.
    pub left: Vec<Term<B>>,
    /// The terms on the right.
    pub right: Vec<Term<B>>,
    /// Forgeries by hand; the harness adds its own.
    pub forged: Vec<Forged<B>>,
    /// What rounding is relative to, beside the terms: the size of what cancels inside a term.
    pub magnitude: f64,
}

impl<B: Ground> Equation<B> {
    /// left = right; terms are to follow.
    pub fn new(name: &'static str) -> Self {
        Self {
            name,
            relation: Relation::Equal,
            left: Vec::new(),
            right: Vec::new(),
            forged: Vec::new(),
            magnitude: 0.0,
        }
    }

    /// left ≤ right.
    pub fn at_most(name: &'static str) -> Self {
        Self {
            relation: Relation::AtMost,
            ..Self::new(name)
        }
    }

    /// One more term on the left, its sign included.
    pub fn left(self, name: &'static str, value: impl Components<B>) -> Self {
        self.with_left(name, value.components())
    }

    fn with_left(mut self, name: &'static str, value: Vec<B>) -> Self {
        self.left.push(Term::new(name, value));
        self
    }

    /// One more term on the right, its sign included.
    pub fn right(self, name: &'static str, value: impl Components<B>) -> Self {
        self.with_right(name, value.components())
    }

    fn with_right(mut self, name: &'static str, value: Vec<B>) -> Self {
        self.right.push(Term::new(name, value));
        self
    }

    /// The last term on the right (or on the left, if there is none on the right yet) vanishes identically in
    /// this situation. The harness checks that.
    pub fn vanishes(mut self, here: bool, reason: &'static str) -> Self {
        let last = if self.right.is_empty() {
            self.left.last_mut()
        } else {
            self.right.last_mut()
        };
        let term = last.expect("there is a term that can vanish");
        if here {
            term.vanishes = Some(reason);
        }
        self
    }

    /// A forgery: this term has this value instead.
    pub fn forge(self, name: &'static str, term: &'static str, value: impl Components<B>) -> Self {
        self.forge_terms(name, vec![(term, value.components())])
    }

    /// A forgery that changes several terms.
    pub fn forge_terms(
        mut self,
        name: &'static str,
        replaced: Vec<(&'static str, Vec<B>)>,
    ) -> Self {
        for (term, _) in &replaced {
            let known = self.left.iter().chain(&self.right).any(|t| t.name == *term);
            assert!(
                known,
                "forgery {name:?} of {:?} replaces no term {term:?}",
                self.name
            );
        }
        self.forged.push(Forged {
            name,
            replaced,
            somewhere: false,
            vacuous: None,
        });
        self
    }

    /// The last forgery cannot be caught in this situation: it changes nothing. The harness checks that.
    pub fn vacuous(mut self, here: bool, reason: &'static str) -> Self {
        let forged = self.forged.last_mut().expect("there is a forgery");
        if here {
            forged.vacuous = Some(reason);
        }
        self
    }

    /// The last forgery is right for some instances: it is enough that some catch it.
    pub fn somewhere(mut self) -> Self {
        let forged = self.forged.last_mut().expect("there is a forgery");
        forged.somewhere = true;
        self
    }

    /// Rounding is judged relative to this, too: for terms that vanish by cancellation.
    pub fn magnitude(self, size: impl Components<B>) -> Self {
        self.with_magnitude(largest(&size.components()))
    }

    fn with_magnitude(mut self, size: f64) -> Self {
        self.magnitude += size;
        self
    }
}

impl<B: Ground> Equation<B> {
    /// A forgery with the right side of another equation of the same form, caught if it is wrong somewhere. None if
    /// there is nothing on the right that does not vanish.
    pub fn forge_right(self, name: &'static str, other: Self) -> Self {
        if self.right.iter().all(|t| t.vanishes.is_some()) {
            return self;
        }
        let terms = other.right.into_iter().map(|t| (t.name, t.value));
        self.forge_terms(name, terms.collect()).somewhere()
    }
}

impl<B: Copy> Equation<B> {
    /// The same equation over another scalar.
    pub fn map<C>(&self, f: &dyn Fn(B) -> C) -> Equation<C> {
        let all = |values: &[B]| values.iter().map(|x| f(*x)).collect();
        let terms = |terms: &[Term<B>]| -> Vec<Term<C>> {
            let mapped = terms.iter().map(|t| Term {
                name: t.name,
                value: all(&t.value),
                vanishes: t.vanishes,
            });
            mapped.collect()
        };
        let replaced = |r: &(&'static str, Vec<B>)| (r.0, all(&r.1));
        let forged = self.forged.iter().map(|f| Forged {
            name: f.name,
            replaced: f.replaced.iter().map(replaced).collect(),
            somewhere: f.somewhere,
            vacuous: f.vacuous,
        });
        Equation {
            name: self.name,
            relation: self.relation,
            left: terms(&self.left),
            right: terms(&self.right),
            forged: forged.collect(),
            magnitude: self.magnitude,
        }
    }
}

impl<B: Ground> Equation<B> {
    /// The terms of both sides.
    pub(super) fn terms(&self) -> impl Iterator<Item = &Term<B>> {
        self.left.iter().chain(&self.right)
    }

    /// Σ of the terms' magnitudes, never zero; 1 where numbers have no size.
    pub(super) fn scale(&self) -> f64 {
        if B::METHOD == Method::Exact {
            return 1.0;
        }
        let sum = self.terms().map(|t| largest(&t.value)).sum::<f64>() + self.magnitude;
        if sum == 0.0 { 1.0 } else { sum }
    }

    /// The two sides, with some terms replaced; as long as the longer one.
    fn sides(&self, replaced: &[(&'static str, Vec<B>)]) -> [Vec<B>; 2] {
        let side = |terms: &[Term<B>]| -> Vec<B> {
            let mut sum: Vec<B> = Vec::new();
            for term in terms {
                let value = replaced
                    .iter()
                    .find(|r| r.0 == term.name)
                    .map_or(&term.value, |r| &r.1);
                sum.resize(value.len(), B::zero());
                for (s, x) in sum.iter_mut().zip(value) {
                    *s += *x;
                }
            }
            sum
        };
        let (mut left, mut right) = (side(&self.left), side(&self.right));
        let len = left.len().max(right.len());
        left.resize(len, B::zero());
        right.resize(len, B::zero());
        [left, right]
    }

    /// left − right, with some terms replaced.
    pub fn difference(&self, replaced: &[(&'static str, Vec<B>)]) -> Vec<B> {
        let [left, right] = self.sides(replaced);
        left.iter().zip(&right).map(|(l, r)| *l - *r).collect()
    }

    /// |left − right| over the scale, or left/right; with some terms replaced.
    pub(super) fn residual(&self, replaced: &[(&'static str, Vec<B>)]) -> f64 {
        if self.relation == Relation::AtMost {
            let [left, right] = self.sides(replaced);
            return largest(&left) / largest(&right);
        }
        largest(&self.difference(replaced)) / self.scale()
    }

    /// Every number in it, those of the forgeries included.
    pub fn numbers(&self) -> impl Iterator<Item = B> {
        let forged = self.forged.iter().flat_map(|f| &f.replaced);
        let values = self.terms().map(|t| &t.value).chain(forged.map(|r| &r.1));
        values.flatten().copied()
    }

    /// All wrong versions, by name: every term dropped, flipped and doubled, and the forgeries made by hand.
    pub fn forgeries(&self) -> Vec<(String, Forged<B>)> {
        let mut all = Vec::new();
        let terms = self.terms().filter(|_| self.relation == Relation::Equal);
        for term in terms {
            for (kind, factor) in [("drop", 0), ("flip", -1), ("double", 2)] {
                let value = term.value.iter().map(|x| B::from_int(factor) * *x);
                let forged = Forged {
                    name: "",
                    replaced: vec![(term.name, value.collect())],
                    somewhere: false,
                    vacuous: term.vanishes,
                };
                all.push((format!("{}: {kind} {}", self.name, term.name), forged));
            }
        }
        let by_hand = self.forged.iter();
        all.extend(by_hand.map(|f| (format!("{}: {}", self.name, f.name), f.clone())));
        all
    }

    /// Did a root or an inverse not exist?
    pub fn is_poisoned(&self) -> bool {
        self.numbers().any(|x| x.is_poison())
    }
}

/// max |component|; NaN if there is one.
pub(super) fn largest<B: Ground>(value: &[B]) -> f64 {
    let mut max = 0.0;
    for x in value {
        if x.is_poison() {
            return f64::NAN;
        }
        max = f64::max(max, x.size());
    }
    max
}
