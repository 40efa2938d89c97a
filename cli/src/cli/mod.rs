//! The command line: arguments in, tables, files and exit codes out. Only here is anything printed.

mod action;
mod converge;
mod curvature;
mod einstein;
mod files;
mod given;
mod job;
mod journal;
mod memory;
mod notes;
mod output;
mod phases;
mod picture;
mod progress;
mod reproduce;
mod stop;
mod table;
mod values;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;
use stop::Stop;

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

Exit codes: 0 done, 1 a computation or a file failed, 2 bad arguments.";

/// Distributional scalar curvature of Regge metrics: recomputes the numbers of the paper
/// "Finite element approximation of scalar curvature in arbitrary dimension" (Gawlik, Neunteufel)
/// from nothing but the formula of a metric, and the same for other metrics.
#[derive(Parser)]
#[command(name = "regge", version, after_help = EXAMPLES, subcommand_required = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Reproduce(reproduce::Args),
    Converge(converge::Args),
    Curvature(Box<curvature::Args>),
    Einstein(einstein::Args),
    Action(action::Args),
}

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    match Cli::try_parse() {
        Ok(cli) => finish(run(cli.command)),
        Err(error) => match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                // A reader that has gone away has seen enough.
                let _ = error.print();
                ExitCode::SUCCESS
            }
            ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => finish(Err(no_command())),
            _ => finish(Err(Stop::Usage(values::one_line(&error.to_string())))),
        },
    }
}

fn no_command() -> Stop {
    let cli = Cli::command();
    let names: Vec<&str> = cli
        .get_subcommands()
        .map(|command| command.get_name())
        .collect();
    Stop::Usage(format!("a command is needed: {}", names.join(", ")))
}

fn run(command: Command) -> Result<(), Stop> {
    if let Some(line) = regge_curvature::scalar::Lanes::unused_width() {
        eprintln!("note: {line}");
    }
    match command {
        Command::Reproduce(args) => args.run(),
        Command::Converge(args) => args.run(),
        Command::Curvature(args) => args.run(),
        Command::Einstein(args) => args.run(),
        Command::Action(args) => args.run(),
    }
}

fn finish(result: Result<(), Stop>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(stop) => {
            // Nothing is left to be done where standard error cannot be written.
            let _ = stop.report(&mut std::io::stderr());
            ExitCode::from(stop.code())
        }
    }
}
