//! Floor 2 of the verification. What claims are about, and what several of them compute in the same way.
//!
//! | | what stands there | kinds of claims |
//! |---|---|---|
//! | [`point`] | jets of a moving metric and of fields at one point | [`Pointwise`](point::Pointwise) |
//! | [`polynomial`] | polynomial fields on simplices over the prime field | [`ByParts`](polynomial::ByParts) |
//! | [`fields`] | random fields on meshes | |
//! | [`mesh`] | meshes, the sums of the paper's forms, why terms vanish | [`OnMesh`](mesh::OnMesh), [`Evolution`](mesh::Evolution) |
//! | [`mod@reference`] | geometry and numbers that do not come from the library | |

pub mod fields;
pub mod mesh;
pub mod point;
pub mod polynomial;
pub mod reference;
