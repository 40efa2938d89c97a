//! The command line: arguments in, tables, files and exit codes out. Only here is anything printed.

mod common;
mod from_files;
mod groups;
mod memory;
mod picture;
#[cfg(feature = "shell")]
mod shell;
mod study;
mod values;

use clap::{Parser, Subcommand};
use common::Common;
use from_files::{action, curvature, einstein};
use regge_curvature::scalar::Lanes;
use regge_terminal::{EXIT_CODES, Stop};
use std::ffi::OsString;
use std::process::ExitCode;
use study::{converge, reproduce};

const EXAMPLES: &str = "\
Examples:
  regge reproduce table1                  the paper's Table 1, N = 2, beside the printed numbers
  regge reproduce table1 --as-printed     the same by the low-order quadrature of the paper
  regge reproduce table2 --levels 0..=2   Table 2, N = 3, on three meshes
  regge reproduce table2 --rows t2.jsonl  all of it, to 1.5 million cells; --resume goes on after a kill
  regge reproduce figure2                 the critical term, averaged and canonical interpolant
  regge converge --metric trig --dimension 3 --degree 1 --levels 0..=3 --plot trig.svg
  regge curvature --mesh m.msh --metric g.toml --degree 1 --json c.json --vtu c.vtu --plot c.svg
  regge einstein --mesh m.msh --lengths l.csv --json e.json
  regge action --mesh m.msh --lengths l.csv --csv gradient.csv

Every command has its own --help, with examples. What the paper states is checked by another program:
cargo run --release -p regge-verify";

/// Curvature of Regge metrics, from files or as in the paper.
///
/// Distributional scalar curvature of Regge metrics: recomputes the numbers of the paper
/// "Finite element approximation of scalar curvature in arbitrary dimension" (Gawlik, Neunteufel)
/// from nothing but the formula of a metric, and the same for other metrics.
#[derive(Parser)]
#[command(
    name = "regge",
    version,
    after_help = "Example: regge curvature --mesh m.msh --metric g.toml --plot c.svg\nMore: regge --help, regge COMMAND --help",
    after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"),
    arg_required_else_help = true,
    subcommand_required = true
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    common: Common,
}

#[derive(Subcommand)]
enum Command {
    Reproduce(reproduce::Args),
    Converge(converge::Args),
    Curvature(Box<curvature::Args>),
    Einstein(einstein::Args),
    Action(action::Args),
    #[cfg(feature = "shell")]
    Completions(shell::Completions),
    #[cfg(feature = "shell")]
    Man(shell::Man),
    /// Says where the claims are checked now
    #[command(hide = true, disable_help_flag = true)]
    Verify {
        /// What the other program is to be given
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
}

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    regge_terminal::main(run)
}

fn run(Cli { command, common }: Cli) -> Result<(), Stop> {
    let computes = !matches!(command, Command::Verify { .. });
    if let Some(line) = Lanes::unused_width().filter(|_| computes) {
        common.voice(&[]).note(&line);
    }
    common.set_threads()?;
    match command {
        Command::Reproduce(args) => args.run(&common),
        Command::Converge(args) => args.run(&common),
        Command::Curvature(args) => in_the_pool(|| args.run(&common)),
        Command::Einstein(args) => in_the_pool(|| args.run(&common)),
        Command::Action(args) => in_the_pool(|| args.run(&common)),
        #[cfg(feature = "shell")]
        Command::Completions(args) => args.run(<Cli as clap::CommandFactory>::command()),
        #[cfg(feature = "shell")]
        Command::Man(args) => args.run(<Cli as clap::CommandFactory>::command()),
        Command::Verify { arguments } => Err(elsewhere(&arguments)),
    }
}

/// Runs a command on one of the threads that compute: it hands work to the others without being sent to sleep and woken each time,
/// thousands of times where an equation is solved. (Studies have threads of their own, one a case.)
fn in_the_pool(run: impl FnOnce() -> Result<(), Stop> + Send) -> Result<(), Stop> {
    rayon::scope(|_| run())
}

/// The catalogue of claims takes minutes to compile, which the other commands are not to wait for.
fn elsewhere(arguments: &[OsString]) -> Stop {
    let mut command = "cargo run --release -p regge-verify --".to_owned();
    for argument in arguments {
        command = command + " " + &argument.to_string_lossy();
    }
    Stop::Input(format!("verify is a program of its own: {command}"))
}
