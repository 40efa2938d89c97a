//! How large the discrete problem is, from numbers of simplices alone: before there is a mesh.

use super::layout::{own, slopes};
use crate::simplex::binomial;

/// The sizes of a [`super::Hhj`] problem.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Size {
    /// How many k-simplices, k = 0…N.
    simplices: Vec<usize>,
    /// p ≥ 1, the degree of u.
    degree: usize,
}

impl Size {
    /// On a mesh with so many k-simplices, k = 0…N, by u of degree p ≥ 1.
    pub fn new(simplices: &[usize], degree: usize) -> Self {
        Self {
            simplices: simplices.to_vec(),
            degree,
        }
    }

    /// N.
    pub fn dimension(&self) -> usize {
        self.simplices.len() - 1
    }

    /// p.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// How many cells.
    pub fn cells(&self) -> usize {
        self.simplices[self.dimension()]
    }

    /// How many coefficients u and û have, bubbles included.
    pub fn coefficients(&self) -> usize {
        self.sum(|k| self.own(k) + self.slopes(k))
    }

    /// How many coefficients u has.
    pub fn functions(&self) -> usize {
        self.sum(|k| self.own(k))
    }

    /// How many coefficients are left when the bubbles are condensed, clamped ones included.
    pub fn unknowns(&self) -> usize {
        self.sum(|k| self.width(k))
    }

    /// How many coefficients a cell sees, its bubbles excluded.
    pub fn outer(&self) -> usize {
        let n = self.dimension();
        (0..n).map(|k| binomial(n + 1, k + 1) * self.width(k)).sum()
    }

    /// How many entries the lower triangles of the simplices' diagonal blocks have.
    pub fn blocks(&self) -> usize {
        self.sum(|k| self.width(k) * (self.width(k) + 1) / 2)
    }

    /// How many u belong to a k-simplex.
    fn own(&self, k: usize) -> usize {
        own(k, self.degree)
    }

    /// How many û belong to a k-simplex.
    fn slopes(&self, k: usize) -> usize {
        match k + 1 == self.dimension() {
            true => slopes(self.dimension(), self.degree),
            false => 0,
        }
    }

    /// How many unknowns belong to a k-simplex when the bubbles are condensed.
    fn width(&self, k: usize) -> usize {
        match k == self.dimension() {
            true => 0,
            false => self.own(k) + self.slopes(k),
        }
    }

    fn sum(&self, per_simplex: impl Fn(usize) -> usize) -> usize {
        let counts = self.simplices.iter().enumerate();
        counts.map(|(k, count)| count * per_simplex(k)).sum()
    }
}
