//! M18: the contracted Bianchi identity, and the invariance behind it.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, list};
use crate::stage::fields::{Tangent, function, metric, test_function, value_only};
use crate::stage::mesh::{FLAT, OnMesh, POINTS, QUADRATURE, everywhere, orders, times};
use nalgebra::{DMatrix, DVector, Dyn, LU};
use regge_curvature::field::{Evaluate, PointByPoint, TensorField};
use regge_curvature::functional::{Rules, Three, a_h, b_h, distributional_curvature};
use regge_curvature::interpolate::Canonical;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, form, symmetric};
use regge_curvature::simplex::{Bernstein, Points, barycentric_jets};
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// The discrete Bianchi identity.
pub struct M18;

impl OnMesh for M18 {
    const RECORD: Record = Record {
        label: "M18",
        paper: &[],
        title: "The contracted Bianchi identity for Regge metrics",
        statement: r"X=\sum c_{ij}\lambda_i\lambda_j(x_j-x_i):\qquad b_h(g;L_Xg,v)-a_h(g;L_Xg,v) =
            -\langle (R\omega)_{\rm dist}(g),Xv\rangle\qquad\forall v\in V",
        sides: "Left: b_h and a_h with a Lie derivative. Right: the functional of g alone. X is tangent to every simplex, so \
            that its flow maps Regge metrics to Regge metrics on the same mesh, and the functional is invariant. Finite: the three \
            sums of φ*g against v∘φ and of g against v, φ = id + X, without any derivative of the functional.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        everywhere(dimension, quick)
            .into_iter()
            // L_X g has degree r + 2, v degree 2.
            .map(|s| Setting {
                order: s.order + 2,
                ..s
            })
            .filter(|s| dimension < 4 || s.shape != Shape::Torus(3))
            .collect()
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        let field = Tangent {
            g: g.clone(),
            c: draw.numbers(mesh.count(1)),
        };
        let (space, target) = (
            Lagrange::new(&mesh, at.test),
            Lagrange::new(&mesh, at.test + 1),
        );
        let rules = at.rules(N);
        let v = test_function(&space, draw);
        // L_X g has a formula over f64 alone.
        let single = PointByPoint(&g);
        let b = b_h(&single, &field, &space, &rules).pair(&v);
        let a = a_h(&single, &field, &space, &rules).pair(&v);
        let r =
            distributional_curvature(&g, &target, &rules).pair(&field.apply(&space, &target, &v));
        let (flat, surface) = (at.degree == 0, N == 2);
        vec![
            Equation::new("Bianchi")
                .left("Σ_T ∫⟨𝕊L_Xg,∇∇v⟩ω", b.cells)
                .left("−Σ_F ∫𝕊L_Xg(n,n)⟦∇_n v⟧ω_F", b.faces)
                .left("−Σ_T ∫⟨G,L_Xg⟩vω", -a.cells)
                .vanishes(
                    flat || surface,
                    "G = 0 when N = 2, or g is constant on cells",
                )
                .left("−Σ̊_F ∫⟨⟦II‾⟧,L_Xg⟩vω_F", -a.faces)
                .vanishes(
                    flat || surface,
                    "II‾ = 0 when N = 2, or g is constant on cells",
                )
                .left("Σ̊_S ∫Θ Tr(L_Xg|_S)vω_S", -a.hinges)
                .vanishes(surface, POINTS)
                .right("−Σ_T ∫R (Xv) ω", -r.cells)
                .vanishes(flat, FLAT)
                .right("−2Σ̊_F ∫⟦H⟧(Xv)ω_F", -r.faces)
                .vanishes(flat, FLAT)
                .right("−2Σ̊_S ∫Θ(Xv)ω_S", -r.hinges)
                .vanishes(surface, "X = 0 at vertices"),
        ]
    }
}

/// φ*g for φ = id + X, which maps every subsimplex to itself.
struct PulledBack<const N: usize>(Tangent<N>);

/// Barycentric coordinates of φ(λ).
fn image<const N: usize>(x: &Vector<Jet1<f64, N>, N>, lambda: &[Jet2<f64, N>]) -> Vec<f64> {
    let inner = list(N, |k| lambda[k + 1].value + x[k].value);
    let mut all = vec![1.0 - inner.iter().sum::<f64>()];
    all.extend(inner);
    all
}

impl<const N: usize> Evaluate<f64, N> for PulledBack<N> {
    type Table = Vec<Vec<Jet2<f64, N>>>;
    type Local = (Vec<f64>, Vec<f64>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        list(points.len(), |q| barycentric_jets(points, q))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.0.on_cell(cell)
    }
    /// (φ*g)_mn = ∂_mφᵏ ∂_nφˡ g_kl(φ).
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let x = Tangent::jets(&local.0, &table[q]);
        let there = Points::new(N + 1, image(&x, &table[q]));
        let g = &self.0.g;
        let g: Mat<f64, N> = g.value(&local.1, &Evaluate::<f64, N>::tabulate(g, &there), 0);
        let d = |m: usize| -> Vector<f64, N> {
            Vector::from_fn(|k, _| x[k].d[m] + f64::from(u8::from(k == m)))
        };
        symmetric(|m, n| value_only(form(&g, &d(m), &d(n))))
    }
}

