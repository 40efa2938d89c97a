//! The distributional densitized scalar curvature, and what the boundary adds to it. Paper: def:distcurv.

use super::measure::{Density, Where, full_angle};
use super::seen::{OnCell, Seen, all_sites};
use super::walk::pair;
use super::{Rules, Sums};
use crate::field::{Evaluate, TensorField};
use crate::scalar::Real;
use crate::spaces::{Scalar, TestSpace};

/// ⟨(Rω)_dist(g), v⟩ = Σ_T ∫ R v ω + 2 Σ̊_F ∫ ⟦H⟧ v ω_F + 2 Σ̊_S ∫ Θ_S v ω_S for every function v of a test space.
///
/// Functions that do not vanish on the boundary are tested as they are: no boundary term is added.
/// Paper: def:distcurv.
pub fn distributional_curvature<const N: usize, G: TensorField<N>>(
    g: &G,
    space: &impl TestSpace<N, Value = Scalar>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    one(distributional_curvatures(g, &[space], rules))
}

/// [`distributional_curvature`] against several test spaces on one mesh: the curvature is evaluated once.
///
/// # Panics
/// If there is no space.
pub fn distributional_curvatures<const N: usize, G: TensorField<N>>(
    g: &G,
    spaces: &[&dyn TestSpace<N, Value = Scalar>],
    rules: &Rules,
) -> Vec<Sums<G::Scalar>> {
    on::<G::Wide, N, G>(g, spaces, rules, Where::Interior, true)
}

/// 2 Σ_{F⊂∂Ω} ∫ H v ω_F + 2 Σ_{S⊂∂Ω} ∫ (π − Σ_T θ_ST) v ω_S for every function v; the sum over cells is empty.
///
/// H is that of the outward normal. Added to [`distributional_curvature`], it makes
/// the total at v = 1 equal to 4πχ when N = 2 (Gauss and Bonnet), on every triangle and so for every Regge metric; for
/// N ≥ 3 they are twice the terms of Gibbons, Hawking and York with the corners of Hartle and Sorkin.
pub fn boundary_curvature<const N: usize, G: TensorField<N>>(
    g: &G,
    space: &impl TestSpace<N, Value = Scalar>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    one(boundary_curvatures(g, &[space], rules))
}

/// [`boundary_curvature`] against several test spaces on one mesh.
///
/// # Panics
/// If there is no space.
pub fn boundary_curvatures<const N: usize, G: TensorField<N>>(
    g: &G,
    spaces: &[&dyn TestSpace<N, Value = Scalar>],
    rules: &Rules,
) -> Vec<Sums<G::Scalar>> {
    on::<G::Wide, N, G>(g, spaces, rules, Where::Boundary, true)
}

/// Σ_T ∫_T R v ω for every function v: all of ⟨(Rω)(g), v⟩ when g is smooth on the whole domain.
pub fn smooth_curvature<const N: usize, G: TensorField<N>>(
    g: &G,
    space: &impl TestSpace<N, Value = Scalar>,
    rules: &Rules,
) -> Vec<G::Scalar> {
    one(smooth_curvatures(g, &[space], rules)).cells
}

/// [`smooth_curvature`] against several test spaces on one mesh, as sums of which two are empty.
///
/// # Panics
/// If there is no space.
pub fn smooth_curvatures<const N: usize, G: TensorField<N>>(
    g: &G,
    spaces: &[&dyn TestSpace<N, Value = Scalar>],
    rules: &Rules,
) -> Vec<Sums<G::Scalar>> {
    on::<G::Wide, N, G>(g, spaces, rules, Where::Interior, false)
}

fn one<S>(sums: Vec<S>) -> S {
    sums.into_iter().next().expect("one space, one result")
}

fn on<T: Real, const N: usize, G: Evaluate<T, N>>(
    g: &G,
    spaces: &[&dyn TestSpace<N, Value = Scalar>],
    rules: &Rules,
    on: Where,
    singular: bool,
) -> Vec<Sums<T::Sum>> {
    let formulas = &rules.formulas;
    let curved = !g.is_constant();
    let mesh = spaces.first().expect("a test space").mesh();
    let seen = Seen::new(g, &all_sites(N, rules), formulas);
    let density = ScalarCurvature::<T, N, G> {
        seen,
        full_angle: full_angle(formulas, on),
        sums: [
            curved && on == Where::Interior,
            curved && singular,
            singular,
        ],
        faces: T::from_int(formulas.faces),
        hinges: T::from_int(formulas.hinges),
    };
    pair(mesh, &density, on, spaces, rules)
}

/// R ω, 2 H ω_F, 2 Θ_S ω_S.
struct ScalarCurvature<'a, T: Real, const N: usize, G: Evaluate<T, N>> {
    seen: Seen<'a, T, N, G>,
    sums: [bool; 3],
    faces: T,
    hinges: T,
    full_angle: T,
}

impl<T: Real, const N: usize, G: Evaluate<T, N>> Density<T, N> for ScalarCurvature<'_, T, N, G> {
    type Value = Scalar;
    type Local = OnCell<G::Local, T, N>;

    fn sums(&self) -> [bool; 3] {
        self.sums
    }

    fn is_constant_on_hinges(&self) -> bool {
        self.seen.g.is_constant()
    }

    fn full_angle(&self) -> T {
        self.full_angle
    }

    fn on_cell(&self, cell: usize) -> Self::Local {
        self.seen.on_cell(cell)
    }

    #[inline]
    fn in_cell(&self, at: &Self::Local, block: usize, out: &mut [T]) {
        out[0] = self.seen.inside(at, block, |inside, _| inside.scalar());
    }

    #[inline]
    fn on_face(&self, at: &Self::Local, place: usize, block: usize, out: &mut [T]) {
        let h = self
            .seen
            .side(at, place, block, |side| side.densitized_mean_curvature());
        out[0] = h * self.faces;
    }

    #[inline]
    fn at_hinge(
        &self,
        at: &Self::Local,
        place: usize,
        block: usize,
        factors: Option<&mut [T]>,
    ) -> T {
        self.seen.corner(at, place, block, |corner| {
            if let Some(factors) = factors {
                factors[0] = corner.omega() * self.hinges;
            }
            corner.angle()
        })
    }
}
