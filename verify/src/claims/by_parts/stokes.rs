//! T01: Stokes' theorem on a face.

use crate::harness::{Draw, Equation, Ground, Judgement, Record, Setting, each, list};
use crate::stage::fields::{Regge, Seen, metric, points_of};
use crate::stage::mesh::{FLAT, OnMesh, QUADRATURE, on_one_simplex, opposite, outward_of_face};
use crate::stage::point::Face;
use crate::stage::polynomial::{ByParts, Exactly, poison};
use regge_curvature::density::{Corner, outward, surface_div};
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::Rules;
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Vector, contract, inverse_and_det};
use regge_curvature::mesh::Side;
use regge_curvature::riemann::Connection;
use regge_curvature::simplex::{Bernstein, Derivatives, JetTable, Points, subsets};
use regge_curvature::spaces::ReggeSpace;

/// Stokes' theorem on a face.
pub struct T01;

/// Both sides of T01 on every face of one simplex, for one polynomial one-form.
#[derive(Default)]
struct Stokes {
    div: Vec<f64>,
    boundary: Vec<f64>,
    curved: Vec<f64>,
}

/// The degree of a one-form's components.
const DEGREE: usize = 2;

/// A polynomial one-form with components α_m = Σ c_mα B_α; each component's coefficients are followed by those of its
/// derivatives.
struct OneForm {
    components: Vec<Vec<f64>>,
}

impl OneForm {
    fn new<const N: usize>(draw: &mut Draw) -> Self {
        let size = Bernstein::new(N + 1, DEGREE).len();
        let coefficients = draw.numbers(N * size);
        let derivatives = Derivatives::<N>::new(DEGREE);
        let components = coefficients.chunks_exact(size);
        Self {
            components: components.map(|c| derivatives.follow(1, c)).collect(),
        }
    }

    /// Its components with derivatives at all points.
    fn at<const N: usize>(&self, points: &Points) -> Vec<Vector<Jet1<f64, N>, N>> {
        let table = JetTable::<f64, N>::new(DEGREE, points);
        let component = |q: usize, m: usize| table.jet1(q, &self.components[m]);
        list(points.len(), |q| Vector::from_fn(|m, _| component(q, m)))
    }
}

impl Stokes {
    fn new<const N: usize>(at: &Setting, g: &Regge<f64, N>, alpha: &OneForm) -> Self {
        let (mut all, rules) = (Self::default(), at.rules(N));
        let on_faces = points_of::<N>(N - 1, &rules.faces);
        let seen = Seen::<f64, N, _>::new(g, N - 1, &rules.faces);
        for (place, points) in on_faces.iter().enumerate() {
            let side = Side { cell: 0, place };
            let (mut div, mut curved) = (0.0, 0.0);
            for ((q, w), form) in rules
                .faces
                .weights()
                .iter()
                .enumerate()
                .zip(alpha.at::<N>(points))
            {
                let connection = Connection::new(&seen.jet1(side, q));
                let nu = outward_of_face::<f64, N>(place).map(Jet1::constant);
                let face = Face::new(&at.formulas, &connection, &nu);
                let omega = w * face.normal.omega;
                div += surface_div(&connection, &face.normal, &form) * omega;
                let value = form.map(|x| x.value);
                curved += face.h * contract(&value, &face.normal.n) * omega;
            }
            all.div.push(div);
            all.curved.push(curved);
            let vertex = opposite::<N>(N - 1, place)[0];
            all.boundary
                .push(outflow(&at.formulas, g, &rules, alpha, vertex));
        }
        all
    }
}

/// ∫_∂F α(ν_F) ω_S of the face opposite to a vertex: over the hinges opposite to it and another.
fn outflow<const N: usize>(
    formulas: &Formulas,
    g: &Regge<f64, N>,
    rules: &Rules,
    alpha: &OneForm,
    vertex: usize,
) -> f64 {
    let on_hinges = points_of::<N>(N - 2, &rules.hinges);
    let seen = Seen::<f64, N, _>::new(g, N - 2, &rules.hinges);
    let mut sum = 0.0;
    for (place, _) in subsets(N + 1, N - 1).iter().enumerate() {
        let lacking = opposite::<N>(N - 2, place);
        let Some(face) = lacking.iter().position(|&v| v == vertex) else {
            continue;
        };
        let nu: Vec<Vector<f64, N>> = each(&lacking, |&v| outward(v));
        let forms = alpha.at::<N>(&on_hinges[place]);
        for (q, w) in rules.hinges.weights().iter().enumerate() {
            let (inverse, det) = inverse_and_det(&seen.value(Side { cell: 0, place }, q));
            let corner = Corner::new(formulas, &inverse, det, [&nu[0], &nu[1]]);
            // ν_F = −τ.
            let flow = -contract(&forms[q].map(|x| x.value), &corner.conormal(face));
            sum += w * flow * corner.omega();
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
        sides: "Left: derivatives of α on the face. Right: none. Flat faces in a curved metric, every face of a simplex. Exactly \
            as T04, for α = vσ(n,·).",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        let sides = Stokes::new::<N>(at, &g, &OneForm::new::<N>(draw));
        vec![
            Equation::new("Stokes")
                .left("∫div_Fα ω_F", sides.div)
                .right("∫_∂F α(ν_F)", sides.boundary)
                .right("∫Hα(n)ω_F", sides.curved)
                .vanishes(at.degree == 0, FLAT),
        ]
    }
}

/// The same equation between integrals that are computed without error, for α = vσ(n,·).
impl ByParts for T01 {
    const RECORD: Record = <Self as OnMesh>::RECORD;

    fn equations<F: Ground, const N: usize>(
        numbers: &[F],
        formulas: &Formulas,
    ) -> Vec<Equation<F>> {
        let at = Exactly::<F, N>::on_single(numbers, formulas);
        let (mut div, mut boundary, mut curved) = (Vec::new(), Vec::new(), Vec::new());
        for f in 0..=N {
            let mut outflow = F::zero();
            for other in (0..=N).filter(|o| *o != f) {
                // ν_F = −τ.
                outflow -= at.integral(N - 2, &|l| [at.hinge(0, [f, other], l)[0]])[0];
            }
            boundary.push(outflow);
            let [d, h] = if outflow.is_poison() {
                poison()
            } else {
                at.integral(N - 1, &|l| {
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
    }
}
