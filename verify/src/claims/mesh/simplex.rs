//! T01: Stokes' theorem on a face. M17: the variation on one simplex, where nothing is continuous.

use super::density::{FaceTerms, HingeTerms, Seen, opposite, outward_of_face, points_of};
use super::fields::{Regge, metric, minus, moving, rates, values, variation};
use super::parts::on_one_simplex;
use super::setting::{Draw, OnMesh, QUADRATURE, Setting};
use super::variation::{FLAT, POINTS};
use crate::claim::{Equation, Judgement, Record};
use crate::instance::Face;
use num_dual::Dual64;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, b_h_with, distributional_curvature_with, integrate};
use regge::hinge::Hinge;
use regge::hypersurface::{outward, surface_div};
use regge::jet::{Jet1, Jet2};
use regge::lagrange::Lagrange;
use regge::linalg::{Vector, contract, inverse_and_det};
use regge::mesh::Side;
use regge::regge::ReggeSpace;
use regge::riemann::Connection;
use regge::simplex::{Bernstein, Points, subsets};

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
            q(&FaceTerms::new::<K, N>(&g.jet2(side, p), &sigma.jet1(side, p), side.place))
        })
    }

    /// Σ_S ∫θ Tr(σ|_S)vω_S.
    fn hinges<K: Formulas>(&self, g: &Regge<'_, f64, N>, sigma: &Regge<'_, f64, N>) -> Vec<f64> {
        let rule = &self.rules.hinge;
        let g = Seen::<f64, N, _>::new(g, N - 2, rule);
        let sigma = Seen::<f64, N, _>::new(sigma, N - 2, rule);
        let hinges = 0..self.space.mesh().count(N - 2);
        integrate(self.space, N - 2, rule, hinges, |_, side, p| {
            let terms = HingeTerms::new::<K, N>(&g.value(side, p), &sigma.value(side, p), side.place);
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
        let (regge, space) = (ReggeSpace::new(&mesh, at.degree), Lagrange::new(&mesh, at.test));
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let rules = Rules::new::<N>(at.order);
        let moved = moving(&g, &sigma);
        // There are no interior faces: only the sums over cells are production's own.
        let rate = rates(&distributional_curvature_with::<K, Dual64, N, _>(&moved, &space, &rules));
        let b = values(b_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let a = values(a_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let all = Boundary { space: &space, rules };
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
                .right("−Σ_F ∫⟨II‾,σ⟩vω_F", minus(&all.faces::<K>(&g, &sigma, |q| q.second_form)))
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

/// Stokes' theorem on a face.
pub struct T01;

/// Both sides of T01 on every face of one simplex, for one polynomial one-form.
#[derive(Default)]
struct Stokes {
    div: Vec<f64>,
    boundary: Vec<f64>,
    curved: Vec<f64>,
}

/// A polynomial one-form with components α_m = Σ c_mα B_α.
struct OneForm {
    basis: Bernstein,
    coefficients: Vec<f64>,
}

impl OneForm {
    fn new<const N: usize>(draw: &mut Draw) -> Self {
        let basis = Bernstein::new(N + 1, 2);
        Self {
            coefficients: draw.numbers(N * basis.len()),
            basis,
        }
    }

    /// Its components with derivatives at all points.
    fn at<const N: usize>(&self, points: &Points) -> Vec<Vector<Jet1<f64, N>, N>> {
        let table: Vec<Vec<Jet2<f64, N>>> = self.basis.tabulate_jets(points);
        let component = |row: &Vec<Jet2<f64, N>>, m: usize| {
            let c = &self.coefficients[m * row.len()..(m + 1) * row.len()];
            let jet = regge::simplex::combine::<f64, f64, N>(c, row);
            Jet1 { value: jet.value, d: jet.d }
        };
        table.iter().map(|row| Vector::from_fn(|m, _| component(row, m))).collect()
    }
}

impl Stokes {
    fn new<K: Formulas, const N: usize>(g: &Regge<'_, f64, N>, rules: &Rules, alpha: &OneForm) -> Self {
        let mut all = Self::default();
        let on_faces = points_of::<N>(N - 1, &rules.face);
        let seen = Seen::<f64, N, _>::new(g, N - 1, &rules.face);
        for (place, points) in on_faces.iter().enumerate() {
            let side = Side { cell: 0, place };
            let (mut div, mut curved) = (0.0, 0.0);
            for ((q, w), form) in rules.face.weights().iter().enumerate().zip(alpha.at::<N>(points)) {
                let connection = Connection::new(&seen.jet1(side, q));
                let nu = outward_of_face::<f64, N>(place).map(Jet1::constant);
                let face = Face::new::<K>(&connection, &nu);
                div += w * surface_div(&connection, &face.normal, &form) * face.omega;
                let value = form.map(|x| x.value);
                curved += w * face.h * contract(&value, &face.normal.n) * face.omega;
            }
            all.div.push(div);
            all.curved.push(curved);
            all.boundary.push(outflow(g, rules, alpha, opposite::<N>(N - 1, place)[0]));
        }
        all
    }
}

/// ∫_∂F α(ν_F) ω_S of the face opposite to a vertex: over the hinges opposite to it and another.
fn outflow<const N: usize>(g: &Regge<'_, f64, N>, rules: &Rules, alpha: &OneForm, vertex: usize) -> f64 {
    let on_hinges = points_of::<N>(N - 2, &rules.hinge);
    let seen = Seen::<f64, N, _>::new(g, N - 2, &rules.hinge);
    let mut sum = 0.0;
    for (place, _) in subsets(N + 1, N - 1).iter().enumerate() {
        let lacking = opposite::<N>(N - 2, place);
        let Some(face) = lacking.iter().position(|&v| v == vertex) else {
            continue;
        };
        let nu: Vec<Vector<f64, N>> = lacking.iter().map(|&v| outward(v)).collect();
        let forms = alpha.at::<N>(&on_hinges[place]);
        for (q, w) in rules.hinge.weights().iter().enumerate() {
            let (inverse, det) = inverse_and_det(&seen.value(Side { cell: 0, place }, q));
            let hinge = Hinge::new(&inverse, [&nu[0], &nu[1]]);
            // ν_F = −τ.
            let flow = -contract(&forms[q].map(|x| x.value), &hinge.conormal(face));
            sum += w * flow * hinge.omega_s(det);
        }
    }
    sum
}

impl OnMesh for T01 {
    const RECORD: Record = Record {
        label: "T01",
        paper: &["surfacestokes"],
        title: "Stokes' theorem on a face, for forms that are not tangential",
        statement: r"\int_F(\operatorname{div}_F\alpha)\,\omega_F = \int_{\partial F}\alpha(\nu_F)\,\omega_{\partial F} +
            \int_F H\alpha(n)\,\omega_F",
        sides: "Left: derivatives of α on the face. Right: none. Flat faces in a curved metric, every face of a simplex.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        let sides = Stokes::new::<K, N>(&g, &Rules::new::<N>(at.order), &OneForm::new::<N>(draw));
        vec![
            Equation::new("Stokes")
                .left("∫div_Fα ω_F", sides.div)
                .right("∫_∂F α(ν_F)", sides.boundary)
                .right("∫Hα(n)ω_F", sides.curved)
                .vanishes(at.degree == 0, FLAT),
        ]
    }
}
