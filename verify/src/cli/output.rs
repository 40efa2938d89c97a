//! Files that are whole or not there.

use super::stop::Stop;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Refuses a file that cannot be written, before anything is computed for it.
pub fn check(path: &Path) -> Result<(), Stop> {
    let refuse = |reason: &str| Err(Stop::Usage(format!("{}: {reason}", path.display())));
    if path.is_dir() || path.file_name().is_none() {
        return refuse("is a folder, not a file");
    }
    if folder(path).is_dir() {
        Ok(())
    } else {
        refuse("there is no such folder")
    }
}

/// Writes a file beside its place and moves it there: what stood there before stays until the new one is whole.
pub fn write(path: &Path, content: &str) -> Result<(), Stop> {
    let beside = beside(path);
    let written = write_new(&beside, content).and_then(|()| fs::rename(&beside, path));
    written.map_err(|error| {
        // It may not even be there; the error that counts is the first.
        let _ = fs::remove_file(&beside);
        Stop::Failed(format!("{}: {error}", path.display()))
    })
}

fn write_new(path: &Path, content: &str) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(content.as_bytes())?;
    file.sync_all()
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A name in the same folder, so that the move is within one file system, and of this process alone.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    folder(path).join(format!(".{name}.{}.part", std::process::id()))
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
