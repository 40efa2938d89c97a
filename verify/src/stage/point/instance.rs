//! The instance itself.

use super::draw::{self, Source, vary2};
use crate::harness::Timed;
use regge_curvature::density::{Corner, Normal};
use regge_curvature::formulas::{Formulas, PAPER};
use regge_curvature::jet::{Jet1, Jet2, lower};
use regge_curvature::linalg::{Mat, Vector, contract};
use regge_curvature::riemann::{Connection, differential};
use regge_curvature::scalar::{Algebraic, Field};

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
    /// The inverse of the other metric, in a position where it is any matrix; else it is computed.
    pub(super) other_inverse: Option<Mat<S::Base, N>>,
    /// Two vectors, in a position where they are any; else they are what is made of g.
    pub(super) any: Option<[Vector<S::Base, N>; 2]>,
    /// More numbers.
    pub spare: [S::Base; 12],
    /// By which formulas the library computes.
    pub formulas: Formulas,
}

impl<S: Timed, const N: usize> Instance<S, N> {
    /// How many numbers make an instance.
    pub fn count() -> usize {
        Self::groups().len()
    }

    /// What each of these numbers is: `∂σ` for a first derivative of σ, `rates` for those of vector fields.
    pub fn groups() -> Vec<String> {
        let mut source = Source::counting();
        Self::draw(&mut source, &PAPER);
        source.groups()
    }

    /// The instance made of these numbers, [`Instance::count`] of them.
    #[inline(never)]
    pub fn from_numbers(numbers: &[S::Base], formulas: &Formulas) -> Self {
        Self::draw(&mut Source::new(numbers), formulas)
    }

    fn draw(source: &mut Source<'_, S::Base>, formulas: &Formulas) -> Self {
        let g: Mat<Jet2<S::Base, N>, N> = draw::metric(source.of("g"));
        let sigma = draw::tensor(source.of("σ"));
        let moving_g = g.zip_map(&sigma, vary2::<S, N>);
        let phi: Jet2<S::Base, N> = draw::level_function(source.of("φ"));
        Self {
            g,
            sigma,
            moving_g,
            phi,
            fields: ["X", "Y"].map(|name| draw::field(source.of(name))),
            v: source.of("v").jet2(),
            alpha: Vector::from_fn(|_, _| source.of("α").jet1()),
            nu_bar: draw::other_face(source.of("ν̄"), &phi),
            nu_rate: Vector::from_fn(|_, _| source.of("ν̇").next()),
            seeds: draw::transversal(source.of("τ"), &phi),
            other: lower(&draw::metric(source.of("g̃"))),
            other_inverse: None,
            any: None,
            spare: std::array::from_fn(|_| source.of("x").next()),
            formulas: *formulas,
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

    /// The connection of the other metric. What is made of its inverse is proved for any inverse, where that is a position.
    #[inline(never)]
    pub fn other0(&self) -> Connection<S::Base, N> {
        let mut connection = Connection::new(&self.other);
        if let Some(inverse) = self.other_inverse {
            connection.inverse = inverse;
        }
        connection
    }

    /// These vectors, which are made of g alone. Where the other metric is in a position and g is not, they are any two: what
    /// holds for any vectors holds for these.
    pub fn or_any(&self, vectors: [Vector<S::Base, N>; 2]) -> [Vector<S::Base, N>; 2] {
        self.any.unwrap_or(vectors)
    }

    /// How much of dφ⊗α + α⊗dφ is added to g where two metrics are to agree on vectors tangent to {φ = 0} alone: with |dφ|,
    /// |α| ≤ √N and g ≥ ½ δ, little enough for a positive definite metric.
    pub fn tear() -> S::Base {
        S::Base::ratio(1, 8 * N as i64)
    }

    /// The unit normal and ω_F of a hypersurface with this covector.
    pub fn normal<F: Algebraic>(&self, at: &Connection<F, N>, nu: &Vector<F, N>) -> Normal<F, N> {
        Normal::new(&self.formulas, &at.inverse, at.det, nu)
    }

    /// The wedge between two hypersurfaces with these outward covectors.
    pub fn corner<'c, F: Algebraic>(
        &'c self,
        at: &'c Connection<F, N>,
        nu: [&Vector<F, N>; 2],
    ) -> Corner<'c, F, N> {
        Corner::new(&self.formulas, &at.inverse, at.det, nu)
    }

    /// f_i with its first two derivatives, i < N ≤ 3, for some functions of one variable each.
    pub fn functions(&self) -> [Jet2<S::Base, N>; N] {
        std::array::from_fn(|i| {
            let mut jet = Jet2::constant(self.spare[3 + i]);
            jet.d[i] = self.spare[6 + i];
            jet.dd[i][i] = self.spare[9 + i];
            jet
        })
    }

    /// A point of ℝ^N.
    pub fn position(&self) -> [S::Base; N] {
        std::array::from_fn(|k| self.spare[k])
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
}

/// A constant in time, with its x-derivatives.
pub fn still_jet<S: Timed, const N: usize>(jet: Jet1<S::Base, N>) -> Jet1<S, N> {
    jet.map(S::fixed)
}

/// Σ_i f(τ_i). Every call has an f of its own: inlined, it is no function of its own.
#[inline(always)]
pub fn sum<B: Field, X>(items: &[X], f: impl Fn(&X) -> B) -> B {
    let mut sum = B::zero();
    for x in items {
        sum += f(x);
    }
    sum
}

/// ∇_X Y, from `[(m, k)]` = (∇_m Y)^k.
pub fn along<F: Field, const N: usize>(nabla: &Mat<F, N>, x: &Vector<F, N>) -> Vector<F, N> {
    Vector::from_fn(|k, _| {
        let mut sum = F::zero();
        for m in 0..N {
            sum += x[m] * nabla[(m, k)];
        }
        sum
    })
}

/// ∇_X f = Xᵐ ∂_m f.
pub fn derivative<F: Field, const N: usize>(f: &Jet1<F, N>, x: &Vector<F, N>) -> F {
    contract(&differential(f), x)
}
