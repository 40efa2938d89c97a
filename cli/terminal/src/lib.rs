//! What the programs of this project share: arguments in, one line and an exit code out where something is wrong, files
//! that are whole or not there, a bar of progress.

mod bar;
pub mod output;
mod stop;

pub use bar::{Bar, in_words};
pub use stop::{EXIT_CODES, Out, Stop};

use clap::error::ErrorKind;
use clap::{Command, Parser};
use std::process::ExitCode;

/// Runs a program on the arguments of this process: what `run` refuses, and what is wrong with the arguments, is said in
/// one line on standard error.
pub fn main<A: Parser>(run: impl FnOnce(A) -> Result<(), Stop>) -> ExitCode {
    let result = match A::try_parse() {
        Ok(arguments) => run(arguments),
        Err(error) => instead(&error, &A::command()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(stop) => {
            // Nothing is left to be done where standard error cannot be written.
            let _ = stop.report(A::command().get_name(), &mut std::io::stderr());
            ExitCode::from(stop.code())
        }
    }
}

/// What is done where the arguments ask for no run: help is shown, anything else is refused.
fn instead(error: &clap::Error, program: &Command) -> Result<(), Stop> {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            // A reader that has gone away has seen enough.
            let _ = error.print();
            Ok(())
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => Err(no_command(program)),
        _ => Err(Stop::Usage(one_line(&error.to_string()))),
    }
}

fn no_command(program: &Command) -> Stop {
    let shown = program.get_subcommands().filter(|of| !of.is_hide_set());
    let names: Vec<&str> = shown.map(Command::get_name).collect();
    Stop::Usage(format!("a command is needed: {}", names.join(", ")))
}

/// Clap's message without its advice on usage, in one line.
fn one_line(message: &str) -> String {
    let end = ["\n\nUsage:", "\n\nFor more"]
        .iter()
        .filter_map(|mark| message.find(mark))
        .min();
    let message = &message[..end.unwrap_or(message.len())];
    let message = message.strip_prefix("error: ").unwrap_or(message);
    let message = message.replace("\n\n  tip: ", "; ");
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_messages_become_one_line() {
        let message = "error: no such thing\n  [possible values: a, b]\n\nFor more information, try '--help'.\n";
        assert_eq!(one_line(message), "no such thing [possible values: a, b]");
    }
}
