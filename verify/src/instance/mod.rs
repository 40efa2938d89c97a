//! Random instances: a moving metric, fields, and hypersurfaces, by their jets at one point.
//!
//! An instance is a fixed number of random numbers, arranged. The strategies of proptest that draw them are shared
//! by the run and the tests, and shrink towards zero: the metric towards ½ δ, all fields towards 0.

mod draw;
mod geometry;

pub use draw::{jet1, jet2, vary1, vary2};
pub use geometry::{
    Face, Scene, along, derivative, divergence_terms, mean_curvature_density, orthonormal, reversed,
};

use crate::claim::{Ground, Timed};
use draw::Source;
use proptest::strategy::{BoxedStrategy, Strategy};
use regge_curvature::formulas::Formulas;
use regge_curvature::jet::{Jet1, Jet2, lower};
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::riemann::{Connection, differential};
use regge_curvature::scalar::Field;

/// All that a pointwise claim may need, at one point and time.
#[derive(Clone, Debug)]
pub struct Instance<S: Timed, const N: usize> {
    /// g at this time.
    pub g: Mat<Jet2<S::Base, N>, N>,
    /// σ = ∂g/∂t.
    pub sigma: Mat<Jet2<S::Base, N>, N>,
    /// g + t σ.
    pub moving_g: Mat<Jet2<S, N>, N>,
    /// Two time-dependent vector fields, upper index.
    pub fields: [Vector<Jet1<S, N>, N>; 2],
    /// A function v.
    pub v: Jet2<S::Base, N>,
    /// A one-form.
    pub alpha: Vector<Jet1<S::Base, N>, N>,
    /// The level function of the hypersurface F = {φ = 0}.
    pub phi: Jet2<S::Base, N>,
    /// A second covector: the other face of a hinge.
    pub nu_bar: Vector<S::Base, N>,
    /// A rate of change of dφ, for a hypersurface that moves (which the paper excludes).
    pub nu_rate: Vector<S::Base, N>,
    /// N−1 time-dependent vector fields, no combination of which is nearly normal to F: a frame of F is made
    /// from them.
    pub seeds: Vec<Vector<Jet1<S, N>, N>>,
    /// Another metric.
    pub other: Mat<Jet1<S::Base, N>, N>,
    /// More numbers.
    pub spare: [S::Base; 12],
}

/// Strategy of the numbers that make an instance.
pub fn numbers<S: Timed, const N: usize>() -> BoxedStrategy<Vec<S::Base>> {
    let len = Instance::<S, N>::count();
    proptest::collection::vec(S::Base::number(), len).boxed()
}

/// Strategy of instances.
pub fn instances<S: Timed + std::fmt::Debug, const N: usize>() -> BoxedStrategy<Instance<S, N>> {
    numbers::<S, N>()
        .prop_map(|numbers| Instance::from_numbers(&numbers))
        .boxed()
}

impl<S: Timed, const N: usize> Instance<S, N> {
    /// How many numbers make an instance.
    pub fn count() -> usize {
        let mut source = Source::counting();
        Self::draw(&mut source);
        source.taken()
    }

    /// The instance made of these numbers, [`Instance::count`] of them.
    pub fn from_numbers(numbers: &[S::Base]) -> Self {
        Self::draw(&mut Source::new(numbers))
    }

    fn draw(source: &mut Source<'_, S::Base>) -> Self {
        let g: Mat<Jet2<S::Base, N>, N> = draw::metric(source);
        let sigma = draw::tensor(source);
        let moving_g = g.zip_map(&sigma, vary2::<S, N>);
        let phi: Jet2<S::Base, N> = draw::level_function(source);
        Self {
            g,
            sigma,
            moving_g,
            phi,
            fields: [draw::field(source), draw::field(source)],
            v: source.jet2(),
            alpha: Vector::from_fn(|_, _| source.jet1()),
            nu_bar: draw::other_face(source, &phi),
            nu_rate: Vector::from_fn(|_, _| source.next()),
            seeds: draw::transversal(source, &phi),
            other: lower(&draw::metric(source)),
            spare: std::array::from_fn(|_| source.next()),
        }
    }

    /// The connection of g + t σ, with first x-derivatives.
    #[inline(never)]
    pub fn moving(&self) -> Connection<Jet1<S, N>, N> {
        Connection::new(&self.moving_g)
    }

