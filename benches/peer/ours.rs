//! Our side of the comparison with NGSolve, which `benches/peer/compare.py` drives. Each call prints one line of JSON.
//!
//! ```text
//! ours mesh N k SEED                   points and cells of the paper's mesh
//! ours functional N k r q SCALAR n     the best of n runs of the functional against P_q by rules of order 2(r+2)
//! ours accuracy k                      |R − R_exact| of a metric of degree 2 that the Regge space holds, N = 3
//! ```
//! SCALAR is f64, lanes or dual.

use num_dual::Dual64;
use regge_curvature::field::{Evaluate, PointByPoint};
use regge_curvature::functional::Sums;
use regge_curvature::jet::lower;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::scalar::Real;
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeFunction, ReggeSpace, Rules, Smooth, TensorField,
    distributional_curvature,
};
use serde_json::{Value, json};
use std::time::Instant;

/// The seed of what the command line does not repeat.
const SEED: u64 = 3;

/// The paper's mesh of level k.
fn mesh<const N: usize>(level: u32, seed: u64) -> Mesh<N> {
    Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, seed))
        .expect("the paper's mesh")
}

fn write_mesh<const N: usize>(level: u32, seed: u64) -> Value {
    let mesh = mesh::<N>(level, seed);
    let points = mesh.points().expect("coordinates").iter();
    json!({
        "points": points.map(|x| x.as_slice().to_vec()).collect::<Vec<_>>(),
        "cells": (0..mesh.cell_count()).map(|c| mesh.vertices(N, c).to_vec()).collect::<Vec<_>>(),
    })
}

/// What is timed.
#[derive(Clone, Copy)]
struct Job {
    level: u32,
    degree: usize,
    test_degree: usize,
    repeats: usize,
}

/// The canonical interpolant of the paper's metric.
fn interpolant<const N: usize>(job: Job) -> ReggeFunction<f64, N> {
    let mesh = mesh::<N>(job.level, SEED);
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let space = ReggeSpace::new(&mesh, job.degree);
    let order = 2 * job.degree + 12;
    Interpolant::canonical()
        .with_order(order)
        .apply(&space, &g)
        .expect("a metric")
}

/// The curvature of a metric in the field's scalars, timed, and its three sums at inner vertices.
fn functional<const N: usize, G: TensorField<N>>(
    job: Job,
    mesh: &Mesh<N>,
    g: &G,
    real: impl Fn(&G::Scalar) -> f64,
) -> Value {
    let test = Lagrange::new(mesh, job.test_degree);
    let rules = Rules::on(mesh, 2 * (job.degree + 2));
    let mut best = f64::INFINITY;
    let mut sums: Option<Sums<G::Scalar>> = None;
    for _ in 0..job.repeats {
        let start = Instant::now();
        sums = Some(distributional_curvature(g, &test, &rules));
        best = best.min(start.elapsed().as_secs_f64());
    }
    let sums = sums.expect("at least one run");
    let inner: Vec<usize> = (0..mesh.count(0))
        .filter(|&v| mesh.is_interior(0, v))
        .collect();
    let at_inner = |sum: &[G::Scalar]| inner.iter().map(|&v| real(&sum[v])).collect::<Vec<_>>();
    json!({
        "cells": mesh.cell_count(),
        "seconds": best,
        "microseconds_per_cell": best * 1e6 / mesh.cell_count() as f64,
        "element": at_inner(&sums.cells),
        "face": at_inner(&sums.faces),
        "hinge": at_inner(&sums.hinges),
    })
}

/// The graph of |x|²/2: g = δ + x ⊗ x is quadratic and so is its own interpolant of degree 2.
struct Paraboloid;

impl<const N: usize> SmoothTensor<N> for Paraboloid {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        symmetric(|i, j| {
            let delta = if i == j { S::one() } else { S::zero() };
            delta + x[i] * x[j]
        })
    }
}

/// R of the paraboloid at the barycentres, from the Regge function, against Gauss' equation:
/// Σ_{i≠j} (w − x_i² − x_j²)/w² with w = 1 + |x|².
fn accuracy(level: u32) -> Value {
    let mesh = mesh::<3>(level, SEED);
    let g = Smooth::new(&mesh, Paraboloid).expect("coordinates");
    let space = ReggeSpace::new(&mesh, 2);
    let g_h = Interpolant::canonical()
        .with_order(8)
        .apply(&space, &g)
        .expect("a metric");
    let table = Evaluate::<f64, 3>::tabulate(&g_h, Rule::new(3, 1).points());
    let mut worst: f64 = 0.0;
    for cell in 0..mesh.cell_count() {
        let local = Evaluate::<f64, 3>::on_cell(&g_h, cell);
        let jets = g_h.jet2(&local, &table, 0);
        let r = Curvature::new(&jets, &Connection::new(&lower(&jets))).scalar();
        let corners = (0..4).filter_map(|i| mesh.corner(cell, i));
        let x = corners.sum::<regge_curvature::linalg::Vector<f64, 3>>() / 4.0;
        let w = 1.0 + x.norm_squared();
        let exact = (6.0 * w - 4.0 * x.norm_squared()) / (w * w);
        worst = worst.max((r - exact).abs());
    }
    json!({ "error": worst })
}

fn by_scalar<const N: usize>(scalar: &str, job: Job) -> Value {
    let g = interpolant::<N>(job);
    let mesh = g.space().mesh();
    match scalar {
        "f64" => functional(job, mesh, &PointByPoint(&g), |x| *x),
        "dual" => {
            let moving = g.coefficients().iter().map(|&c| Dual64::new(c, c));
            let moving = g.space().function(moving.collect()).expect("as many");
            functional(job, mesh, &moving, |x| x.re)
        }
        _ => functional(job, mesh, &g, |x| *x),
    }
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| args[i].parse::<usize>().expect("a number");
    let result = match args[0].as_str() {
        "mesh" if number(1) == 2 => write_mesh::<2>(number(2) as u32, number(3) as u64),
        "mesh" => write_mesh::<3>(number(2) as u32, number(3) as u64),
        "accuracy" => accuracy(number(1) as u32),
        _ => {
            let job = Job {
                level: number(2) as u32,
                degree: number(3),
                test_degree: number(4),
                repeats: number(6),
            };
            match number(1) {
                2 => by_scalar::<2>(&args[5], job),
                _ => by_scalar::<3>(&args[5], job),
            }
        }
    };
    println!("{result}");
}
