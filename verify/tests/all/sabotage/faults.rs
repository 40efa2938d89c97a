//! Each number of `Formulas`, wrong: the claim that names the formula fails, and what does not use it goes on holding.

use super::{broken, complaints, report};
use regge_curvature::formulas::{Formulas, PAPER};
use regge_verify::claims::{catalogue, records};

/// A wrong number.
struct Fault {
    /// Which.
    field: &'static str,
    formulas: Formulas,
    /// A claim that fails, and what its page says of the formula.
    by: (&'static str, &'static str),
    /// Others that fail.
    broken: &'static [&'static str],
    /// Some that hold.
    sound: &'static [&'static str],
    /// N.
    dimension: usize,
}

/// `field: value, (claim, its words), [others that fail], [some that hold]`, when N = 3.
macro_rules! faults {
    ($($field:ident: $value:expr, $by:expr, $broken:expr, $sound:expr;)*) => {
        vec![$(Fault {
            field: stringify!($field),
            formulas: Formulas { $field: $value, ..PAPER },
            by: $by,
            broken: &$broken,
            sound: &$sound,
            dimension: 3,
        }),*]
    };
}

/// In the order of `Formulas`.
fn all() -> Vec<Fault> {
    let mut all = faults! {
        omega: 2, ("P02", r"\omega = \sqrt{\det g}"),
            ["D10", "D11", "T03", "T04"], ["D13", "M01", "M02", "M14", "P20"];
        scalar: -1, ("P03", r"(R\omega)"),
            ["D10", "D11", "M03"], ["M01", "M02", "M14", "P24"];
        einstein: 0, ("M11", r"\langle G,g\rangle = -\tfrac{N-2}{2}R"),
            ["M03", "M19", "P03"], ["D10", "M01", "M02", "M12", "P20"];
        reverse_trace_halves: 1, ("D02", r"\operatorname{Tr}\mathbb{S}\sigma = (1-N)"),
            ["D13", "I09", "M03", "P03", "P15", "P20"], ["D03", "M02", "M14", "P10"];
        normal_length: 2, ("D12", "g(n,n) = 1"),
            ["D03", "D04", "D11", "I01", "I02", "M01"], ["D02", "M02", "M14", "P03", "P24"];
        tangential: 0, ("D05", "tangential part of g⁻¹"),
            ["D03", "D04", "D06", "D11", "M01"], ["D12", "M02", "P03", "P07", "P24"];
        second_form: -1, ("D03", r"\mathrm{II}(X,Y) = g(\nabla_X n,Y)"),
            ["D04", "D11", "M01", "P13"], ["D12", "M02", "M14", "P22"];
        mean_curvature: -1, ("D03", r"H = \operatorname{Tr}\mathrm{II}"),
            ["D04", "D07", "D11", "M01", "P20"], ["M02", "M14", "P12", "P14"];
        trace_reversed: 0, ("D07", r"\overline{\mathrm{II}} = \mathrm{II} - Hg"),
            ["M01", "M11", "M19", "P19", "P20"], ["D03", "M02", "P18"];
        omega_f: 2, ("P02", r"\omega_F = \sqrt{\det g|_F}"),
            ["D11", "M04", "M17"], ["D13", "M02", "M14", "P20"];
        dihedral_sin: -1, ("D09", r"\theta_{ST}\in(0,\pi)"),
            ["D10", "D11", "I18", "M14", "P22"], ["M01", "P20"];
        dihedral_cos: -1, ("D09", r"\cos\theta_{ST} = -g(n^+,n^-)"),
            ["D10", "D11", "I20", "M12", "M14", "P24"], ["I18", "M01", "P20"];
        omega_s: 2, ("P02", r"\omega_S = \sqrt{\det g|_S}"),
            ["D11", "M04", "M12", "M14"], ["D09", "D13", "M01", "P24"];
        trace_on_s: -1, ("P02", r"\operatorname{Tr}(\sigma|_S)"),
            ["M02", "M09", "M11", "M12", "M19"], ["D09", "M01", "M14", "P24"];
        conormal: -1, ("D09", "conormals"),
            ["M02", "M04", "M13", "P23", "P24", "T01"], ["D10", "M12", "P22"];
        conormal_slope: -1, ("D09", "conormals"),
            ["M02", "M04", "M13", "P23", "P24"], ["D10", "M12", "P22"];
        faces: 1, ("D11", r"2\mathring{\sum_F}"),
            ["M01", "M03", "M19"], ["M02", "M14", "P20"];
        hinges: 1, ("D11", r"2\mathring{\sum_S}"),
            ["M02", "M03", "M14"], ["M01", "M12", "P24"];
        full_angle: 1, ("D10", r"\Theta_S=0"),
            ["D11", "M09", "M12", "M14"], ["D09", "M01", "M02"];
        boundary_angle: 2, ("M15", r"\Bigl(\pi-\sum_T\theta_{ST}\Bigr)"),
            [], ["D09", "D11", "M07", "M14"];
        b_cells: 2, ("T03", "the production b_h's cell term"),
            ["M04", "M17", "T04"], ["D10", "M01", "M03", "M12"];
        b_faces: 1, ("T04", r"- \sum_F\int_F\mathbb{S}\sigma(n,n)\nabla_n v"),
            ["M04", "M17"], ["D10", "M01", "M03", "M12"];
        b_on_boundary: false, ("T04", "boundary included"),
            ["M04", "M17"], ["D10", "M01", "M02", "M03"];
        a_cells: 2, ("M19", "the production a_h with σ = g"),
            ["M03"], ["D10", "M01", "M12", "M14"];
        a_faces: -1, ("M19", "the production a_h with σ = g"),
            ["M03"], ["M01", "M02", "M12", "M14"];
        a_hinges: 1, ("M12", r"-\mathring{\sum_S}\int_S\Theta_S\operatorname{Tr}(\sigma|_S)"),
            ["M02", "M03", "M09", "M19"], ["M01", "M14", "P24"];
    };
    // The theorem of Gauss and Bonnet is about surfaces.
    for fault in all.iter_mut().filter(|f| f.by.0 == "M15") {
        fault.dimension = 2;
    }
    all
}

/// The texts of a claim's page.
fn page(label: &str) -> String {
    let records = records();
    let record = records.iter().find(|r| r.label == label);
    let record = record.unwrap_or_else(|| panic!("no claim {label}"));
    let texts = [record.title, record.statement, record.sides];
    // Lines of a statement are broken anywhere.
    let all = texts.join(" ");
    all.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_fault_is_found_by_a_claim_that_names_it() {
    let mut wrong = Vec::new();
    for fault in all() {
        let (label, words) = fault.by;
        if !page(label).contains(words) {
            wrong.push(format!("{}: {label} does not say {words:?}", fault.field));
        }
        let failing = [&[label], fault.broken].concat();
        let only = [failing.as_slice(), fault.sound].concat();
        let found = report(catalogue(), fault.dimension, fault.formulas, &only);
        let of_fault = complaints(&broken(&found), &failing, fault.sound);
        wrong.extend(of_fault.iter().map(|c| format!("{}: {c}", fault.field)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A new number of `Formulas` needs a fault here.
#[test]
fn there_is_a_fault_for_every_formula() {
    let faults: Vec<&str> = all().iter().map(|f| f.field).collect();
    let text = format!("{PAPER:?}");
    let fields: Vec<&str> = (text.split([' ', '{', ','].as_slice()))
        .filter_map(|word| word.strip_suffix(':'))
        .collect();
    assert_eq!(faults, fields);
    assert!(faults.len() >= 20);
}
