//! The claims of the analysis: a smoke run, and the committed pages.

use regge_analysis::claims::ALL;
use regge_analysis::report::one_line;
use regge_analysis::{Effort, run};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// docs/verification.
fn committed(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification");
    root.join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(committed(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Few levels, one run: every claim holds and every forgery is caught. All levels are those of `regge-verify --analysis`.
#[test]
fn a_quick_run_holds() {
    let effort = Effort::new(20_261_128, true);
    let report = run(&effort, &[], &|_, _| ()).expect("everything can be measured");
    // A07, A21, A23, A25, A34, A39 and A40 are left out: they need larger meshes.
    assert_eq!(report.claims.len() + 7, ALL.len());
    let table = report.table();
    assert!(report.failures().is_empty(), "{table}");
}

#[test]
fn labels_are_unique_and_in_order() {
    let labels: Vec<&str> = ALL.iter().map(|claim| claim.label).collect();
    assert!(labels.is_sorted());
    assert_eq!(labels.iter().collect::<BTreeSet<_>>().len(), labels.len());
}

/// `regge-verify --analysis --report docs/verification` has been run since a claim was last changed, and all was well.
#[test]
fn the_committed_pages_are_those_of_the_claims() {
    let index = read("analysis.md");
    assert!(index.contains(" 0 claims fail, 0 forgeries not caught"));
    for claim in ALL {
        let page = read(&format!("{}.md", claim.label));
        assert!(page.contains(&one_line(claim.statement)), "{}", claim.label);
        assert!(page.contains(claim.how), "{}", claim.label);
        assert!(index.contains(&format!("[{0}]({0}.md)", claim.label)));
        assert!(read(&format!("{}.svg", claim.label)).starts_with("<svg"));
    }
}
