//! Meshes of domains that are no cubes, made of a cube's.

use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;

/// The cells of `Mesh::cube` on (−1, 1)^N that are kept, with their vertices moved.
fn carved<const N: usize>(
    side: usize,
    keep: impl Fn(&Vector<f64, N>) -> bool,
    place: impl Fn(&Vector<f64, N>) -> Vector<f64, N>,
) -> Mesh<N> {
    let cube = Mesh::<N>::cube(side).unwrap();
    let points = cube.points().unwrap();
    let (lower, upper) = (points[0], points[points.len() - 1]);
    let centred = |x: &Vector<f64, N>| {
        (x - lower).component_div(&(upper - lower)) * 2.0 - Vector::repeat(1.0)
    };
    let mut numbers = vec![None; points.len()];
    let (mut kept, mut cells) = (Vec::new(), Vec::new());
    for cell in 0..cube.cell_count() {
        let vertices = cube.vertices(N, cell);
        let corners = vertices.iter().map(|&v| centred(&points[v as usize]));
        if !keep(&(corners.sum::<Vector<f64, N>>() / (N + 1) as f64)) {
            continue;
        }
        let number = |&v: &u32| {
            *numbers[v as usize].get_or_insert_with(|| {
                kept.push(place(&centred(&points[v as usize])));
                kept.len() - 1
            })
        };
        cells.push(vertices.iter().map(number).collect::<Vec<_>>());
    }
    Mesh::new(kept, &cells).unwrap()
}

/// The cube (−1, 1)^N without the part where all coordinates are positive: an L for N = 2, Fichera's corner for N = 3. `side` is
/// even.
pub fn fichera<const N: usize>(side: usize) -> Mesh<N> {
    carved(
        side,
        |x: &Vector<f64, N>| x.iter().any(|c| *c < 0.0),
        |x| *x,
    )
}

/// Half way from the cube (−1, 1)^N to the unit ball, which has flat cells where the cube has corners.
pub fn rounded<const N: usize>(side: usize) -> Mesh<N> {
    let place = |x: &Vector<f64, N>| match x.norm() {
        0.0 => *x,
        length => x * (0.5 + 0.5 * x.amax() / length),
    };
    carved(side, |_| true, place)
}

/// The cube without a hole in its middle, a third as wide, through all of it along the last axis. `side` is divided by three.
pub fn ring<const N: usize>(side: usize) -> Mesh<N> {
    let keep = |x: &Vector<f64, N>| x.iter().take(2).any(|c| c.abs() > 1.0 / 3.0);
    carved(side, keep, |x| *x)
}

/// Fichera's corner whose vertices nearest to a point of the inside are moved towards each other, so that the cells that have both
/// are slivers with edges this short in units of the mesh.
pub fn slivers(side: usize, part: f64) -> Mesh<3> {
    let mesh = fichera::<3>(side);
    let step = 2.0 / side as f64;
    let edge = |v: u32| mesh.points().unwrap()[v as usize];
    let middle = Vector::repeat(-0.5);
    let inner = (0..mesh.count(1))
        .filter(|&e| (mesh.vertices(1, e).iter()).all(|&v| mesh.is_interior(0, v as usize)));
    let distance = |e: usize| (edge(mesh.vertices(1, e)[0]) - middle).norm();
    let nearest = inner
        .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
        .unwrap();
    let [a, b] = [0, 1].map(|i| mesh.vertices(1, nearest)[i]);
    let towards = (edge(a) - edge(b)).normalize();
    let mut points = mesh.points().unwrap().to_vec();
    points[b as usize] = edge(a) - towards * (part * step);
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|t| mesh.vertices(3, t).iter().map(|&v| v as usize).collect())
        .collect();
    Mesh::new(points, &cells).unwrap()
}
