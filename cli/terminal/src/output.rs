//! Files that are whole or not there.

use super::stop::Stop;
use serde::Serialize;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Refuses a file that cannot be written, before anything is computed for it.
///
/// # Errors
/// Says why it cannot.
pub fn check(path: &Path) -> Result<(), Stop> {
    let refuse = |reason: &str| Err(Stop::Usage(format!("{}: {reason}", path.display())));
    let path = &real(path);
    if path.is_dir() || path.file_name().is_none() {
        return refuse("is a folder, not a file");
    }
    if !folder(path).is_dir() {
        return refuse("there is no such folder");
    }
    if is_device(path) {
        return Ok(());
    }
    let tried =
        beside(path).and_then(|beside| File::create(&beside).and_then(|_| fs::remove_file(beside)));
    tried.or_else(|error| refuse(&error.to_string()))
}

/// Writes a file beside its place and moves it there: what stood there before stays until the new one is whole.
///
/// # Errors
/// Names the file and what failed.
pub fn write(path: &Path, content: &str) -> Result<(), Stop> {
    write_by(path, |out| out.write_all(content.as_bytes()))
}

/// Writes a report as JSON.
///
/// # Errors
/// Names the file and what failed.
pub fn json(path: &Path, report: &impl Serialize) -> Result<(), Stop> {
    write_by(path, |out| {
        serde_json::to_writer_pretty(&mut *out, report)?;
        writeln!(out)
    })
}

/// [`write()`] for what need not be in memory as a whole.
///
/// # Errors
/// Names the file and what failed.
pub fn write_by(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Stop> {
    let target = real(path);
    let written = match is_device(&target) {
        // A pipe or a terminal has no place to move a file to, and nothing to lose.
        true => File::options()
            .write(true)
            .open(&target)
            .and_then(|file| fill(file, content).map(drop)),
        false => replace(&target, content),
    };
    written.map_err(|error| Stop::Failed(format!("{}: {error}", path.display())))
}

type Content<'a> = &'a mut dyn Write;

fn replace(path: &Path, content: impl FnOnce(Content<'_>) -> io::Result<()>) -> io::Result<()> {
    let beside = beside(path)?;
    let written = File::create(&beside)
        .and_then(|file| fill(file, content)?.sync_all())
        .and_then(|()| fs::rename(&beside, path));
    if written.is_err() {
        // It may not even be there; the error that counts is the first.
        let _ = fs::remove_file(&beside);
    }
    written
}

/// Behind links, which are to stay.
fn real(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.into())
}

fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|of| !of.is_file() && !of.is_dir())
}

fn fill(file: File, content: impl FnOnce(Content<'_>) -> io::Result<()>) -> io::Result<File> {
    let mut out = BufWriter::new(file);
    content(&mut out)?;
    out.into_inner().map_err(io::IntoInnerError::into_error)
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A name in the same folder, so that the move is within one file system, and of this process alone.
fn beside(path: &Path) -> io::Result<PathBuf> {
    let name = path
        .file_name()
        .ok_or(io::ErrorKind::IsADirectory)?
        .to_string_lossy();
    Ok(folder(path).join(format!(".{name}.{}.part", std::process::id())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_no_other() {
        let folder = std::env::temp_dir().join(format!("regge-output-{}", std::process::id()));
        fs::create_dir_all(folder.join("taken/inside")).unwrap();
        let file = folder.join("old.json");
        write(&file, "old").unwrap();
        // A folder that is not empty cannot be replaced by a file: the move fails, after the writing.
        assert!(write(&folder.join("taken"), "new").is_err());
        assert!(folder.join("taken/inside").is_dir());
        write(&file, "new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(
            fs::read_dir(&folder).unwrap().count(),
            2,
            "no part is left behind"
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
