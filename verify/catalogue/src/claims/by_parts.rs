//! T01, T03, T04, M04: integration by parts, exactly.
//!
//! The metric is g = LLᵀ with L unipotent and affine, which is curved and has det g = 1; v = (∏_F q_F)² w, q_F = ν·g⁻¹ν,
//! clears the denominators. Every integrand is then a polynomial and is integrated exactly over F_p.

use super::mesh;
use crate::claim::seed::Key;
use crate::claim::{Budget, Case, Check, Equation, Ground, Judgement, Method, Record, Tally};
use crate::exact::Fp;
use crate::exact_rule::on_simplex;
use crate::instance::{Face, reversed};
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge::formulas::Formulas;
use regge::hinge::Hinge;
use regge::hypersurface::{Normal, outward, surface_div};
use regge::jet::{Jet, Jet1, Jet2, lower, lower_vector};
use regge::linalg::{Mat, Vector, apply, contract, form, identity, inverse_and_det, symmetric};
use regge::riemann::{Connection, differential};
use regge::scalar::{Algebraic, Field};
use regge::simplex::subsets;
use std::marker::PhantomData;

/// Where an identity is integrated.
struct Domain<const N: usize> {
    /// The corners of each cell.
    cells: Vec<Vec<[Fp; N]>>,
    /// A covector normal to each face.
    normals: Vec<Vector<Fp, N>>,
    /// Is vertex 0 of all cells an interior one? Then v is to be a multiple of its hat function.
    inner_vertex: bool,
}

impl<const N: usize> Domain<N> {
    /// The reference simplex.
    fn single() -> Self {
        let corner = |v: usize| std::array::from_fn(|k| Fp::from_int(i64::from(k + 1 == v)));
        Self {
            cells: vec![(0..=N).map(corner).collect()],
            normals: (0..=N).map(outward).collect(),
            inner_vertex: false,
        }
    }

    /// A simplex cut at an inner point.
    fn cut() -> Self {
        let at = |c: i64| std::array::from_fn(|k| Fp::from_int(if k as i64 == c { 3 } else { 0 }));
        let corners: Vec<[Fp; N]> = (-1..N as i64).map(at).collect();
        let inner = [Fp::one(); N];
        let cell = |left_out: usize| {
            let kept = (0..=N).filter(|v| *v != left_out).map(|v| corners[v]);
            std::iter::once(inner).chain(kept).collect::<Vec<_>>()
        };
        let cells: Vec<Vec<[Fp; N]>> = (0..=N).map(cell).collect();
        let mut normals: Vec<Vector<Fp, N>> = Vec::new();
        for cell in &cells {
            normals.extend((0..=N).map(|f| barycentric(cell, f)));
        }
        // Each inner face is there from two cells, with normals that differ by a factor.
        let mut different: Vec<Vector<Fp, N>> = Vec::new();
        for nu in normals {
            if !different.iter().any(|other| parallel(other, &nu)) {
                different.push(nu);
            }
        }
        Self {
            cells,
            normals: different,
            inner_vertex: true,
        }
    }

    /// Degree of all integrands, which are products of v with the derivatives of 𝕊σ. Too low a number makes the claims
    /// fail.
    fn degree(&self) -> usize {
        // v: 4 for each face, 1, and the hat function; 𝕊σ: 5; Γ: 3 for each of two derivatives; g⁻¹: 2 for each of two
        // contractions.
        4 * self.normals.len() + 1 + usize::from(self.inner_vertex) + 5 + 6 + 4
    }
}

/// dλ_v of the cell with these corners, as a global covector.
fn barycentric<const N: usize>(corners: &[[Fp; N]], v: usize) -> Vector<Fp, N> {
    let edges = Mat::<Fp, N>::from_fn(|a, m| corners[m + 1][a] - corners[0][a]);
    // Solves for J⁻¹ by the inverse of JᵀJ, which is symmetric.
    let gram =
        symmetric(|m, n| (0..N).fold(Fp::zero(), |sum, a| sum + edges[(a, m)] * edges[(a, n)]));
    let inverse = inverse_and_det(&gram).0;
    let local: Vector<Fp, N> = outward(v);
    let raised = apply(&inverse, &local);
    Vector::from_fn(|a, _| (0..N).fold(Fp::zero(), |sum, m| sum + edges[(a, m)] * raised[m]))
}

