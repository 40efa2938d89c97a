//! The distributional curvature by scalars and degrees. Times are for a whole mesh; divide by the number of cells,
//! which is the throughput's unit.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use num_dual::Dual64;
use regge::functional::{Rules, distributional_curvature};
use regge::lagrange::Lagrange;
use regge::mesh::Mesh;
use regge::metrics::Metric;
use regge::regge::{Interpolant, Projection, ReggeSpace};
use regge::scalar::{Lanes, Real};
use regge::smooth::Smooth;
use std::hint::black_box;

/// All of ⟨(Rω)_dist(g_h), ·⟩ against P_{r+2} by rules of order 2(r+2), scalar T.
fn by_scalar<T: Real + 'static, const N: usize>(
    c: &mut Criterion,
    name: &str,
    level: u32,
    degree: usize,
) where
    f64: regge::scalar::Lift<T>,
{
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh");
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let space = ReggeSpace::new(&mesh, degree);
    let g_h = Interpolant::AverageHierarchical(Projection::exact::<N>(degree))
        .apply(&space, &g)
        .expect("a metric");
    let test = Lagrange::new(&mesh, degree + 2);
    let rules = Rules::new::<N>(2 * (degree + 2));
    let mut group = c.benchmark_group(format!("curvature N={N} r={degree}"));
    group
        .sample_size(10)
        .throughput(Throughput::Elements(mesh.cells() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |b| {
        b.iter(|| distributional_curvature::<T, _, _>(black_box(&g_h), &test, &rules));
    });
    group.finish();
}

fn benches(c: &mut Criterion) {
    for degree in 0..=2 {
        by_scalar::<f64, 3>(c, "f64", 3, degree);
        by_scalar::<Lanes, 3>(c, "lanes", 3, degree);
        by_scalar::<Dual64, 3>(c, "dual", 3, degree);
        by_scalar::<Lanes, 2>(c, "lanes", 6, degree);
    }
}

criterion_group!(functional, benches);
criterion_main!(functional);
