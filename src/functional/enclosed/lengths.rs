//! Classical Regge calculus with proven digits: the production corner over intervals.

use crate::Error;
use crate::density::{Corner, outward};
use crate::formulas::PAPER;
use crate::functional::action::check_degree;
use crate::linalg::{Mat, Vector, indefinite_pivot, inverse_and_det, ldlt, symmetric};
use crate::mesh::Mesh;
use crate::parallel::in_order;
use crate::scalar::{Algebraic, Field, Interval};
use crate::simplex::{factorial, subsets};
use crate::spaces::ReggeFunction;

/// Enclosures for a metric of degree 0, whose coefficients, the squared lengths, are taken to be exact.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed {
    /// By hinge: Θ_S = 2π − Σ_T θ_ST, in radians; π − Σ_T θ_ST on the boundary.
    pub defects: Vec<Interval>,
    /// By hinge: |S|.
    pub sizes: Vec<Interval>,
    /// Σ̊_S Θ_S |S|.
    pub interior: Interval,
    /// Σ_{S⊂∂Ω} (π − Σ_T θ_ST) |S|.
    pub boundary: Interval,
    /// By edge: Σ_S Θ_S ∂|S|/∂ℓ, the derivative of the action in the edge's length.
    pub gradient: Vec<Interval>,
}

/// What a cell has at its hinges.
struct OnCell {
    angles: Vec<Interval>,
    sizes: Vec<Interval>,
    /// `[place][e]`: ∂|S|/∂ℓ_e.
    rates: Vec<Vec<Interval>>,
}

/// Encloses the angle defects, the sizes of the hinges, Regge's action and its gradient.
///
/// # Errors
/// If the degree of g is not 0; or if g is not positive definite in a cell, or so nearly degenerate that intervals cannot tell.
pub fn enclosed<const N: usize>(g: &ReggeFunction<f64, N>) -> Result<Enclosed, Error> {
    check_degree(g)?;
    let mesh = g.space().mesh();
    let mut all = Enclosed {
        defects: full_angles(mesh),
        sizes: vec![Interval::zero(); mesh.count(N - 2)],
        interior: Interval::zero(),
        boundary: Interval::zero(),
        gradient: vec![Interval::zero(); mesh.count(1)],
    };
    // ∂|S|/∂ℓ by hinge, once for each of its edges: from its first cell.
    let mut rates: Vec<Vec<(u32, Interval)>> = vec![Vec::new(); mesh.count(N - 2)];
    let mut failed = None;
    in_order(
        mesh.cell_count(),
        |cell| on_cell(g, cell),
        |cell, found| {
            let found = match found {
                Ok(found) => found,
                Err(error) => {
                    failed.get_or_insert(error);
                    return;
                }
            };
            for (place, &hinge) in mesh.simplices_of(cell, N - 2).iter().enumerate() {
                let hinge = hinge as usize;
                all.defects[hinge] -= found.angles[place];
                if mesh.first_side(N - 2, hinge).cell == cell {
                    all.sizes[hinge] = found.sizes[place];
                    let edges = mesh.simplices_of(cell, 1).iter().copied();
                    rates[hinge] = edges.zip(found.rates[place].iter().copied()).collect();
                }
            }
        },
    );
    if let Some(error) = failed {
        return Err(error);
    }
    all.add_up(mesh, &rates);
    Ok(all)
}

/// 2π at interior hinges, π at those of the boundary.
fn full_angles<const N: usize>(mesh: &Mesh<N>) -> Vec<Interval> {
    let mut angles = vec![Interval::pi(); mesh.count(N - 2)];
    for hinge in mesh.interior_hinges() {
        angles[hinge] += Interval::pi();
    }
    angles
}

impl Enclosed {
    fn add_up<const N: usize>(&mut self, mesh: &Mesh<N>, rates: &[Vec<(u32, Interval)>]) {
        let mut inside = vec![false; mesh.count(N - 2)];
        for hinge in mesh.interior_hinges() {
            inside[hinge] = true;
        }
        for (hinge, rates) in rates.iter().enumerate() {
            let term = self.defects[hinge] * self.sizes[hinge];
            if inside[hinge] {
                self.interior += term;
            } else {
                self.boundary += term;
            }
            for (edge, rate) in rates {
                self.gradient[*edge as usize] += self.defects[hinge] * *rate;
            }
        }
    }

    /// The action.
    pub fn action(&self) -> Interval {
        self.interior + self.boundary
    }
}

