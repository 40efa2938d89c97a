//! Floor 2. The meshes and Regge metrics on which bounds are measured.

mod metrics;

pub use metrics::{near, near_by, noisy, smooth};

use crate::delaunay::Delaunay;
use crate::pieces::{Pieces, shape_regularity};
use regge_curvature::Error;
use regge_curvature::linalg::{Vector, vector};
use regge_curvature::mesh::{Mesh, SplitMix64};

/// The patterns of vertices and coefficients repeat after so many cubes: the same few shapes of cells at every level, so that a
/// best constant changes with h and not with how unlucky the worst of ever more random cells is.
const PERIOD: usize = 2;

/// A random number from [−1, 1) for these numbers.
fn pattern(seed: u64, key: impl Iterator<Item = usize>) -> f64 {
    let mix = |state: u64, number: usize| SplitMix64::new(state ^ (number as u64 + 1)).next_u64();
    // Seeds are small numbers, and so are the keys: mixed as they are, some would meet.
    let start = SplitMix64::new(seed).next_u64();
    SplitMix64::new(key.fold(start, mix)).symmetric()
}

/// The place of a vertex in a grid with so many points a direction.
fn place<const N: usize>(vertex: usize, points: usize) -> [usize; N] {
    std::array::from_fn(|i| vertex / points.pow(i as u32) % points)
}

/// Freudenthal's cube with so many cubes a side, inner vertices moved in a random periodic pattern by up to an eighth of a
/// cube's edge: uniformly shape-regular, which the meshes of the paper's section 5 are not for N = 2.
///
/// # Errors
/// Never, for a side above 0.
pub fn mesh<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    let cube = Mesh::<N>::cube(side)?;
    let mut points = cube
        .points()
        .ok_or(Error::NoCoordinates("a mesh"))?
        .to_vec();
    for vertex in cube.interior(0) {
        let at = place::<N>(vertex, side + 1).map(|i| i % PERIOD);
        for (i, x) in points[vertex].iter_mut().enumerate() {
            *x += 0.25 / side as f64 * pattern(seed, at.into_iter().chain([i]));
        }
    }
    moved(&cube, points)
}

/// Freudenthal's cube of boxes whose sides vary by up to a half in a random periodic pattern, and the grid that they are made of.
///
/// # Errors
/// Never, for a side above 0.
pub fn gridded<const N: usize>(side: usize, seed: u64) -> Result<(Mesh<N>, [Vec<f64>; N]), Error> {
    let cube = Mesh::<N>::cube(side)?;
    let knot = |i: usize, at: usize| {
        let place = 2.0 * at as f64 / side as f64 - 1.0;
        let inner = (1..side).contains(&at);
        let by = if inner { 0.25 / side as f64 } else { 0.0 };
        place + by * pattern(seed, [at % PERIOD, i].into_iter())
    };
    let grids: [Vec<f64>; N] = std::array::from_fn(|i| (0..=side).map(|at| knot(i, at)).collect());
    let moved_vertex = |vertex: usize| -> Vector<f64, N> {
        let at = place::<N>(vertex, side + 1);
        vector(|i| grids[i][at[i]])
    };
    let points = (0..cube.count(0)).map(moved_vertex).collect();
    Ok((moved(&cube, points)?, grids))
}

/// ℝ^N/2ℤ^N in the same way: without a boundary, and so without a layer of cells where things are different.
///
/// # Errors
/// If the side is less than 3.
pub fn torus<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    let torus = Mesh::<N>::torus(side)?;
    let (mut cells, mut corners) = (Vec::new(), Vec::new());
    for cell in 0..torus.cell_count() {
        let vertices = corners_of(&torus, cell);
        let corner = |(i, vertex): (usize, &usize)| {
            let at = place::<N>(*vertex, side).map(|i| i % PERIOD);
            let move_by = |i: usize| 0.25 / side as f64 * pattern(seed, at.into_iter().chain([i]));
            let moved: Vector<f64, N> = vector(move_by);
            Some(torus.corner(cell, i)? + moved)
        };
        corners.push(vertices.iter().enumerate().filter_map(corner).collect());
        cells.push(vertices);
    }
    Mesh::with_cell_charts(torus.count(0), &cells, &corners)
}

/// Every cell cut at its barycentre, as Alfeld does: hinges of valence N + 1, and cells that are flatter.
///
/// # Errors
/// If a mesh has no coordinates.
pub fn alfeld<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    let whole = mesh::<N>(side, seed)?;
    let points = whole.points().ok_or(Error::NoCoordinates("a mesh"))?;
    let (mut points, mut cells) = (points.to_vec(), Vec::new());
    for cell in 0..whole.cell_count() {
        let vertices = corners_of(&whole, cell);
        let sum: Vector<f64, N> = vertices.iter().map(|v| points[*v]).sum();
        for left_out in 0..=N {
            let mut part = vertices.clone();
            part[left_out] = points.len();
            cells.push(part);
        }
        points.push(sum / (N + 1) as f64);
    }
    Mesh::new(points, &cells)
}

