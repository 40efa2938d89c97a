//! M06: eq. integralformula, and M05 along a finite path: the difference of two curvatures as an integral over t.

use super::fields::{Regge, Tested, metric, minus};
use super::setting::{Draw, OnMesh, QUADRATURE, Setting, Shape};
use super::variation::orders;
use crate::claim::{Equation, Judgement, Method, Record};
use regge::field::{Combination, TensorField};
use regge::formulas::Formulas;
use regge::functional::{
    Rules, a_h_with, b_h_with, distributional_curvature_with, smooth_curvature,
};
use regge::lagrange::Lagrange;
use regge::linalg::Mat;
use regge::mesh::Mesh;
use regge::metrics::Metric;
use regge::quadrature::gauss_legendre;
use regge::regge::{Interpolant, Projection, ReggeSpace, geodesic_interpolant};
use regge::scalar::Real;
use regge::smooth::{Smooth, SmoothTensor};

/// How many Gauss points in t: the integrand is analytic in t far beyond [0, 1].
const POINTS_IN_T: usize = 8;

/// ∫₀¹ b_h dt and −∫₀¹ a_h dt by n Gauss points in t.
struct Path<'a, K, G, H, const N: usize> {
    ends: (&'a G, &'a H),
    space: &'a Lagrange<'a, N>,
    rules: &'a Rules,
    formulas: std::marker::PhantomData<K>,
}

impl<K: Formulas, G: TensorField<f64, N>, H: TensorField<f64, N>, const N: usize>
    Path<'_, K, G, H, N>
{
    fn integral(&self, points: usize) -> [Vec<f64>; 2] {
        let (from, to) = self.ends;
        let sigma = Combination::new(-1.0, from, 1.0, to);
        let mut sums = [vec![0.0; self.space.len()], vec![0.0; self.space.len()]];
        let (nodes, weights) = gauss_legendre(points);
        for (t, w) in nodes.into_iter().zip(weights) {
            let g = Combination::segment(from, to, t);
            let b = b_h_with::<K, f64, N, _, _>(&g, &sigma, self.space, self.rules).total();
            let a = a_h_with::<K, f64, N, _, _>(&g, &sigma, self.space, self.rules).total();
            for i in 0..b.len() {
                sums[0][i] += w * b[i];
                sums[1][i] -= w * a[i];
            }
        }
        sums.map(|s| Tested::Inner.of(self.space, &s))
    }

    /// ⟨(Rω)_dist(to), v⟩ − ⟨(Rω)_dist(from), v⟩ = ∫ b_h − ∫ a_h; with fewer points in t it must not hold.
    fn equation(&self, name: &'static str, to: Vec<f64>, from: Vec<f64>) -> Equation<f64> {
        let [b, a] = self.integral(POINTS_IN_T);
        let inner = |v: &[f64]| Tested::Inner.of(self.space, v);
        let mut equation = Equation::new(name)
            .left("⟨(Rω)_dist(g_h),v⟩", inner(&to))
            .left("−⟨(Rω)(g),v⟩", minus(&inner(&from)))
            .right("∫b_h dt", b)
            .right("−∫a_h dt", a)
            .vanishes(N == 2, "(Gω)_dist = 0 when N = 2");
        // The margins show how fast it converges in t: three points are nearly enough.
        let names = ["1 Gauss point in t", "2 Gauss points in t"];
        for (points, name) in (1..).zip(names) {
            let [b, a] = self.integral(points);
            equation = equation
                .forge_terms(name, vec![("∫b_h dt", b), ("−∫a_h dt", a)])
                .somewhere();
        }
        equation
    }
}

/// A smooth metric on a small patch: the formula at a third of the coordinates, so that one cell sees little of it
/// and rules of moderate order integrate to rounding.
#[derive(Clone, Copy, Debug)]
struct Patch(Metric);

impl<const N: usize> SmoothTensor<N> for Patch {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        self.0.at(&x.map(|x| x * S::ratio(1, 3) + S::ratio(1, 5)))
    }
}

/// ⟨(Rω)_dist(g_h) − (Rω)(g), v⟩ = ∫₀¹ b_h − a_h dt.
pub struct M06;

