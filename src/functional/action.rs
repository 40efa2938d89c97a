//! Regge's action, its gradient in the edge lengths, and Schläfli's identity. Degree 0: lengths are all there is.

use super::seen::{OnCell, Seen, all_sites, weights};
use super::{Rules, boundary_curvature, distributional_curvature};
use crate::Error;
use crate::field::{Combination, Evaluate, TensorField};
use crate::formulas::PAPER;
use crate::mesh::Mesh;
use crate::parallel::{collect, in_order};
use crate::scalar::{Field, Real};
use crate::simplex::binomial;
use crate::spaces::{BasisFunction, Lagrange, ReggeFunction};
use num_dual::{Dual64, HyperDual64};
use std::f64::consts::{PI, TAU};

/// Regge's action, by where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Action<T> {
    /// ½⟨(Rω)_dist(g), 1⟩: for degree 0 Σ̊_S Θ_S |S|.
    pub interior: T,
    /// ½ of the boundary terms: for degree 0 Σ_{S⊂∂Ω} (π − Σ_T θ_ST) |S|.
    pub boundary: T,
}

impl<T: Real> Action<T> {
    /// The action.
    pub fn total(&self) -> T {
        self.interior + self.boundary
    }
}

/// The action: half the Einstein–Hilbert action with the boundary terms that make it stationary, under
/// variations that keep the boundary's metric, exactly where the distributional Einstein tensor vanishes.
pub fn regge_action<const N: usize, G: TensorField<N>>(
    g: &G,
    mesh: &Mesh<N>,
    rules: &Rules,
) -> Action<G::Scalar> {
    let hats = Lagrange::new(mesh, 1);
    // The hat functions add up to one.
    let ones = vec![1.0; hats.len()];
    let half = G::Scalar::half();
    Action {
        interior: distributional_curvature(g, &hats, rules)
            .pair(&ones)
            .total()
            * half,
        boundary: boundary_curvature(g, &hats, rules).pair(&ones).total() * half,
    }
}

/// The derivatives of the action in the edge lengths.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ActionGradient {
    /// Σ_S Θ_S ∂|S|/∂ℓ by edge, with π − Σ_T θ_ST in place of Θ_S on the boundary: the whole derivative of the action.
    pub gradient: Vec<f64>,
    /// The largest |Σ_{S⊂T} |S| ∂θ_ST/∂ℓ| over all cells T and edges: 0 up to rounding by Schläfli's identity, which
    /// is why the derivatives of the angles do not appear in the gradient.
    pub schlaefli: f64,
}

/// Regge's equations: the gradient of the action in the edge lengths, by automatic differentiation cell by cell.
///
/// Angles and volumes are those of the curvature's own code at dual numbers: one tangent direction for each edge of
/// each cell.
///
/// # Errors
/// If the degree of g is not 0.
pub fn action_gradient<const N: usize>(g: &ReggeFunction<f64, N>) -> Result<ActionGradient, Error> {
    check_degree(g)?;
    let mesh = g.space().mesh();
    let defects = signed_defects(g);
    let mut result = ActionGradient {
        gradient: vec![0.0; mesh.count(1)],
        schlaefli: 0.0,
    };
    let moving = Moving::new(g);
    let field = along(g, 0);
    let corners = moving.seen(&field);
    let on_cell = |cell: usize| moving.derivatives(&corners, cell);
    in_order(mesh.cell_count(), on_cell, |cell, derivatives| {
        for (e, &edge) in mesh.simplices_of(cell, 1).iter().enumerate() {
            for (place, &hinge) in mesh.simplices_of(cell, N - 2).iter().enumerate() {
                // Each hinge counts once: in its first cell.
                if mesh.first_side(N - 2, hinge as usize).cell == cell {
                    result.gradient[edge as usize] +=
                        defects[hinge as usize] * derivatives.volumes[e][place];
                }
            }
            result.schlaefli = result.schlaefli.max(derivatives.schlaefli[e].abs());
        }
    });
    Ok(result)
}

/// A summand of an entry of the Hessian.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HessianEntry {
    /// The edge of the row.
    pub row: usize,
    /// The edge of the column.
    pub column: usize,
    /// What is to be added there.
    pub value: f64,
}

