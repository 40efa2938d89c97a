//! Floor 0. Best constants: the least C with A ≤ C B for two quadratic forms on a finite element space.
//!
//! C B − A is positive definite if and only if its Cholesky factorisation exists. So both ends of the bracket that
//! bisection finds are certified up to rounding: by a factorisation that succeeds, and by one that fails.

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Mat, Side};
use nalgebra::DMatrix;
use regge_curvature::Error;

/// An unknown that is held at zero.
pub const HELD: usize = usize::MAX;

/// A quadratic form, summed up from small symmetric matrices.
#[derive(Clone, Debug, Default)]
pub struct Form {
    size: usize,
    /// Entries on and below the diagonal: column, row, value.
    entries: Vec<(u32, u32, f64)>,
}

impl Form {
    /// Zero, in so many unknowns.
    pub fn zero(size: usize) -> Self {
        Self {
            size,
            entries: Vec::new(),
        }
    }

    /// Adds a symmetric matrix in these unknowns.
    pub fn add(&mut self, unknowns: &[usize], local: &DMatrix<f64>) {
        for (c, &column) in unknowns.iter().enumerate() {
            for (r, &row) in unknowns.iter().enumerate() {
                // The list of a face may have an unknown twice: both entries count.
                if row != HELD && column != HELD && row >= column && local[(r, c)] != 0.0 {
                    self.entries
                        .push((column as u32, row as u32, local[(r, c)]));
                }
            }
        }
    }

    /// Adds 2 xᵀ B y for a matrix B between two lists of unknowns, all of the second after all of the first.
    pub fn add_between(&mut self, x: &[usize], y: &[usize], b: &DMatrix<f64>) {
        for (i, &column) in x.iter().enumerate() {
            for (j, &row) in y.iter().enumerate() {
                if row != HELD && column != HELD {
                    self.entries.push((column as u32, row as u32, b[(i, j)]));
                }
            }
        }
    }

    /// Its value.
    pub fn energy(&self, x: &[f64]) -> f64 {
        let of = |(c, r, value): &(u32, u32, f64)| {
            let twice = if c == r { 1.0 } else { 2.0 };
            twice * value * x[*c as usize] * x[*r as usize]
        };
        self.entries.iter().map(of).sum()
    }

    /// Adds a form in the unknowns from `start` on.
    pub fn add_shifted(&mut self, start: usize, other: &Self) {
        let moved = |&(c, r, x): &(u32, u32, f64)| (c + start as u32, r + start as u32, x);
        self.entries.extend(other.entries.iter().map(moved));
    }

    /// Adds a multiple of another form.
    pub fn add_form(&mut self, factor: f64, other: &Self) {
        let scaled = other.entries.iter().map(|&(c, r, x)| (c, r, factor * x));
        self.entries.extend(scaled);
    }
}

/// Two forms in one pattern.
struct Pencil {
    pattern: SymbolicSparseColMat<usize>,
    symbolic: SymbolicLlt<usize>,
    /// The entries of A and B.
    values: Vec<[f64; 2]>,
}

impl Pencil {
    fn new(a: &Form, b: &Form) -> Result<Self, Error> {
        let mut all: Vec<(u32, u32, [f64; 2])> = Vec::new();
        all.extend(a.entries.iter().map(|&(c, r, x)| (c, r, [x, 0.0])));
        all.extend(b.entries.iter().map(|&(c, r, x)| (c, r, [0.0, x])));
        all.sort_by_key(|&(c, r, _)| (c, r));
        let (mut starts, mut rows) = (vec![0; b.size + 1], Vec::new());
        let mut values: Vec<[f64; 2]> = Vec::new();
        let mut last = None;
        for (c, r, [x, y]) in all {
            match (last == Some((c, r)), values.last_mut()) {
                (true, Some(value)) => *value = [value[0] + x, value[1] + y],
                _ => {
                    last = Some((c, r));
                    starts[c as usize + 1] += 1;
                    rows.push(r as usize);
                    values.push([x, y]);
                }
            }
        }
        for c in 0..b.size {
            starts[c + 1] += starts[c];
        }
        let pattern = SymbolicSparseColMat::new_checked(b.size, b.size, starts, None, rows);
        let symbolic = SymbolicLlt::try_new(pattern.as_ref(), Side::Lower)
            .map_err(|e| Error::Solver(format!("{} unknowns: {e}", b.size)))?;
        Ok(Self {
            pattern,
            symbolic,
            values,
        })
    }

