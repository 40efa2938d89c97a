//! Floor 7. R_h^(q): the L²(Ω, g_h)-projection of the distributional curvature onto Lagrange functions.
//!
//! u ∈ V_h with ∫ u v ω(g_h) = ⟨(Rω)_dist(g_h), v⟩ for all v ∈ V_h, Lagrange functions of degree q. Paper: section 1.
//! The paper's functional is defined for v that vanish on ∂Ω, and so is u; with the boundary terms of
//! [`boundary_curvature`](crate::functional::boundary_curvature) all of the Lagrange space may be taken.

mod hats;

use crate::Error;
use crate::density::Volume;
use crate::field::{Evaluate, TensorField};
use crate::linalg::inverse_and_det;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::scalar::Real;
use crate::simplex::binomial;
use crate::spaces::Lagrange;
use crate::sparse::{Factor, Kept, Lower};
use hats::HatMass;
use nalgebra::DMatrix;

/// The test functions of a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tested {
    /// Those that vanish on the boundary.
    Interior,
    /// All.
    All,
}

/// The mass matrix of a Lagrange space in L²(Ω, g), ready to be solved with.
#[derive(Debug)]
pub struct Projection {
    len: usize,
    mass: Mass,
}

#[derive(Debug)]
enum Mass {
    /// Of hat functions.
    Hats(HatMass),
    /// Of functions of a higher degree, factorised, with those that are unknowns; none where there is no unknown.
    Factorised(Kept, Option<Box<Factor>>),
}

impl Projection {
    /// The projection in the metric g, integrals by a rule on cells.
    ///
    /// # Errors
    /// If memory does not suffice, or g is not positive definite at the points of the rule.
    pub fn new<const N: usize, G: TensorField<N, Scalar = f64>>(
        g: &G,
        space: &Lagrange<N>,
        tested: Tested,
        rule: &Rule,
    ) -> Result<Self, Error> {
        let mass = match space.degree() {
            1 => Mass::Hats(HatMass::new(g, space.mesh(), tested, rule)?),
            _ => factorised(g, space, tested, rule)?,
        };
        let len = space.len();
        Ok(Self { len, mass })
    }

    /// About how many bytes the projection onto functions of a degree takes on a mesh with so many simplices of each dimension.
    ///
    /// Hat functions are solved for by iteration and take next to nothing. For others a factor by minimum degree fills up as one by
    /// dissection does, with constants a little above what was measured: 45 to 62 bytes for N = 2, 200 to 274 up to 10⁵ functions and
    /// more than 325 for 3.6·10⁵ for N = 3, 80 to 130 for N = 4.
    pub fn memory(simplices: &[usize], degree: usize) -> f64 {
        let counts = simplices.iter().enumerate();
        let functions: usize = counts
            .map(|(k, count)| count * binomial(degree - 1, k))
            .sum();
        let functions = functions as f64;
        match (degree, simplices.len() - 1) {
            (1, _) => 0.0,
            (_, 2) => 72.0 * functions * functions.max(2.0).log2(),
            (_, 3) => 400.0 * functions.powf(4.0 / 3.0),
            (_, n) => 150.0 * functions.powf(2.0 - 2.0 / n as f64),
        }
    }

    /// The coefficients of u from ⟨f, v⟩ for every basis function v; 0 where v is not tested.
    ///
    /// # Errors
    /// If a volume form is all but degenerate in a cell.
    ///
    /// # Panics
    /// If the load has not an entry for each basis function.
    pub fn apply(&self, load: &[f64]) -> Result<Vec<f64>, Error> {
        assert_eq!(load.len(), self.len, "a load of another space");
        let (kept, factor) = match &self.mass {
            Mass::Hats(mass) => return mass.solve(load),
            Mass::Factorised(kept, factor) => (kept, factor),
        };
        let mut x = kept.gather(load);
        if let Some(factor) = factor {
            factor.solve(&mut x);
        }
        Ok(kept.scatter(&x))
    }
}

fn factorised<const N: usize, G: TensorField<N, Scalar = f64>>(
    g: &G,
    space: &Lagrange<N>,
    tested: Tested,
    rule: &Rule,
) -> Result<Mass, Error> {
    let is_kept = |dof| tested == Tested::All || space.vanishes_on_boundary(dof);
    let cells = space.mesh().cell_count();
    let kept = Kept::new(space.len(), is_kept, cells, |cell| space.cell_dofs(cell))?;
    let factor = match kept.is_empty() {
        true => None,
        false => {
            let mass = mass::<G::Wide, G, N>(g, space, &kept, rule)?;
            Some(Box::new(Factor::new(&mass)?))
        }
    };
    Ok(Mass::Factorised(kept, factor))
}

/// The matrix ∫ v_i v_j ω of the unknowns.
fn mass<T: Real<Sum = f64>, G: Evaluate<T, N>, const N: usize>(
    g: &G,
    space: &Lagrange<N>,
    kept: &Kept,
    rule: &Rule,
) -> Result<Lower, Error> {
    let blocks = |cell: usize| kept.blocks(space.cell_dofs(cell));
    let cells = space.mesh().cell_count();
    let mut mass = kept.matrix(cells, &blocks)?;
    let table = g.tabulate(rule.points());
    let basis = space.basis(N).tabulate::<T>(rule.points());
    let weights = rule.weight_blocks::<T>();
    let size = space.cell_len();
    let on_cell = |cell: usize| {
        let local = g.on_cell(cell);
        let mut sums = vec![T::zero(); size * size];
        for ((block, weight), basis) in weights.iter().enumerate().zip(&basis) {
            let (_, det) = inverse_and_det(&g.value(&local, &table, block));
            let scale = Volume::from_det(det) * *weight;
            for j in 0..size {
                let scaled = scale * basis[j];
                for i in j..size {
                    sums[j * size + i] += scaled * basis[i];
                }
            }
        }
        DMatrix::from_fn(size, size, |i, j| sums[j * size + i].reduce())
    };
    in_order(cells, on_cell, |cell, matrix| {
        mass.add(&blocks(cell), &matrix)
    });
    Ok(mass)
}