    /// The connection of g, with first x-derivatives.
    #[inline(never)]
    pub fn still(&self) -> Connection<Jet1<S::Base, N>, N> {
        Connection::new(&self.g)
    }

    /// The connection of g + t σ.
    #[inline(never)]
    pub fn moving0(&self) -> Connection<S, N> {
        Connection::new(&lower(&self.moving_g))
    }

    /// The connection of g.
    #[inline(never)]
    pub fn still0(&self) -> Connection<S::Base, N> {
        Connection::new(&lower(&self.g))
    }

    /// The face F = {φ = 0} and what is on it, by the formulas K.
    pub fn scene<K: Formulas>(&self) -> Scene<S::Base, N> {
        Scene::new::<K, S>(self, &self.nu())
    }

    /// H of F = {φ = 0} in the metric g + t σ.
    #[inline(never)]
    pub fn moving_h<K: Formulas>(&self) -> S {
        Face::new::<K>(&self.moving0(), &self.nu().map(still_jet::<S, N>)).h
    }

    /// σ with first derivatives.
    pub fn sigma1(&self) -> Mat<Jet1<S::Base, N>, N> {
        lower(&self.sigma)
    }

    /// σ.
    pub fn sigma0(&self) -> Mat<S::Base, N> {
        lower(&self.sigma1())
    }

    /// ν = dφ, which is a covector field along a curved hypersurface.
    pub fn nu(&self) -> Vector<Jet1<S::Base, N>, N> {
        differential(&self.phi)
    }

    /// ν with its derivatives forgotten: that of a plane.
    pub fn flat_nu(&self) -> Vector<Jet1<S::Base, N>, N> {
        self.nu().map(|x| Jet1::constant(x.value))
    }

    /// The g(t)-orthonormal frame of the tangent spaces of the level sets of φ that Gram and Schmidt make of
    /// the seeds; it turns and stretches in space and time.
    #[inline(never)]
    pub fn frame(&self) -> Frame<S, N> {
        let moving = self.moving();
        let nu = self.nu().map(still_jet::<S, N>);
        let normal = regge_curvature::hypersurface::Normal::new(&moving.inverse, &nu);
        let mut vectors = vec![normal.n];
        vectors.extend(self.seeds.iter().copied());
        let tau = orthonormal(&moving.g, &vectors).split_off(1);
        Frame { n: normal.n, tau }
    }
}

/// A constant in time, with its x-derivatives.
pub fn still_jet<S: Timed, const N: usize>(jet: Jet1<S::Base, N>) -> Jet1<S, N> {
    jet.map(S::fixed)
}

/// n, τ_1…τ_{N−1}: orthonormal at all times, as fields around the point.
#[derive(Clone, Debug)]
pub struct Frame<S: Timed, const N: usize> {
    /// The unit normal of the level sets.
    pub n: Vector<Jet1<S, N>, N>,
    /// An orthonormal frame of their tangent spaces.
    pub tau: Vec<Vector<Jet1<S, N>, N>>,
}

impl<S: Timed, const N: usize> Frame<S, N> {
    /// n at this time, with x-derivatives.
    pub fn n1(&self) -> Vector<Jet1<S::Base, N>, N> {
        self.n.map(|x| x.map(S::value))
    }

    /// n at this time and point.
    pub fn n0(&self) -> Vector<S::Base, N> {
        self.n.map(|x| x.value.value())
    }

    /// The τ_i at this time, with x-derivatives.
    pub fn tau1(&self) -> Vec<Vector<Jet1<S::Base, N>, N>> {
        self.tau
            .iter()
            .map(|t| t.map(|x| x.map(S::value)))
            .collect()
    }

    /// The τ_i at this time and point.
    pub fn tau0(&self) -> Vec<Vector<S::Base, N>> {
        self.tau
            .iter()
            .map(|t| t.map(|x| x.value.value()))
            .collect()
    }

    /// τ̇_i at the point.
    pub fn tau_rate(&self) -> Vec<Vector<S::Base, N>> {
        self.tau.iter().map(|t| t.map(|x| x.value.rate())).collect()
    }
}

/// Σ_i f(τ_i).
pub fn sum<B: Field, X>(items: &[X], f: impl Fn(&X) -> B) -> B {
    let mut sum = B::zero();
    for x in items {
        sum += f(x);
    }
    sum
}
