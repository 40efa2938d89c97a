//! Rows on disk as soon as they are there: a file of JSON lines, the first of which says of what make the rows are.

use regge_study::{Make, Row, Study};
use regge_terminal::Stop;
use serde::Serialize;
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Where the rows of a run go.
#[derive(Clone, Debug, clap::Args)]
#[group(skip)]
pub struct Args {
    /// Write each row to this file as soon as it is there, as a line of JSON
    #[arg(long, value_name = "FILE.jsonl")]
    rows: Option<PathBuf>,
    /// Go on with the file of --rows: what is in it is not computed again
    #[arg(long, requires = "rows")]
    resume: bool,
}

/// An open file of rows.
pub struct Journal {
    file: File,
    path: PathBuf,
}

impl Args {
    /// Its name, if one was asked for.
    pub fn file(&self) -> &Option<PathBuf> {
        &self.rows
    }

    /// The file, if one was asked for, and the rows that are in it.
    pub fn open(&self, study: &Study) -> Result<(Option<Journal>, Vec<Row>), Stop> {
        let Some(path) = &self.rows else {
            return Ok((None, Vec::new()));
        };
        let refuse = |reason: String| Stop::Usage(format!("{}: {reason}", path.display()));
        let mut options = OpenOptions::new();
        let opened = options
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(path);
        let mut file = opened.map_err(|error| refuse(error.to_string()))?;
        let mut text = String::new();
        file.read_to_string(&mut text)
            .map_err(|error| refuse(error.to_string()))?;
        if !text.is_empty() && !self.resume {
            return Err(refuse("holds rows; --resume goes on with them".into()));
        }
        let mut journal = Journal {
            file,
            path: path.clone(),
        };
        let make = Make::of(study);
        // A line that the end of an earlier run cut short is computed again.
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        let rows = read(path, &text[..whole], &make)?;
        let failed = |error| journal_failed(path, error);
        journal.file.set_len(whole as u64).map_err(failed)?;
        journal.file.seek(SeekFrom::End(0)).map_err(failed)?;
        if whole == 0 {
            journal.line(&make)?;
        }
        Ok((Some(journal), rows))
    }
}

impl Journal {
    /// Adds a line, which is on disk when this returns.
    pub fn line(&mut self, what: &impl Serialize) -> Result<(), Stop> {
        let json = serde_json::to_string(what).map_err(|error| Stop::Failed(error.to_string()))?;
        let written = self.file.write_all((json + "\n").as_bytes());
        let written = written.and_then(|()| self.file.sync_data());
        written.map_err(|error| journal_failed(&self.path, error))
    }
}

fn journal_failed(path: &Path, error: std::io::Error) -> Stop {
    Stop::Failed(format!("{}: {error}", path.display()))
}

/// The rows of an earlier run of the same make.
fn read(path: &Path, text: &str, make: &Make) -> Result<Vec<Row>, Stop> {
    let refuse =
        |line: usize, reason: String| Stop::Input(format!("{}:{line}: {reason}", path.display()));
    let mut lines = text.lines().enumerate().map(|(i, line)| (i + 1, line));
    if let Some((number, line)) = lines.next() {
        let found: Make = serde_json::from_str(line).map_err(|error| {
            refuse(
                number,
                format!("does not say what the rows are of: {error}"),
            )
        })?;
        if found != *make {
            return Err(refuse(number, format!("rows of another study: {line}")));
        }
    }
    let row = |(number, line): (usize, &str)| {
        serde_json::from_str(line).map_err(|error| refuse(number, error.to_string()))
    };
    lines.map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_another_make_or_no_rows_are_refused() {
        let make = Make {
            metric: "flat".into(),
            dimension: 2,
            quantity: "curvature-error".into(),
            projection: "exact".into(),
            quadrature: "converged".into(),
            seed: 3,
        };
        let first = serde_json::to_string(&make).unwrap() + "\n";
        let path = Path::new("f.jsonl");
        assert!(read(path, &first, &make).unwrap().is_empty());
        let other = Make {
            seed: 4,
            ..make.clone()
        };
        assert!(matches!(read(path, &first, &other), Err(Stop::Input(_))));
        let broken = first + "{\"degree\":\n";
        match read(path, &broken, &make) {
            Err(Stop::Input(reason)) => assert!(reason.starts_with("f.jsonl:2: "), "{reason}"),
            _ => panic!("half a row was taken"),
        }
    }
}
