//! Which files are one and the same, whatever they are called.

use std::fs;
use std::path::{Path, PathBuf};

/// A file as the system knows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Identity {
    /// One that is there, by device and number: links, hard ones too, are the file that they lead to.
    #[cfg(unix)]
    There(u64, u64),
    /// By the place where it is or will be.
    At(PathBuf),
}

impl Identity {
    /// Of a path.
    pub fn of(path: &Path) -> Self {
        #[cfg(unix)]
        if let Ok(file) = fs::metadata(path) {
            use std::os::unix::fs::MetadataExt;
            return Self::There(file.dev(), file.ino());
        }
        Self::At(place(path))
    }
}

/// The absolute path behind all links, as far as it is there.
pub fn place(path: &Path) -> PathBuf {
    // A link that leads nowhere yet is the file that it names; a chain of them ends, or goes around in a circle.
    let mut path = path.to_path_buf();
    for _ in 0..40 {
        match fs::read_link(&path) {
            Ok(target) => path = folder(&path).join(target),
            Err(_) => break,
        }
    }
    let whole = fs::canonicalize(&path);
    whole.unwrap_or_else(
        |_| match (fs::canonicalize(folder(&path)), path.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            _ => path.clone(),
        },
    )
}

/// The folder that a path is in.
pub fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
