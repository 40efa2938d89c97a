//! Regge's action, its gradient in the edge lengths, and Schläfli's identity. Degree 0: lengths are all there is.

use super::boundary::boundary_curvature;
use super::curvature::distributional_curvature;
use super::local::Wedges;
use super::Rules;
use crate::Error;
use crate::field::{Combination, TensorField};
use crate::lagrange::Lagrange;
use crate::mesh::Mesh;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::regge::{BasisFunction, ReggeFunction};
use crate::scalar::{Field, Real};
use crate::simplex::subsets;
use num_dual::Dual64;
use std::f64::consts::{PI, TAU};

/// (½⟨(Rω)_dist(g), 1⟩, ½ of the boundary terms): for degree 0 Σ̊_S Θ_S |S| and Σ_{S⊂∂Ω} (π − Σ_T θ_ST) |S|.
///
/// Their sum is the action: half the Einstein–Hilbert action with the boundary terms that make it stationary, under
/// variations that keep the boundary's metric, exactly where the distributional Einstein tensor vanishes.
pub fn regge_action<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    mesh: &Mesh<N>,
    rules: &Rules,
) -> [T::Sum; 2] {
    let hats = Lagrange::new(mesh, 1);
    let inside = distributional_curvature::<T, N, G>(g, &hats, rules);
    let outside = boundary_curvature::<T, N, G>(g, &hats, rules);
    [inside, outside].map(|sums| {
        let mut total = T::Sum::zero();
        for value in sums.total() {
            total += value;
        }
        total * T::Sum::half()
    })
}

/// The derivatives of the action in the edge lengths.
#[derive(Clone, Debug, PartialEq)]
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
pub fn action_gradient<const N: usize>(
    g: &ReggeFunction<'_, f64, N>,
) -> Result<ActionGradient, Error> {
    let (space, mesh) = (g.space(), g.space().mesh());
    if space.degree() != 0 {
        let reason = format!(
            "the action has edge lengths for variables in degree 0, not {}",
            space.degree()
        );
        return Err(Error::Input(reason));
    }
    let defects = signed_defects(g);
    let mut result = ActionGradient {
        gradient: vec![0.0; mesh.count(1)],
        schlaefli: 0.0,
    };
    let moving = Moving::new(g);
    let wedges = Wedges::<Dual64, N, _>::new(&moving.field, &moving.rule);
    let on_cell = |cell: usize| moving.derivatives(&wedges, cell);
    in_order(mesh.cells(), on_cell, |cell, derivatives| {
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

/// Θ_S, or π − Σ_T θ_ST on the boundary, of every hinge of a piecewise flat metric.
fn signed_defects<const N: usize>(g: &ReggeFunction<'_, f64, N>) -> Vec<f64> {
    let mesh = g.space().mesh();
    let wedges = Wedges::<f64, N, _>::new(g, &Rule::new(N - 2, 0));
    let mut all = Vec::with_capacity(mesh.count(N - 2));
    let on_hinge = |hinge: usize| {
        let full = if mesh.is_interior(N - 2, hinge) { TAU } else { PI };
        full - wedges.around(mesh, hinge)[0].0
    };
    in_order(mesh.count(N - 2), on_hinge, |_, defect| all.push(defect));
    all
}

/// What the lengths of a cell's edges change in it.
struct CellDerivatives {
    /// ∂|S|/∂ℓ_e, `[e][S]`.
    volumes: Vec<Vec<f64>>,
    /// Σ_S |S| ∂θ_S/∂ℓ_e, by e.
    schlaefli: Vec<f64>,
}

/// g + ε ψ: a metric one of whose squared lengths moves.
type Along<'a, 's, const N: usize> =
    Combination<&'a ReggeFunction<'s, f64, N>, BasisFunction<'s, N>, Dual64>;

fn along<'a, 's, const N: usize>(g: &'a ReggeFunction<'s, f64, N>, i: usize) -> Along<'a, 's, N> {
    let direction = BasisFunction::new(g.space(), i);
    Combination::new(Dual64::from(1.0), g, Dual64::new(0.0, 1.0), direction)
}

/// The corners of cells whose edges move, one at a time.
struct Moving<'a, 's, const N: usize> {
    g: &'a ReggeFunction<'s, f64, N>,
    /// Any direction will do: what moves is in the data of the cell.
    field: Along<'a, 's, N>,
    rule: Rule,
    hinges: usize,
}

impl<'a, 's, const N: usize> Moving<'a, 's, N> {
    fn new(g: &'a ReggeFunction<'s, f64, N>) -> Self {
        Self {
            g,
            field: along(g, 0),
            rule: Rule::new(N - 2, 0),
            hinges: subsets(N + 1, N - 1).len(),
        }
    }

    fn derivatives(&self, wedges: &Wedges<'_, Dual64, N, Along<'a, 's, N>>, cell: usize) -> CellDerivatives {
        let mut all = CellDerivatives {
            volumes: Vec::new(),
            schlaefli: Vec::new(),
        };
        for &edge in self.g.space().mesh().simplices_of(cell, 1) {
            let local = along(self.g, edge as usize).on_cell(cell);
            // In degree 0 the coefficients are the squared lengths, and ∂/∂ℓ = 2ℓ ∂/∂(ℓ²).
            let slope = 2.0 * self.g.coefficients()[edge as usize].sqrt();
            let corners: Vec<(Dual64, Dual64)> = (0..self.hinges)
                .map(|place| {
                    let (angle, omega_s) = wedges.at(&local, place, 0);
                    (angle, omega_s * wedges.weights[0])
                })
                .collect();
            let turned = corners.iter().map(|(angle, size)| size.re * angle.eps);
            all.schlaefli.push(slope * turned.sum::<f64>());
            let grown = corners.iter().map(|(_, size)| slope * size.eps);
            all.volumes.push(grown.collect());
        }
        all
    }
}
