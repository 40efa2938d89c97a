//! D10: smooth metrics. M16: flat metrics in disguise.

use super::fields::{metric, values};
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use crate::claim::{Equation, Judgement, Record};
use regge::field::TensorField;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, distributional_curvature_with, smooth_curvature};
use regge::jet::Jet2;
use regge::lagrange::Lagrange;
use regge::linalg::{Mat, Vector, symmetric};
use regge::mesh::Mesh;
use regge::metrics::Metric;
use regge::regge::{Canonical, ReggeSpace};
use regge::simplex::{Bernstein, Points};
use regge::smooth::Smooth;

fn size(sums: &[&[f64]]) -> f64 {
    sums.iter()
        .flat_map(|s| s.iter())
        .fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// A smooth metric has no jumps.
pub struct D10;

impl OnMesh for D10 {
    const RECORD: Record = Record {
        label: "D10",
        paper: &["def:distcurv"],
        title: "For smooth metrics the distributional curvature is the curvature",
        statement: r"g\text{ smooth}:\quad [\![H]\!]_F=0,\ [\![I\!I]\!]_F=0,\ \Theta_S=0,\quad (R\omega)_{\rm dist}(g)=(R\omega)(g)",
        sides: "The production sums over faces and hinges of a metric that each cell sees in coordinates of its own; a factor \
            or normal that is wrong on one side leaves something behind.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let shapes: &[Shape] = if quick {
            &[Shape::Alfeld]
        } else {
            &[Shape::Alfeld, Shape::Cube(2)]
        };
        match dimension {
            2 | 3 => grid(shapes, &[3, 4], 1),
            4 => grid(&shapes[..1], &[3], 1),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let mut all = Vec::new();
        for formula in [Metric::Trig, Metric::GraphQuartic, Metric::Sphere] {
            let Ok(g) = Smooth::new(&mesh, formula) else {
                continue;
            };
            let sums = values(distributional_curvature_with::<K, f64, N, _>(
                &g, &space, &rules,
            ));
            let a = values(a_h_with::<K, f64, N, _, _>(&g, &g, &space, &rules));
            let smooth = smooth_curvature::<f64, N, _>(&g, &space, &rules.element);
            let large = size(&[&smooth]);
            all.push(
                Equation::new("(Rω)_dist")
                    .left("Σ_T ∫Rvω", sums.t)
                    .left("2Σ̊_F ∫⟦H⟧vω_F", sums.f)
                    .vanishes(true, "g is smooth")
                    .left("2Σ̊_S ∫Θvω_S", sums.s)
                    .vanishes(true, "g is smooth")
                    .right("∫Rvω", smooth)
                    .magnitude(large),
            );
            all.push(
                Equation::new("(Gω)_dist")
                    .left("Σ̊_F ∫⟨⟦II‾⟧,g⟩vω_F", a.f)
                    .vanishes(true, "g is smooth")
                    .left("−Σ̊_S ∫Θ Tr(g|_S)vω_S", a.s)
                    .vanishes(true, "g is smooth")
                    .magnitude(large),
            );
        }
        all
    }
}

/// φ*δ for a continuous piecewise polynomial map φ of degree s: g_mn = ∂_mφ·∂_nφ.
struct PullBack<'m, const N: usize> {
    space: Lagrange<'m, N>,
    phi: Vec<Vector<f64, N>>,
}

impl<'m, const N: usize> PullBack<'m, N> {
    /// The identity, every coefficient moved by up to `noise`.
    fn new(mesh: &'m Mesh<N>, degree: usize, noise: f64, draw: &mut Draw) -> Self {
        let space = Lagrange::new(mesh, degree);
        let moves = draw.numbers(space.len() * N);
        let mut phi = vec![Vector::zeros(); space.len()];
        let basis = space.basis(N);
        for cell in 0..mesh.cells() {
            for (i, dof) in space.cell_dofs(cell).enumerate() {
                let mut x = Vector::from_fn(|m, _| noise * moves[dof * N + m]);
                for (v, &e) in basis.exponents()[i].iter().enumerate() {
                    if let Some(corner) = mesh.corner(cell, v) {
                        x += corner * (e as f64 / degree as f64);
                    }
                }
                phi[dof] = x;
            }
        }
        Self { space, phi }
    }
}