/// Angles and sizes at the hinges of a cell, through the library's own corner, seen from the vertex that makes them narrowest.
fn on_cell<const N: usize>(g: &ReggeFunction<f64, N>, cell: usize) -> Result<OnCell, Error> {
    let squares: Vec<Interval> = g.local(cell).into_iter().map(Interval::exactly).collect();
    let base = base::<N>(&squares);
    let metric = from_squares::<N>(&squares, base);
    if !ldlt(&metric)
        .factors
        .diagonal()
        .iter()
        .all(|d| d.is_positive())
    {
        return Err(degenerate(g, cell));
    }
    let (inverse, det) = inverse_and_det(&metric);
    let edges = subsets(N + 1, 2);
    let per_size = Interval::one() / Interval::exactly(factorial(N - 2));
    let mut found = OnCell {
        angles: Vec::new(),
        sizes: Vec::new(),
        rates: Vec::new(),
    };
    for hinge in subsets(N + 1, N - 1) {
        let apart: Vec<usize> = (0..=N).filter(|v| !hinge.contains(v)).collect();
        let nu: [Vector<Interval, N>; 2] = [apart[0], apart[1]].map(|v| outward(swapped(base, v)));
        let mut corner = Corner::new(&PAPER, &inverse, det, [&nu[0], &nu[1]]);
        // The same number, det g|_S over det g (Jacobi): in flat cells the difference of products encloses zero.
        corner.gram = corner.gram.meet(det_on::<N>(&squares, &hinge) / det);
        let (sin, cos) = corner.dihedral();
        // A vertex of a surface has the size 1, however thin the triangle is.
        let size = match N {
            2 => Interval::one(),
            _ => corner.omega() * per_size,
        };
        // ∂|S|/∂ℓ = 2ℓ ∂|S|/∂ℓ² = ℓ Tr(∂g/∂ℓ² |_S) |S|; an edge outside of S has none.
        let rate = |(e, edge): (usize, &Vec<usize>)| {
            if !edge.iter().all(|v| hinge.contains(v)) {
                return Interval::zero();
            }
            let mut unit = vec![Interval::zero(); edges.len()];
            unit[e] = Interval::one();
            squares[e].sqrt() * corner.trace(&from_squares(&unit, base)) * size
        };
        let angle = Interval::angle(sin, cos);
        if !angle.is_positive() {
            return Err(degenerate(g, cell));
        }
        found.angles.push(angle);
        found
            .rates
            .push(edges.iter().enumerate().map(rate).collect());
        found.sizes.push(size);
    }
    Ok(found)
}

/// Vertex 0 and the base in each other's place.
fn swapped(base: usize, vertex: usize) -> usize {
    match vertex {
        0 => base,
        v if v == base => 0,
        v => v,
    }
}

/// The square of the length between two vertices of an N-simplex, from those by edge.
fn square<const N: usize>(squares: &[Interval], i: usize, j: usize) -> Interval {
    let place = subsets(N + 1, 2)
        .iter()
        .position(|e| e[0] == i.min(j) && e[1] == i.max(j));
    place.map_or(Interval::zero(), |e| squares[e])
}

/// The vertex with the shortest edges: in a thin triangle it is that of the largest angle. From there det g is a difference of
/// numbers that are not much larger.
fn base<const N: usize>(squares: &[Interval]) -> usize {
    let around = |v: usize| -> f64 {
        (0..=N)
            .map(|w| square::<N>(squares, v, w).high())
            .sum::<f64>()
    };
    let least = (0..=N).min_by(|&a, &b| around(a).total_cmp(&around(b)));
    least.expect("a simplex has vertices")
}

/// g_ij = ½(q_0i + q_0j − q_ij) in reference coordinates, from q by edge, with the base for vertex 0.
fn from_squares<const N: usize>(squares: &[Interval], base: usize) -> Mat<Interval, N> {
    let q = |i: usize, j: usize| square::<N>(squares, swapped(base, i), swapped(base, j));
    symmetric(|i, j| (q(0, i + 1) + q(0, j + 1) - q(i + 1, j + 1)) * Interval::half())
}

/// det g|_S of a hinge with these vertices, relative to its own reference coordinates: 1 for a vertex of a surface.
fn det_on<const N: usize>(squares: &[Interval], hinge: &[usize]) -> Interval {
    let q = |i: usize, j: usize| square::<N>(squares, hinge[i], hinge[j]);
    let on_s =
        |i: usize, j: usize| (q(0, i + 1) + q(0, j + 1) - q(i + 1, j + 1)) * Interval::half();
    // The rest of the matrix is that of the identity.
    let metric: Mat<Interval, N> = symmetric(|i, j| match i.max(j) < N - 2 {
        true => on_s(i, j),
        false if i == j => Interval::one(),
        false => Interval::zero(),
    });
    inverse_and_det(&metric).1
}

/// A cell with a pivot that may not be positive.
fn degenerate<const N: usize>(g: &ReggeFunction<f64, N>, cell: usize) -> Error {
    let squares: Vec<Interval> = g.local(cell).into_iter().map(Interval::exactly).collect();
    let middle = from_squares::<N>(&squares, 0).map(|x| (x.low() + x.high()) / 2.0);
    match indefinite_pivot(&middle) {
        Some(pivot) => Error::Indefinite {
            cell,
            point: vec![1.0 / (N as f64 + 1.0); N + 1],
            pivot,
        },
        None => Error::Cell {
            cell,
            reason: "it is so flat that its angles cannot be enclosed".to_owned(),
        },
    }
}