/// The Hessian of the action in the edge lengths: entries to be added up, both triangles.
///
/// ∂²/∂ℓ_i∂ℓ_j = Σ_S ∂Θ_S/∂ℓ_j ∂|S|/∂ℓ_i + Θ_S ∂²|S|/∂ℓ_i∂ℓ_j, since Schläfli's identity may be differentiated.
///
/// # Errors
/// If the degree of g is not 0.
pub fn action_hessian<const N: usize>(
    g: &ReggeFunction<f64, N>,
) -> Result<Vec<HessianEntry>, Error> {
    check_degree(g)?;
    let mesh = g.space().mesh();
    let defects = signed_defects(g);
    let moving = Moving::new(g);
    let (once, twice) = (along(g, 0), along_two(g, [0, 0]));
    let (first, second) = (moving.seen(&once), moving.seen(&twice));
    let mut entries = Vec::new();
    let on_cell = |cell: usize| {
        let own = |hinge: &u32| mesh.first_side(N - 2, *hinge as usize).cell == cell;
        let hinges = mesh.simplices_of(cell, N - 2);
        let turned: Vec<f64> = (hinges.iter())
            .map(|h| if own(h) { defects[*h as usize] } else { 0.0 })
            .collect();
        let derivatives = moving.derivatives(&first, cell);
        moving.cell_hessian(&second, cell, &derivatives, &turned)
    };
    in_order(mesh.cell_count(), on_cell, |_, local| entries.extend(local));
    Ok(entries)
}

pub(super) fn check_degree<const N: usize>(g: &ReggeFunction<f64, N>) -> Result<(), Error> {
    match g.space().degree() {
        0 => Ok(()),
        r => Err(Error::Input(format!(
            "the action has edge lengths for variables in degree 0, not {r}"
        ))),
    }
}

/// Θ_S, or π − Σ_T θ_ST on the boundary, of every hinge of a piecewise flat metric.
fn signed_defects<const N: usize>(g: &ReggeFunction<f64, N>) -> Vec<f64> {
    let mesh = g.space().mesh();
    let rules = Rules::new(N, 0);
    let seen = Seen::<f64, N, _>::new(g, &all_sites(N, &rules), &PAPER);
    let angle = |side: crate::mesh::Side| {
        let local = seen.on_cell(side.cell);
        seen.corner(&local, side.place, 0, |corner| corner.angle())
    };
    collect(mesh.count(N - 2), |hinge| {
        let full = if mesh.is_interior(N - 2, hinge) {
            TAU
        } else {
            PI
        };
        full - mesh.star(N - 2, hinge).map(angle).sum::<f64>()
    })
}

/// What the lengths of a cell's edges change in it.
struct CellDerivatives {
    /// ∂|S|/∂ℓ_e, `[e][S]`.
    volumes: Vec<Vec<f64>>,
    /// ∂θ_ST/∂ℓ_e, `[e][S]`.
    angles: Vec<Vec<f64>>,
    /// Σ_S |S| ∂θ_S/∂ℓ_e, by e.
    schlaefli: Vec<f64>,
}

/// g + ε ψ: a metric one of whose squared lengths moves.
type Along<'a, const N: usize> = Combination<&'a ReggeFunction<f64, N>, BasisFunction<N>, Dual64>;

fn along<'a, const N: usize>(g: &'a ReggeFunction<f64, N>, i: usize) -> Along<'a, N> {
    let direction = BasisFunction::new(g.space(), i);
    Combination::new(Dual64::from(1.0), g, Dual64::new(0.0, 1.0), direction)
}

/// The corners of cells whose edges move, one or two at a time.
struct Moving<'a, const N: usize> {
    g: &'a ReggeFunction<f64, N>,
    rules: Rules,
    /// The weight of the one point on a hinge.
    weight: f64,
    hinges: usize,
}

impl<'a, const N: usize> Moving<'a, N> {
    fn new(g: &'a ReggeFunction<f64, N>) -> Self {
        let rules = Rules::new(N, 0);
        Self {
            g,
            weight: weights::<f64>(&rules.hinges)[0],
            rules,
            hinges: binomial(N + 1, 2),
        }
    }

