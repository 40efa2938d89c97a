//! M18: the contracted Bianchi identity, and the invariance behind it.

use super::fields::{Regge, function, metric, times};
use super::gauge::value_only;
use super::setting::{Draw, OnMesh, QUADRATURE, Setting, Shape};
use super::variation::{FLAT, POINTS, everywhere};
use crate::claim::{Equation, Judgement, Method, Record};
use nalgebra::{DMatrix, DVector};
use regge::field::TensorField;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, b_h_with, distributional_curvature_with};
use regge::jet::{Jet1, Jet2};
use regge::lagrange::Lagrange;
use regge::linalg::{Mat, Vector, form, symmetric};
use regge::regge::{Canonical, ReggeSpace};
use regge::simplex::{Bernstein, Points, barycentric_jets, multi_indices, subsets};

/// X = Σ c_ij λ_iλ_j (x_j − x_i) over the edges i < j: continuous, and tangent to every subsimplex.
struct Tangent<'a, 's, const N: usize> {
    g: &'a Regge<'s, f64, N>,
    /// By edge of the mesh.
    c: Vec<f64>,
}

impl<const N: usize> Tangent<'_, '_, N> {
    fn on_edges(&self, cell: usize) -> Vec<f64> {
        let edges = self.g.space().mesh().simplices_of(cell, 1);
        edges.iter().map(|&e| self.c[e as usize]).collect()
    }

    /// Xᵏ in reference coordinates, with derivatives.
    fn jets(c: &[f64], lambda: &[Jet2<f64, N>]) -> Vector<Jet1<f64, N>, N> {
        let mut x = Vector::from_element(Jet1::constant(0.0));
        for (edge, c) in subsets(N + 1, 2).iter().zip(c) {
            let (i, j) = (edge[0], edge[1]);
            let product = lambda[i] * lambda[j];
            let jet = Jet1 {
                value: c * product.value,
                d: product.d.map(|d| c * d),
            };
            // Vertex v is at e_{v−1}, vertex 0 at the origin.
            x[j - 1] += jet;
            if i > 0 {
                x[i - 1] -= jet;
            }
        }
        x
    }

    /// The coefficients of Xv of degree q+1: X B_α = Σ c_ij [α_j (α_i+1) B_{α+e_i} − α_i (α_j+1) B_{α+e_j}]/(q+1).
    fn apply(&self, space: &Lagrange<'_, N>, target: &Lagrange<'_, N>, v: &[f64]) -> Vec<f64> {
        let q = space.degree();
        let raised = multi_indices(N + 1, q + 1);
        let mut all = vec![0.0; target.len()];
        for cell in 0..space.mesh().cells() {
            let mut local = vec![0.0; raised.len()];
            for (alpha, dof) in multi_indices(N + 1, q).iter().zip(space.cell_dofs(cell)) {
                for (edge, c) in subsets(N + 1, 2).iter().zip(self.on_edges(cell)) {
                    for (from, to, sign) in [(edge[1], edge[0], 1.0), (edge[0], edge[1], -1.0)] {
                        let mut beta = alpha.clone();
                        beta[to] += 1;
                        let Some(place) = raised.iter().position(|b| *b == beta) else {
                            continue;
                        };
                        let factor = (alpha[from] * beta[to]) as f64 / (q + 1) as f64;
                        local[place] += sign * c * factor * v[dof];
                    }
                }
            }
            for (value, dof) in local.iter().zip(target.cell_dofs(cell)) {
                all[dof] = *value;
            }
        }
        all
    }
}

