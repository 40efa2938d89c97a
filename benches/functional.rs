//! The distributional curvature by dimension, degree and scalar, against the hat functions, by rules of order 2(r+2).
//!
//! Times are for a whole mesh; divided by the number of cells, which is the throughput's unit, they are what
//! docs/performance.md shows. Scalars of one degree are measured one after the other: compare those.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use num_dual::Dual64;
use regge_curvature::field::PointByPoint;
use regge_curvature::scalar::Lanes;
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, TensorField,
    distributional_curvature,
};
use std::hint::black_box;

/// All of ⟨(Rω)_dist(g_h), ·⟩ in the scalars of the field.
fn by_scalar<const N: usize>(
    c: &mut Criterion,
    name: &str,
    space: &ReggeSpace<N>,
    g: &impl TensorField<N>,
) {
    let (mesh, degree) = (space.mesh(), space.degree());
    let hats = Lagrange::new(mesh, 1);
    let rules = Rules::on(mesh, 2 * (degree + 2));
    let mut group = c.benchmark_group(format!("curvature N={N} r={degree}"));
    group
        .sample_size(20)
        .throughput(Throughput::Elements(mesh.cell_count() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |b| {
        b.iter(|| distributional_curvature(black_box(g), &hats, &rules));
    });
    group.finish();
}

/// Every scalar with every degree on the paper's mesh of this level.
fn by_degree<const N: usize>(c: &mut Criterion, level: u32) {
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh");
    let graph = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let order = 2 * degree + 2;
        let g = Interpolant::Canonical { order }
            .apply(&space, &graph)
            .expect("a metric");
        // The same metric with a derivative: what is a constant times a table becomes a dual number times one.
        let moving = g.coefficients().iter().map(|&c| Dual64::new(c, c));
        let moving = space.function(moving.collect()).expect("as many");
        by_scalar(c, "f64", &space, &PointByPoint(&g));
        by_scalar(c, "lanes", &space, &g);
        by_scalar(c, "dual", &space, &moving);
    }
}

fn benches(c: &mut Criterion) {
    println!("vectors of {} bits", Lanes::BUILT_FOR);
    by_degree::<2>(c, 5);
    by_degree::<3>(c, 3);
}

criterion_group!(functional, benches);
criterion_main!(functional);
