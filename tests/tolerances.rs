//! Every comparison by approx says its tolerance, as a number: with bare dual numbers, whose derivatives it would overlook,
//! that does not compile (`regge_curvature::parts`).

use std::path::{Path, PathBuf};

/// The macros that compare; `assert_` may stand before.
const NAMES: [&str; 4] = ["abs_diff_eq", "abs_diff_ne", "relative_eq", "relative_ne"];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let hidden = |name: &std::ffi::OsStr| name.as_encoded_bytes().starts_with(b".");
        if path.is_dir() && !path.ends_with("target") && !path.file_name().is_some_and(hidden) {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// What stands in the parentheses at the start of a text.
fn arguments(text: &str) -> &str {
    let mut depth = 0;
    let end = text.find(|c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0
    });
    &text[..end.expect("parentheses are closed")]
}

#[test]
fn comparisons_say_their_tolerance() {
    let mut files = Vec::new();
    sources(Path::new(env!("CARGO_MANIFEST_DIR")), &mut files);
    let mut seen = 0;
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a source");
        for name in NAMES {
            let call = format!("{name}!");
            for (start, _) in text.match_indices(&call) {
                let text = &text[start + call.len()..];
                if !text.starts_with('(') {
                    continue;
                }
                let given = arguments(text);
                let said = given.contains("epsilon = ") || given.contains("max_relative = ");
                assert!(said, "{}: {call}{given})", file.display());
                seen += 1;
            }
        }
    }
    assert!(seen > 10, "{seen}");
}
