//! All tests of the package in one program: they are small, and what takes time is to link the catalogue.

mod catalogue;
mod certificates;
mod cli;
mod coverage;
mod errata;
mod exact;
mod how_to;
mod labels;
mod program;
mod proof;
mod sabotage;
// What the command line's tests read the same schema by.
#[path = "../../../cli/tests/common/schema.rs"]
mod schema;
