//! M17: the variation on one simplex, where nothing is continuous.

use super::density::{FaceTerms, HingeTerms, Seen, outward_of_face};
use super::fields::{Regge, metric, minus, moving, rates, values, variation};
use super::parts::on_one_simplex;
use super::setting::{Draw, OnMesh, QUADRATURE, Setting};
use super::variation::{FLAT, POINTS};
use crate::claim::{Equation, Judgement, Record};
use crate::instance::Face;
use num_dual::Dual64;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, b_h_with, distributional_curvature_with, integrate};
use regge::jet::Jet1;
use regge::lagrange::Lagrange;
use regge::regge::ReggeSpace;
use regge::riemann::Connection;

/// The variation on one simplex.
pub struct M17;

/// What M17 sums over the boundary of the simplex.
struct Boundary<'s, const N: usize> {
    space: &'s Lagrange<'s, N>,
    rules: Rules,
}

impl<const N: usize> Boundary<'_, N> {
    /// d/dt 2Σ_F ∫Hvω_F.
    fn faces_rate<K: Formulas>(&self, g: &Regge<'_, Dual64, N>) -> Vec<f64> {
        let rule = &self.rules.face;
        let g = Seen::<Dual64, N, _>::new(g, N - 1, rule);
        let faces = 0..self.space.mesh().count(N - 1);
        let sum = integrate(self.space, N - 1, rule, faces, |_, side, p| {
            let connection = Connection::new(&g.jet1(side, p));
            let nu = outward_of_face::<Dual64, N>(side.place).map(Jet1::constant);
            let face = Face::new::<K>(&connection, &nu);
            face.h * face.omega * 2.0
        });
        sum.iter().map(|x| x.eps).collect()
    }

    /// d/dt −2Σ_S ∫θvω_S.
    fn hinges_rate<K: Formulas>(&self, g: &Regge<'_, Dual64, N>) -> Vec<f64> {
        let rule = &self.rules.hinge;
        let g = Seen::<Dual64, N, _>::new(g, N - 2, rule);
        let hinges = 0..self.space.mesh().count(N - 2);
        let sum = integrate(self.space, N - 2, rule, hinges, |_, side, p| {
            let value = g.value(side, p);
            let hinge = HingeTerms::<Dual64>::new::<K, N>(&value, &value, side.place);
            hinge.theta * hinge.omega * -2.0
        });
        sum.iter().map(|x| x.eps).collect()
    }

    /// Σ_F ∫⟨II‾,σ|_F⟩vω_F.
    fn faces<K: Formulas>(
        &self,
        g: &Regge<'_, f64, N>,
        sigma: &Regge<'_, f64, N>,
        q: fn(&FaceTerms) -> f64,
    ) -> Vec<f64> {
        let rule = &self.rules.face;
        let g = Seen::<f64, N, _>::new(g, N - 1, rule);
        let sigma = Seen::<f64, N, _>::new(sigma, N - 1, rule);
        let faces = 0..self.space.mesh().count(N - 1);
        integrate(self.space, N - 1, rule, faces, |_, side, p| {
            q(&FaceTerms::new::<K, N>(
                &g.jet2(side, p),
                &sigma.jet1(side, p),
                side.place,
            ))
        })
    }

    /// Σ_S ∫θ Tr(σ|_S)vω_S.
    fn hinges<K: Formulas>(&self, g: &Regge<'_, f64, N>, sigma: &Regge<'_, f64, N>) -> Vec<f64> {
        let rule = &self.rules.hinge;
        let g = Seen::<f64, N, _>::new(g, N - 2, rule);
        let sigma = Seen::<f64, N, _>::new(sigma, N - 2, rule);
        let hinges = 0..self.space.mesh().count(N - 2);
        integrate(self.space, N - 2, rule, hinges, |_, side, p| {
            let terms =
                HingeTerms::new::<K, N>(&g.value(side, p), &sigma.value(side, p), side.place);
            terms.theta * terms.trace * terms.omega
        })
    }
}

impl OnMesh for M17 {
    const RECORD: Record = Record {
        label: "M17",
        paper: &[],
        title: "The first variation on one simplex: any g, any σ, any v",
        statement: r"\frac{d}{dt}\Bigl[\int_T Rv\omega + 2\sum_F\int_F Hv\omega_F - 2\sum_S\int_S\theta v\omega_S\Bigr]
            = \int_T\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega - \sum_F\int_F\mathbb{S}\sigma(n,n)\nabla_n v\,\omega_F
            - \Bigl[\int_T\langle G,\sigma\rangle v\omega + \sum_F\int_F\langle\overline{I\!I},\sigma|_F\rangle v\omega_F +
            \sum_S\int_S\theta\operatorname{Tr}(\sigma|_S)v\omega_S\Bigr]",
        sides: "Left: R, H and dihedral angles of g + tσ over dual numbers. Right: b_h and the terms of a_h at t = 0. There \
            is one cell, so that no continuity is used: the theorem holds cell by cell.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let (regge, space) = (
            ReggeSpace::new(&mesh, at.degree),
            Lagrange::new(&mesh, at.test),
        );
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let rules = Rules::new::<N>(at.order);
        let moved = moving(&g, &sigma);
        // There are no interior faces: only the sums over cells are production's own.
        let rate = rates(&distributional_curvature_with::<K, Dual64, N, _>(
            &moved, &space, &rules,
        ));
        let b = values(b_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let a = values(a_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let all = Boundary {
            space: &space,
            rules,
        };
        let (flat, surface) = (at.degree == 0, N == 2);
        vec![
            Equation::new("one simplex")
                .left("d/dt ∫Rvω", rate.t)
                .vanishes(flat, FLAT)
                .left("d/dt 2Σ_F ∫Hvω_F", all.faces_rate::<K>(&moved))
                .vanishes(flat, FLAT)
                .left("d/dt −2Σ_S ∫θvω_S", all.hinges_rate::<K>(&moved))
                .right("∫⟨𝕊σ,∇∇v⟩ω", b.t)
                .right("−Σ_F ∫𝕊σ(n,n)∇_n v ω_F", b.f)
                .right("−∫⟨G,σ⟩vω", minus(&a.t))
                .vanishes(flat || surface, "G = 0 when N = 2, or g is constant")
                .right(
                    "−Σ_F ∫⟨II‾,σ⟩vω_F",
                    minus(&all.faces::<K>(&g, &sigma, |q| q.second_form)),
                )
                .vanishes(flat || surface, "II‾ = 0 when N = 2, or g is constant")
                .right("−Σ_S ∫θ Tr(σ|_S)vω_S", minus(&all.hinges::<K>(&g, &sigma)))
                .vanishes(surface, POINTS)
                .forge(
                    "II for II‾",
                    "−Σ_F ∫⟨II‾,σ⟩vω_F",
                    minus(&all.faces::<K>(&g, &sigma, |q| q.plain_second_form)),
                )
                .vacuous(flat, FLAT),
        ]
    }
}
