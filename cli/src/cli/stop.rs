//! Why the program stops before it is done: one line and an exit code.

use std::io::{self, ErrorKind, Write};

/// Why the program stops.
#[derive(Debug)]
pub enum Stop {
    /// The arguments make no sense.
    Usage(String),
    /// A file that was given makes no sense.
    Input(String),
    /// A computation or a file failed.
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

    /// The one line.
    pub fn report(&self, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Usage(reason) => writeln!(to, "regge: {reason} (see --help)"),
            Self::Input(reason) | Self::Failed(reason) => writeln!(to, "regge: {reason}"),
        }
    }
}

impl From<io::Error> for Stop {
    /// Of writing to standard output.
    fn from(error: io::Error) -> Self {
        Self::Failed(format!("standard output: {error}"))
    }
}

/// Standard output, or nowhere once nobody reads it: there may still be files to write.
pub struct Out(io::Stdout);

impl Out {
    /// Standard output.
    pub fn new() -> Self {
        Self(io::stdout())
    }
}

fn read_or_not<T>(result: io::Result<T>, unread: T) -> io::Result<T> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(unread),
        result => result,
    }
}

impl Write for Out {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        read_or_not(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        read_or_not(self.0.flush(), ())
    }
}
