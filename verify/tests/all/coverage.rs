//! Every claim is checked enough, and the committed pages are those of the catalogue.

use regge_verify::claims::{catalogue, records};
use regge_verify::harness::{Budget, Check, ENOUGH, Excuses, Kind, Method, Shape};
use regge_verify::paper::statements;
use regge_verify::report::{CHAIN, coverage};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The checks of a claim, and its excuses.
fn checks_of<'a>(all: &'a [Check], label: &str) -> (Vec<&'a Check>, Excuses) {
    let of: Vec<&Check> = all.iter().filter(|c| c.record.label == label).collect();
    let excuses = Excuses {
        one_method: of.iter().find_map(|c| c.excuses.one_method),
        few_cases: of.iter().find_map(|c| c.excuses.few_cases),
    };
    (of, excuses)
}

#[test]
fn every_claim_has_two_methods_or_a_reason() {
    let all = catalogue();
    for record in records() {
        let (checks, excuses) = checks_of(&all, record.label);
        // A proof and a test over prime fields have the program in common.
        let others = checks.iter().filter(|c| c.method != Method::Proof);
        let methods: BTreeSet<&str> = others.map(|c| c.method.name()).collect();
        assert_eq!(
            methods.len() == 1,
            excuses.one_method.is_some(),
            "{}: {methods:?}, {excuses:?}",
            record.label
        );
    }
}

#[test]
fn every_claim_has_enough_instances_or_a_reason() {
    let (all, budget) = (catalogue(), Budget::full(0));
    for record in records() {
        let (checks, excuses) = checks_of(&all, record.label);
        let by = |method: &str| -> usize {
            let of = checks.iter().filter(|c| c.method.name() == method);
            of.map(|c| c.cases(&budget)).sum()
        };
        let most = ["AD", "exact", "oracle", "homotopy"]
            .map(by)
            .into_iter()
            .max();
        assert_eq!(
            most < Some(ENOUGH),
            excuses.few_cases.is_some(),
            "{}: {most:?} instances, {excuses:?}",
            record.label
        );
    }
}

/// A claim without cases would hold.
#[test]
fn every_check_has_cases() {
    for check in catalogue() {
        for budget in [Budget::full(0), Budget::quick(0)] {
            let (label, n) = (check.record.label, check.dimension);
            assert!(check.cases(&budget) > 0, "{label}, N = {n}: {budget:?}");
        }
    }
}

/// What is stated of integrals hangs on something: each link on claims of the catalogue that hold at a point or stand above it,
/// and every claim about integrals is a link or is known to be none.
#[test]
fn the_chain_is_closed() {
    // Numbers of other codes, the numbering of coefficients, interpolants, and what is an identity at every point of a mesh.
    const NO_LINKS: [&str; 9] = [
        "D11", "D14", "I29", "M07", "M16", "M20", "N03", "N04", "N05",
    ];
    let all = catalogue();
    let on_meshes = |label: &str| {
        let mut checks = all.iter().filter(|c| c.record.label == label);
        checks.any(|c| matches!(c.kind, Kind::Mesh(_) | Kind::Integrals(_)))
    };
    for (place, link) in CHAIN.iter().enumerate() {
        assert!(!link.from.is_empty(), "{}", link.claim);
        for from in link.from {
            let above = CHAIN[..place].iter().any(|l| l.claim == *from);
            let known = all.iter().any(|c| c.record.label == *from);
            let elsewhere = !on_meshes(from) || NO_LINKS.contains(from);
            assert!(known && (above || elsewhere), "{} from {from}", link.claim);
        }
    }
    for record in records().iter().filter(|r| on_meshes(r.label)) {
        let linked = CHAIN.iter().any(|l| l.claim == record.label);
        let none = NO_LINKS.contains(&record.label);
        assert!(
            linked != none,
            "{}: in the chain, or no link?",
            record.label
        );
    }
}

/// docs/verification.
fn committed(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs/verification")
        .join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(committed(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// The index says how much of the paper is verified. `REGGE_BLESS=1 cargo test -p regge-verify coverage` writes it anew.
#[test]
fn the_index_counts_the_statements() {
    let (index, now) = (read("index.md"), coverage(&statements()));
    if std::env::var_os("REGGE_BLESS").is_some() {
        let title = now.trim_start().lines().next().expect("a title");
        let before = index.split(title).next().unwrap_or_default();
        let page = format!("{}\n{now}", before.trim_end());
        std::fs::write(committed("index.md"), page).expect("the index can be written");
    }
    assert!(read("index.md").ends_with(&now), "the index is out of date");
}

/// `regge-verify --report docs/verification` has been run since a claim was last changed.
#[test]
fn the_committed_pages_are_those_of_the_catalogue() {
    let report: Value = serde_json::from_str(&read("report.json")).expect("JSON");
    let entries = report["claims"].as_array().expect("a list");
    assert!(entries.iter().all(|e| e["verdict"] == "pass"));
    let key = |e: &Value| {
        let text = |k: &str| e[k].as_str().unwrap_or_default().to_owned();
        (text("label"), e["dimension"].as_u64(), text("method"))
    };
    let there: BTreeSet<_> = entries.iter().map(key).collect();
    let wanted = catalogue();
    let wanted: BTreeSet<_> = (wanted.iter())
        .map(|c| {
            let (label, method) = (c.record.label.to_owned(), c.method.name().to_owned());
            (label, Some(c.dimension as u64), method)
        })
        .collect();
    assert_eq!(there, wanted);
    let html = read("index.html");
    for record in records() {
        let page = read(&format!("{}.md", record.label));
        let statement: Vec<&str> = record.statement.split_whitespace().collect();
        assert!(page.contains(&statement.join(" ")), "{}", record.label);
        assert!(page.contains(record.sides), "{}", record.label);
        assert!(html.contains(&format!("id=\"{}\"", record.label)));
    }
}

/// Delaunay's mesh has interior hinges of other valences than Alfeld's, which are three, and cells that are not flat.
#[test]
fn hinges_have_other_valences_than_three() {
    let mesh = Shape::Delaunay(1).mesh::<3>();
    let valences: BTreeSet<usize> = (mesh.interior_hinges())
        .map(|hinge| mesh.star(1, hinge).count())
        .collect();
    assert!(valences.len() > 1 && !valences.contains(&3), "{valences:?}");
    let shape = regge_analysis::pieces::shape_regularity(&mesh);
    assert!(shape < 30.0, "h/ρ = {shape}");
}