impl<const N: usize> TensorField<f64, N> for Tangent<'_, '_, N> {
    type Table = (Vec<Vec<Jet2<f64, N>>>, Vec<Vec<Jet2<f64, N>>>);
    type Local = (Vec<f64>, Vec<f64>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        let lambda = (0..points.len())
            .map(|q| barycentric_jets(points, q))
            .collect();
        (lambda, TensorField::<f64, N>::tabulate(self.g, points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        (
            self.on_edges(cell),
            TensorField::<f64, N>::on_cell(self.g, cell),
        )
    }
    /// (L_X g)_mn = Xᵏ∂_k g_mn + g_kn ∂_m Xᵏ + g_mk ∂_n Xᵏ.
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let x = Self::jets(&local.0, &table.0[q]);
        let g: Mat<Jet1<f64, N>, N> = self.g.jet1(&local.1, &table.1, q);
        symmetric(|m, n| {
            let mut sum = 0.0;
            for k in 0..N {
                sum += x[k].value * g[(m, n)].d[k];
                sum += g[(k, n)].value * x[k].d[m] + g[(m, k)].value * x[k].d[n];
            }
            value_only(sum)
        })
    }
}

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

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        let field = Tangent {
            g: &g,
            c: draw.numbers(mesh.count(1)),
        };
        let (space, target) = (
            Lagrange::new(&mesh, at.test),
            Lagrange::new(&mesh, at.test + 1),
        );
        let rules = Rules::new::<N>(at.order);
        let mut v = draw.numbers(space.len());
        for (dof, c) in v.iter_mut().enumerate() {
            *c *= f64::from(u8::from(space.vanishes_on_boundary(dof)));
        }
        let b = b_h_with::<K, f64, N, _, _>(&g, &field, &space, &rules).pair(&v);
        let a = a_h_with::<K, f64, N, _, _>(&g, &field, &space, &rules).pair(&v);
        let r = distributional_curvature_with::<K, f64, N, _>(&g, &target, &rules)
            .pair(&field.apply(&space, &target, &v));
        let (flat, surface) = (at.degree == 0, N == 2);
        vec![
            Equation::new("Bianchi")
                .left("Σ_T ∫⟨𝕊L_Xg,∇∇v⟩ω", b[0])
                .left("−Σ_F ∫𝕊L_Xg(n,n)⟦∇_n v⟧ω_F", b[1])
                .left("−Σ_T ∫⟨G,L_Xg⟩vω", -a[0])
                .vanishes(
                    flat || surface,
                    "G = 0 when N = 2, or g is constant on cells",
                )
                .left("−Σ̊_F ∫⟨⟦II‾⟧,L_Xg⟩vω_F", -a[1])
                .vanishes(
                    flat || surface,
                    "II‾ = 0 when N = 2, or g is constant on cells",
                )
                .left("Σ̊_S ∫Θ Tr(L_Xg|_S)vω_S", -a[2])
                .vanishes(surface, POINTS)
                .right("−Σ_T ∫R (Xv) ω", -r[0])
                .vanishes(flat, FLAT)
                .right("−2Σ̊_F ∫⟦H⟧(Xv)ω_F", -r[1])
                .vanishes(flat, FLAT)
                .right("−2Σ̊_S ∫Θ(Xv)ω_S", -r[2])
                .vanishes(surface, "X = 0 at vertices"),
        ]
    }
}

/// φ*g for φ = id + X, which maps every subsimplex to itself.
struct PulledBack<'a, 's, const N: usize>(Tangent<'a, 's, N>);

/// Barycentric coordinates of φ(λ).
fn image<const N: usize>(x: &Vector<Jet1<f64, N>, N>, lambda: &[Jet2<f64, N>]) -> Vec<f64> {
    let inner = (0..N).map(|k| lambda[k + 1].value + x[k].value);
    let first = 1.0 - inner.clone().sum::<f64>();
    std::iter::once(first).chain(inner).collect()
}

impl<const N: usize> TensorField<f64, N> for PulledBack<'_, '_, N> {
    type Table = Vec<Vec<Jet2<f64, N>>>;
    type Local = (Vec<f64>, Vec<f64>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        (0..points.len())
            .map(|q| barycentric_jets(points, q))
            .collect()
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.0.on_cell(cell)
    }
    /// (φ*g)_mn = ∂_mφᵏ ∂_nφˡ g_kl(φ).
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let x = Tangent::jets(&local.0, &table[q]);
        let there = Points::new(N + 1, image(&x, &table[q]));
        let g = self.0.g;
        let g: Mat<f64, N> = g.value(&local.1, &TensorField::<f64, N>::tabulate(g, &there), 0);
        let d = |m: usize| -> Vector<f64, N> {
            Vector::from_fn(|k, _| x[k].d[m] + f64::from(u8::from(k == m)))
        };
        symmetric(|m, n| value_only(form(&g, &d(m), &d(n))))
    }
}

