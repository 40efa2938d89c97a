//! Equations as vectors: what integrals over them and comparisons of their sizes need.

use super::equation::Equation;

impl Equation<f64> {
    /// Σ w_i e_i, equation by equation, of lists of the same form: an integral, term by term.
    pub fn weighted(weights: &[f64], lists: Vec<Vec<Self>>) -> Vec<Self> {
        let mut sum: Vec<Self> = Vec::new();
        for (w, list) in weights.iter().zip(lists) {
            let scaled = list.into_iter().map(|e| e.times(*w));
            sum = if sum.is_empty() {
                scaled.collect()
            } else {
                sum.into_iter()
                    .zip(scaled)
                    .map(|(a, b)| a.plus(b))
                    .collect()
            };
        }
        sum
    }

    /// Does it fail, and so does this equation of the same form, which is of much the same size? Where everything
    /// vanishes, rounding alone would fail.
    pub fn fails_like(&self, other: &Self, tolerance: f64) -> bool {
        let fails = |e: &Self| !e.is_poisoned() && e.residual(&[]) > tolerance;
        fails(self) && fails(other) && self.scale() > 1e-2 * other.scale()
    }

    /// All its vectors, those of the forgeries included.
    fn vectors(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        let forged = self.forged.iter_mut().flat_map(|f| &mut f.replaced);
        let terms = self.left.iter_mut().chain(&mut self.right);
        terms.map(|t| &mut t.value).chain(forged.map(|f| &mut f.1))
    }

    fn times(mut self, w: f64) -> Self {
        self.magnitude *= w.abs();
        for x in self.vectors().flatten() {
            *x *= w;
        }
        self
    }

    fn plus(mut self, mut other: Self) -> Self {
        self.magnitude += other.magnitude;
        for (x, y) in self.vectors().flatten().zip(other.vectors().flatten()) {
            *x += *y;
        }
        self
    }
}
