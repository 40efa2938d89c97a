//! What a proof rests on, as data.

use serde::Serialize;

/// An equation that vanishes on its lattice.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Proved {
    /// Which.
    pub equation: String,
    /// The normal position.
    pub position: String,
    /// How many points there are.
    pub points: usize,
    /// The monomials that there can be, by their degrees in the jets.
    pub monomials: Vec<String>,
    /// The degree in the parameters, denominators cleared.
    pub parameters: u64,
}

/// What a proof rests on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Proof {
    /// How many points there were, over all equations.
    pub points: usize,
    /// The largest degree in the jets.
    pub degree: u64,
    /// The degrees of the monomials that there can be, and the positions, by equation.
    pub equations: Vec<Proved>,
    /// log₂ of the chance that a formula which is not equivariant was taken for one that is.
    pub motion_log2: f64,
}

impl Proof {
    /// How sure it is that the equations may be brought to their positions.
    pub fn motion(&self) -> String {
        if self.motion_log2.is_finite() {
            format!("chance < 2^{:.0}", self.motion_log2)
        } else {
            "not needed".to_owned()
        }
    }
}
