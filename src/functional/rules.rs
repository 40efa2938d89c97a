//! The quadrature of the three sums, and the sums.

use crate::formulas::{Formulas, PAPER};
use crate::mesh::Mesh;
use crate::quadrature::Rule;
use crate::scalar::Real;

/// The quadrature rules of the three sums, in dimensions N, N−1 and N−2.
#[derive(Clone, Debug)]
pub struct Rules {
    /// On cells.
    pub cells: Rule,
    /// On faces.
    pub faces: Rule,
    /// On hinges.
    pub hinges: Rule,
    /// By which formulas densities are computed.
    pub(crate) formulas: Formulas,
}

impl Rules {
    /// Rules exact for polynomials of degree ≤ `order` on the simplices of a mesh.
    ///
    /// The integrands are not polynomials: see [`Rules::default_order`].
    pub fn on<const N: usize>(_mesh: &Mesh<N>, order: usize) -> Self {
        Self::new(N, order)
    }

    /// The same for the meshes of dimension N ≥ 2.
    pub fn new(dimension: usize, order: usize) -> Self {
        Self::of(
            Rule::new(dimension, order),
            Rule::new(dimension - 1, order),
            Rule::new(dimension - 2, order),
        )
    }

    /// These rules, on cells, faces and hinges.
    pub fn of(cells: Rule, faces: Rule, hinges: Rule) -> Self {
        Self {
            cells,
            faces,
            hinges,
            formulas: PAPER,
        }
    }

    /// Densities by other formulas than the paper's, for a sceptic.
    #[cfg(feature = "formulas")]
    #[doc(hidden)]
    pub fn with_formulas(mut self, formulas: Formulas) -> Self {
        self.formulas = formulas;
        self
    }

    /// The order at which integration is not what limits the accuracy: 2(r+2)+2 for a metric of degree r, against
    /// test functions of degree r+2.
    ///
    /// On the paper's meshes with k ≥ 1 raising it changes the H⁻² error by less than 3·10⁻⁴ of itself; with two
    /// triangles for the whole square (k = 0) it takes 20 more (`tests/quadrature_order.rs`).
    pub fn default_order(degree: usize) -> usize {
        2 * (degree + 2) + 2
    }
}

/// Three sums over the simplices of a mesh, for every test function, signs and factors included.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Lists<T>")
)]
pub struct Sums<T> {
    /// Σ_T, by test function.
    pub cells: Vec<T>,
    /// Σ_F, by test function.
    pub faces: Vec<T>,
    /// Σ_S, by test function.
    pub hinges: Vec<T>,
}

/// Sums as they are read.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Lists<T> {
    cells: Vec<T>,
    faces: Vec<T>,
    hinges: Vec<T>,
}

#[cfg(feature = "serde")]
impl<T> TryFrom<Lists<T>> for Sums<T> {
    type Error = crate::Error;

    fn try_from(lists: Lists<T>) -> Result<Self, Self::Error> {
        let Lists {
            cells,
            faces,
            hinges,
        } = lists;
        let [one, two, three] = [cells.len(), faces.len(), hinges.len()];
        if one != two || one != three {
            return Err(crate::Error::Input(format!(
                "sums over cells, faces and hinges for {one}, {two} and {three} test functions, not one number of them"
            )));
        }
        Ok(Self {
            cells,
            faces,
            hinges,
        })
    }
}

impl<T: Real> Sums<T> {
    /// All zero.
    pub(super) fn zero(len: usize) -> Self {
        Self {
            cells: vec![T::zero(); len],
            faces: vec![T::zero(); len],
            hinges: vec![T::zero(); len],
        }
    }

    /// The whole functional, by test function.
    pub fn total(&self) -> Vec<T> {
        (0..self.cells.len()).map(|i| self.of(i).total()).collect()
    }

    /// The three sums for the test function v_i.
    pub fn of(&self, i: usize) -> Three<T> {
        Three {
            cells: self.cells[i],
            faces: self.faces[i],
            hinges: self.hinges[i],
        }
    }

    /// The three sums for v = Σ c_i v_i. With all c_i = 1, v = 1.
    pub fn pair(&self, coefficients: &[f64]) -> Three<T> {
        let of = |sum: &[T]| {
            let mut value = T::zero();
            for (s, c) in sum.iter().zip(coefficients) {
                value += *s * T::from_f64(*c);
            }
            value
        };
        Three {
            cells: of(&self.cells),
            faces: of(&self.faces),
            hinges: of(&self.hinges),
        }
    }
}

/// The three sums for one test function.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Three<T> {
    /// Σ_T.
    pub cells: T,
    /// Σ_F.
    pub faces: T,
    /// Σ_S.
    pub hinges: T,
}

impl<T: Real> Three<T> {
    /// The sum of the three.
    pub fn total(&self) -> T {
        self.cells + self.faces + self.hinges
    }
}
