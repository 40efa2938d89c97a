//! The command line `regge-verify`: checks every claim, or those asked for, and writes the report.

mod command;

use command::Args;
use std::process::ExitCode;

fn main() -> ExitCode {
    regge_terminal::main(Args::run)
}