fn parallel<const N: usize>(a: &Vector<Fp, N>, b: &Vector<Fp, N>) -> bool {
    (0..N).all(|i| (0..i).all(|j| a[i] * b[j] == a[j] * b[i]))
}

/// Affine functions of x: L's entry, w, σ's components, and one for each cell.
struct Fields<const N: usize> {
    numbers: Vec<Fp>,
}

/// g, σ and v with derivatives at a point of a cell, in the cell's coordinates.
struct Point<const N: usize> {
    g: Mat<Jet2<Fp, N>, N>,
    inverse: Mat<Jet2<Fp, N>, N>,
    still: Connection<Jet1<Fp, N>, N>,
    sigma: Mat<Jet2<Fp, N>, N>,
    v: Jet2<Fp, N>,
}

impl<const N: usize> Fields<N> {
    const SIGMA: usize = 2;
    const CELLS: usize = Self::SIGMA + N * (N + 1) / 2;
    const COUNT: usize = (Self::CELLS + N + 1) * (N + 1) + 1;

    /// The k-th affine function.
    fn affine(&self, k: usize, x: &[Jet2<Fp, N>; N]) -> Jet2<Fp, N> {
        let c = &self.numbers[k * (N + 1)..];
        let mut sum = Jet2::constant(c[N]);
        for i in 0..N {
            sum += Jet2::constant(c[i]) * x[i];
        }
        sum
    }

    /// g = L Lᵀ with an affine entry L_10 and, for N ≥ 3, a constant L_21.
    fn metric(&self, x: &[Jet2<Fp, N>; N]) -> Mat<Jet2<Fp, N>, N> {
        let mut l = identity::<Jet2<Fp, N>, N>();
        l[(1, 0)] = self.affine(0, x);
        if N > 2 {
            l[(2, 1)] = Jet2::constant(self.numbers[Self::COUNT - 1]);
        }
        symmetric(|i, j| {
            let mut sum = Jet2::zero();
            for k in 0..N {
                sum += l[(i, k)] * l[(j, k)];
            }
            sum
        })
    }

    fn sigma(&self, x: &[Jet2<Fp, N>; N]) -> Mat<Jet2<Fp, N>, N> {
        symmetric(|i, j| self.affine(Self::SIGMA + i * N - i * (i + 1) / 2 + j, x))
    }

    /// v, from its factor w, global g⁻¹ and the reference coordinates.
    fn v(
        &self,
        domain: &Domain<N>,
        x: &[Jet2<Fp, N>; N],
        xi: &[Jet2<Fp, N>; N],
        inverse: &Mat<Jet2<Fp, N>, N>,
    ) -> Jet2<Fp, N> {
        let mut v = self.affine(1, x);
        for nu in &domain.normals {
            let nu: Vector<Jet2<Fp, N>, N> = nu.map(Jet2::constant);
            let square = form(inverse, &nu, &nu);
            v *= square * square;
        }
        if domain.inner_vertex {
            let mut hat = Jet2::one();
            for x in xi {
                hat -= *x;
            }
            v *= hat;
        }
        v
    }

    /// All that is needed at the point of a cell with these barycentric coordinates of a subsimplex.
    fn at(&self, domain: &Domain<N>, cell: usize, vertices: &[usize], lambda: &[Fp]) -> Point<N> {
        let mut xi: [Jet2<Fp, N>; N] = std::array::from_fn(|i| Jet2::coordinate(Fp::zero(), i));
        for (v, l) in vertices.iter().zip(lambda) {
            if *v > 0 {
                xi[v - 1].value = *l;
            }
        }
        let corners = &domain.cells[cell];
        let edge = |a: usize, m: usize| Jet2::constant(corners[m + 1][a] - corners[0][a]);
        let x: [Jet2<Fp, N>; N] = std::array::from_fn(|a| {
            let start = Jet2::constant(corners[0][a]);
            (0..N).fold(start, |sum, m| sum + edge(a, m) * xi[m])
        });
        let here = |t: &Mat<Jet2<Fp, N>, N>| -> Mat<Jet2<Fp, N>, N> {
            symmetric(|m, n| {
                let mut sum = Jet2::zero();
                for a in 0..N {
                    for b in 0..N {
                        sum += edge(a, m) * t[(a, b)] * edge(b, n);
                    }
                }
                sum
            })
        };
        let global = self.metric(&x);
        let v = self.v(domain, &x, &xi, &inverse_and_det(&global).0);
        let mut sigma = here(&self.sigma(&x));
        if domain.inner_vertex && N == 2 {
            // Tangentially it is seen by the cell's edge on the boundary alone, so that σ(n,n) jumps.
            let [a, b] = [1, 2].map(outward::<Jet2<Fp, N>, N>);
            let c = self.affine(Self::CELLS + cell, &x);
            sigma = symmetric(|i, j| sigma[(i, j)] + c * (a[i] * b[j] + b[i] * a[j]));
        }
        let g = here(&global);
        Point {
            still: Connection::new(&g),
            inverse: inverse_and_det(&g).0,
            g,
            sigma,
            v,
        }
    }
}

