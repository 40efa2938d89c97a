//! Why a file was refused: the file, the place in it, the reason, in one line.

use std::fmt;
use std::path::{Path, PathBuf};

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    Whole,
    /// A line, from 1.
    Line(u64),
    /// A byte of a binary file, from 0.
    Byte(u64),
}

/// Why a file was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// The file.
    pub file: PathBuf,
    /// Where in it.
    pub place: Place,
    /// What is wrong.
    pub reason: String,
}

impl std::error::Error for InputError {}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        match self.place {
            Place::Whole => write!(f, ": {}", self.reason),
            Place::Line(line) => write!(f, ", line {line}: {}", self.reason),
            Place::Byte(byte) => write!(f, ", byte {byte}: {}", self.reason),
        }
    }
}

impl InputError {
    /// A refusal.
    pub fn new(file: &Path, place: Place, reason: impl Into<String>) -> Self {
        // A reason may quote the file, or come from a parser that draws pictures.
        let reason: String = reason.into();
        let words: Vec<&str> = reason.split_whitespace().collect();
        Self {
            file: file.into(),
            place,
            reason: words.join(" "),
        }
    }
}

/// What is wrong at a place of the file that is being read; the file's name is added by its reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    /// Where.
    pub place: Place,
    /// What.
    pub reason: String,
}

impl Fault {
    /// A fault.
    pub fn new(place: Place, reason: impl Into<String>) -> Self {
        Self {
            place,
            reason: reason.into(),
        }
    }

    /// With the file's name.
    pub fn of(self, file: &Path) -> InputError {
        InputError::new(file, self.place, self.reason)
    }
}

/// The bytes of a file.
pub(super) fn bytes_of(file: &Path) -> Result<Vec<u8>, InputError> {
    std::fs::read(file).map_err(|error| InputError::new(file, Place::Whole, error.to_string()))
}

/// The text of a file.
pub(super) fn text_of(file: &Path) -> Result<String, InputError> {
    String::from_utf8(bytes_of(file)?).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at]
            .iter()
            .filter(|b| **b == b'\n')
            .count();
        InputError::new(file, Place::Line(line as u64 + 1), "is no UTF-8 text")
    })
}
