//! Statements d/dt F(g + tσ) = …, and two ways to check them.
//!
//! [`ByAd`] has the left side by dual numbers, at t = 0. [`ByPath`] takes no derivative in t at all: the left side is
//! F at t = 1 minus F at t = 0, between two arbitrary Regge metrics, and the right side is integrated over t by Gauss'
//! rule. Every term of the claim is integrated for itself, so that its forgeries are those of the claim.

use super::fields::{Regge, Three, function, metric, moving, rates, values, variation};
use super::pair::{Pair, with_spaces};
use super::setting::{Draw, OnMesh, QUADRATURE, Setting, Shape};
use crate::claim::{Equation, Judgement, Method, Record};
use num_dual::Dual64;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, Sums, distributional_curvature_with};
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::scalar::{Lift, Real};
use regge_curvature::spaces::Lagrange;
use std::marker::PhantomData;

/// How many Gauss points in t. The metrics at the ends differ by a few per cent, in the thin cells of Alfeld's split by a
/// few tenths as the cell sees it; the integrand is analytic in t far beyond [0, 1].
pub const POINTS_IN_T: usize = 8;

/// f64 and dual numbers.
pub trait Clock: Real<Sum = Self> + Lift<Self> {}

impl Clock for f64 {}
impl Clock for Dual64 {}

/// g, σ, and how much the functional's three sums change: their rates at t = 0, or their increases up to t = 1.
pub struct Moving<const N: usize> {
    /// g and σ.
    pub at: Pair<N>,
    /// The change of the three sums.
    pub rate: Three,
    /// The coefficients of one random test function that vanishes on the boundary.
    pub v: Vec<f64>,
}

/// A statement about d/dt of a functional of g + tσ.
pub trait Evolution: Send + Sync + 'static {
    /// What the page says.
    const RECORD: Record;
    /// How the residuals are judged.
    const JUDGEMENT: Judgement;

    /// The cases in dimension N.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting>;

    /// The cases along paths: each mesh and degree once.
    fn paths(dimension: usize, quick: bool) -> Vec<Setting> {
        let mut paths: Vec<Setting> = Vec::new();
        for at in Self::settings(dimension, quick) {
            let known = |p: &Setting| (p.shape, p.degree) == (at.shape, at.degree);
            if !paths.iter().any(known) {
                paths.push(at);
            }
        }
        paths
    }

    /// F: by default the three sums of ⟨(Rω)_dist(g), v⟩.
    fn functional<K: Formulas, T: Clock, const N: usize>(
        g: &Regge<T, N>,
        space: &Lagrange<N>,
        rules: &Rules,
    ) -> Sums<T> {
        distributional_curvature_with::<K, T, N, _>(g, space, rules)
    }

    /// The equations, linear in σ and in the rates.
    fn equations<K: Formulas, const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>>;
}

/// A random function that vanishes on the boundary.
fn test_function<const N: usize>(space: &Lagrange<N>, draw: &mut Draw) -> Vec<f64> {
    let mut v = draw.numbers(space.len());
    for (dof, c) in v.iter_mut().enumerate() {
        if !space.vanishes_on_boundary(dof) {
            *c = 0.0;
        }
    }
    v
}

/// At t = 0, over dual numbers.
pub struct ByAd<C>(PhantomData<fn() -> C>);

impl<C: Evolution> OnMesh for ByAd<C> {
    const RECORD: Record = C::RECORD;
    const JUDGEMENT: Judgement = C::JUDGEMENT;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        C::settings(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        with_spaces::<_, N>(at, |regge, space| {
            let (g, sigma) = (metric(regge, draw), variation(regge, draw));
            let rules = Rules::new::<N>(at.order);
            let rate = rates(&C::functional::<K, Dual64, N>(
                &moving(&g, &sigma),
                space,
                &rules,
            ));
            let v = test_function(space, draw);
            let at_zero = Pair {
                space: space.clone(),
                rules,
                g,
                sigma,
            };
            C::equations::<K, N>(
                at,
                &Moving {
                    at: at_zero,
                    rate,
                    v,
                },
            )
        })
    }
}