    /// A field of the kind that moves. In which direction does not matter here: that is in the data of a cell.
    fn seen<'f, T: Real, F: Evaluate<T, N>>(&self, field: &'f F) -> Seen<'f, T, N, F> {
        Seen::new(field, &all_sites(N, &self.rules), &PAPER)
    }

    fn derivatives(
        &self,
        corners: &Seen<'_, Dual64, N, Along<'a, N>>,
        cell: usize,
    ) -> CellDerivatives {
        let mut all = CellDerivatives {
            volumes: Vec::new(),
            angles: Vec::new(),
            schlaefli: Vec::new(),
        };
        for &edge in self.g.space().mesh().simplices_of(cell, 1) {
            let local = corners.on(along(self.g, edge as usize).on_cell(cell));
            // In degree 0 the coefficients are the squared lengths, and ∂/∂ℓ = 2ℓ ∂/∂(ℓ²).
            let slope = 2.0 * self.g.coefficients()[edge as usize].sqrt();
            let moved: Vec<(Dual64, Dual64)> = (0..self.hinges)
                .map(|place| {
                    let (angle, omega) = at(corners, &local, place);
                    (angle, omega * self.weight)
                })
                .collect();
            let turned = moved.iter().map(|(angle, size)| size.re * angle.eps);
            all.schlaefli.push(slope * turned.sum::<f64>());
            let angles = moved.iter().map(|(angle, _)| slope * angle.eps);
            all.angles.push(angles.collect());
            let grown = moved.iter().map(|(_, size)| slope * size.eps);
            all.volumes.push(grown.collect());
        }
        all
    }

    /// The Hessian of a cell: −Σ_S ∂θ_ST/∂ℓ_j ∂|S|/∂ℓ_i, and Θ_S ∂²|S|/∂ℓ_i∂ℓ_j of the hinges that count here.
    fn cell_hessian(
        &self,
        corners: &Seen<'_, HyperDual64, N, AlongTwo<'a, N>>,
        cell: usize,
        derivatives: &CellDerivatives,
        defects: &[f64],
    ) -> Vec<HessianEntry> {
        let edges = self.g.space().mesh().simplices_of(cell, 1);
        let lengths: Vec<f64> = (edges.iter())
            .map(|&e| self.g.coefficients()[e as usize].sqrt())
            .collect();
        let mut entries = Vec::with_capacity(edges.len() * edges.len());
        for i in 0..edges.len() {
            for j in 0..edges.len() {
                let pair = [edges[i] as usize, edges[j] as usize];
                let local = corners.on(along_two(self.g, pair).on_cell(cell));
                let mut sum = 0.0;
                for (place, defect) in defects.iter().enumerate() {
                    let grown = derivatives.volumes[i][place];
                    sum -= derivatives.angles[j][place] * grown;
                    if *defect != 0.0 {
                        let (_, omega) = at(corners, &local, place);
                        // From squared lengths to lengths: (ℓ²)′ = 2ℓ and (ℓ²)″ = 2.
                        let mixed = (omega * self.weight).eps1eps2;
                        let bent = if i == j { grown / lengths[i] } else { 0.0 };
                        sum += defect * (4.0 * lengths[i] * lengths[j] * mixed + bent);
                    }
                }
                entries.push(HessianEntry {
                    row: pair[0],
                    column: pair[1],
                    value: sum,
                });
            }
        }
        entries
    }
}

/// (θ_ST, ω_S) of a cell that moves.
fn at<T: Real, const N: usize, F: Evaluate<T, N>>(
    corners: &Seen<'_, T, N, F>,
    local: &OnCell<F::Local, T, N>,
    place: usize,
) -> (T, T) {
    corners.corner(local, place, 0, |corner| (corner.angle(), corner.omega()))
}

/// g + ε₁ ψ_i + ε₂ ψ_j: a metric two of whose squared lengths move.
type AlongTwo<'a, const N: usize> = Combination<
    Combination<&'a ReggeFunction<f64, N>, BasisFunction<N>, HyperDual64>,
    BasisFunction<N>,
    HyperDual64,
>;

fn along_two<'a, const N: usize>(
    g: &'a ReggeFunction<f64, N>,
    [i, j]: [usize; 2],
) -> AlongTwo<'a, N> {
    let (one, space) = (HyperDual64::from(1.0), g.space());
    let first = HyperDual64::new(0.0, 1.0, 0.0, 0.0);
    let second = HyperDual64::new(0.0, 0.0, 1.0, 0.0);
    let inner = Combination::new(one, g, first, BasisFunction::new(space, i));
    Combination::new(one, inner, second, BasisFunction::new(space, j))
}
