//! The whole report as one HTML file that needs no network: formulas in MathML, pictures in SVG.

use super::chart::strips;
use super::data::Report;
use super::formula::{escape, mathml};
use super::page::{SHARED, allowed, names, residual};
use super::summary::{Row, margin};
use crate::harness::{Entry, Record, Verdict};
use std::fmt::Write;

const STYLE: &str = "\
body{font:16px/1.5 Georgia,serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}\
h1,h2{font-weight:normal}h2{border-top:1px solid #ccc;padding-top:1.5rem;margin-top:2.5rem}\
table{border-collapse:collapse;font:13px/1.4 system-ui,sans-serif;margin:1rem 0}\
td,th{padding:.15rem .7rem .15rem 0;text-align:left;vertical-align:top}th{border-bottom:1px solid #999}\
math{font-size:1.15em;margin:1rem 0;padding:.3rem 0;overflow-x:auto;overflow-y:hidden}code{font-size:.9em}.fail{color:#b00;font-weight:bold}\
svg text{font:11px system-ui,sans-serif;fill:#555}svg .tolerance{stroke:#888;stroke-dasharray:3 2}\
svg .forgery{stroke:#b55;stroke-width:1.5;opacity:.6}svg circle{fill:#26a}details{margin:.5rem 0}";

/// The report.
pub fn document(report: &Report, records: &[&Record]) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <title>regge: verification report</title><style>{STYLE}</style></head><body>\n\
         <h1>Verification report</h1>\n<p>regge {}. {}</p>\n<p>{SHARED}</p>\n\
         <p>In the pictures a dot is the worst residual of a claim and a stroke is a forgery, both over the \
         tolerance, which is the dashed line at 1. In the lists of forgeries ×m is the weakest residual over the \
         tolerance; those with few Gauss points in t show how fast the integral along a path converges.</p>\n",
        escape(&report.version),
        escape(&report.conclusion()),
    );
    let rows = report.rows();
    contents(&mut html, &rows, records);
    for row in &rows {
        if let Some(record) = records.iter().find(|r| r.label == row.label) {
            section(&mut html, row, record);
        }
    }
    html + "</body></html>\n"
}

fn contents(html: &mut String, rows: &[Row<'_>], records: &[&Record]) {
    html.push_str("<table><tr><th>claim<th><th>N<th>by<th>cases<th>verdict</tr>\n");
    for row in rows {
        let title = records
            .iter()
            .find(|r| r.label == row.label)
            .map_or("", |r| r.title);
        let _ = writeln!(
            html,
            "<tr><td><a href=\"#{0}\">{0}</a><td>{1}<td>{2}<td>{3}<td>{4}<td>{5}</tr>",
            row.label,
            escape(title),
            row.dimensions_listed(),
            row.methods().join(", "),
            row.cases(),
            standing(row)
        );
    }
    html.push_str("</table>\n");
}

fn standing(row: &Row<'_>) -> String {
    match row.verdict() {
        Verdict::Pass => escape(&row.standing()),
        fails => verdict(fails).to_owned(),
    }
}

fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "holds",
        Verdict::Fail => "<span class=\"fail\">fails</span>",
    }
}

fn section(html: &mut String, row: &Row<'_>, record: &Record) {
    let _ = write!(
        html,
        "<h2 id=\"{0}\">{0}. {1}</h2>\n{2}\n<p>{3}</p>\n",
        record.label,
        escape(record.title),
        mathml(record.statement),
        escape(record.sides),
    );
    for excuse in row.excuses() {
        let _ = writeln!(html, "<p>{}</p>", escape(&excuse));
    }
    if !record.paper.is_empty() {
        let _ = writeln!(
            html,
            "<p>In the paper: <code>{}</code></p>",
            record.paper.join("</code>, <code>")
        );
    }
    html.push_str("<table><tr><th>N<th>by<th>cases<th>worst residual<th>allowed<th>verdict</tr>\n");
    for e in &row.entries {
        let _ = writeln!(
            html,
            "<tr><td>{}<td>{}, {}<td>{}<td>{}<td>{}<td>{}</tr>",
            e.dimension,
            e.method,
            e.scalar,
            e.cases,
            residual(e),
            escape(&allowed(e)),
            verdict(e.verdict)
        );
    }
    html.push_str("</table>\n");
    html.push_str(&strips(row));
    forgeries(html, row);
}

fn forgeries(html: &mut String, row: &Row<'_>) {
    let names = names(row);
    let _ = writeln!(
        html,
        "<details><summary>{} forgeries</summary><ul>",
        names.len()
    );
    for name in names {
        let missed = |e: &&Entry| e.forgeries.iter().any(|f| f.name == name && !f.caught);
        let reason = row.entries.iter().find_map(|e| {
            let v = e.vacuous.iter().find(|v| v.name == name)?;
            Some(format!(
                " (changes nothing when N = {}: {})",
                e.dimension,
                escape(&v.reason)
            ))
        });
        let fails = row.entries.iter().copied().any(|e| missed(&e));
        let mark = if fails {
            " <span class=\"fail\">not caught</span>"
        } else {
            ""
        };
        let seen = row.weakest_of(&name);
        let seen = seen.map_or(String::new(), |m| format!(", {}", margin(Some(m))));
        let _ = writeln!(
            html,
            "<li>{}{seen}{mark}{}</li>",
            escape(&name),
            reason.unwrap_or_default()
        );
    }
    html.push_str("</ul></details>\n");
}