/// What is integrated over a cell.
struct OnCell {
    div_div: Fp,
    hessian: Fp,
    div_gradient: Fp,
}

/// What is integrated over a face, ω_F included, as one cell sees it.
struct OnFace {
    /// (div 𝕊σ)(n) v.
    div_s: Fp,
    /// div_F(σ(n,·)) v.
    div_f: Fp,
    /// div_F(vσ(n,·)).
    div_f_v: Fp,
    /// Hσ(n,n) v.
    h_nn: Fp,
    /// 𝕊σ(n,n).
    s_nn: Fp,
    /// ∇_n v ω_F.
    along_n: Fp,
    /// 𝕊σ(n,∇v).
    gradient: Fp,
}

/// One draw on one domain.
struct Exactly<'a, K, const N: usize> {
    fields: &'a Fields<N>,
    domain: &'a Domain<N>,
    formulas: PhantomData<K>,
}

impl<K: Formulas, const N: usize> Exactly<'_, K, N> {
    fn point(&self, cell: usize, vertices: &[usize], lambda: &[Fp]) -> Point<N> {
        self.fields.at(self.domain, cell, vertices, lambda)
    }

    fn cell(&self, cell: usize, lambda: &[Fp]) -> OnCell {
        let all: Vec<usize> = (0..=N).collect();
        let p = self.point(cell, &all, lambda);
        let base = p.still.lower();
        let omega = base.det.sqrt();
        let s_sigma = K::reverse_trace(&p.g, &p.inverse, &p.sigma);
        let flux = base.sharp(&base.div_tensor(&lower(&s_sigma)));
        let dv = lower_vector(&differential(&p.v));
        OnCell {
            div_div: omega * p.still.div_div(&s_sigma) * p.v.value,
            hessian: omega * base.inner(&lower(&lower(&s_sigma)), &base.hessian(&p.v)),
            div_gradient: omega * contract(&dv, &flux),
        }
    }

    fn face(&self, cell: usize, opposite: usize, lambda: &[Fp]) -> OnFace {
        let vertices: Vec<usize> = (0..=N).filter(|v| *v != opposite).collect();
        let p = self.point(cell, &vertices, lambda);
        let (base, nu) = (p.still.lower(), outward::<Jet1<Fp, N>, N>(opposite));
        let face = Face::new::<K>(&base, &nu);
        let (sigma, n) = (lower(&p.sigma), face.normal.n);
        let s_sigma = reversed::<K, Fp, N>(&p.still, &sigma);
        let s_value = lower(&s_sigma);
        let flux = apply(&sigma, &Normal::new(&p.still.inverse, &nu).n);
        let v: Jet1<Fp, N> = p.v.lower();
        let dv = lower_vector(&differential(&p.v));
        let div_f = |flux| surface_div(&base, &face.normal, flux) * face.omega;
        OnFace {
            div_s: contract(&base.div_tensor(&s_sigma), &n) * v.value * face.omega,
            div_f: div_f(&flux) * v.value,
            div_f_v: div_f(&flux.map(|x| x * v)),
            h_nn: face.h * face.normal.normal_normal(&lower(&sigma)) * v.value * face.omega,
            s_nn: face.normal.normal_normal(&s_value),
            along_n: contract(&dv, &n) * face.omega,
            gradient: form(&s_value, &n, &base.sharp(&dv)) * face.omega,
        }
    }

    /// σ(n,τ) v ω_S, τ pointing into the face, for the two faces of a cell at a hinge.
    fn hinge(&self, cell: usize, opposite: [usize; 2], lambda: &[Fp]) -> [Fp; 2] {
        let vertices: Vec<usize> = (0..=N).filter(|v| !opposite.contains(v)).collect();
        let p = self.point(cell, &vertices, lambda);
        let nu = opposite.map(outward::<Fp, N>);
        let hinge = Hinge::new(&p.inverse.map(|x| x.value), [&nu[0], &nu[1]]);
        let (sigma, omega) = (lower(&lower(&p.sigma)), hinge.omega_s(p.still.det.value));
        [0, 1].map(|f| form(&sigma, &hinge.normal(f), &hinge.conormal(f)) * omega * p.v.value)
    }

    /// ∫ of several densities over a cell, face or hinge. Points where one of them does not exist are avoided.
    fn integral<const M: usize>(&self, k: usize, densities: impl Fn(&[Fp]) -> [Fp; M]) -> [Fp; M] {
        let mut sums = [Fp::zero(); M];
        let usable = |lambda: &[Fp]| k == N || !poisoned(&densities(lambda));
        if !(0..TRIED).any(|i| usable(&somewhere(k, i))) {
            return [Fp::POISON; M];
        }
        on_simplex(k, self.domain.degree(), &usable, &mut |lambda, w| {
            for (sum, x) in sums.iter_mut().zip(densities(lambda)) {
                *sum += w * x;
            }
        });
        sums
    }

    /// ∫(div div 𝕊σ)v, ∫⟨𝕊σ,∇∇v⟩, ∫(div 𝕊σ)(∇v) over all cells.
    fn cells(&self) -> [Fp; 3] {
        let of = |cell: usize| {
            self.integral(N, |lambda| {
                let p = self.cell(cell, lambda);
                [p.div_div, p.hessian, p.div_gradient]
            })
        };
        (0..self.domain.cells.len())
            .map(of)
            .fold([Fp::zero(); 3], add)
    }

    /// Densities over the faces of the only cell.
    fn faces<const M: usize>(&self, q: impl Fn(&OnFace) -> [Fp; M]) -> [Fp; M] {
        let of = |f: usize| self.integral(N - 1, |lambda| q(&self.face(0, f, lambda)));
        let mut sums = [Fp::zero(); M];
        for f in 0..=N {
            if !poisoned(&sums) {
                sums = add(sums, of(f));
            }
        }
        sums
    }
}

