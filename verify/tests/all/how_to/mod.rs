//! The examples of docs/how-to/claim.md, compiled and run.

// As the page has them, where comments stand beside the lines.
#[rustfmt::skip]
mod at_a_point;
#[rustfmt::skip]
mod on_a_mesh;

use regge_verify::claims::Catalogue;
use regge_verify::stage::{mesh, point};
use regge_verify::{Options, run_catalogue};

const PAGE: &str = include_str!("../../../../docs/how-to/claim.md");

#[test]
fn the_page_has_the_code_that_is_compiled() {
    for code in [include_str!("at_a_point.rs"), include_str!("on_a_mesh.rs")] {
        let block = format!("```rust\n{code}```\n");
        assert!(PAGE.contains(&block), "the page lacks\n{block}");
    }
}

#[test]
fn the_examples_hold_and_catch_their_forgeries() {
    let mut all = Catalogue::new();
    point::add::<at_a_point::Laplacian, 3>(&mut all);
    mesh::add::<on_a_mesh::Volumes, 3>(&mut all);
    let report = run_catalogue(all, &Options::default(), &|_| ()).expect("no label is asked for");
    assert!(report.passed(), "{}", report.table());
    // Over floating point numbers, over the fields, proved, and on meshes.
    assert_eq!(report.claims.len(), 4);
}
