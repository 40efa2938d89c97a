//! Floor 1 of the verification. The harness: what a claim is, how it is judged, and how forgeries are made of it.
//!
//! A claim yields [`Equation`]s with named terms, one set for every random instance. The [`Tally`] judges them and
//! forges every term in three ways: it drops, flips and doubles it. A claim passes if all its equations hold *and*
//! every forgery is caught wherever its term does not vanish. Where a term vanishes identically, the claim says
//! so, and that is checked as well.
//!
//! Nothing here knows what a claim is about, and nothing is compiled for each claim: a [`Check`] is data, and the
//! mathematics is behind the function pointers in it. What the functions work on is on the floor above,
//! [`stage`](crate::stage).

mod bound;
mod case;
mod check;
mod entry;
mod equation;
mod judgement;
mod lists;
mod proof;
mod proved;
mod record;
mod scalar;
mod tally;
mod weighted;

pub use bound::Bound;
pub use case::{Draw, Key, Setting, Shape, grid};
pub use check::{
    Budget, Cases, Catalogue, Check, Integrals, Kind, OnMeshes, OnNumbers, OnPrograms, has,
};
pub use entry::{Entry, Failure, Forgery, Vacuous, Verdict};
pub use equation::{Equation, Forged, Relation, Term};
pub use judgement::{Judgement, Method};
pub use lists::{each, list, others, pairwise, table};
pub use proof::{AtPoints, Goal, Moved, Moves, Proofs, Variable, Wrong};
pub use proved::{Proof, Proved};
pub use record::{ENOUGH, Excuses, Record};
pub use scalar::{Components, Drawn, Ground, Timed};
pub use tally::{Case, Tally};
