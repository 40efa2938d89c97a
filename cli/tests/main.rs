//! The command line's tests as one program.
//!
//! `cargo test -p regge-cli --test all cli_numbers` runs one file.

mod cli;
mod cli_action;
mod cli_curvature;
mod cli_curvature_input;
mod cli_curvature_output;
mod cli_files;
mod cli_formats;
mod cli_gmsh;
mod cli_numbers;
mod cli_resume;
mod cli_study;
mod cli_surface;
mod cli_topology;
mod cli_words;
mod cli_wrong;
mod common;
mod fuzz_readers;