    /// The factor of C B − A, if it is positive definite.
    fn factor(&self, c: f64) -> Option<Llt<usize, f64>> {
        let values: Vec<f64> = self.values.iter().map(|[a, b]| c * b - a).collect();
        let matrix = SparseColMatRef::new(self.pattern.as_ref(), &values);
        Llt::try_new_with_symbolic(self.symbolic.clone(), matrix, Side::Lower).ok()
    }

    fn is_positive(&self, c: f64) -> bool {
        self.factor(c).is_some()
    }
}

/// How far apart the ends of the bracket are, relatively.
const NARROW: f64 = 1e-3;

/// A constant below 10⁻¹² is zero, above 10¹² there is none.
const RANGE: f64 = 1e12;

/// The least C with A ≤ C B, or rather the upper end of a bracket around it of width 10⁻³: C B − A has a Cholesky factor.
///
/// # Errors
/// If B is not positive definite, so that there is no such C.
pub fn best_constant(a: &Form, b: &Form) -> Result<f64, Error> {
    let pencil = Pencil::new(a, b)?;
    let (mut low, mut high) = (0.5, 1.0);
    while !pencil.is_positive(high) {
        (low, high) = (high, 4.0 * high);
        if high > RANGE {
            return Err(Error::Solver(
                "there is no constant: a form is not definite".into(),
            ));
        }
    }
    while low > 1.0 / RANGE && pencil.is_positive(low) {
        (low, high) = (low / 4.0, low);
    }
    while high > low * (1.0 + NARROW) {
        let middle = (low * high).sqrt();
        match pencil.is_positive(middle) {
            true => high = middle,
            false => low = middle,
        }
    }
    Ok(high)
}

/// Is A ≤ C B, by a Cholesky factor of (C + 10⁻⁹) B − A?
///
/// # Errors
/// If memory does not suffice.
pub fn is_certified(a: &Form, b: &Form, c: f64) -> Result<bool, Error> {
    Ok(Pencil::new(a, b)?.is_positive(c + 1e-9))
}

/// The greatest |f(v)|/B(v, v)^{1/2}: the norm of a functional in the dual of the space that B is a norm of.
///
/// # Errors
/// If B is not positive definite.
pub fn dual_norm(b: &Form, f: &[f64]) -> Result<f64, Error> {
    let factor = Pencil::new(&Form::zero(b.size), b)?.factor(1.0);
    let factor = factor.ok_or_else(|| Error::Solver("a form is not definite".into()))?;
    let solution = factor.solve(Mat::from_fn(f.len(), 1, |i, _| f[i]));
    let square: f64 = f
        .iter()
        .enumerate()
        .map(|(i, f)| f * solution[(i, 0)])
        .sum();
    Ok(square.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    /// 2xy against x² + 4y²: the best constant is ½. The held unknown plays no part.
    #[test]
    fn the_best_constant_of_two_small_forms() {
        let (mut a, mut b) = (Form::zero(2), Form::zero(2));
        a.add_between(&[0, HELD], &[1], &dmatrix![1.0; 7.0]);
        b.add(
            &[0, HELD, 1],
            &dmatrix![1.0, 5.0, 0.0; 5.0, 1.0, 5.0; 0.0, 5.0, 2.0],
        );
        b.add(&[1], &dmatrix![2.0]);
        let c = best_constant(&a, &b).unwrap();
        assert!((0.5..0.5006).contains(&c), "{c}");
        assert!(is_certified(&a, &b, 0.5).unwrap() && !is_certified(&a, &b, 0.499).unwrap());
    }

    /// x + 2y against x² + 4y²: √2 at (1, ½).
    #[test]
    fn the_norm_of_a_small_functional() {
        let mut b = Form::zero(2);
        b.add(&[0, 1], &dmatrix![1.0, 0.0; 0.0, 4.0]);
        let norm = dual_norm(&b, &[1.0, 2.0]).unwrap();
        assert!((norm - 2.0_f64.sqrt()).abs() < 1e-14, "{norm}");
        assert!(dual_norm(&Form::zero(2), &[1.0, 2.0]).is_err());
    }

    #[test]
    fn an_indefinite_form_has_none() {
        let (mut a, mut b) = (Form::zero(2), Form::zero(2));
        a.add(&[1], &dmatrix![1.0]);
        b.add(&[0, 1], &dmatrix![1.0, 0.0; 0.0, -1.0]);
        assert!(best_constant(&a, &b).is_err());
    }
}
