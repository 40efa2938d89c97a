//! The command line `regge`.
use regge_verify::study::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let dimension: usize = a[1].parse().unwrap();
    let q = match a[5].as_str() { "c" => Quadrature::CONVERGED, "p" => Quadrature::AS_PRINTED, o => Quadrature { load: LoadQuadrature::Order(o.parse().unwrap()), norm: None } };
    let cases = a[3].split(',').flat_map(|r| { let r: usize = r.parse().unwrap(); (0..=a[4].parse::<u32>().unwrap()).map(move |level| Case { degree: r, level }) }).collect();
    let study = Study { metric: regge::metrics::Metric::from_name(&std::env::var("M").unwrap_or("graph-quartic".into())).unwrap(), dimension, quantity: Quantity::from_name(&a[2]).unwrap(),
        interpolants: a[6].split(',').map(|i| Interpolation::from_name(i).unwrap()).collect(),
        projection: if a[5] == "p" { ProjectionKind::Discrete } else { ProjectionKind::Exact }, quadrature: q, seed: std::env::var("SEED").map_or(3,|s|s.parse().unwrap()), cases };
    let t = std::time::Instant::now();
    study.run(&mut |e| if let Event::Row(r) = e { println!("{} {} {:22} ndof {} h {:.4} e {:.13e} o {:?} p {:?} {:.2?} s {:.2}", r.degree, r.level, r.interpolant, r.ndof, r.mesh_size, r.error, r.order, r.printed, r.printed.map(|p| r.error/p), r.seconds) }).unwrap();
    println!("{:.2?}", t.elapsed());
}
