//! Floor 2. The smooth metric of these measurements, and Regge metrics near it.

use super::{PERIOD, pattern, place};
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth, SmoothTensor};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// The smooth metric of these measurements: it has no symmetry.
///
/// # Errors
/// If the mesh has no coordinates.
pub fn smooth<const N: usize>(mesh: &Mesh<N>) -> Result<Smooth<Metric, N>, Error> {
    Smooth::new(mesh, Metric::Trig)
}

/// A Regge metric near g on a cube's mesh: the canonical interpolant, its coefficients times 1 + a ξ with ξ from [−1, 1) in a
/// random periodic pattern.
///
/// # Errors
/// If g is not positive definite.
pub fn near<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    r: usize,
    a: f64,
    seed: u64,
) -> Result<ReggeFunction<f64, N>, Error> {
    near_by(g, r, &|_, _| a, seed)
}

/// The same with an amplitude that depends on the simplex that a coefficient belongs to, by its dimension and number.
///
/// # Errors
/// If g is not positive definite.
pub fn near_by<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    r: usize,
    amplitude: &dyn Fn(&Mesh<N>, (usize, usize)) -> f64,
    seed: u64,
) -> Result<ReggeFunction<f64, N>, Error> {
    let (canonical, mesh) = (canonical(g, r)?, g.mesh());
    let side = (mesh.count(0) as f64).powf(1.0 / N as f64).round() as usize;
    // A torus has as many vertices as cubes in a direction, and its grid begins anew there.
    let closed = mesh.is_closed();
    let side = if closed { side } else { side - 1 };
    let (mut owner, mut number) = ((0, 0), 0);
    let space = canonical.space();
    let shaken = canonical.coefficients().iter().enumerate().map(|(dof, c)| {
        let now = space.numbering().owner(dof);
        number = if now == owner { number + 1 } else { 0 };
        owner = now;
        let vertices = mesh.vertices(now.0, now.1);
        let grid = if closed { side } else { side + 1 };
        let places: Vec<[usize; N]> = (vertices.iter())
            .map(|&vertex| place(vertex as usize, grid))
            .collect();
        // Where the first vertex is in its block, and the others relative to it, one to the right or left.
        let relative = (places.iter())
            .flat_map(|p| (0..N).map(|i| ((p[i] + grid - places[0][i]) % grid).min(2)));
        let block = places[0].map(|i| i % PERIOD).into_iter();
        let key: Vec<usize> = block.chain(relative).chain([number]).collect();
        c * (1.0 + amplitude(mesh, now) * pattern(seed, key.into_iter()))
    });
    space.function(shaken.collect())
}

fn canonical<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    r: usize,
) -> Result<ReggeFunction<f64, N>, Error> {
    let interpolant = Interpolant::canonical().with_order(2 * r + 6);
    interpolant.apply(&ReggeSpace::new(g.mesh(), r), g)
}

/// The same on any mesh: each coefficient has its own ξ, and a is this function of the diameter of the edge, face or cell that the
/// coefficient belongs to.
///
/// # Errors
/// If g is not positive definite.
pub fn noisy<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    r: usize,
    a: &dyn Fn(f64) -> f64,
    seed: u64,
) -> Result<ReggeFunction<f64, N>, Error> {
    let (canonical, mut random) = (canonical(g, r)?, SplitMix64::new(seed));
    let (space, mesh) = (canonical.space(), g.mesh());
    let points = mesh.points().ok_or(Error::NoCoordinates("a mesh"))?;
    let diameter = |(k, simplex): (usize, usize)| {
        let vertices = mesh.vertices(k, simplex);
        let pairs = vertices
            .iter()
            .flat_map(|v| vertices.iter().map(move |w| (*v, *w)));
        let lengths = pairs.map(|(v, w)| (points[v as usize] - points[w as usize]).norm());
        lengths.fold(0.0, f64::max)
    };
    let shaken = canonical.coefficients().iter().enumerate().map(|(dof, c)| {
        let size = a(diameter(space.numbering().owner(dof)));
        c * (1.0 + size * random.symmetric())
    });
    space.function(shaken.collect())
}
