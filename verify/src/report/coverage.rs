//! How much of the paper is verified: its statements by their status.

use super::markdown::cell;
use crate::paper::{Statement, Status};
use std::fmt::Write;

/// The section of the index: how many statements have which status, before and now, and those that are not verified.
pub fn coverage(statements: &[Statement]) -> String {
    let computed = statements.iter().filter(|s| s.before != Status::Nothing);
    let mut text = format!(
        "\n## What of the paper is verified\n\nThe paper has {} statements that can be computed \
         ([statements.csv](statements.csv) has them one by one, with the claims that verify each; [labels.toml](labels.toml) \
         goes by its labels). Verified: by claims with independent sides, or measured and judged ([analysis.md](analysis.md)). Test only: a test or \
         a study computes it and judges nothing. Before: an audit of 24 November 2026, which counted the four statements of \
         the appendix on degrees of freedom, duality, the projector and the average as absent, though I28 and I29 had them.\n\n\
         | status | before | now |\n|---|---|---|\n",
        computed.count()
    );
    for status in Status::COMPUTED {
        let before = statements.iter().filter(|s| s.before == status).count();
        let now = statements.iter().filter(|s| s.status() == status).count();
        let _ = writeln!(text, "| {} | {before} | {now} |", status.name());
    }
    text += "\nNot verified:\n\n| no. | place | statement | status | what there is | what is missing |\n|---|---|---|---|---|---|\n";
    let open = |s: &&Statement| !matches!(s.status(), Status::Verified | Status::Nothing);
    for s in statements.iter().filter(open) {
        let there: Vec<&str> = s
            .homes
            .iter()
            .chain(&s.seen_in)
            .map(String::as_str)
            .collect();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            s.number,
            cell(&s.place),
            cell(&s.what),
            s.status().name(),
            there.join(", "),
            cell(&s.missing),
        );
    }
    text
}
