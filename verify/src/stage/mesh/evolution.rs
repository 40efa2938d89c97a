//! Statements d/dt F(g + tσ) = …, and two ways to check them.
//!
//! By AD the left side is computed with dual numbers, at t = 0. Along a path no derivative in t is taken at all: the
//! left side is F at t = 1 minus F at t = 0, between two arbitrary Regge metrics, and the right side is integrated over
//! t by Gauss' rule. Every term of the claim is integrated for itself, so that its forgeries are those of the claim.

use super::cases::QUADRATURE;
use super::claim::{OnMesh, Stretched, add};
use super::pair::{Pair, spaces};
use super::sums::{Three, rates, values};
use crate::harness::{Catalogue, Draw, Equation, Judgement, Method, Record, Setting, Shape, each};
use crate::stage::fields::{Regge, combination, moving, test_function, wild};
use num_dual::Dual64;
use regge_curvature::functional::{Sums, distributional_curvature};
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::scalar::Number;
use regge_curvature::spaces::Lagrange;
use std::marker::PhantomData;

/// How many Gauss points in t. The metrics at the ends differ by a few per cent, in the thin cells of Alfeld's split by a
/// few tenths as the cell sees it; the integrand is analytic in t far beyond [0, 1].
pub const POINTS_IN_T: usize = 8;

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
pub trait Evolution: 'static {
    /// What the page says.
    const RECORD: Record;
    /// How the residuals are judged.
    const JUDGEMENT: Judgement;
    /// Where it is meaningful.
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];

    /// The cases in one of these dimensions.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting>;

    /// The cases along paths: each mesh and degree once.
    fn paths(dimension: usize, quick: bool) -> Vec<Setting> {
        let mut paths: Vec<Setting> = Vec::new();
        for at in Self::settings(dimension, quick) {
            let known = |p: &Setting| (p.shape, p.degree, p.test) == (at.shape, at.degree, at.test);
            if !paths.iter().any(known) {
                paths.push(at);
            }
        }
        paths
    }

    /// F: by default the three sums of ⟨(Rω)_dist(g), v⟩.
    fn functional<T: Number, const N: usize>(
        at: &Setting,
        g: &Regge<T, N>,
        space: &Lagrange<N>,
    ) -> Sums<T> {
        distributional_curvature(g, space, &at.rules(N))
    }

    /// The equations, linear in σ and in the rates.
    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>>;
}

/// Adds a statement in dimension N by both methods.
#[inline(always)]
pub fn add_evolution<C: Evolution, const N: usize>(all: &mut Catalogue) {
    add::<ByAd<C>, N>(all);
    add::<ByPath<C>, N>(all);
}

/// Adds a statement that holds at every point in stretched cells, by AD, for metrics of all degrees below this number.
#[inline(always)]
pub fn add_stretched<C: Evolution, const DEGREES: usize, const N: usize>(all: &mut Catalogue) {
    add::<Stretched<ByAd<C>, DEGREES>, N>(all);
}

/// A functional of g, as data.
type Functional<T, const N: usize> = fn(&Setting, &Regge<T, N>, &Lagrange<N>) -> Sums<T>;

/// The equations of a statement, as data.
type Equations<const N: usize> = fn(&Setting, &Moving<N>) -> Vec<Equation<f64>>;

/// At t = 0, over dual numbers.
struct ByAd<C>(PhantomData<fn() -> C>);

impl<C: Evolution> OnMesh for ByAd<C> {
    const RECORD: Record = C::RECORD;
    const JUDGEMENT: Judgement = C::JUDGEMENT;
    const DIMENSIONS: &'static [usize] = C::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        C::settings(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        C::equations::<N>(at, &at_zero(at, draw, C::functional::<Dual64, N>))
    }
}

/// A random pair, and the rate of the functional at t = 0.
fn at_zero<const N: usize>(
    at: &Setting,
    draw: &mut Draw,
    functional: Functional<Dual64, N>,
) -> Moving<N> {
    let pair = Pair::draw(at, draw);
    let sums = functional(at, &moving(&pair.g, &pair.sigma), &pair.space);
    Moving {
        rate: rates(&sums),
        v: test_function(&pair.space, draw),
        at: pair,
    }
}

/// Between t = 0 and t = 1, without derivatives in t.
pub struct ByPath<C>(PhantomData<fn() -> C>);

impl<C: Evolution> OnMesh for ByPath<C> {
    const RECORD: Record = C::RECORD;
    const METHOD: Method = Method::Homotopy;
    /// The increase of a sum is a small difference, and what Gauss' rule leaves in t is added.
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = C::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        C::paths(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let path = Path::draw(at, draw, C::functional::<f64, N>);
        path.equations(at, C::equations::<N>)
    }
}

/// The segment between two Regge metrics.
struct Path<const N: usize> {
    ends: [Regge<f64, N>; 2],
    space: Lagrange<N>,
    v: Vec<f64>,
    /// F at the end minus F at the beginning.
    increase: Three,
}

impl<const N: usize> Path<N> {
    fn draw(at: &Setting, draw: &mut Draw, functional: Functional<f64, N>) -> Self {
        let (regge, space) = spaces(at);
        let ends = [(); 2].map(|()| wild(&regge, draw, at.noise));
        let from = values(functional(at, &ends[0], &space));
        let to = values(functional(at, &ends[1], &space));
        Self {
            v: test_function(&space, draw),
            increase: to.less(&from),
            ends,
            space,
        }
    }

    /// The claim's equations with the increases on the left, integrated over t by so many points. The weights add up
    /// to 1, so that the left sides stay what they are.
    fn integrated(
        &self,
        at: &Setting,
        equations: Equations<N>,
        points: usize,
    ) -> Vec<Equation<f64>> {
        let (nodes, weights) = gauss_legendre(points);
        let [from, to] = &self.ends;
        let sigma = combination(-1.0, from, 1.0, to);
        let all = each(&nodes, |&t| {
            let g = combination(1.0 - t, from, t, to);
            let moving = Moving {
                at: Pair::new(at, self.space.clone(), g, sigma.clone()),
                rate: self.increase.clone(),
                v: self.v.clone(),
            };
            equations(at, &moving)
        });
        Equation::weighted(&weights, all)
    }

    /// With enough points in t, and the forgeries with fewer: their margins show how fast Gauss' rule converges.
    fn equations(&self, at: &Setting, equations: Equations<N>) -> Vec<Equation<f64>> {
        let mut all = self.integrated(at, equations, POINTS_IN_T);
        for (points, name) in too_few(at, N) {
            let coarse = self.integrated(at, equations, points);
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