impl M06 {
    /// Every interpolant of the formula.
    fn interpolants<'s, const N: usize>(
        space: &'s ReggeSpace<'s, N>,
        g: &Smooth<'_, Patch, N>,
    ) -> Vec<(&'static str, Regge<'s, f64, N>)> {
        let projection = || Projection::exact::<N>(space.degree());
        let all = [
            ("canonical", Interpolant::Canonical { order: 16 }),
            ("averaged", Interpolant::Average(projection())),
            (
                "averaged, hierarchical",
                Interpolant::AverageHierarchical(projection()),
            ),
        ];
        let mut found: Vec<_> = (all.iter())
            .filter_map(|(name, i)| Some((*name, i.apply(space, g).ok()?)))
            .collect();
        if space.degree() == 0
            && let Ok(geodesic) = geodesic_interpolant(space, g.formula())
        {
            found.push(("geodesic", geodesic));
        }
        found
    }
}

impl OnMesh for M06 {
    const RECORD: Record = Record {
        label: "M06",
        paper: &["integralformula"],
        title: "The error as an integral along the segment from g to g_h",
        statement: r"\langle (R\omega)_{\rm dist}(g_h) - (R\omega)(g),v\rangle = \int_0^1 b_h(\tilde g(t);\sigma,v) -
            a_h(\tilde g(t);\sigma,v)\,dt,\quad \tilde g(t)=(1-t)g+tg_h,\ \sigma=g_h-g",
        sides: "Left: two curvature functionals. Right: the forms b_h and a_h at points between them. No derivative in t is \
            taken anywhere.",
    };
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let degrees = if quick { 2 } else { 3 };
        let of = |shape, order| {
            (0..degrees)
                .map(move |r| Setting::new(shape, r, order))
                .collect()
        };
        match dimension {
            2 => of(Shape::Cube(2), 20),
            3 => of(Shape::Alfeld, 22),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let mesh: Mesh<N> = at.shape.mesh();
        let Ok(g) = Smooth::new(&mesh, Patch(Metric::Trig)) else {
            return Vec::new();
        };
        let regge = ReggeSpace::new(&mesh, at.degree);
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let smooth = smooth_curvature::<f64, N, _>(&g, &space, &rules.element);
        let found = Self::interpolants(&regge, &g);
        assert!(
            found.len() >= 3 + usize::from(at.degree == 0),
            "every interpolant exists"
        );
        let one = |(name, g_h): &(&'static str, Regge<'_, f64, N>)| {
            let path = Path::<K, _, _, N> {
                ends: (&g, g_h),
                space: &space,
                rules: &rules,
                formulas: std::marker::PhantomData,
            };
            let to = distributional_curvature_with::<K, f64, N, _>(g_h, &space, &rules);
            path.equation(name, to.total(), smooth.clone())
        };
        found.iter().map(one).collect()
    }
}

/// M05 along a path: two arbitrary Regge metrics as ends.
pub struct Between;

impl OnMesh for Between {
    const RECORD: Record = Record {
        ..super::variation::M05::RECORD
    };
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        // Two ends: twice as far from a flat metric.
        let orders = orders(dimension).map(|o| if o > 2 { o + 2 } else { o });
        let all =
            |shapes: &[Shape]| super::setting::grid(shapes, &orders, if quick { 1 } else { 2 });
        match dimension {
            2 => all(&[Shape::Alfeld, Shape::Torus(3), Shape::Sphere]),
            3 => {
                let mut cases = super::setting::grid(&[Shape::Torus(3)], &orders[..1], 1);
                cases.extend(all(&[Shape::Alfeld, Shape::Sphere]));
                cases
            }
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let (from, to) = (metric(&regge, draw), metric(&regge, draw));
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let curvature = |g: &Regge<'_, f64, N>| {
            distributional_curvature_with::<K, f64, N, _>(g, &space, &rules).total()
        };
        let path = Path::<K, _, _, N> {
            ends: (&from, &to),
            space: &space,
            rules: &rules,
            formulas: std::marker::PhantomData,
        };
        vec![path.equation(
            "between two Regge metrics",
            curvature(&to),
            curvature(&from),
        )]
    }
}