impl<const N: usize> TensorField<N> for PulledBack<N> {
    type Scalar = f64;
    type Wide = f64;
}

/// The points with barycentric coordinates in ℕ/degree, and the factors of Bernstein's matrix there.
fn lattice<const N: usize>(degree: usize) -> (Points, LU<f64, Dyn, Dyn>) {
    let basis = Bernstein::new(N + 1, degree);
    let exponents = basis.exponents().iter().flatten();
    let lambda = exponents.map(|&e| e as f64 / degree as f64).collect();
    let points = Points::new(N + 1, lambda);
    let value = |q, a| basis.value(a, points.lambda(q));
    let matrix = DMatrix::from_fn(basis.len(), basis.len(), value);
    (points, matrix.lu())
}

/// The coefficients of v∘φ in a space of twice the degree.
fn composed<const N: usize>(
    x: &Tangent<N>,
    space: &Lagrange<N>,
    target: &Lagrange<N>,
    v: &[f64],
) -> Vec<f64> {
    let basis = Bernstein::new(N + 1, space.degree());
    let (points, solver) = lattice::<N>(target.degree());
    let mut all = vec![0.0; target.len()];
    for cell in 0..space.mesh().cell_count() {
        let (c, dofs): (_, Vec<usize>) = (x.on_edges(cell), space.cell_dofs(cell).collect());
        let values = DVector::from_fn(points.len(), |q, _| {
            let lambda: Vec<Jet2<f64, N>> = barycentric_jets(&points, q);
            let there = image(&Tangent::jets(&c, &lambda), &lambda);
            let terms = dofs.iter().enumerate();
            terms.map(|(a, d)| v[*d] * basis.value(a, &there)).sum()
        });
        // Bernstein's polynomials are determined by their values on the lattice.
        let local = solver.solve(&values).expect("the matrix is regular");
        for (value, dof) in local.iter().zip(target.cell_dofs(cell)) {
            all[dof] = *value;
        }
    }
    all
}

/// The three sums of φ*g against v∘φ, and against v.
fn transformed<const N: usize>(
    x: Tangent<N>,
    space: &Lagrange<N>,
    v: &[f64],
    rules: &Rules,
) -> [Three<f64>; 2] {
    let mesh = space.mesh();
    let degree = x.g.space().degree();
    let raised = ReggeSpace::new(mesh, 2 * degree + 2);
    let still = Tangent {
        g: x.g.clone(),
        c: vec![0.0; mesh.count(1)],
    };
    let field = PulledBack(x);
    let canonical = Canonical::new(&raised);
    let values = canonical.evaluate(&field, 4 * degree + 6);
    let moved = function(&raised, canonical.solve(&values));
    let target = Lagrange::new(mesh, 2 * space.degree());
    let sums = distributional_curvature(&moved, &target, rules);
    let pair = |x: &Tangent<N>| sums.pair(&composed(x, space, &target, v));
    [pair(&field.0), pair(&still)]
}

/// ⟨(Rω)_dist(φ*g), v∘φ⟩ = ⟨(Rω)_dist(g), v⟩, sum by sum.
pub struct Invariance;

impl OnMesh for Invariance {
    const RECORD: Record = M18::RECORD;
    const METHOD: Method = Method::Homotopy;
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let all = M18::settings(dimension, quick).into_iter();
        // φ*g has the degree 2r + 2, and is no polynomial's inverse on a cell even for r = 0.
        all.filter(|at| at.pick < 2 && at.degree < 2)
            .map(|at| Setting {
                order: orders(dimension)[2] + 2,
                ..at
            })
            .collect()
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        // Small enough to turn nothing over.
        let c = times(0.05, &draw.numbers(mesh.count(1)));
        let space = Lagrange::new(&mesh, at.test);
        let v = draw.numbers(space.len());
        let rules = at.rules(N);
        let before = distributional_curvature(&g, &space, &rules).pair(&v);
        let [after, unmoved] = transformed::<N>(Tangent { g, c }, &space, &v, &rules);
        let one = |name, of: fn(&Three<f64>) -> f64, flat: bool, still: bool| {
            Equation::new(name)
                .left("of φ*g, v∘φ", of(&after))
                .vanishes(flat, FLAT)
                .right("of g, v", of(&before))
                .vanishes(flat, FLAT)
                // Angles of size 2π cancel around hinges of size 1, and as much in R and ⟦H⟧ of φ*g.
                .magnitude(1.0)
                .forge("v for v∘φ", "of φ*g, v∘φ", of(&unmoved))
                .vacuous(flat, FLAT)
                .vacuous(still, "φ leaves vertices where they are")
        };
        let flat = at.degree == 0;
        vec![
            one("Σ_T ∫Rvω", |sums| sums.cells, flat, false),
            one("2Σ̊_F ∫⟦H⟧vω_F", |sums| sums.faces, flat, false),
            one("2Σ̊_S ∫Θvω_S", |sums| sums.hinges, false, N == 2),
        ]
    }
}