/// The jet whose derivatives nobody may use: they are poison.
pub fn value_only<const N: usize>(value: f64) -> Jet2<f64, N> {
    Jet2 {
        value,
        d: [f64::NAN; N],
        dd: [[f64::NAN; N]; N],
    }
}

impl<const N: usize> TensorField<f64, N> for PullBack<'_, N> {
    type Table = Vec<Vec<Jet2<f64, N>>>;
    type Local = Vec<Vector<f64, N>>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        Bernstein::new(N + 1, self.space.degree()).tabulate_jets(points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.space.cell_dofs(cell).map(|d| self.phi[d]).collect()
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let d = |m: usize| -> Vector<f64, N> {
            local.iter().zip(&table[q]).map(|(c, b)| c * b.d[m]).sum()
        };
        symmetric(|m, n| value_only(d(m).dot(&d(n))))
    }
}

/// φ*δ is flat.
pub struct M16;

impl OnMesh for M16 {
    const RECORD: Record = Record {
        label: "M16",
        paper: &[],
        title: "The pull-back of a flat metric by a piecewise polynomial homeomorphism is flat",
        statement: r"\varphi\in C^0,\ \varphi|_T\in P_s:\quad g=\varphi^*\delta\in{\rm Reg}^{2(s-1)}:\quad [\![I\!I]\!]_F=0,\
            \Theta_S=0,\ (R\omega)_{\rm dist}(g)=0,\ (G\omega)_{\rm dist}(g)=0",
        sides: "Each production sum, relative to its one-sided parts: the metric jumps across faces, its curvature does not.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 1 } else { 8 };
        let of = |shape, s: &[usize]| -> Vec<Setting> {
            let one = |s: &usize| vec![Setting::new(shape, *s, 4); times];
            s.iter().flat_map(one).collect()
        };
        match dimension {
            2 => of(Shape::Cube(2), &[1, 2]),
            3 => of(Shape::Alfeld, &[1, 2]),
            _ => Vec::new(),
        }
    }

    /// Here the setting's degree is s.
    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let field = PullBack::new(&mesh, at.degree, 0.03, draw);
        let regge = ReggeSpace::new(&mesh, 2 * (at.degree - 1));
        let canonical = Canonical::new(&regge);
        // It is a Regge metric of this degree: the canonical interpolant changes nothing.
        let g = super::fields::function(
            &regge,
            canonical.solve(&canonical.evaluate(&field, 4 * at.degree)),
        );
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let sums = values(distributional_curvature_with::<K, f64, N, _>(
            &g, &space, &rules,
        ));
        let a = values(a_h_with::<K, f64, N, _, _>(
            &g,
            &metric(&regge, draw),
            &space,
            &rules,
        ));
        // Angles of size 2π around hinges of size 1, and as much for H.
        let one = |name, sum: Vec<f64>| {
            Equation::new(name)
                .left("sum", sum)
                .vanishes(true, "it is the claim")
                .magnitude(1.0)
        };
        let other = metric(&regge, draw);
        let curved = values(distributional_curvature_with::<K, f64, N, _>(
            &other, &space, &rules,
        ));
        vec![
            one("Σ_T ∫Rvω", sums.t),
            one("Σ̊_F ∫⟦H⟧vω_F", sums.f),
            one("Σ̊_S ∫Θvω_S", sums.s).forge("a metric that is no pull-back", "sum", curved.s),
            one("Σ_T ∫⟨G,σ⟩vω", a.t),
            one("Σ̊_F ∫⟨⟦II‾⟧,σ⟩vω_F", a.f),
            one("Σ̊_S ∫Θ Tr(σ|_S)vω_S", a.s),
        ]
    }
}
