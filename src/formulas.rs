//! Floor 1. The signs and factors of the paper's formulas, as data.
//!
//! Production code computes by [`PAPER`]. With the feature `formulas`, a sceptic changes a number,
//! `Formulas { second_form: -1, ..PAPER }`, hands it to `Rules::with_formulas` or to a density, and sees which claims of the
//! verification fail: the code that is tested is the code that is used.
//!
//! Without the feature, `Formulas` has no number of its own, and the compiler sees the paper's wherever one is read. The kernels'
//! source is the same and so are their results, bit by bit, but asking whether a factor is 1 took a tenth of the time of a
//! triangle.

use crate::scalar::Field;

/// k x. What is multiplied by 1, as nearly everything is, costs no multiplication, and nothing at all where k is known.
#[inline]
pub(crate) fn times<F: Field>(k: i64, x: F) -> F {
    if k == 1 { x } else { x * F::from_int(k) }
}

/// The formulas by which something is computed: any, for a sceptic.
#[cfg(feature = "formulas")]
#[doc(hidden)]
pub type Formulas = Numbers;

/// The formulas by which everything is computed: the paper's.
#[cfg(not(feature = "formulas"))]
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formulas;

#[cfg(not(feature = "formulas"))]
impl std::ops::Deref for Formulas {
    type Target = Numbers;

    #[inline]
    fn deref(&self) -> &Numbers {
        &NUMBERS
    }
}

/// The formulas as the paper has them (with the corrected conormal).
#[cfg(feature = "formulas")]
#[doc(hidden)]
pub const PAPER: Formulas = NUMBERS;

/// The formulas as the paper has them (with the corrected conormal).
#[cfg(not(feature = "formulas"))]
#[doc(hidden)]
pub const PAPER: Formulas = Formulas;

/// The signs and factors of the formulas that the functionals are made of. All are as in [`PAPER`], unless somebody wants to see
/// what a wrong one does.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numbers {
    /// k in ω = k √det g.
    pub omega: i64,
    /// k in R = k g^jl Ric_jl.
    pub scalar: i64,
    /// k in G = Ric − ½ k R g.
    pub einstein: i64,
    /// k in 𝕊σ = σ − ½ k g Tr σ: 2.
    pub reverse_trace_halves: i64,
    /// k in |ν| = k √(g^ij ν_i ν_j), by which n = g⁻¹ν/|ν| and II are normalised.
    pub normal_length: i64,
    /// k in P^ij = g^ij − k nⁱnʲ.
    pub tangential: i64,
    /// k in II = k ∇ν/|ν|.
    pub second_form: i64,
    /// k in H = k Tr II.
    pub mean_curvature: i64,
    /// k in II‾ = II − k H g.
    pub trace_reversed: i64,
    /// k in ω_F = k √(ν·g⁻¹ν det g).
    pub omega_f: i64,
    /// k in sin θ = k √gram/√(g^aa g^bb).
    pub dihedral_sin: i64,
    /// k in cos θ = −k g(n_a, n_b).
    pub dihedral_cos: i64,
    /// k in ω_S = k √(gram det g).
    pub omega_s: i64,
    /// k in Tr(σ|_S) = Tr σ − [g^bb σ(ν_a,ν_a) − 2 k g^ab σ(ν_a,ν_b) + g^aa σ(ν_b,ν_b)]/gram.
    pub trace_on_s: i64,
    /// k in τ = k (g^ab/g^aa ν_a − ν_b)/√(gram/g^aa), both ν raised.
    pub conormal: i64,
    /// k in the slope k g^ab/g^aa of the same formula.
    pub conormal_slope: i64,
    /// The factor of the face sum in def:distcurv: 2.
    pub faces: i64,
    /// The factor of the hinge sum in def:distcurv: 2.
    pub hinges: i64,
    /// Θ_S + Σ_T θ_ST over π at an interior hinge: 2.
    pub full_angle: i64,
    /// The same on the boundary: 1.
    pub boundary_angle: i64,
    /// The factor of Σ_T ∫⟨𝕊σ, ∇∇v⟩ω in b_h.
    pub b_cells: i64,
    /// The factor of Σ_F ∫𝕊σ(n,n)⟦∇_n v⟧ω_F in b_h: −1.
    pub b_faces: i64,
    /// Does b_h sum over the faces of the boundary too?
    pub b_on_boundary: bool,
    /// The factor of Σ_T ∫⟨G, σ⟩vω in a_h.
    pub a_cells: i64,
    /// The factor of Σ_F ∫⟨⟦II‾⟧, σ⟩vω_F in a_h.
    pub a_faces: i64,
    /// The factor of Σ_S ∫Θ_S Tr(σ|_S)vω_S in a_h: −1.
    pub a_hinges: i64,
}

/// The paper's.
const NUMBERS: Numbers = Numbers {
    omega: 1,
    scalar: 1,
    einstein: 1,
    reverse_trace_halves: 2,
    normal_length: 1,
    tangential: 1,
    second_form: 1,
    mean_curvature: 1,
    trace_reversed: 1,
    omega_f: 1,
    dihedral_sin: 1,
    dihedral_cos: 1,
    omega_s: 1,
    trace_on_s: 1,
    conormal: 1,
    conormal_slope: 1,
    faces: 2,
    hinges: 2,
    full_angle: 2,
    boundary_angle: 1,
    b_cells: 1,
    b_faces: -1,
    b_on_boundary: true,
    a_cells: 1,
    a_faces: 1,
    a_hinges: -1,
};
