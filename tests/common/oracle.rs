//! The reference cases of tests/oracle.

// The catalogue reads them too, and it is a package that must stand alone: one reader, that is there.
#[path = "../../verify/catalogue/src/oracle/read.rs"]
mod read;

pub use read::Oracle;

/// All cases, by name.
pub fn load_all() -> Vec<Oracle> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/oracle");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder of oracles")
        .map(|e| e.expect("an entry").path())
        .filter(|p| p.extension().is_some_and(|e| e == "json"))
        .collect();
    files.sort();
    assert_eq!(files.len(), 10, "ten cases were copied");
    let read = |p| std::fs::read_to_string(p).expect("a readable case");
    files
        .iter()
        .map(|p| serde_json::from_str(&read(p)).expect("a case"))
        .collect()
}