/// Delaunay's triangulation of the vertices and the midpoints of cubes, both moved in a random periodic pattern by up to a tenth of a cube's
/// edge, those on the boundary along it. No two vertices see the same, but cells in the interior are still those of the lattice of cubes
/// and midpoints.
///
/// # Errors
/// Never, for a side above 0.
pub fn delaunay<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    delaunay_by(side, seed, 0.1)
}

/// The same with vertices moved by up to this share of a cube's edge.
fn delaunay_by<const N: usize>(side: usize, seed: u64, share: f64) -> Result<Mesh<N>, Error> {
    let mut all = Delaunay::new(&Mesh::<N>::cube(1)?)?;
    let edge = 2.0 / side as f64;
    let by = |at: [usize; N], i: usize, kind: usize| {
        let key = at.map(|i| i % PERIOD).into_iter().chain([i, kind]);
        share * edge * pattern(seed, key)
    };
    for number in 0..(side + 1).pow(N as u32) {
        let at = place::<N>(number, side + 1);
        let on = |i: usize| at[i] == 0 || at[i] == side;
        let corner =
            vector(|i| -1.0 + edge * at[i] as f64 + if on(i) { 0.0 } else { by(at, i, 0) });
        // The corners of the square are there from the beginning.
        if !(0..N).all(on) {
            all.insert(corner);
        }
        if at.iter().all(|i| *i < side) {
            all.insert(vector(|i| {
                -1.0 + edge * (at[i] as f64 + 0.5) + by(at, i, 1)
            }));
        }
    }
    all.mesh()
}

/// In a pattern without slivers h_T/ρ_T is at most this; about one pattern in ten is of this kind for N = 3, nearly all for N = 2.
const NO_SLIVER: f64 = 20.0;

/// Delaunay's triangulation with vertices moved so far, by a fifth of a cube's edge, that cells are those of no lattice: for N = 3 between 3 and
/// 8 of them meet at an edge. Patterns with slivers, which Delaunay's property does not exclude in space, are passed over.
///
/// # Errors
/// Never, for a side above 0.
pub fn unstructured<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    // The pattern has a period of two cubes: all shapes that it has are there with four cubes a side.
    let few = 2 * PERIOD;
    let has_slivers = |seed: &u64| {
        let mesh = delaunay_by::<N>(few, *seed, 0.2);
        !mesh.is_ok_and(|mesh| shape_regularity(&mesh) <= NO_SLIVER)
    };
    let mut seeds = (0..).map(|attempt: u64| seed.wrapping_add(attempt << 32));
    let seed = seeds.find(|seed| !has_slivers(seed)).unwrap_or(seed);
    delaunay_by(side, seed, 0.2)
}

/// Graded towards the centre: cubes' surfaces go to cubes' surfaces, those at distance ρ to ρ², so that cells are ever smaller there
/// and keep a shape.
///
/// # Errors
/// If a mesh has no coordinates.
pub fn graded<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    let even = mesh::<N>(side, seed)?;
    let points = even.points().ok_or(Error::NoCoordinates("a mesh"))?;
    let inward = |p: &Vector<f64, N>| *p * p.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    moved(&even, points.iter().map(inward).collect())
}

/// The cells of a mesh with other points.
fn moved<const N: usize>(mesh: &Mesh<N>, points: Vec<Vector<f64, N>>) -> Result<Mesh<N>, Error> {
    let cells = 0..mesh.cell_count();
    let cells: Vec<Vec<usize>> = cells.map(|cell| corners_of(mesh, cell)).collect();
    Mesh::new(points, &cells)
}

/// The vertices of a cell.
fn corners_of<const N: usize>(mesh: &Mesh<N>, cell: usize) -> Vec<usize> {
    let vertices = mesh.vertices(N, cell).iter();
    vertices.map(|vertex| *vertex as usize).collect()
}

/// The same, taken apart, with h.
///
/// # Errors
/// As [`mesh`].
pub fn pieces<const N: usize>(side: usize, seed: u64) -> Result<(Pieces<N>, f64), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let h = mesh.mesh_size();
    Ok((Pieces::new(mesh)?, h))
}

/// A mesh with all its points multiplied by a factor.
///
/// # Errors
/// If it has no points.
pub fn scaled<const N: usize>(mesh: &Mesh<N>, factor: f64) -> Result<Mesh<N>, Error> {
    squeezed(mesh, [factor; N])
}

/// A mesh with the coordinates of its points multiplied by factors.
///
/// # Errors
/// If it has no points.
pub fn squeezed<const N: usize>(mesh: &Mesh<N>, factors: [f64; N]) -> Result<Mesh<N>, Error> {
    let points = mesh.points().ok_or(Error::NoCoordinates("a scaled mesh"))?;
    moved(
        mesh,
        points
            .iter()
            .map(|p| vector(|i| factors[i] * p[i]))
            .collect(),
    )
}
