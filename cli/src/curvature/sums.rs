//! All that is summed for a report, from one evaluation of the curvature for each order of quadrature.

use super::report::Parts;
use super::settle::{LOAD_SETTLES, SUMS_SETTLE, Settles, all_finite, lists, relative_change};
use regge_curvature::TensorField;
use regge_curvature::functional::{Rules, Sums, boundary_curvatures, distributional_curvatures};
use regge_curvature::norm::DualNorm;
use regge_curvature::spaces::{Indicators, Lagrange, Scalar, TestSpace};

/// The sums of def:distcurv and, if asked for, the boundary's.
#[derive(Clone, Debug)]
pub struct AllSums {
    /// Cells, interior faces, interior hinges.
    pub inner: Sums<f64>,
    /// The boundary terms, by test function; none for the paper's functional.
    pub boundary: Option<Vec<f64>>,
}

impl AllSums {
    /// By test function.
    pub fn parts(&self) -> Vec<Parts> {
        Parts::of(&self.inner, self.boundary.as_deref())
    }

    /// The whole functional, by test function.
    pub fn total(&self) -> Vec<f64> {
        self.parts().iter().map(|parts| parts.total).collect()
    }

    fn lists(&self) -> Vec<&[f64]> {
        let outer = self.boundary.as_deref();
        lists(&self.inner).into_iter().chain(outer).collect()
    }
}

/// What the curvature is paired with.
pub struct Tests<'a, const N: usize> {
    /// The hat functions.
    pub hats: Lagrange<N>,
    /// Test functions of another degree.
    pub finer: Option<Lagrange<N>>,
    /// The simplices one by one.
    pub simplices: Option<Indicators<N>>,
    /// Those of a norm.
    pub norm: Option<&'a dyn DualNorm<N>>,
    /// Are the terms of the boundary wanted?
    pub boundary: bool,
}

/// ∫ R v ω of the smooth metric for the test functions of the norm, by these rules.
pub type SmoothLoad<'a> = &'a dyn Fn(&Rules) -> Vec<f64>;

/// The curvature by one order.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// Against hat functions.
    pub hats: AllSums,
    /// Against the functions of another degree.
    pub finer: Option<AllSums>,
    /// Simplex by simplex; factor 2 included.
    pub simplices: Option<Sums<f64>>,
    /// The functional whose norm is wanted.
    pub load: Option<Vec<f64>>,
}

impl<const N: usize> Tests<'_, N> {
    /// The highest degree of a test function.
    pub fn degree(&self) -> usize {
        self.finer.as_ref().map_or(1, Lagrange::degree)
    }

    /// Evaluates the curvature by these rules, once, and pairs it with all of them.
    pub fn evaluate<G: TensorField<N, Scalar = f64>>(
        &self,
        g_h: &G,
        smooth: SmoothLoad<'_>,
        rules: &Rules,
    ) -> Evaluation {
        let mut spaces: Vec<&dyn TestSpace<N, Value = Scalar>> = vec![&self.hats];
        spaces.extend(
            self.finer
                .iter()
                .map(|s| s as &dyn TestSpace<N, Value = Scalar>),
        );
        let with_boundary = spaces.len();
        let outer = self
            .boundary
            .then(|| boundary_curvatures(g_h, &spaces, rules));
        spaces.extend(
            self.simplices
                .iter()
                .map(|s| s as &dyn TestSpace<N, Value = Scalar>),
        );
        spaces.extend(
            self.norm
                .map(|n| n.space() as &dyn TestSpace<N, Value = Scalar>),
        );
        let mut sums = distributional_curvatures(g_h, &spaces, rules).into_iter();
        let outer = outer.map_or(vec![None; with_boundary], |sums| {
            sums.iter().map(|sums| Some(sums.total())).collect()
        });
        let mut outer = outer.into_iter();
        let mut next = || sums.next().expect("sums for every space");
        let mut both = || AllSums {
            inner: next(),
            boundary: outer.next().expect("a boundary for each of these spaces"),
        };
        Evaluation {
            hats: both(),
            finer: self.finer.as_ref().map(|_| both()),
            simplices: self.simplices.as_ref().map(|_| next()),
            load: self.norm.map(|_| difference(next().total(), smooth(rules))),
        }
    }
}

fn difference(ours: Vec<f64>, smooth: Vec<f64>) -> Vec<f64> {
    let pairs = ours.into_iter().zip(smooth);
    pairs.map(|(ours, smooth)| ours - smooth).collect()
}

