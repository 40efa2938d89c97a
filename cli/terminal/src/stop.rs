//! Why the program stops before it is done: one line and an exit code.

use std::io::{self, Write};

/// What [`Stop::code`] gives, for the help of a program.
pub const EXIT_CODES: &str = "\
Exit codes: 0 done; 1 a computation failed, or a file could not be written; 2 the arguments make no sense, or a file
that was given cannot be read or used.";

/// Why the program stops.
#[derive(Debug)]
pub enum Stop {
    /// The arguments make no sense.
    Usage(String),
    /// A file that was given cannot be read or makes no sense, or more is asked for than the machine or this build can do.
    Input(String),
    /// A computation failed, or a file could not be written.
    Failed(String),
}

impl Stop {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Usage(_) | Self::Input(_) => 2,
            Self::Failed(_) => 1,
        }
    }

    /// Writes the one line, which begins with the program's name.
    ///
    /// # Errors
    /// Those of `to`.
    pub fn report(&self, program: &str, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Usage(reason) => writeln!(to, "{program}: {reason} (see --help)"),
            Self::Input(reason) | Self::Failed(reason) => writeln!(to, "{program}: {reason}"),
        }
    }
}

impl From<io::Error> for Stop {
    /// Of writing to standard output.
    fn from(error: io::Error) -> Self {
        Self::Failed(format!("standard output: {error}"))
    }
}