/// At so many points of a face or hinge a root is looked for. It is at half of them if it is at any.
const TRIED: i64 = 40;

/// Points of a k-simplex.
fn somewhere(k: usize, i: i64) -> Vec<Fp> {
    let mut lambda: Vec<Fp> = (1..=k as i64)
        .map(|j| Fp::from_int(i + j * j + 2))
        .collect();
    let sum = lambda.iter().fold(Fp::zero(), |sum, x| sum + *x);
    lambda.push(Fp::one() - sum);
    lambda
}

fn add<const M: usize>(mut a: [Fp; M], b: [Fp; M]) -> [Fp; M] {
    for (x, y) in a.iter_mut().zip(b) {
        *x += y;
    }
    a
}

/// An identity between integrals of polynomials.
pub trait ByParts: Send + Sync + 'static {
    /// That of the claim.
    const RECORD: Record;

    /// The domain.
    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>>;
}

/// Does nothing exist to be compared?
fn poisoned<const M: usize>(all: &[Fp; M]) -> bool {
    all.iter().any(|x| x.is_poison())
}

/// Runs `f` on one simplex.
fn on_single<K: Formulas, const N: usize, R>(
    numbers: Vec<Fp>,
    f: impl FnOnce(&Exactly<'_, K, N>) -> R,
) -> R {
    f(&Exactly {
        fields: &Fields { numbers },
        domain: &Domain::single(),
        formulas: PhantomData,
    })
}

/// Stokes' theorem on the faces of a simplex, for α = vσ(n,·).
pub struct T01;

impl ByParts for T01 {
    const RECORD: Record = mesh::T01_RECORD;

    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>> {
        on_single::<K, N, _>(numbers, |at| {
            let (mut div, mut boundary, mut curved) = (Vec::new(), Vec::new(), Vec::new());
            for f in 0..=N {
                let mut outflow = Fp::zero();
                for other in (0..=N).filter(|o| *o != f) {
                    // ν_F = −τ.
                    outflow -= at.integral(N - 2, |l| [at.hinge(0, [f, other], l)[0]])[0];
                }
                boundary.push(outflow);
                let [d, h] = if outflow.is_poison() {
                    [Fp::POISON; 2]
                } else {
                    at.integral(N - 1, |l| {
                        let p = at.face(0, f, l);
                        [p.div_f_v, p.h_nn]
                    })
                };
                div.push(d);
                curved.push(h);
            }
            vec![
                Equation::new("Stokes")
                    .left("∫div_Fα ω_F", div)
                    .right("∫_∂F α(ν_F)", boundary)
                    .right("∫Hα(n)ω_F", curved),
            ]
        })
    }
}

/// Twice by parts over a cell.
pub struct T03;

impl ByParts for T03 {
    const RECORD: Record = mesh::T03_RECORD;

    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>> {
        on_single::<K, N, _>(numbers, |at| {
            let faces = at.faces(|q| [q.gradient, q.div_s]);
            let [div_div, hessian, inner] = if poisoned(&faces) {
                [Fp::POISON; 3]
            } else {
                at.cells()
            };
            let [normal, div] = faces;
            vec![
                Equation::new("once")
                    .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                    .right("∫_∂T 𝕊σ(n,∇v)", normal)
                    .right("−∫(div 𝕊σ)(∇v)ω", -inner),
                Equation::new("twice")
                    .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                    .right("∫_∂T 𝕊σ(n,∇v)", normal)
                    .right("−∫_∂T (div 𝕊σ)(n)v", -div)
                    .right("∫(div div 𝕊σ)vω", div_div),
            ]
        })
    }
}

/// Σ_F: (div 𝕊σ)(n) v, div_F(σ(n,·)) v, Hσ(n,n) v, 𝕊σ(n,n)∇_n v.
struct Terms {
    faces: [Fp; 4],
    hinges: Fp,
    cells: [Fp; 3],
}

impl Terms {
    fn equation(self) -> Equation<Fp> {
        let ([div_s, div_f, h_nn, normal], turn) = (self.faces, self.hinges);
        Equation::new("by parts")
            .left("∫(div div 𝕊σ)v", self.cells[0])
            .left("−Σ_F∫(div 𝕊σ)(n)v", -div_s)
            .left("−Σ_F∫div_F(σ(n,·))v", -div_f)
            .left("Σ_F∫Hσ(n,n)v", h_nn)
            .left("−Σ_S∫Σσ(n,τ)v", -turn)
            .right("∫⟨𝕊σ,∇∇v⟩", self.cells[1])
            .right("−Σ_F∫𝕊σ(n,n)∇_n v", -normal)
            .forge("conormal as printed", "−Σ_S∫Σσ(n,τ)v", turn)
    }
}

/// lemma:IBPdivdivS on one simplex.
pub struct T04;

impl ByParts for T04 {
    const RECORD: Record = mesh::T04_RECORD;

    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>> {
        on_single::<K, N, _>(numbers, |at| {
            // The hinges first: where roots do not exist at all, the rest need not be integrated.
            let mut hinges = Fp::zero();
            for pair in subsets(N + 1, 2) {
                let two = at.integral(N - 2, |l| at.hinge(0, [pair[0], pair[1]], l));
                hinges += two[0] + two[1];
            }
            let mut terms = Terms {
                hinges,
                faces: [Fp::POISON; 4],
                cells: [Fp::POISON; 3],
            };
            if !hinges.is_poison() {
                terms.faces = at.faces(|q| [q.div_s, q.div_f, q.h_nn, q.s_nn * q.along_n]);
                terms.cells = at.cells();
            }
            vec![terms.equation()]
        })
    }
}

/// lemma:IBPdivdivS on a triangle cut into three, v a multiple of the inner vertex's hat function.
pub struct M04;

impl M04 {
    /// The inner vertex.
    fn hinge<K: Formulas, const N: usize>(at: &Exactly<'_, K, N>) -> Fp {
        let of = |cell: usize| at.hinge(cell, [1, 2], &[Fp::one()]);
        let all = (0..at.domain.cells.len()).map(of);
        all.fold(Fp::zero(), |sum, two| sum + two[0] + two[1])
    }

    /// The inner edges, from the inner vertex to the corner c, from both sides; 𝕊σ(n,n) of the first for both.
    fn inner_edge<K: Formulas, const N: usize>(at: &Exactly<'_, K, N>, c: usize) -> [Fp; 4] {
        let sides: Vec<(usize, usize)> = (0..=N)
            .filter(|cell| *cell != c)
            .map(|cell| {
                // The cell lacks one corner: its vertices are the inner one and the others in their order.
                let place = 1 + c - usize::from(cell < c);
                (cell, (1..=N).find(|v| *v != place).unwrap_or(0))
            })
            .collect();
        at.integral(N - 1, |lambda| {
            let [p, q] = [sides[0], sides[1]].map(|(cell, f)| at.face(cell, f, lambda));
            let normal = p.s_nn * (p.along_n + q.along_n);
            [
                p.div_s + q.div_s,
                p.div_f + q.div_f,
                p.h_nn + q.h_nn,
                normal,
            ]
        })
    }

    /// The boundary, where v vanishes and ∇v does not.
    fn boundary<K: Formulas, const N: usize>(at: &Exactly<'_, K, N>, cell: usize) -> [Fp; 4] {
        let normal = at.integral(N - 1, |lambda| {
            let p = at.face(cell, 0, lambda);
            [p.s_nn * p.along_n]
        });
        [Fp::zero(), Fp::zero(), Fp::zero(), normal[0]]
    }
}

impl ByParts for M04 {
    const RECORD: Record = mesh::M04_RECORD;

    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>> {
        let at = Exactly::<K, N> {
            fields: &Fields { numbers },
            domain: &Domain::cut(),
            formulas: PhantomData,
        };
        let mut terms = Terms {
            hinges: Self::hinge(&at),
            faces: [Fp::POISON; 4],
            cells: [Fp::POISON; 3],
        };
        if !terms.hinges.is_poison() {
            let inner = (0..=N).map(|c| Self::inner_edge(&at, c));
            let outer = (0..=N).map(|cell| Self::boundary(&at, cell));
            terms.faces = inner.chain(outer).fold([Fp::zero(); 4], add);
            terms.cells = at.cells();
        }
        vec![terms.equation()]
    }
}

/// One of them in dimension N by the formulas K.
pub struct ByPartsCheck<C, K, const N: usize>(PhantomData<fn() -> (C, K)>);

impl<C, K, const N: usize> Default for ByPartsCheck<C, K, N> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<C: ByParts, K: Formulas, const N: usize> ByPartsCheck<C, K, N> {
    /// Draws until all roots exist: the equations and how many draws were spoilt.
    fn draw(runner: &mut TestRunner) -> Option<(Vec<Equation<Fp>>, usize)> {
        let numbers = proptest::collection::vec(Fp::number(), Fields::<N>::COUNT);
        for spoilt in 0..Fp::REDRAWS {
            let drawn = numbers.new_tree(runner).ok()?.current();
            let equations = C::equations::<K, N>(drawn);
            if !equations.iter().any(Equation::is_poisoned) {
                return Some((equations, spoilt));
            }
        }
        None
    }
}

impl<C: ByParts, K: Formulas, const N: usize> Check for ByPartsCheck<C, K, N> {
    fn record(&self) -> &'static Record {
        &C::RECORD
    }

    fn dimension(&self) -> usize {
        N
    }

    fn method(&self) -> Method {
        Method::Exact
    }

    /// 2⁻⁵⁴ a draw: two are enough; on the tetrahedron each takes seconds.
    fn cases(&self, budget: &Budget) -> usize {
        match (budget.quick, N) {
            (true, 3..) => 1,
            (true, _) | (_, 3..) => 2,
            _ => 4,
        }
    }

    fn run(&self, budget: &Budget) -> Entry {
        // One identity of integrals in the coefficients of the fields: degree ≤ 2 · 40 in L's, 1 in σ's and w's.
        let mut tally = Tally::new(Judgement::Exact { degree: 100.0 });
        for number in 0..self.cases(budget) {
            let case = Case {
                number,
                ..Case::default()
            };
            let key = Key {
                seed: budget.seed,
                label: C::RECORD.label,
                dimension: N,
                method: Method::Exact.name(),
                case: number,
            };
            let Some((equations, spoilt)) = Self::draw(&mut key.runner()) else {
                let what = "no draw had all the roots that the claim takes";
                tally.fail(&case, what.to_owned());
                break;
            };
            tally.redrawn(spoilt);
            if !tally.add(&case, &equations) {
                break;
            }
        }
        tally.finish(&C::RECORD, N, Fp::NAME, Method::Exact)
    }
}
