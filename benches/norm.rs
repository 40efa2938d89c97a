//! The H⁻² norm: set-up with factorisation, and one solution.

use criterion::{Criterion, criterion_group, criterion_main};
use regge::mesh::{Mesh, SplitMix64};
use regge::norm::HMinus2;
use std::hint::black_box;

fn on<const N: usize>(c: &mut Criterion, level: u32, degree: usize) {
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh");
    let mut group = c.benchmark_group(format!("H-2 N={N} level={level} p={degree}"));
    group.sample_size(10);
    group.bench_function("set up and factorise", |b| {
        b.iter(|| HMinus2::new(black_box(&mesh), degree).expect("a norm"));
    });
    let norm = HMinus2::new(&mesh, degree).expect("a norm");
    let mut random = SplitMix64::new(1);
    let load: Vec<f64> = (0..norm.space().len())
        .map(|_| random.symmetric())
        .collect();
    group.bench_function("solve", |b| {
        b.iter(|| norm.norm(black_box(&load), None).expect("a norm"))
    });
    group.finish();
}

fn benches(c: &mut Criterion) {
    on::<2>(c, 5, 4);
    on::<3>(c, 2, 4);
}

criterion_group!(norm, benches);
criterion_main!(norm);
