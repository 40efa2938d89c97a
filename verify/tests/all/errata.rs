//! The errata are what the program computes. `REGGE_BLESS=1 cargo test -p regge-verify errata` writes the page.

use regge_verify::errata::{conormal, page, scaling};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/errata.md");

#[test]
fn the_printed_conormal_negates_the_second_variation() {
    let (second, printed) = conormal();
    // Rounding of sums of 10³ terms of size 1.
    assert!((second + printed).abs() < 1e-11 * second.abs().max(1.0));
    assert!(second.abs() > 1e-2, "it must matter: {second}");
}

#[test]
fn scaling2_has_no_constant() {
    let quotient = |k: f64| {
        let (value, norm) = scaling(k).expect("a triangle has coordinates");
        assert!(
            (value - 1.0).abs() < 1e-14,
            "the integral over the edge is 1"
        );
        value / norm
    };
    // It grows like √(2k).
    assert!((quotient(1e4) / 2e4f64.sqrt() - 1.0).abs() < 1e-3);
}

#[test]
fn the_page_is_up_to_date() {
    let now = page().expect("all numbers can be computed");
    if std::env::var_os("REGGE_BLESS").is_some() {
        std::fs::write(PAGE, &now).expect("the page can be written");
    }
    let committed = std::fs::read_to_string(PAGE).expect("the committed page");
    assert_eq!(committed, now, "REGGE_BLESS=1 writes the page anew");
}