impl Settles for Evaluation {
    fn change_since(&self, before: &Self) -> f64 {
        let mut change = relative_change(&before.hats.lists(), &self.hats.lists());
        if let (Some(before), Some(after)) = (&before.finer, &self.finer) {
            change = change.max(relative_change(&before.lists(), &after.lists()));
        }
        if let (Some(before), Some(after)) = (&before.load, &self.load) {
            let load = relative_change(&[before], &[after]);
            change = change.max(load * SUMS_SETTLE / LOAD_SETTLES);
        }
        change
    }

    fn is_finite(&self) -> bool {
        let finer = self.finer.as_ref();
        let sums = all_finite(&self.hats.lists()) && finer.is_none_or(|s| all_finite(&s.lists()));
        sums && self.load.as_ref().is_none_or(|load| all_finite(&[load]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use regge_curvature::field::Evaluate;
    use regge_curvature::jet::{Jet1, Jet2};
    use regge_curvature::linalg::Mat;
    use regge_curvature::norm::{Kind, Setting};
    use regge_curvature::scalar::{Number, Real};
    use regge_curvature::simplex::Points;
    use regge_curvature::{Interpolant, Mesh, Metric, ReggeFunction, ReggeSpace, Smooth};
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// A Regge function that counts how often it is asked for second derivatives, which R alone needs.
    struct Counted {
        g: ReggeFunction<f64, 2>,
        asked: AtomicUsize,
    }

    impl<T: Real> Evaluate<T, 2> for Counted
    where
        f64: regge_curvature::scalar::Lift<T>,
    {
        type Table = <ReggeFunction<f64, 2> as Evaluate<T, 2>>::Table;
        type Local = <ReggeFunction<f64, 2> as Evaluate<T, 2>>::Local;

        fn tabulate(&self, points: &Points) -> Self::Table {
            Evaluate::<T, 2>::tabulate(&self.g, points)
        }

        fn on_cell(&self, cell: usize) -> Self::Local {
            Evaluate::<T, 2>::on_cell(&self.g, cell)
        }

        fn jet2(&self, at: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, 2>, 2> {
            self.asked.fetch_add(1, Ordering::Relaxed);
            self.g.jet2(at, table, block)
        }

        fn jet1(&self, at: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, 2>, 2> {
            self.g.jet1(at, table, block)
        }
    }

    impl TensorField<2> for Counted {
        type Scalar = f64;
        type Wide = <f64 as Number>::Wide;
    }

    /// Hat functions, those of another degree, simplices and a norm: R is evaluated once at each point for all of them.
    #[test]
    fn everything_is_paired_with_one_evaluation() {
        let mesh = Mesh::<2>::cube(3).expect("a square");
        let space = ReggeSpace::new(&mesh, 1);
        let sphere = Smooth::new(&mesh, Metric::Sphere).expect("coordinates");
        let g = Interpolant::canonical()
            .apply(&space, &sphere)
            .expect("a metric");
        let norm = Kind::named("hm2").expect("a norm");
        let norm = (norm.new)(&Setting::new(&mesh, 3)).expect("a norm");
        let tests = Tests {
            hats: Lagrange::new(&mesh, 1),
            finer: Some(Lagrange::new(&mesh, 3)),
            simplices: Some(Indicators::new(&mesh)),
            norm: Some(&*norm),
            boundary: true,
        };
        let (rules, none) = (Rules::on(&mesh, 8), vec![0.0; norm.space().len()]);
        let counted = Counted {
            g,
            asked: AtomicUsize::new(0),
        };
        let all = tests.evaluate(&counted, &|_| none.clone(), &rules);
        let blocks = rules.cells.points().blocks::<<f64 as Number>::Wide>();
        let asked = counted.asked.load(Ordering::Relaxed);
        assert_eq!(asked, mesh.cell_count() * blocks);
        // They are of one functional: with v = 1 all of them give the same.
        let whole = |sums: &Sums<f64>| sums.total().iter().sum::<f64>();
        let one = whole(&all.hats.inner);
        let finer = all.finer.expect("asked for");
        for other in [
            whole(&finer.inner),
            whole(&all.simplices.expect("asked for")),
            all.load.expect("asked for").iter().sum(),
        ] {
            assert!((other - one).abs() < 1e-11 * one.abs(), "{other} {one}");
        }
    }
}
