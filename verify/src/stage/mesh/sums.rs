//! The three sums of the functionals as vectors over test functions.

use crate::harness::pairwise;
use num_dual::Dual64;
use regge_curvature::functional::Sums;
use regge_curvature::spaces::Lagrange;

/// The three sums over cells, faces and hinges.
#[derive(Clone, Debug)]
pub struct Three {
    /// Σ_T.
    pub t: Vec<f64>,
    /// Σ_F.
    pub f: Vec<f64>,
    /// Σ_S.
    pub s: Vec<f64>,
}

impl Three {
    /// The largest entry: what cancels in sums over test functions.
    pub fn largest(&self) -> f64 {
        let all = self.t.iter().chain(&self.f).chain(&self.s);
        all.fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// These sums minus others.
    pub fn less(&self, other: &Self) -> Self {
        let minus = |x: &[f64], y: &[f64]| pairwise(x, y, |x, y| x - y);
        Self {
            t: minus(&self.t, &other.t),
            f: minus(&self.f, &other.f),
            s: minus(&self.s, &other.s),
        }
    }
}

/// The sums of numbers.
pub fn values(sums: Sums<f64>) -> Three {
    Three {
        t: sums.cells,
        f: sums.faces,
        s: sums.hinges,
    }
}

/// d/dt of sums that depend on t.
pub fn rates(sums: &Sums<Dual64>) -> Three {
    let rate = |v: &Vec<Dual64>| v.iter().map(|x| x.eps).collect();
    Three {
        t: rate(&sums.cells),
        f: rate(&sums.faces),
        s: rate(&sums.hinges),
    }
}

/// Which test functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tested {
    /// Those that vanish on the boundary of the mesh: V.
    Inner,
    /// Those that do not.
    Outer,
    /// v = 1 alone.
    One,
}

impl Tested {
    /// The entries of these test functions. Bernstein's polynomials add up to 1.
    pub fn of<const N: usize>(self, space: &Lagrange<N>, all: &[f64]) -> Vec<f64> {
        let of_boundary = |inner: bool| {
            let mut some = Vec::new();
            for dof in 0..space.len() {
                if space.vanishes_on_boundary(dof) == inner {
                    some.push(all[dof]);
                }
            }
            some
        };
        match self {
            Self::Inner => of_boundary(true),
            Self::Outer => of_boundary(false),
            Self::One => vec![all.iter().sum()],
        }
    }

    /// The same of three sums.
    pub fn of_sums<const N: usize>(self, space: &Lagrange<N>, sums: &Three) -> Three {
        Three {
            t: self.of(space, &sums.t),
            f: self.of(space, &sums.f),
            s: self.of(space, &sums.s),
        }
    }
}

/// c v.
pub fn times(c: f64, v: &[f64]) -> Vec<f64> {
    v.iter().map(|x| c * x).collect()
}

/// −v.
pub fn minus(v: &[f64]) -> Vec<f64> {
    times(-1.0, v)
}
