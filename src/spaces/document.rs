//! Regge functions written down with serde (feature `serde`).
//!
//! In JSON: `{"version": 1, "degree": 1, "mesh": {…}, "coefficients": […]}`, the coefficients in the order of the space's numbering.

use super::{ReggeFunction, ReggeSpace};
use crate::Error;
use crate::mesh::{Mesh, Version};

/// A Regge function as it is written.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document<C, const N: usize> {
    version: Version,
    degree: usize,
    mesh: Mesh<N>,
    coefficients: Vec<C>,
}

impl<C: Copy, const N: usize> From<ReggeFunction<C, N>> for Document<C, N> {
    fn from(function: ReggeFunction<C, N>) -> Self {
        Self {
            version: Version,
            degree: function.space().degree(),
            mesh: function.space().mesh().clone(),
            coefficients: function.coefficients().to_vec(),
        }
    }
}

impl<C: Copy, const N: usize> TryFrom<Document<C, N>> for ReggeFunction<C, N> {
    type Error = Error;

    fn try_from(document: Document<C, N>) -> Result<Self, Error> {
        let (mesh, degree, count) = (&document.mesh, document.degree, document.coefficients.len());
        // Seen before tables are made for a degree that nobody can have meant.
        if dimension(mesh, degree) != count as f64 {
            return Err(Error::Input(format!(
                "{count} coefficients do not fit a Regge space of degree {degree} on this mesh"
            )));
        }
        ReggeSpace::new(mesh, degree).function(document.coefficients)
    }
}

/// The dimension Σ_k |𝒯^k| C(r+1, k) k(k+1)/2 of the Regge space, which need not fit into memory: the whole numbers in f64 are
/// exact as long as anybody can have so many coefficients.
fn dimension<const N: usize>(mesh: &Mesh<N>, degree: usize) -> f64 {
    let on_simplices = |k: usize| {
        let choose = |b: f64, i: usize| b * (degree as f64 + 1.0 - i as f64) / (i + 1) as f64;
        let per_simplex = (0..k).fold(1.0, choose) * (k * (k + 1) / 2) as f64;
        mesh.count(k) as f64 * per_simplex
    };
    (1..=N).map(on_simplices).sum()
}
