//! Every case of tests/oracle (computed by an unrelated code, see its README): the three sums of def:distcurv.

mod common;

use common::oracle::{Oracle, load_all};
use regge::functional::{Rules, distributional_curvature};
use regge::lagrange::Lagrange;

/// NGSolve differentiates by differences, which its README puts at 1e-9 to 1e-7 of an entry; a third code agrees to
/// 1e-9 of the largest entry.
const TOLERANCE: f64 = 1e-8;

fn compare<const N: usize>(oracle: &Oracle) {
    let mesh = oracle.mesh::<N>();
    let space = oracle.space(&mesh);
    let g = oracle.metric(&space);
    let hats = Lagrange::new(&mesh, 1);
    let sums = distributional_curvature::<f64, _, _>(&g, &hats, &Rules::new::<N>(20));
    let scale = oracle.curvature.largest();
    for (i, &vertex) in oracle.curvature.vertex.iter().enumerate() {
        let ours = [sums.element[vertex], sums.face[vertex], sums.hinge[vertex]];
        let theirs = [
            oracle.curvature.element[i],
            oracle.curvature.face[i],
            oracle.curvature.angle[i],
        ];
        for (ours, theirs) in ours.iter().zip(theirs) {
            assert!(
                (ours - theirs).abs() <= TOLERANCE * scale,
                "{}: vertex {vertex}: {ours} against {theirs}",
                oracle.name
            );
        }
    }
}

#[test]
fn three_sums_agree_with_every_oracle() {
    for oracle in load_all() {
        match oracle.dimension {
            2 => compare::<2>(&oracle),
            3 => compare::<3>(&oracle),
            n => panic!("no oracle of dimension {n}"),
        }
    }
}
