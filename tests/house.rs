//! The floor plan holds: no module imports from above, no file imports, by way of however many others, a file that imports it, in
//! any package.
//!
//! The plan is the table in the documentation of a package's `lib.rs`; this test has none of its own. Imports are read from the
//! text: `use` lines and paths that begin with `crate::` or `super::`. A file and the `mod.rs` of its own folder may name each
//! other: a folder's `mod.rs` is its front.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const PACKAGES: [&str; 8] = [
    "src",
    "cli/src",
    "cli/readers/src",
    "verify/src",
    "verify/analysis/src",
    "verify/study/src",
    "verify/oracle/src",
    "python/src",
];

/// A module by its path from the root of the package; the root itself is empty.
type Module = Vec<String>;

/// The source files of a package, by module, with their text, comments and tests left out.
fn sources(root: &Path) -> BTreeMap<Module, String> {
    fn collect(root: &Path, folder: &Path, all: &mut BTreeMap<Module, String>) {
        for entry in fs::read_dir(folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                collect(root, &path, all);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = fs::read_to_string(&path).expect("a readable source");
                let code = text
                    .lines()
                    .map(|line| line.split("//").next().unwrap_or(""));
                all.insert(module(root, &path), code.collect::<Vec<_>>().join("\n"));
            }
        }
    }
    let mut all = BTreeMap::new();
    collect(root, root, &mut all);
    all
}

fn module(root: &Path, file: &Path) -> Module {
    let inside = file.strip_prefix(root).expect("a file of the package");
    let mut parts: Module = inside
        .with_extension("")
        .iter()
        .map(|p| p.to_string_lossy().into_owned())
        .collect();
    let is_front = |name: &String| ["mod", "lib", "main"].contains(&name.as_str());
    parts.pop_if(|name| is_front(name));
    parts
}

/// What a file imports from its own package, as paths from the root.
fn imports(module: &Module, is_front: bool, code: &str) -> Vec<Module> {
    let mut all = Vec::new();
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let before = code[..at].chars().next_back();
            if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':') {
                continue;
            }
            let mut base = if start == "crate::" {
                Vec::new()
            } else {
                // In a `mod.rs`, super is the folder above its own; elsewhere the folder that the file is in.
                let up = module.len().saturating_sub(1);
                module[..up].to_vec()
            };
            let mut rest = &code[at + start.len()..];
            while let Some(further) = rest.strip_prefix("super::") {
                base.pop();
                rest = further;
            }
            expand(&base, rest, &mut all);
        }
    }
    // A front names its own children without a prefix.
    if is_front {
        for line in code.lines().filter_map(|l| l.trim().strip_prefix("use ")) {
            if !line.starts_with("crate::") && !line.starts_with("super::") {
                expand(module, line, &mut all);
            }
        }
    }
    all
}

/// The paths of a use tree: `a::{b, c::d}` below a base.
fn expand(base: &Module, tree: &str, all: &mut Vec<Module>) {
    let end = tree.find(|c: char| !c.is_alphanumeric() && c != '_');
    let (name, rest) = tree.split_at(end.unwrap_or(tree.len()));
    if let Some(group) = tree.strip_prefix('{') {
        let (mut depth, mut start) = (0, 0);
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => {
                    expand(base, group[start..i].trim(), all);
                    return;
                }
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    expand(base, group[start..i].trim(), all);
                    start = i + 1;
                }
                _ => {}
            }
        }
        return;
    }
    if name.is_empty() {
        return;
    }
    let mut path = base.clone();
    path.push(name.to_owned());
    match rest.strip_prefix("::") {
        Some(further) => expand(&path, further, all),
        None => all.push(path),
    }
}

/// Who imports whom, by files that exist.
fn arrows(root: &Path) -> BTreeSet<(Module, Module)> {
    let sources = sources(root);
    let mut arrows = BTreeSet::new();
    for (from, code) in &sources {
        let is_front = root.join(from.iter().collect::<PathBuf>()).is_dir();
        for mut path in imports(from, is_front, code) {
            while !path.is_empty() && !sources.contains_key(&path) {
                path.pop();
            }
            if !path.is_empty() && path != *from {
                arrows.insert((from.clone(), path));
            }
        }
    }
    arrows
}

