//! M16: flat metrics in disguise.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, list, pairwise};
use crate::stage::fields::{Regge, function, metric, value_only};
use crate::stage::mesh::{OnMesh, POINTS_IN_T, Pair, QUADRATURE, ROUNDING, Tested, values};
use regge_curvature::field::{Evaluate, TensorField};
use regge_curvature::functional::{a_h, distributional_curvature};
use regge_curvature::interpolate::Canonical;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::simplex::{Bernstein, Points};
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// φ*δ for a continuous piecewise polynomial map φ of degree s: g_mn = ∂_mφ·∂_nφ. Or, with another map ψ, the
/// symmetric ½(∂_mφ·∂_nψ + ∂_mψ·∂_nφ).
struct PullBack<const N: usize> {
    space: Lagrange<N>,
    phi: Vec<Vector<f64, N>>,
    psi: Vec<Vector<f64, N>>,
}

impl<const N: usize> PullBack<N> {
    /// By one map.
    fn new(mesh: &Mesh<N>, degree: usize, phi: Vec<Vector<f64, N>>) -> Self {
        Self::polarised(mesh, degree, phi.clone(), phi)
    }

    fn polarised(
        mesh: &Mesh<N>,
        degree: usize,
        phi: Vec<Vector<f64, N>>,
        psi: Vec<Vector<f64, N>>,
    ) -> Self {
        let space = Lagrange::new(mesh, degree);
        Self { space, phi, psi }
    }
}

/// The coefficients of the identity as a map of degree s.
fn identity_map<const N: usize>(mesh: &Mesh<N>, degree: usize) -> Vec<Vector<f64, N>> {
    let space = Lagrange::new(mesh, degree);
    let mut phi = vec![Vector::zeros(); space.len()];
    let basis = space.basis(N);
    for cell in 0..mesh.cell_count() {
        for (i, dof) in space.cell_dofs(cell).enumerate() {
            let mut x = Vector::zeros();
            for (v, &e) in basis.exponents()[i].iter().enumerate() {
                let corner = mesh.corner(cell, v).expect("the mesh has coordinates");
                x += corner * (e as f64 / degree as f64);
            }
            phi[dof] = x;
        }
    }
    phi
}

/// A random displacement: every coefficient up to 0.03.
fn displacement<const N: usize>(len: usize, draw: &mut Draw) -> Vec<Vector<f64, N>> {
    let moves = draw.numbers(len * N);
    list(len, |dof| Vector::from_fn(|m, _| 0.03 * moves[dof * N + m]))
}

/// φ + t u.
fn moved<const N: usize>(
    phi: &[Vector<f64, N>],
    t: f64,
    u: &[Vector<f64, N>],
) -> Vec<Vector<f64, N>> {
    pairwise(phi, u, |x, u| x + u * t)
}

impl<const N: usize> Evaluate<f64, N> for PullBack<N> {
    type Table = Vec<Vec<Jet2<f64, N>>>;
    type Local = [Vec<Vector<f64, N>>; 2];

    fn tabulate(&self, points: &Points) -> Self::Table {
        Bernstein::new(N + 1, self.space.degree()).tabulate_jets(points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        [&self.phi, &self.psi].map(|map| self.space.cell_dofs(cell).map(|d| map[d]).collect())
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let d = |map: &[Vector<f64, N>], m: usize| -> Vector<f64, N> {
            map.iter().zip(&table[q]).map(|(c, b)| c * b.d[m]).sum()
        };
        let [phi, psi] = local;
        symmetric(|m, n| value_only(0.5 * (d(phi, m).dot(&d(psi, n)) + d(psi, m).dot(&d(phi, n)))))
    }
}

impl<const N: usize> TensorField<N> for PullBack<N> {
    type Scalar = f64;
    type Wide = f64;
}

/// As a Regge function, which the field is for maps of degree s: the canonical interpolant changes nothing.
fn as_regge<const N: usize>(regge: &ReggeSpace<N>, field: &PullBack<N>, s: usize) -> Regge<f64, N> {
    let canonical = Canonical::new(regge);
    function(regge, canonical.solve(&canonical.evaluate(field, 4 * s)))
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
        sides: "Left: each production sum; the metric jumps across faces, its curvature does not. Right: nothing. Along the \
            path φ_t = id + tu: b_h(g_t; ġ_t, v) vanishes at all t, and so does a_h.",
    };
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 1 } else { 16 };
        let of = |shape, s: &[usize]| -> Vec<Setting> {
            let one = |s: &usize| {
                let at = Setting::new(shape, *s, 4);
                (0..times).map(move |pick| Setting { pick, ..at })
            };
            s.iter().flat_map(one).collect()
        };
        match dimension {
            2 => of(Shape::Cube(2), &[1, 2]),
            _ => of(Shape::Alfeld, &[1, 2]),
        }
    }

    /// Here the setting's degree is s.
    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let start = identity_map(&mesh, at.degree);
        let u = displacement(start.len(), draw);
        let regge = ReggeSpace::new(&mesh, 2 * (at.degree - 1));
        let pulled_back = PullBack::new(&mesh, at.degree, moved(&start, 1.0, &u));
        let g = as_regge(&regge, &pulled_back, at.degree);
        let space = Lagrange::new(&mesh, at.test);
        let rules = at.rules(N);
        let sums = values(distributional_curvature(&g, &space, &rules));
        let a = values(a_h(&g, &metric(&regge, draw), &space, &rules));
        // Angles of size 2π around hinges of size 1, and as much for H.
        let one = |name, sum: Vec<f64>| {
            Equation::new(name)
                .left("sum", sum)
                .vanishes(true, "it is the claim")
                .magnitude(1.0)
        };
        let other = metric(&regge, draw);
        let curved = values(distributional_curvature(&other, &space, &rules));
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

