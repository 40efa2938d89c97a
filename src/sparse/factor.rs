//! A sparse Cholesky factorisation by faer.

use super::analysis::analyse;
use super::lower::Lower;
use super::memory;
use crate::Error;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::supernodal::{
    SupernodalLltRef, SymbolicSupernodalCholesky, factorize_supernodal_numeric_llt,
    factorize_supernodal_numeric_llt_scratch,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

/// L with A = L Lᵀ; the unknowns are eliminated in the order of the matrix.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: SymbolicSupernodalCholesky<u32>,
    values: Vec<f64>,
}

/// Columns of L that are shorter than this on the average make products of blocks that are over before a second thread
/// is awake: measured, one thread takes 3/4 of the time for N = 2 (level 7, p = 4) and 2/3 for N = 3 (level 2, p = 4). Where
/// exactly two begin to pay was not measured: a block of 400 columns is milliseconds of work, a thread wakes in microseconds.
const LONG_COLUMN: usize = 400;

/// The degree of parallelism depends on the matrix alone, since the order of the sums depends on it.
fn parallelism(symbolic: &SymbolicSupernodalCholesky<u32>) -> Par {
    match symbolic.len_val() / symbolic.nrows().max(1) < LONG_COLUMN {
        true => Par::Seq,
        false => in_parallel(),
    }
}

/// The threads of faer's larger products: always as many, since the order of their sums depends on it.
#[cfg(feature = "parallel")]
pub(crate) fn in_parallel() -> Par {
    Par::rayon(2)
}

/// The threads of faer's larger products: none.
#[cfg(not(feature = "parallel"))]
pub(crate) fn in_parallel() -> Par {
    Par::Seq
}

impl Factor {
    /// The factor of a matrix with at least one row.
    ///
    /// # Errors
    /// If memory does not suffice, or the matrix is not positive definite.
    pub fn new(matrix: &Lower) -> Result<Self, Error> {
        let (columns, rows, entries) = (&matrix.columns, &matrix.rows, &matrix.values);
        let n = columns.len() - 1;
        let symbolic = analyse(matrix)?;
        // It is asked for first, since `vec!` aborts; and `vec!` writes no zeros over those that the system gives.
        let len = symbolic.len_val();
        if Vec::<f64>::new().try_reserve_exact(len).is_err() {
            let need = len as f64 * 8e-9;
            return Err(Error::Solver(format!(
                "{n} unknowns: the factor needs {need:.1} GB of memory"
            )));
        }
        let mut values = vec![0.0; len];
        let par = parallelism(&symbolic);
        let scratch = factorize_supernodal_numeric_llt_scratch::<u32, f64>(
            &symbolic,
            par,
            Default::default(),
        );
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, columns, None, rows);
        factorize_supernodal_numeric_llt(
            &mut values,
            SparseColMatRef::new(pattern, entries),
            Default::default(),
            &symbolic,
            par,
            MemStack::new(&mut memory(n, scratch)?),
            Default::default(),
        )
        .map_err(|_| Error::Solver(format!(
            "{n} unknowns: the matrix is positive definite, but not to double precision: cells that are stretched, or \
             a high degree, are too much for it; rounder cells or a lower degree may do"
        )))?;
        Ok(Self { symbolic, values })
    }

    /// x becomes A⁻¹ x.
    pub fn solve(&self, x: &mut [f64]) {
        let (n, par) = (x.len(), parallelism(&self.symbolic));
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(1, par);
        SupernodalLltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, n, 1),
            par,
            MemStack::new(&mut MemBuffer::new(scratch)),
        );
    }
}
