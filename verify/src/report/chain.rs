//! How the claims that are no identities at a point follow from those that are, and what of analysis is needed beside.

use super::data::Report;
use super::summary::Row;
use std::fmt::Write;

/// One step of the chain.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// What follows.
    pub claim: &'static str,
    /// From which claims.
    pub from: &'static [&'static str],
    /// And from what else, which is no claim.
    pub analysis: &'static str,
}

const fn link(claim: &'static str, from: &'static [&'static str], analysis: &'static str) -> Link {
    Link {
        claim,
        from,
        analysis,
    }
}

/// In an order in which each follows from what stands before or holds at a point.
pub const CHAIN: [Link; 21] = [
    link(
        "D10",
        &["D08", "D09"],
        "the angles around a hinge of a smooth metric add up to 2π (to π at a smooth boundary point)",
    ),
    link(
        "T01",
        &["D03", "D06"],
        "the divergence theorem for tangential fields on F, which is a simplex with a smooth metric",
    ),
    link(
        "T03",
        &["D01", "D12"],
        "Leibniz's rule; the divergence theorem on T",
    ),
    link(
        "T04",
        &["T01", "T02", "T03", "D05", "D09"],
        "nothing: the face terms are split into tangential and normal parts and summed",
    ),
    link(
        "M04",
        &["T04", "D13"],
        "a sum over cells; v and ∇v of a test function vanish on ∂Ω where the paper says so",
    ),
    link(
        "M17",
        &["P03", "P20", "P24", "P02", "T04"],
        "differentiation under integrals over fixed simplices",
    ),
    link(
        "P04",
        &["P03", "T03"],
        "differentiation under the integral; v has compact support",
    ),
    link(
        "M01",
        &["P20"],
        "differentiation under integrals over fixed faces; a sum over both sides",
    ),
    link(
        "M02",
        &["P24", "P02"],
        "differentiation under integrals over fixed hinges; a sum over the cells around each",
    ),
    link(
        "M03",
        &["P03", "M01", "M02"],
        "differentiation under integrals over fixed cells",
    ),
    link(
        "M05",
        &["M03", "M04", "P19"],
        "nothing: the terms with div div 𝕊σ cancel",
    ),
    link(
        "M10",
        &["M05", "D14"],
        "nothing: the same terms, named differently",
    ),
    link(
        "M06",
        &["M05"],
        "the fundamental theorem of calculus along g + t(g_h − g), all of whose metrics are positive definite",
    ),
    link(
        "M08",
        &["M05"],
        "v = 1 is a test function, since Ω is closed",
    ),
    link(
        "M12",
        &["P02", "D03"],
        "derivatives of a constant metric vanish",
    ),
    link(
        "M09",
        &["M08", "M12"],
        "nothing: R and H vanish where the metric is constant on cells",
    ),
    link(
        "M13",
        &["M02", "M09", "M12"],
        "one more derivative in t, at the flat metric, where all Θ_S vanish",
    ),
    link(
        "M14",
        &["D11"],
        "R and H vanish where the metric is constant on cells",
    ),
    link("M19", &["M11"], "a sum over cells, faces and hinges"),
    link(
        "M15",
        &["M07", "M08"],
        "metrics are convex, hence connected; the theorem for one metric of each surface",
    ),
    link(
        "M18",
        &["M08"],
        "a diffeomorphism of every cell that maps all subsimplices to themselves changes no integral",
    ),
];

/// The page.
pub(super) fn chain(report: &Report) -> String {
    let rows = report.rows();
    let mut text = "# From points to meshes\n\nWhat is stated at a point is proved or tested at points. What is stated of integrals \
        follows from that, and from what the last column says; every claim here is checked on meshes for itself, too.\n\n\
        | claim | its own verdict | follows from | and from |\n|---|---|---|---|\n"
        .to_owned();
    for link in CHAIN {
        let from: Vec<String> = link.from.iter().map(|l| cited(&rows, l)).collect();
        let _ = writeln!(
            text,
            "| [{0}]({0}.md) | {1} | {2} | {3} |",
            link.claim,
            standing(&rows, link.claim),
            from.join(", "),
            link.analysis
        );
    }
    text
}

fn standing(rows: &[Row<'_>], label: &str) -> String {
    let row = rows.iter().find(|r| r.label == label);
    row.map_or("not run".to_owned(), Row::standing)
}

/// A claim with its verdict, unless it is in the chain itself.
fn cited(rows: &[Row<'_>], label: &str) -> String {
    if CHAIN.iter().any(|l| l.claim == label) {
        return format!("{label} (above)");
    }
    format!("{label} ({})", standing(rows, label))
}
