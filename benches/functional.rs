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

/// All of ⟨(Rω)_dist(g), ·⟩ in the scalars of a field.
fn by_scalar<const N: usize>(
    c: &mut Criterion,
    [name, degree]: [&str; 2],
    g: &impl TensorField<N>,
    hats: &Lagrange<N>,
    rules: &Rules,
) {
    let mut group = c.benchmark_group(format!("curvature N={N} r={degree}"));
    group
        .sample_size(20)
        .throughput(Throughput::Elements(hats.mesh().cell_count() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |b| {
        b.iter(|| distributional_curvature(black_box(g), hats, rules));
    });
    group.finish();
}

/// Every scalar with every degree on the paper's mesh of this level.
fn by_degree<const N: usize>(c: &mut Criterion, level: u32) {
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh");
    let graph = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let hats = Lagrange::new(&mesh, 1);
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let order = 2 * degree + 2;
        let g = Interpolant::canonical()
            .with_order(order)
            .apply(&space, &graph)
            .expect("a metric");
        let duals = g.coefficients().iter().map(|c| Dual64::from(*c)).collect();
        let dual = space.function(duals).expect("as many coefficients");
        let (rules, r) = (Rules::on(&mesh, 2 * (degree + 2)), degree.to_string());
        by_scalar(c, ["f64", &r], &PointByPoint(&g), &hats, &rules);
        by_scalar(c, ["lanes", &r], &g, &hats, &rules);
        by_scalar(c, ["dual", &r], &dual, &hats, &rules);
    }
}

fn benches(c: &mut Criterion) {
    println!("vectors of {} bits", Lanes::BUILT_FOR);
    by_degree::<2>(c, 5);
    by_degree::<3>(c, 3);
}

criterion_group!(functional, benches);
criterion_main!(functional);
