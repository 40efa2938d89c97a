//! The H⁻² norm: set-up and solution by both solvers; one application of the matrix-free operator and of its
//! preconditioner by levels, beside a dense product as the measure of the machine.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::norm::{BiharmonicSolver, Direct, HMinus2, Hhj, Iterative};
use std::hint::black_box;
use std::sync::Arc;

fn perturbed<const N: usize>(level: u32) -> Mesh<N> {
    Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh")
}

fn random(len: usize) -> Vec<f64> {
    let mut random = SplitMix64::new(1);
    (0..len).map(|_| random.symmetric()).collect()
}

fn solvers<const N: usize>(c: &mut Criterion, level: u32, degree: usize) {
    let mesh = perturbed::<N>(level);
    let mut group = c.benchmark_group(format!("H-2 N={N} level={level} p={degree}"));
    group.sample_size(10);
    let hhj = Arc::new(Hhj::new(&mesh, degree).expect("a problem"));
    group.bench_function("set up and factorise", |b| {
        b.iter(|| Direct::new(black_box(&hhj).clone()).expect("a factor"));
    });
    group.bench_function("set up the iteration", |b| {
        b.iter(|| Iterative::new(black_box(&hhj).clone()).expect("a solver"));
    });
    let load = random(hhj.space().len());
    let direct: Box<dyn BiharmonicSolver<N>> =
        Box::new(Direct::new(hhj.clone()).expect("a factor"));
    let iterative = Box::new(Iterative::new(hhj).expect("a solver"));
    for solver in [direct, iterative] {
        let name = format!("solve by {}", solver.name());
        let norm = HMinus2::with_solver(solver);
        group.bench_function(name, |b| {
            b.iter(|| norm.norm(black_box(&load), None).expect("a norm"))
        });
    }
    group.finish();
}

/// Level 6 is 1 572 864 cells and up to 7 GB: `REGGE_BENCH_FINEST=6` asks for it.
fn finest() -> u32 {
    let asked = std::env::var("REGGE_BENCH_FINEST").ok();
    asked.and_then(|level| level.parse().ok()).unwrap_or(5)
}

/// Operations as the throughput: the report's elements a second are Flop/s.
fn operator(c: &mut Criterion, degree: usize) {
    let mut group = c.benchmark_group(format!("matrix-free N=3 p={degree}"));
    group.sample_size(10);
    for level in 3..=finest() {
        let mesh = perturbed::<3>(level);
        let hhj = Hhj::new(&mesh, degree).expect("a problem");
        let solver = Iterative::new(hhj).expect("a solver");
        let x = random(solver.unknowns());
        let (mut y, mut room) = (x.clone(), Vec::new());
        group.throughput(Throughput::Elements(solver.operations() as u64));
        group.bench_function(BenchmarkId::new("operator", level), |b| {
            b.iter(|| solver.apply(black_box(&x), &mut y, &mut room));
        });
        group.throughput(Throughput::Elements(mesh.cell_count() as u64));
        group.bench_function(BenchmarkId::new("preconditioner, by cells", level), |b| {
            b.iter(|| solver.precondition(black_box(&x), &mut y));
        });
    }
    group.finish();
}

/// The machine: a product of two dense matrices on all threads.
fn peak(c: &mut Criterion) {
    let n = 1536;
    let matrix = || faer::Mat::from_fn(n, n, |i, j| (i * 7 + j) as f64 % 3.0);
    let (a, b) = (matrix(), matrix());
    let mut group = c.benchmark_group("machine");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(2 * (n as u64).pow(3)));
    group.bench_function("dense product", |bench| {
        bench.iter(|| black_box(&a) * black_box(&b));
    });
    group.finish();
}

fn benches(c: &mut Criterion) {
    peak(c);
    operator(c, 2);
    operator(c, 4);
    solvers::<2>(c, 5, 4);
    solvers::<3>(c, 2, 4);
    solvers::<3>(c, 3, 2);
}

criterion_group!(norm, benches);
criterion_main!(norm);