/// Between t = 0 and t = 1, without derivatives in t.
pub struct ByPath<C>(PhantomData<fn() -> C>);

impl<C: Evolution> OnMesh for ByPath<C> {
    const RECORD: Record = C::RECORD;
    const METHOD: Method = Method::Homotopy;
    /// The increase of a sum is a small difference, and what Gauss' rule leaves in t is added.
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        C::paths(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        with_spaces::<_, N>(at, |regge, space| {
            let path = Path {
                ends: [metric(regge, draw), metric(regge, draw)],
                space: space.clone(),
                v: test_function(space, draw),
            };
            path.equations::<C, K>(at)
        })
    }
}

/// The segment between two Regge metrics.
struct Path<const N: usize> {
    ends: [Regge<f64, N>; 2],
    space: Lagrange<N>,
    v: Vec<f64>,
}

impl<const N: usize> Path<N> {
    /// a g_0 + b g_1.
    fn combination(&self, a: f64, b: f64) -> Regge<f64, N> {
        let [from, to] = &self.ends;
        let pairs = from.coefficients().iter().zip(to.coefficients());
        function(from.space(), pairs.map(|(x, y)| a * x + b * y).collect())
    }

    /// F at the end minus F at the beginning.
    fn increase<C: Evolution, K: Formulas>(&self, rules: &Rules) -> Three {
        let [from, to] = (self.ends.each_ref())
            .map(|g| values(C::functional::<K, f64, N>(g, &self.space, rules)));
        let minus = |x: Vec<f64>, y: Vec<f64>| x.iter().zip(&y).map(|(x, y)| x - y).collect();
        Three {
            t: minus(to.t, from.t),
            f: minus(to.f, from.f),
            s: minus(to.s, from.s),
        }
    }

    /// The claim's equations with the increases on the left, integrated over t by so many points. The weights add up
    /// to 1, so that the left sides stay what they are.
    fn integrated<C: Evolution, K: Formulas>(
        &self,
        at: &Setting,
        increase: &Three,
        points: usize,
    ) -> Vec<Equation<f64>> {
        let (nodes, weights) = gauss_legendre(points);
        let one = |t: f64| {
            let pair = Pair {
                space: self.space.clone(),
                rules: Rules::new::<N>(at.order),
                g: self.combination(1.0 - t, t),
                sigma: self.combination(-1.0, 1.0),
            };
            let moving = Moving {
                at: pair,
                rate: increase.clone(),
                v: self.v.clone(),
            };
            C::equations::<K, N>(at, &moving)
        };
        let all: Vec<_> = nodes.into_iter().map(one).collect();
        Equation::weighted(&weights, all)
    }

    /// With enough points in t, and the forgeries with fewer: their margins show how fast Gauss' rule converges.
    fn equations<C: Evolution, K: Formulas>(&self, at: &Setting) -> Vec<Equation<f64>> {
        let increase = self.increase::<C, K>(&Rules::new::<N>(at.order));
        let mut all = self.integrated::<C, K>(at, &increase, POINTS_IN_T);
        for (points, name) in too_few(at, N) {
            let coarse = self.integrated::<C, K>(at, &increase, points);
            all = (all.into_iter().zip(coarse))
                .map(|(fine, coarse)| fine.forge_right(name, coarse))
                .collect();
        }
        all
    }
}

/// Numbers of Gauss points that do not suffice. When N = 4 the metrics at the ends are nearer to each other, and the
/// reference simplex is the one that changes least: two points are nearly enough there.
pub fn too_few(at: &Setting, dimension: usize) -> impl Iterator<Item = (usize, &'static str)> {
    let names = ["1 Gauss point in t", "2 Gauss points in t"];
    let nearly = dimension == 4 || at.shape == Shape::Single;
    (1..).zip(names).take(if nearly { 1 } else { 2 })
}
