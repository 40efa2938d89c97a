//! Files that are whole or not there.

use super::identity::{Identity, folder, place};
use super::out::Out;
use super::stop::Stop;
use serde::Serialize;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file with the option that names it.
pub type Named<'a> = (&'a str, &'a Path);

/// Those of some options that name a file.
pub fn given<'a, const K: usize>(options: [(&'a str, &'a Option<PathBuf>); K]) -> Vec<Named<'a>> {
    let given = |(option, path): (&'a str, &'a Option<PathBuf>)| Some((option, path.as_deref()?));
    options.into_iter().filter_map(given).collect()
}

/// Says which files were written.
///
/// # Errors
/// Those of `out`.
pub fn show_written(out: &mut dyn Write, files: &[Named<'_>]) -> io::Result<()> {
    let mut files = files.iter().filter(|(_, path)| !is_standard(path));
    files.try_for_each(|(_, path)| writeln!(out, "written: {}", path.display()))
}

/// Is it standard output that is meant?
pub fn is_standard(path: &Path) -> bool {
    ["-", "/dev/stdout"]
        .iter()
        .any(|name| path == Path::new(name))
}

/// Refuses, before anything is computed, files that cannot be written, that are one and the same, or that are among those
/// that are read: as files and not as names, so that neither a link nor another way to write a path loses anything.
///
/// # Errors
/// Names the file, and the options.
pub fn check_all(inputs: &[Named<'_>], outputs: &[Named<'_>]) -> Result<(), Stop> {
    let mut seen: Vec<(&str, Option<Identity>)> = Vec::new();
    for &(option, path) in outputs {
        let shown = path.display();
        let refuse = |reason: String| Err(Stop::Usage(format!("{option} {shown}: {reason}")));
        if is_standard(path) {
            if let Some((other, _)) = seen.iter().find(|(_, of)| of.is_none()) {
                return refuse(format!("{other} goes to standard output already"));
            }
            seen.push((option, None));
            continue;
        }
        // Nothing is lost in a device.
        if !is_device(path) {
            let identity = Identity::of(path);
            if let Some((other, _)) = inputs.iter().find(|(_, of)| Identity::of(of) == identity) {
                return refuse(format!("is the file of {other}, which would be lost"));
            }
            let identity = Some(identity);
            if let Some((other, _)) = seen.iter().find(|(_, of)| *of == identity) {
                return refuse(format!("is the file of {other} too"));
            }
            seen.push((option, identity));
        }
        check(path)?;
    }
    Ok(())
}

/// Refuses a file that cannot be written, before anything is computed for it.
///
/// # Errors
/// Says why it cannot.
pub fn check(path: &Path) -> Result<(), Stop> {
    let refuse = |reason: &str| Err(Stop::Usage(format!("{}: {reason}", path.display())));
    let path = &place(path);
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
        // Its own buffer: a report is written word by word, and what `out` is is not known to the compiler.
        let mut words = BufWriter::with_capacity(1 << 16, out);
        serde_json::to_writer_pretty(&mut words, report)?;
        writeln!(words)?;
        words.flush()
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
    if is_standard(path) {
        let mut out = BufWriter::new(Out::new());
        return Ok(content(&mut out).and_then(|()| out.flush())?);
    }
    let target = place(path);
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

fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|of| !of.is_file() && !of.is_dir())
}

fn fill(file: File, content: impl FnOnce(Content<'_>) -> io::Result<()>) -> io::Result<File> {
    let mut out = BufWriter::new(file);
    content(&mut out)?;
    out.into_inner().map_err(io::IntoInnerError::into_error)
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

    /// A link to a file, a hard link, another way to write the path, a link to a file that is not there yet.
    #[cfg(unix)]
    #[test]
    fn files_are_told_by_what_they_are() {
        let folder = std::env::temp_dir().join(format!("regge-identity-{}", std::process::id()));
        fs::create_dir_all(folder.join("inside")).unwrap();
        let at = |name: &str| folder.join(name);
        fs::write(at("m.msh"), "mesh").unwrap();
        std::os::unix::fs::symlink(at("m.msh"), at("soft")).unwrap();
        fs::hard_link(at("m.msh"), at("hard")).unwrap();
        std::os::unix::fs::symlink("later", at("dangling")).unwrap();
        let mesh = at("m.msh");
        let refused = |outputs: &[&str]| {
            let paths: Vec<PathBuf> = outputs.iter().map(|name| at(name)).collect();
            let outputs: Vec<Named<'_>> = paths.iter().map(|path| ("--json", &**path)).collect();
            check_all(&[("--mesh", &mesh)], &outputs).is_err()
        };
        for same in ["m.msh", "soft", "hard", "inside/../m.msh", "./m.msh"] {
            assert!(refused(&[same]), "{same}");
        }
        for (a, b) in [
            ("new", "inside/../new"),
            ("dangling", "later"),
            ("later", "dangling"),
        ] {
            assert!(refused(&[a, b]), "{a} {b}");
        }
        assert!(!refused(&["new", "other"]));
        write(&at("dangling"), "text").unwrap();
        assert_eq!(
            fs::read_to_string(at("later")).unwrap(),
            "text",
            "a link stays a link"
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
