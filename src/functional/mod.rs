//! Floor 6. The functionals of the paper on a mesh: measures on cells, faces and hinges, against every function of a test space.
//!
//! | function | what | paper |
//! |---|---|---|
//! | [`distributional_curvature`] | ⟨(Rω)_dist(g), v⟩ | def:distcurv |
//! | [`distributional_curvatures`] | the same against several spaces, evaluated once | def:distcurv |
//! | [`smooth_curvature`] | ∫ R v ω cell by cell | |
//! | [`boundary_curvature`] | the boundary terms of Gauss and Bonnet | |
//! | [`b_h`], [`a_h`] | the two sides' forms in d/dt⟨(Rω)_dist, v⟩ = b_h − a_h | thm:distcurvdot |
//! | [`variation`], [`variation_adjoint`] | b_h − a_h, and its transpose | thm:distcurvdot |
//! | [`einstein`] | ⟨(Gω)_dist(g), σ⟩ | def:distein |
//! | [`einstein_against`] | the same against every Regge basis function | def:distein |
//! | [`regge_action`], [`action_gradient`], [`action_hessian`] | Regge's action and equations | |
//! | [`angle_defects`], [`cell_volumes`] | Θ_S at barycentres, sizes of hinges and cells | |
//! | [`enclosed`] | Θ_S, \|S\|, the action and its gradient, with proven digits | |
//! | [`enclosed_curvature`] | bounds of R, ⟦H⟧ and Θ over whole cells, faces and hinges | |
//! | [`proven_metric`] | is g positive definite everywhere? | |
//! | [`integrate`] | any density on k-simplices, seen from the cells around | |
//!
//! The three sums over cells T, faces F and hinges S are kept apart. A measure is evaluated cell by cell and knows nothing of
//! test functions; a test space ([`TestSpace`](crate::spaces::TestSpace)) knows nothing of curvature. What is to be summed
//! simplex by simplex is paired with [`Indicators`](crate::spaces::Indicators).

mod action;
mod around;
mod curvature;
mod einstein;
mod enclosed;
mod hessian;
mod integrate;
mod measure;
mod pairing;
mod rules;
mod seen;
mod simplices;
mod variation;
mod walk;

pub use action::{
    Action, ActionGradient, HessianEntry, action_gradient, action_hessian, regge_action,
};
pub use curvature::{
    boundary_curvature, boundary_curvatures, distributional_curvature, distributional_curvatures,
    smooth_curvature, smooth_curvatures,
};
pub use einstein::{a_h, einstein, einstein_against};
pub use enclosed::{Enclosed, EnclosedCurvature, enclosed, enclosed_curvature, proven_metric};
pub use hessian::b_h;
pub use integrate::integrate;
pub use rules::{Rules, Sums, Three};
pub use simplices::{HingeDefect, angle_defects, cell_volumes};
pub use variation::{variation, variation_adjoint};
