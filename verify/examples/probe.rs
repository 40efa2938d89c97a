//! probe
use regge_verify::{Options, run};
fn main() {
    let only: Vec<String> = std::env::args().skip(1).filter(|a| a != "--quick").collect();
    let quick = std::env::args().any(|a| a == "--quick");
    let o = Options { only, quick, ..Options::default() };
    let t = std::time::Instant::now();
    let r = run(&o, &|p| eprintln!("{:.1}s {} N={} {} {:?} {:.1e}/{:.0e} cases {} forg {} vac {} {:?} missed {:?}", t.elapsed().as_secs_f64(), p.entry.label, p.entry.dimension, p.entry.method, p.entry.verdict, p.entry.worst_residual, p.entry.tolerance, p.entry.cases, p.entry.forgeries.len(), p.entry.vacuous.len(), p.entry.failure, p.entry.forgeries.iter().filter(|f| !f.caught).collect::<Vec<_>>())).unwrap();
    eprintln!("{} entries {} forgeries, {:.1} s", r.claims.len(), r.claims.iter().map(|c| c.forgeries.len()).sum::<usize>(), t.elapsed().as_secs_f64());
}
