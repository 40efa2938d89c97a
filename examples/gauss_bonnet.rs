//! Gauss and Bonnet with a boundary, and the curvature as a function: R_h, its L² projection.
//!
//! A piece of the unit sphere in the stereographic chart, R = 2.
//!
//! `cargo run --release -p regge-examples --bin gauss_bonnet`

use regge_curvature::functional::boundary_curvature;
use regge_curvature::project::{Projection, Tested};
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, distributional_curvature,
};
use std::f64::consts::PI;

fn main() -> Result<(), regge_curvature::Error> {
    println!("side   inside      boundary    sum - 4 pi   largest |R_h - 2| in the inner half");
    for side in [4, 8, 16, 32] {
        let mesh = Mesh::<2>::cube(side)?;
        let space = ReggeSpace::new(&mesh, 2);
        let sphere = Smooth::new(&mesh, Metric::Sphere)?;
        let g = Interpolant::canonical().apply(&space, &sphere)?;
        let (test, rules) = (Lagrange::new(&mesh, 2), Rules::on(&mesh, 24));
        let inside = distributional_curvature(&g, &test, &rules).total();
        let boundary = boundary_curvature(&g, &test, &rules).total();
        let [a, b]: [f64; 2] = [&inside, &boundary].map(|list| list.iter().sum());
        // With v = 0 on the boundary, as in the paper: there R_h is 0, and a few cells away it is the curvature.
        let projection = Projection::new(&g, &test, Tested::Interior, &rules.cells)?;
        let r_h = projection.apply(&inside)?;
        let near = |v: &usize| mesh.points().is_some_and(|p| p[*v].amax() < 0.5);
        let vertices = (0..mesh.count(0)).filter(near);
        let error = vertices.map(|v| (r_h[v] - 2.0).abs()).fold(0.0, f64::max);
        println!(
            "{side:4}   {a:.6}    {b:.6}    {:10.1e}   {error:.2e}",
            a + b - 4.0 * PI
        );
    }
    Ok(())
}
