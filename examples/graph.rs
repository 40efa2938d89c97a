//! A metric by a formula of your own, its Regge interpolant, and how the curvature converges.
//!
//! The surface z = sin x cos y; its scalar curvature comes out of the same kernel from exact derivatives. Interpolants
//! of degree r converge in H⁻² with order r + 1 (at least for r ≥ 1; Paper: cor:conv).
//!
//! `cargo run --release -p regge-examples --bin graph`

use regge_curvature::functional::smooth_curvature;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::scalar::Real;
use regge_curvature::{
    HMinus2, Interpolant, Mesh, ReggeSpace, Rules, Smooth, distributional_curvature,
};

/// I + ∇f ⊗ ∇f for f = sin x cos y.
struct Waves;

impl SmoothTensor<2> for Waves {
    fn at<S: Real>(&self, x: &[S; 2]) -> Mat<S, 2> {
        let d = [x[0].cos() * x[1].cos(), -x[0].sin() * x[1].sin()];
        symmetric(|i, j| S::from_int(i64::from(i == j)) + d[i] * d[j])
    }
}

fn main() -> Result<(), regge_curvature::Error> {
    println!("r  side      error   order");
    for degree in [0, 1, 2] {
        let mut before: Option<f64> = None;
        for side in [4, 8, 16, 32] {
            let error = error(degree, side)?;
            let order = before.map_or(String::new(), |b| format!("{:5.2}", (b / error).log2()));
            println!("{degree}  {side:4}  {error:.3e}   {order}");
            before = Some(error);
        }
    }
    Ok(())
}

/// ‖(Rω)_dist(g_h) − (Rω)(g)‖ in H⁻² on a square of side² · 2 triangles, a little shaken.
fn error(degree: usize, side: usize) -> Result<f64, regge_curvature::Error> {
    let mesh = Mesh::<2>::cube(side)?.perturbed(0.2 / side as f64, 1)?;
    let space = ReggeSpace::new(&mesh, degree);
    let g = Smooth::new(&mesh, Waves)?;
    let order = Rules::default_order(degree);
    let g_h = Interpolant::canonical()
        .with_order(order)
        .apply(&space, &g)?;
    let norm = HMinus2::new(&mesh, degree + 2)?;
    let rules = Rules::on(&mesh, order);
    let ours = distributional_curvature(&g_h, norm.space(), &rules).total();
    let theirs = smooth_curvature(&g, norm.space(), &rules);
    let load: Vec<f64> = ours.iter().zip(&theirs).map(|(a, b)| a - b).collect();
    Ok(norm.norm(&load, None)?.total())
}
