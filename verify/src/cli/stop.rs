//! Why the program stops before it is done: one line and an exit code.

use std::io::{self, ErrorKind, Write};

/// Why the program stops.
#[derive(Debug)]
pub enum Stop {
    /// The arguments make no sense.
    Usage(String),
    /// A computation or a file failed.
    Failed(String),
    /// Nobody reads the output any more.
    Unread,
}

impl Stop {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Failed(_) => 1,
            Self::Unread => 0,
        }
    }

    /// The one line.
    pub fn report(&self, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Usage(reason) => writeln!(to, "regge: {reason} (see --help)"),
            Self::Failed(reason) => writeln!(to, "regge: {reason}"),
            Self::Unread => Ok(()),
        }
    }
}

impl From<io::Error> for Stop {
    /// Of writing to standard output.
    fn from(error: io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::Unread,
            _ => Self::Failed(format!("standard output: {error}")),
        }
    }
}
