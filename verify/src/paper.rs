//! Floor 0. What the paper states and where each statement is verified: docs/verification/labels.toml, by the labels of the
//! paper's source, and docs/verification/statements.csv, statement by statement.

use std::collections::BTreeMap;

const LABELS: &str = include_str!("../../docs/verification/labels.toml");
const STATEMENTS: &str = include_str!("../../docs/verification/statements.csv");

/// A `\label` of the paper's source.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Label {
    /// claim, definition, bound, rate, remark, figure, table or section.
    pub kind: String,
    /// The claims that verify it, by their labels.
    pub home: Vec<String>,
    /// Why there is none.
    pub reason: Option<String>,
}

/// The labels by name. The file is simple TOML: a table for each, one key a line.
///
/// # Panics
/// If the file is not, which a test finds out.
pub fn labels() -> BTreeMap<String, Label> {
    let (mut all, mut current) = (BTreeMap::new(), String::new());
    let lines = LABELS
        .lines()
        .filter(|l| !l.is_empty() && !l.starts_with('#'));
    for line in lines {
        if let Some(name) = line.strip_prefix("[\"").and_then(|l| l.strip_suffix("\"]")) {
            current = name.to_owned();
            let before = all.insert(current.clone(), Label::default());
            assert!(before.is_none(), "{name} is there twice");
            continue;
        }
        let key = line.split_once(" = ");
        let (key, value) = key.unwrap_or_else(|| panic!("not a key: {line}"));
        let mut values = value.split('"').skip(1).step_by(2).map(str::to_owned);
        let label: &mut Label = all.get_mut(&current).expect("a key belongs to a label");
        match key {
            "kind" => label.kind = values.next().unwrap_or_default(),
            "home" => label.home = values.collect(),
            "reason" => label.reason = values.next(),
            other => panic!("{current}: no key is called {other}"),
        }
    }
    all
}

/// How far a statement is verified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// By a claim with independent sides, or measured and judged.
    Verified,
    /// A part of it is.
    Partial,
    /// A test or a study computes it, without a verdict.
    TestOnly,
    /// Nothing computes it.
    Absent,
    /// There is nothing to compute.
    Nothing,
}

impl Status {
    /// Those that statements have which can be computed.
    pub const COMPUTED: [Self; 4] = [Self::Verified, Self::TestOnly, Self::Partial, Self::Absent];

    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Verified => "verified",
            Self::TestOnly => "test only",
            Self::Partial => "partial",
            Self::Absent => "absent",
            Self::Nothing => "nothing to compute",
        }
    }
}

/// A statement of the paper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// Its number, in the order of the paper.
    pub number: usize,
    /// Section and label.
    pub place: String,
    /// What it says, in a few words.
    pub what: String,
    /// What an audit of 24 November 2026 found.
    pub before: Status,
    /// The claims that verify it.
    pub homes: Vec<String>,
    /// Files with tests or figures of it that judge nothing.
    pub seen_in: Vec<String>,
    /// What of it is not verified.
    pub missing: String,
}

impl Statement {
    /// How far it is verified, by what is known of it.
    pub fn status(&self) -> Status {
        let (home, seen) = (!self.homes.is_empty(), !self.seen_in.is_empty());
        match (home, seen, self.missing.is_empty()) {
            _ if self.before == Status::Nothing => Status::Nothing,
            (true, _, true) => Status::Verified,
            (true, _, false) | (false, true, false) => Status::Partial,
            (false, true, true) => Status::TestOnly,
            (false, false, _) => Status::Absent,
        }
    }
}

/// All statements, in the order of the paper.
///
/// # Panics
/// If a line of the file has not seven fields, which a test finds out.
pub fn statements() -> Vec<Statement> {
    STATEMENTS.lines().skip(1).map(statement).collect()
}

fn statement(line: &str) -> Statement {
    let fields: Vec<&str> = line.split(';').collect();
    let [number, place, what, before, homes, seen_in, missing] = fields[..] else {
        panic!("not seven fields: {line}");
    };
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect();
    Statement {
        number: number.parse().expect("a statement has a number"),
        place: place.to_owned(),
        what: what.to_owned(),
        before: match before {
            "V" => Status::Verified,
            "P" => Status::Partial,
            "T" => Status::TestOnly,
            "A" => Status::Absent,
            "N" => Status::Nothing,
            other => panic!("no status is called {other}"),
        },
        homes: words(homes),
        seen_in: words(seen_in),
        missing: missing.to_owned(),
    }
}
