//! Floor 4 of the verification. What a run found: data, tables, pages.

mod chain;
mod chart;
mod coverage;
mod data;
mod exactly;
mod formula;
mod html;
mod markdown;
mod page;
mod standing;
mod summary;

pub use crate::harness::{Entry, Failure, Forgery, Vacuous, Verdict};
pub use chain::{CHAIN, Link};
pub use coverage::coverage;
pub use data::Report;
pub use html::document;
pub use page::{Page, pages};
pub use summary::Row;
