//! Floor 4 of the verification. What a run found: data, tables, pages.

mod chart;
mod coverage;
mod data;
mod formula;
mod html;
mod markdown;
mod page;
mod summary;

pub use crate::harness::{Entry, Failure, Forgery, Vacuous, Verdict};
pub use coverage::coverage;
pub use data::Report;
pub use html::document;
pub use page::{Page, pages};
pub use summary::Row;
