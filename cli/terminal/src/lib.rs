//! What the programs of this project share: arguments in, one line and an exit code out where something is wrong, files
//! that are whole or not there, a bar of progress.

mod bar;
mod identity;
mod out;
pub mod output;
mod stop;
mod voice;

pub use bar::{Bar, left};
pub use out::Out;
pub use stop::{EXIT_CODES, Stop};
pub use voice::{Loudness, Phases, Voice};

use clap::error::ErrorKind;
use clap::{Command, Parser};
use std::io::Write;
use std::process::ExitCode;

/// Runs a program on the arguments of this process: what `run` refuses, and what is wrong with the arguments, is said in
/// one line on standard error.
pub fn main<A: Parser>(run: impl FnOnce(A) -> Result<(), Stop>) -> ExitCode {
    let result = match A::try_parse() {
        Ok(arguments) => run(arguments).map(|()| ExitCode::SUCCESS),
        Err(error) => instead(&error, &mut A::command()),
    };
    result.unwrap_or_else(|stop| {
        // Nothing is left to be done where standard error cannot be written.
        let _ = stop.report(A::command().get_name(), &mut std::io::stderr());
        ExitCode::from(stop.code())
    })
}

/// What is done where the arguments ask for no run: help is shown, anything else is refused.
fn instead(error: &clap::Error, program: &mut Command) -> Result<ExitCode, Stop> {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            // A reader that has gone away has seen enough.
            let _ = error.print();
            Ok(ExitCode::SUCCESS)
        }
        // Nothing was asked for: the short help, and a code that tells a script so.
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let _ = write!(std::io::stderr(), "{}", program.render_help());
            Ok(ExitCode::from(2))
        }
        _ => Err(Stop::Usage(one_line(&error.to_string()))),
    }
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
