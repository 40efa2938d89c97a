//! The distributional curvature by dimension, degree and scalar, against the hat functions, by rules of order 2(r+2).
//!
//! Times are for a whole mesh; divided by the number of cells, which is the throughput's unit, they are what
//! docs/performance.md shows. Scalars of one degree are measured one after the other: compare those.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use num_dual::Dual64;
use regge_curvature::functional::{Rules, distributional_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::scalar::{Lanes, Lift, Real};
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use std::hint::black_box;

/// All of ⟨(Rω)_dist(g_h), ·⟩ in scalar T.
fn by_scalar<T: Real, const N: usize>(c: &mut Criterion, name: &str, g: &ReggeFunction<f64, N>)
where
    f64: Lift<T>,
{
    let (mesh, degree) = (g.space().mesh(), g.space().degree());
    let hats = Lagrange::new(mesh, 1);
    let rules = Rules::new::<N>(2 * (degree + 2));
    let mut group = c.benchmark_group(format!("curvature N={N} r={degree}"));
    group
        .sample_size(20)
        .throughput(Throughput::Elements(mesh.cell_count() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |b| {
        b.iter(|| distributional_curvature::<T, _, _>(black_box(g), &hats, &rules));
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
        let g = Interpolant::canonical()
            .with_order(order)
            .apply(&space, &graph)
            .expect("a metric");
        by_scalar::<f64, N>(c, "f64", &g);
        by_scalar::<Lanes, N>(c, "lanes", &g);
        by_scalar::<Dual64, N>(c, "dual", &g);
    }
}

fn benches(c: &mut Criterion) {
    println!("vectors of {} bits", Lanes::BUILT_FOR);
    by_degree::<2>(c, 5);
    by_degree::<3>(c, 3);
}

criterion_group!(functional, benches);
criterion_main!(functional);