/// Along the path φ_t = id + tu: ∫₀¹ b_h(g_t; ġ_t, v) dt = 0, although neither of its sums vanishes.
pub struct Straight;

impl OnMesh for Straight {
    const RECORD: Record = M16::RECORD;
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = M16::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let all = M16::settings(dimension, quick).into_iter();
        // For s = 2 b_h has no polynomial integrands.
        let order = |s: usize| if s == 1 { 4 } else { 22 };
        all.filter(|at| at.pick < 4)
            .map(|at| Setting {
                order: order(at.degree),
                ..at
            })
            .collect()
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = Lagrange::new(&mesh, at.test);
        let start = identity_map(&mesh, at.degree);
        let u = displacement(start.len(), draw);
        let mut sums: [Vec<f64>; 4] = std::array::from_fn(|_| vec![0.0; space.len()]);
        let (nodes, weights) = gauss_legendre(POINTS_IN_T);
        for (t, w) in nodes.into_iter().zip(weights) {
            let terms = Self::forms::<N>(at, &space, &moved(&start, t, &u), &u);
            for (sum, term) in sums.iter_mut().zip(terms) {
                for (s, x) in sum.iter_mut().zip(term) {
                    *s += w * x;
                }
            }
        }
        let [cells, faces, jumps, defects] = sums.map(|s| Tested::Inner.of(&space, &s));
        vec![
            Equation::new("∫b_h(g_t; ġ_t, v)dt")
                .left("Σ_T ∫∫⟨𝕊ġ,∇∇v⟩ω dt", cells)
                .left("−Σ_F ∫∫𝕊ġ(n,n)⟦∇_n v⟧ω_F dt", faces),
            Equation::new("∫a_h(g_t; ġ_t, v)dt")
                .left("Σ̊_F ∫∫⟨⟦II‾⟧,ġ⟩vω_F dt", jumps)
                .vanishes(true, "no jump of II")
                .left("−Σ̊_S ∫∫Θ Tr(ġ|_S)vω_S dt", defects)
                .vanishes(true, "Θ = 0")
                // ġ is as large as the displacement, Θ a difference of angles near 2π.
                .magnitude(0.03),
        ]
    }
}

impl Straight {
    /// The sums of b_h over cells and faces, of a_h over faces and hinges, at g = φ*δ with ġ = ∂φ·∂u + ∂u·∂φ.
    fn forms<const N: usize>(
        at: &Setting,
        space: &Lagrange<N>,
        phi: &[Vector<f64, N>],
        u: &[Vector<f64, N>],
    ) -> [Vec<f64>; 4] {
        let mesh = space.mesh();
        let regge = ReggeSpace::new(mesh, 2 * (at.degree - 1));
        let g = PullBack::new(mesh, at.degree, phi.to_vec());
        let rate = PullBack::polarised(mesh, at.degree, phi.to_vec(), moved(u, 1.0, u));
        let as_regge = |field| as_regge(&regge, &field, at.degree);
        let pair = Pair::new(at, space.clone(), as_regge(g), as_regge(rate));
        let (b, a) = (pair.b(), pair.a());
        [b.t, b.f, a.f, a.s]
    }
}