/// The coefficients of v∘φ in a space of twice the degree.
fn composed<const N: usize>(
    x: &Tangent<'_, '_, N>,
    space: &Lagrange<'_, N>,
    target: &Lagrange<'_, N>,
    v: &[f64],
) -> Vec<f64> {
    let (basis, raised) = (
        Bernstein::new(N + 1, space.degree()),
        Bernstein::new(N + 1, target.degree()),
    );
    let degree = target.degree() as f64;
    let lattice: Vec<f64> = (raised.exponents().iter().flatten())
        .map(|&e| e as f64 / degree)
        .collect();
    let points = Points::new(N + 1, lattice);
    let matrix = DMatrix::from_fn(raised.len(), raised.len(), |q, a| {
        raised.value(a, points.lambda(q))
    });
    let solver = matrix.lu();
    let mut all = vec![0.0; target.len()];
    for cell in 0..space.mesh().cells() {
        let (c, dofs): (_, Vec<usize>) = (x.on_edges(cell), space.cell_dofs(cell).collect());
        let values = DVector::from_fn(points.len(), |q, _| {
            let lambda: Vec<Jet2<f64, N>> = barycentric_jets(&points, q);
            let there = image(&Tangent::jets(&c, &lambda), &lambda);
            let terms = dofs.iter().enumerate();
            terms.map(|(a, d)| v[*d] * basis.value(a, &there)).sum()
        });
        // Bernstein's polynomials are determined by their values on the lattice.
        let local = solver
            .solve(&values)
            .unwrap_or_else(|| values.map(|_| f64::NAN));
        for (value, dof) in local.iter().zip(target.cell_dofs(cell)) {
            all[dof] = *value;
        }
    }
    all
}

/// ⟨(Rω)_dist(φ*g), v∘φ⟩ = ⟨(Rω)_dist(g), v⟩, sum by sum.
pub struct Invariance;

impl OnMesh for Invariance {
    const RECORD: Record = M18::RECORD;
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let all = M18::settings(dimension, quick).into_iter();
        // φ*g has the degree 2r + 2, and is no polynomial's inverse on a cell even for r = 0.
        all.filter(|at| at.pick < 2 && at.degree < 2 && dimension < 4)
            .map(|at| Setting {
                order: super::variation::orders(dimension)[2] + 2,
                ..at
            })
            .collect()
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let raised = ReggeSpace::new(&mesh, 2 * at.degree + 2);
        let g = metric(&regge, draw);
        // Small enough to turn nothing over.
        let c = times(0.05, &draw.numbers(mesh.count(1)));
        let field = PulledBack(Tangent { g: &g, c });
        let canonical = Canonical::new(&raised);
        let values = canonical.evaluate(&field, 4 * at.degree + 6);
        let moved = function(&raised, canonical.solve(&values));
        let (space, target) = (
            Lagrange::new(&mesh, at.test),
            Lagrange::new(&mesh, 2 * at.test),
        );
        let rules = Rules::new::<N>(at.order);
        let v = draw.numbers(space.len());
        let still = Tangent {
            g: &g,
            c: vec![0.0; mesh.count(1)],
        };
        let sums = distributional_curvature_with::<K, f64, N, _>(&moved, &target, &rules);
        let after = sums.pair(&composed(&field.0, &space, &target, &v));
        let unmoved = sums.pair(&composed(&still, &space, &target, &v));
        let before = distributional_curvature_with::<K, f64, N, _>(&g, &space, &rules).pair(&v);
        let size = before.iter().map(|x| x.abs()).sum::<f64>();
        let one = |k: usize, name, flat: bool| {
            Equation::new(name)
                .left("of φ*g, v∘φ", after[k])
                .vanishes(flat, FLAT)
                .right("of g, v", before[k])
                .vanishes(flat, FLAT)
                .magnitude(size)
                .forge("v for v∘φ", "of φ*g, v∘φ", unmoved[k])
                .vacuous(flat, FLAT)
                .vacuous(k == 2 && N == 2, "φ leaves vertices where they are")
        };
        let flat = at.degree == 0;
        vec![
            one(0, "Σ_T ∫Rvω", flat),
            one(1, "2Σ̊_F ∫⟦H⟧vω_F", flat),
            one(2, "2Σ̊_S ∫Θvω_S", false),
        ]
    }
}
