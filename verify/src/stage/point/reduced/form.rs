//! The normal positions.

/// A normal position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::stage::point) enum Form {
    /// g = δ; n = e_N; the other face of a hinge is (2u, 1 − u²) in the last two coordinates, u > 0; the frame is the one of
    /// the coordinates.
    Normal,
    /// The same, and v > 0 may be in denominators.
    Conformal,
    /// g = δ, and X = p e_N with p > 0.
    Vector,
    /// In the coordinates of a simplex: g = δ but for g(e_{N−1}, e_N) = (1 − u²)/(1 + u²), u > 0.
    Hinge,
    /// A product of two spaces, g = δ.
    Split,
    /// g = δ and g̃ = diag(λ), λ_i > 0.
    Pair,
    /// g = δ, n = e_N, and g̃⁻¹ is any symmetric matrix with q² in its last place, q > 0; g̃ itself is not defined.
    Inverse,
    /// g̃ = δ, n = e_N by g̃, and the other face of a hinge as in [`Form::Normal`]; of g there is nothing but two vectors that were
    /// made of it, which are any.
    Other,
    /// As [`Form::Normal`]; α = (0, …, b, b′, c) with c such that g + s(dφ⊗α + α⊗dφ) has the determinant d², d > 0, s as in
    /// [`Instance::tear`](super::Instance::tear).
    Torn,
    /// Numbers that are all free: nothing is brought anywhere.
    Place,
    /// The same; the last of them are f_i, f_i′ and f_i″ of some functions, of which f_i alone may be in denominators.
    Functions,
}

/// In the order in which they are tried.
pub(in crate::stage::point) const FORMS: [Form; 11] = [
    Form::Normal,
    Form::Hinge,
    Form::Vector,
    Form::Conformal,
    Form::Split,
    Form::Pair,
    Form::Inverse,
    Form::Other,
    Form::Torn,
    Form::Place,
    Form::Functions,
];

const SURFACE: [&str; 3] = ["φ", "∂φ", "∂²φ"];

/// Is what is drawn by this name of the second metric?
pub(in crate::stage::point) fn is_second(group: &str) -> bool {
    ["g̃", "∂g̃"].contains(&group)
}

impl Form {
    /// By its number.
    pub fn of(number: usize) -> Self {
        FORMS[number]
    }

    /// May a claim depend on what is drawn by this name?
    pub fn allows(self, group: &str) -> bool {
        let surface = SURFACE.contains(&group);
        let frame = ["ν̄", "τ", "∂τ"].contains(&group);
        let (other, seeds) = (is_second(group), ["τ", "∂τ"].contains(&group));
        match self {
            Self::Normal | Self::Conformal | Self::Torn => !other && group != "x",
            Self::Vector | Self::Hinge | Self::Split => {
                !surface && !frame && !other && group != "x"
            }
            Self::Pair => !surface && !frame && group != "x",
            Self::Inverse => !frame && group != "x",
            Self::Other => !seeds && group != "x",
            Self::Place | Self::Functions => group == "x",
        }
    }

    /// Is nothing brought anywhere?
    pub fn is_free(self) -> bool {
        matches!(self, Self::Place | Self::Functions)
    }

    /// As the pages say it.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Normal => "g = δ, n = e_N",
            Self::Conformal => "g = δ, any v > 0",
            Self::Vector => "g = δ, X = p e_N",
            Self::Hinge => "g = δ but for the hinge's angle",
            Self::Split => "g = δ on both factors",
            Self::Pair => "g = δ, g̃ diagonal",
            Self::Inverse => "g = δ, n = e_N, any g̃⁻¹",
            Self::Other => "g̃ = δ, n = e_N",
            Self::Torn => "g⁺ = δ, n = e_N, det g⁻ = d²",
            Self::Place => "any point",
            Self::Functions => "any f, f′, f″",
        }
    }
}
