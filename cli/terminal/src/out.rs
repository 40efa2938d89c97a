//! Where the lines for the user go.

use std::io::{self, ErrorKind, Write};

/// Standard output, or nowhere once nobody reads it: there may still be files to write.
pub struct Out(To);

enum To {
    Output(io::Stdout),
    Error(io::Stderr),
    Nowhere,
}

impl Default for Out {
    fn default() -> Self {
        Self(To::Output(io::stdout()))
    }
}

impl Out {
    /// Standard output.
    pub fn new() -> Self {
        Self::default()
    }

    /// Standard error, where standard output is for something else.
    pub fn error() -> Self {
        Self(To::Error(io::stderr()))
    }

    /// For those who want to hear nothing.
    pub fn nowhere() -> Self {
        Self(To::Nowhere)
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
        match &mut self.0 {
            To::Output(to) => read_or_not(to.write(bytes), bytes.len()),
            To::Error(to) => read_or_not(to.write(bytes), bytes.len()),
            To::Nowhere => Ok(bytes.len()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.0 {
            To::Output(to) => read_or_not(to.flush(), ()),
            To::Error(to) => read_or_not(to.flush(), ()),
            To::Nowhere => Ok(()),
        }
    }
}
