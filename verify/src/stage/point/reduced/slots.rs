//! Hands out the numbers of a reduced instance, and names them.

use crate::harness::{Ground, Timed, Variable};
use crate::stage::point::draw::vary1;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, zeros};

/// Hands out numbers one by one.
pub(super) struct Slots<'a, B> {
    numbers: Option<&'a [B]>,
    /// What they are.
    pub variables: Vec<Variable>,
}

impl<'a, B: Ground> Slots<'a, B> {
    /// These numbers; ones, if they are only to be named.
    pub fn new(numbers: Option<&'a [B]>) -> Self {
        Self {
            numbers,
            variables: Vec::new(),
        }
    }

    /// A number that may occur in denominators and under roots: it is positive.
    pub fn parameter(&mut self, name: String) -> B {
        self.take(String::new(), name)
    }

    /// A number of a group of its own.
    pub fn jet(&mut self, group: &str, name: String) -> B {
        self.take(group.to_owned(), name)
    }

    /// Any vector, a group of its own.
    pub fn vector<const N: usize>(&mut self, name: &str) -> Vector<B, N> {
        Vector::from_fn(|k, _| self.jet(name, format!("{name}_{}", k + 1)))
    }

    fn take(&mut self, group: String, name: String) -> B {
        let place = self.variables.len();
        self.variables.push(Variable { group, name });
        self.numbers.map_or(B::one(), |n| n[place])
    }

    /// A value that is given, or the next number.
    fn value(&mut self, given: Option<B>, symbol: &str, index: &str) -> B {
        given.unwrap_or_else(|| self.take(symbol.to_owned(), format!("{symbol}{index}")))
    }

    fn first(&mut self, symbol: &str, index: &str, m: usize) -> B {
        self.take(format!("∂{symbol}"), format!("∂{}{symbol}{index}", m + 1))
    }

    pub fn jet1<const N: usize>(
        &mut self,
        given: Option<B>,
        symbol: &str,
        index: &str,
    ) -> Jet1<B, N> {
        Jet1 {
            value: self.value(given, symbol, index),
            d: std::array::from_fn(|m| self.first(symbol, index, m)),
        }
    }

    pub fn jet2<const N: usize>(
        &mut self,
        given: Option<B>,
        symbol: &str,
        index: &str,
    ) -> Jet2<B, N> {
        let low: Jet1<B, N> = self.jet1(given, symbol, index);
        self.second(low, symbol, index)
    }

    /// With second derivatives, which are numbers.
    pub fn second<const N: usize>(
        &mut self,
        low: Jet1<B, N>,
        symbol: &str,
        index: &str,
    ) -> Jet2<B, N> {
        let mut jet = Jet2::constant(low.value);
        jet.d = low.d;
        for m in 0..N {
            for n in m..N {
                let name = format!("∂{}∂{}{symbol}{index}", m + 1, n + 1);
                jet.dd[m][n] = self.take(format!("∂²{symbol}"), name);
                jet.dd[n][m] = jet.dd[m][n];
            }
        }
        jet
    }

    /// A symmetric tensor, its value given or not.
    pub fn tensor<const N: usize>(
        &mut self,
        given: Option<&Mat<B, N>>,
        symbol: &str,
    ) -> Mat<Jet2<B, N>, N> {
        let mut a = zeros();
        for i in 0..N {
            for j in i..N {
                let index = format!("{}{}", i + 1, j + 1);
                a[(i, j)] = self.jet2(given.map(|g| g[(i, j)]), symbol, &index);
                a[(j, i)] = a[(i, j)];
            }
        }
        a
    }

    /// A time-dependent vector field, its value given or not.
    pub fn field<S: Timed<Base = B>, const N: usize>(
        &mut self,
        given: Option<&Vector<B, N>>,
        symbol: &str,
        suffix: &str,
    ) -> Vector<Jet1<S, N>, N> {
        let rate = format!("{symbol}̇");
        Vector::from_fn(|k, _| {
            let index = format!("{suffix}{}", k + 1);
            let still = self.jet1(given.map(|x| x[k]), symbol, &index);
            vary1(still, self.jet1(None, &rate, &index))
        })
    }
}