/// The modules of the table in a package's documentation, with their floor and their place on it.
fn plan(root: &Path) -> BTreeMap<String, (usize, usize)> {
    let text = fs::read_to_string(root.join("lib.rs")).unwrap_or_default();
    let mut plan = BTreeMap::new();
    for line in text.lines().filter_map(|l| l.strip_prefix("//! | ")) {
        let mut cells = line.split(" | ");
        let Some(floor) = cells.next().and_then(|c| c.trim().parse::<usize>().ok()) else {
            continue;
        };
        let names = cells
            .next()
            .unwrap_or_default()
            .split('`')
            .skip(1)
            .step_by(2);
        for (place, name) in names.enumerate() {
            let name = name.trim_start_matches("mod@").trim_end_matches("()");
            plan.insert(name.to_owned(), (floor, place));
        }
    }
    plan
}

/// The folder of a package, from the root of the repository.
fn root(package: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(package)
}

/// The first way from a file back to itself, if there is one. A file and the front of a folder that it is in may name each other.
fn circle(arrows: &BTreeSet<(Module, Module)>) -> Option<Vec<Module>> {
    fn search(
        arrows: &BTreeSet<(Module, Module)>,
        way: &mut Vec<Module>,
        done: &mut BTreeSet<Module>,
    ) -> Option<Vec<Module>> {
        let from = way.last().expect("a way begins somewhere").clone();
        for (_, to) in arrows.iter().filter(|(f, _)| *f == from) {
            if let Some(start) = way.iter().position(|m| m == to) {
                return Some(way[start..].to_vec());
            }
            if !done.contains(to) {
                way.push(to.clone());
                let found = search(arrows, way, done);
                way.pop();
                if found.is_some() {
                    return found;
                }
            }
        }
        done.insert(from);
        None
    }
    let foreign = |(from, to): &&(Module, Module)| !from.starts_with(to) && !to.starts_with(from);
    let arrows: BTreeSet<_> = arrows.iter().filter(foreign).cloned().collect();
    let mut done = BTreeSet::new();
    let starts: BTreeSet<&Module> = arrows.iter().map(|(from, _)| from).collect();
    starts
        .into_iter()
        .find_map(|start| search(&arrows, &mut vec![start.clone()], &mut done))
}

#[test]
fn no_imports_go_around_in_a_circle() {
    for package in PACKAGES {
        let arrows = arrows(&root(package));
        assert!(
            !arrows.is_empty() || package.contains("oracle"),
            "{package}: no imports seen"
        );
        let names =
            |way: Vec<Module>| -> Vec<String> { way.iter().map(|m| m.join("::")).collect() };
        let found = circle(&arrows).map(names);
        assert!(found.is_none(), "{package}: a circle of {found:?}");
    }
}

#[test]
fn no_module_imports_from_above() {
    for package in ["src", "verify/src", "verify/analysis/src", "python/src"] {
        let root = root(package);
        let plan = plan(&root);
        let floor = |module: &Module| {
            let top = &module[0];
            let known = plan.get(top);
            *known.unwrap_or_else(|| panic!("{package}: {top} is missing in the floor plan"))
        };
        let front = |m: &Module| m.is_empty() || ["main", "command"].contains(&m[0].as_str());
        for (from, to) in arrows(&root) {
            if front(&from) || from[0] == to[0] {
                continue;
            }
            assert!(
                floor(&to) < floor(&from),
                "{package}: {} imports {}, which stands above it",
                from.join("::"),
                to.join("::")
            );
        }
    }
}

/// The reader itself, on a house that is wrong in both ways.
#[test]
fn circles_and_upward_imports_are_seen() {
    let module = |path: &str| -> Module { path.split("::").map(str::to_owned).collect() };
    let code = "use super::b::X;\nuse crate::{d::{e, f::Y}, g};\nlet z = crate::h::z();";
    let seen = imports(&module("a::c"), false, code);
    for path in ["a::b::X", "d::e", "d::f::Y", "g", "h::z"] {
        assert!(
            seen.contains(&module(path)),
            "{path} is missing in {seen:?}"
        );
    }
    let arrow = |a: &str, b: &str| (module(a), module(b));
    let mut arrows = BTreeSet::from([arrow("a::x", "b"), arrow("b", "c"), arrow("a", "a::x")]);
    assert_eq!(circle(&arrows), None);
    arrows.insert(arrow("c", "a::x"));
    assert_eq!(circle(&arrows).map(|way| way.len()), Some(3));
}
