//! Classical Regge calculus: the curvature of a sphere from edge lengths alone.
//!
//! The octahedron's edges are halved again and again, the vertices pushed onto the unit sphere; only the lengths are
//! kept. Gauss and Bonnet: the total curvature is 8π on every mesh.
//!
//! `cargo run --release -p regge-examples --bin sphere`

use regge_curvature::functional::angle_defects;
use regge_curvature::{Lagrange, Mesh, ReggeSpace, Rules, distributional_curvature};
use std::collections::HashMap;
use std::f64::consts::PI;

type Point = [f64; 3];

fn main() -> Result<(), regge_curvature::Error> {
    let mut points: Vec<Point> = Vec::new();
    for axis in 0..3 {
        points
            .extend([1.0, -1.0].map(|s| std::array::from_fn(|i| if i == axis { s } else { 0.0 })));
    }
    let octants = (0..8).map(|bits| (0..3).map(|axis| 2 * axis + (bits >> axis & 1)).collect());
    let mut cells: Vec<Vec<usize>> = octants.collect();
    println!("vertices   largest defect   total - 8 pi");
    for _ in 0..6 {
        cells = halved(&mut points, &cells);
        let mesh = Mesh::<2>::new_abstract(points.len(), &cells)?;
        let space = ReggeSpace::new(&mesh, 0);
        // In degree 0 the coefficients are the squared edge lengths.
        let squares = (0..mesh.count(1)).map(|edge| {
            let ends = mesh.vertices(1, edge);
            distance2(points[ends[0] as usize], points[ends[1] as usize])
        });
        let g = space.function(squares.collect())?;
        let hats = Lagrange::new(&mesh, 1);
        let sums = distributional_curvature(&g, &hats, &Rules::on(&mesh, 1));
        let total: f64 = sums.total().iter().sum();
        let defects = angle_defects(&g, &mesh, 1);
        let largest = defects.iter().fold(0.0, |m: f64, d| m.max(d.defect));
        println!(
            "{:8}   {largest:14.8}   {:12.1e}",
            points.len(),
            total - 8.0 * PI
        );
    }
    Ok(())
}

fn distance2(a: Point, b: Point) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum()
}

/// Each triangle cut into four, the new vertices on the sphere.
fn halved(points: &mut Vec<Point>, cells: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut middles: HashMap<[usize; 2], usize> = HashMap::new();
    let mut middle = |a: usize, b: usize| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            let sum: Point = std::array::from_fn(|i| points[a][i] + points[b][i]);
            let length = distance2(sum, [0.0; 3]).sqrt();
            points.push(sum.map(|x| x / length));
            points.len() - 1
        })
    };
    let mut finer = Vec::new();
    for cell in cells {
        let [a, b, c] = [cell[0], cell[1], cell[2]];
        let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
        finer.extend([vec![a, x, z], vec![b, y, x], vec![c, z, y], vec![x, y, z]]);
    }
    finer
}
