//! T01, T03, T04, M04: integration by parts, exactly.
//!
//! The metric is g = LLᵀ with L unipotent and affine, which is curved and has det g = 1; v = (∏_F q_F)² w, q_F = ν·g⁻¹ν,
//! clears the denominators. Every integrand is then a polynomial and is integrated exactly over F_p.

mod check;
mod fields;
mod integrals;

pub use check::ByPartsCheck;

use super::mesh;
use crate::claim::{Equation, Record};
use crate::exact::Fp;
use fields::{Domain, Fields};
use integrals::{Exactly, add, poisoned};
use regge_curvature::formulas::Formulas;
use regge_curvature::scalar::Field;
use regge_curvature::simplex::subsets;
use std::marker::PhantomData;

/// An identity between integrals of polynomials.
pub trait ByParts: Send + Sync + 'static {
    /// That of the claim.
    const RECORD: Record;

    /// The domain.
    fn equations<K: Formulas, const N: usize>(numbers: Vec<Fp>) -> Vec<Equation<Fp>>;
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
