//! The curvature differentiated in the metric, by the same code at dual numbers.
//!
//! d/dt ⟨(Rω)_dist(g + tσ), v⟩ = b_h(g; σ, v) − a_h(g; σ, v) (Paper: thm:distcurvdot): the left side by automatic
//! differentiation, the right side by the paper's formulas.
//!
//! `cargo run --release -p regge-examples --bin derivative`

use num_dual::Dual64;
use regge_curvature::field::Combination;
use regge_curvature::functional::{a_h, b_h};
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, distributional_curvature,
};

fn main() -> Result<(), regge_curvature::Error> {
    let mesh = Mesh::<3>::cube(2)?.perturbed(0.1, 1)?;
    let space = ReggeSpace::new(&mesh, 1);
    let interpolate = |metric| {
        Interpolant::canonical()
            .with_order(8)
            .apply(&space, &Smooth::new(&mesh, metric)?)
    };
    let (g, sigma) = (
        interpolate(Metric::Trig)?,
        interpolate(Metric::GraphQuartic)?,
    );
    let test = Lagrange::new(&mesh, 2);
    println!("order      d/dt by duals            b_h - a_h   difference");
    for order in [4, 8, 12, 16] {
        let rules = Rules::on(&mesh, order);
        let moving = Combination::new(Dual64::from(1.0), &g, Dual64::new(0.0, 1.0), &sigma);
        let curvature = distributional_curvature(&moving, &test, &rules).total();
        let (b, a) = (
            b_h(&g, &sigma, &test, &rules).total(),
            a_h(&g, &sigma, &test, &rules).total(),
        );
        // The largest of the test functions that vanish on the boundary, as the theorem asks.
        let inner = (0..test.len()).filter(|&dof| test.vanishes_on_boundary(dof));
        let size = |dof: usize| curvature[dof].eps.abs();
        let dof = inner
            .max_by(|&i, &j| size(i).total_cmp(&size(j)))
            .expect("a cube of side 2 has an inner vertex");
        let (left, right) = (curvature[dof].eps, b[dof] - a[dof]);
        println!(
            "{order:5}  {left:19.15}  {right:19.15}   {:.1e}",
            (left - right).abs()
        );
    }
    Ok(())
}
