//! M06: eq. integralformula, the difference of two curvatures as an integral over t; and at one t, by AD.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape};
use crate::stage::fields::{Patch, Regge};
use crate::stage::mesh::{OnMesh, POINTS_IN_T, QUADRATURE, Tested, Three, minus, rates, too_few};
use num_dual::Dual64;
use regge_curvature::field::Combination;
use regge_curvature::functional::{Rules, a_h, b_h, distributional_curvature, smooth_curvature};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// A smooth metric g and one of its interpolants g_h.
struct Ends<const N: usize> {
    g: Smooth<Patch<N>, N>,
    g_h: Regge<f64, N>,
    space: Lagrange<N>,
    rules: Rules,
}

impl<const N: usize> Ends<N> {
    /// Those of a case.
    fn draw(at: &Setting, draw: &mut Draw) -> Self {
        let mesh: Mesh<N> = at.shape.mesh();
        let patch = Patch::new(Metric::Trig, draw);
        let g = Smooth::new(&mesh, patch).expect("the mesh has coordinates");
        let regge = ReggeSpace::new(&mesh, at.degree);
        Self {
            g_h: interpolant(at.pick, &regge, &g),
            g,
            space: Lagrange::new(&mesh, at.test),
            rules: at.rules(N),
        }
    }

    fn inner(&self, v: &[f64]) -> Vec<f64> {
        Tested::Inner.of(&self.space, v)
    }

    /// b_h and −a_h at t.
    fn forms(&self, t: f64) -> [Vec<f64>; 2] {
        let sigma = Combination::new(-1.0, &self.g, 1.0, &self.g_h);
        let g = Combination::segment(&self.g, &self.g_h, t);
        let b = b_h(&g, &sigma, &self.space, &self.rules).total();
        let a = a_h(&g, &sigma, &self.space, &self.rules).total();
        [self.inner(&b), minus(&self.inner(&a))]
    }

    /// ∫₀¹ b_h dt and −∫₀¹ a_h dt by n Gauss points.
    fn integral(&self, points: usize) -> [Vec<f64>; 2] {
        let mut sums: [Vec<f64>; 2] = Default::default();
        let (nodes, weights) = gauss_legendre(points);
        for (t, w) in nodes.into_iter().zip(weights) {
            for (sum, form) in sums.iter_mut().zip(self.forms(t)) {
                sum.resize(form.len(), 0.0);
                for (s, x) in sum.iter_mut().zip(form) {
                    *s += w * x;
                }
            }
        }
        sums
    }

    /// ⟨(Rω)_dist(g_h), v⟩ − ⟨(Rω)(g), v⟩ = ∫ b_h − ∫ a_h; with fewer points in t it must not hold.
    fn equation(&self, at: &Setting) -> Equation<f64> {
        let (space, rules) = (&self.space, &self.rules);
        let to = distributional_curvature(&self.g_h, space, rules).total();
        let from = smooth_curvature(&self.g, space, rules);
        let [b, a] = self.integral(POINTS_IN_T);
        let mut equation = Equation::new("integral formula")
            .left("⟨(Rω)_dist(g_h),v⟩", self.inner(&to))
            .left("−⟨(Rω)(g),v⟩", minus(&self.inner(&from)))
            .right("∫b_h dt", b)
            .right("−∫a_h dt", a)
            .vanishes(N == 2, NONE);
        // The margins show how fast it converges in t.
        for (points, name) in too_few(at, N) {
            let [b, a] = self.integral(points);
            equation = equation
                .forge_terms(name, vec![("∫b_h dt", b), ("−∫a_h dt", a)])
                .somewhere();
        }
        equation
    }

    /// d/dt ⟨(Rω)_dist((1−t)g + tg_h), v⟩ = b_h − a_h at this t.
    fn rate_equation(&self, t: f64) -> Equation<f64> {
        let moving = Combination::segment(&self.g, &self.g_h, Dual64::new(t, 1.0));
        let (space, rules) = (&self.space, &self.rules);
        let sums = distributional_curvature(&moving, space, rules);
        let Three { t: cells, f, s } = Tested::Inner.of_sums(space, &rates(&sums));
        let [b, a] = self.forms(t);
        let curvature = smooth_curvature(&self.g, space, rules);
        Equation::new("at one t")
            .left("d/dt Σ_T ∫Rvω", cells)
            .left("d/dt 2Σ̊_F ∫⟦H⟧vω_F", f)
            .left("d/dt 2Σ̊_S ∫Θvω_S", s)
            .right("b_h", b)
            .right("−a_h", a)
            .vanishes(N == 2, NONE)
            // σ is a small difference of two metrics: what is rounded is of their size.
            .magnitude(self.inner(&curvature))
    }
}

const NONE: &str = "(Gω)_dist = 0 when N = 2";

/// The interpolants of a degree.
fn interpolants(degree: usize) -> Vec<Interpolant> {
    Interpolant::ALL
        .into_iter()
        .filter(|one| one.check_degree(degree).is_ok())
        .collect()
}

fn interpolant<const N: usize>(
    pick: usize,
    regge: &ReggeSpace<N>,
    g: &Smooth<Patch<N>, N>,
) -> Regge<f64, N> {
    let chosen = interpolants(regge.degree())[pick];
    // It is near g, which is positive definite.
    chosen
        .apply(regge, g)
        .unwrap_or_else(|e| panic!("{}: {e}", chosen.name()))
}

/// Every interpolant of every degree, so many times.
fn settings(dimension: usize, degrees: usize, times: usize) -> Vec<Setting> {
    let (shape, order) = match dimension {
        2 => (Shape::Cube(2), 24),
        _ => (Shape::Alfeld, 26),
    };
    let of = |degree| {
        let at = Setting::new(shape, degree, order);
        let count = interpolants(degree).len();
        (0..count * times).map(move |i| Setting {
            pick: i % count,
            ..at
        })
    };
    (0..degrees).flat_map(of).collect()
}

/// ⟨(Rω)_dist(g_h) − (Rω)(g), v⟩ = ∫₀¹ b_h − a_h dt.
pub struct M06;

impl OnMesh for M06 {
    const RECORD: Record = Record {
        label: "M06",
        paper: &["integralformula"],
        title: "The error as an integral along the segment from g to g_h",
        statement: r"\langle (R\omega)_{\rm dist}(g_h) - (R\omega)(g),v\rangle = \int_0^1 b_h(\tilde g(t);\sigma,v) -
            a_h(\tilde g(t);\sigma,v)\,dt,\quad \tilde g(t)=(1-t)g+tg_h,\ \sigma=g_h-g",
        sides: "Left: two curvature functionals. Right: the forms b_h and a_h at points between them, which have no integral \
            in common with them. No derivative in t is taken anywhere; by AD, one is, at a random t.",
    };
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        if quick {
            settings(dimension, 2, 1)
        } else {
            settings(dimension, 3, 4)
        }
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        vec![Ends::<N>::draw(at, draw).equation(at)]
    }
}

/// Its integrand.
pub struct AtOneTime;

impl OnMesh for AtOneTime {
    const RECORD: Record = M06::RECORD;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = M06::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        settings(dimension, if quick { 2 } else { 3 }, 1)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let t = draw.numbers(1)[0].abs();
        vec![Ends::<N>::draw(at, draw).rate_equation(t)]
    }
}
