//! Section 4: the three parts of the form a_h.

use crate::best::{Form, best_constant};
use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{near, pieces, smooth, torus};
use crate::fields::Waves;
use crate::finding::Finding;
use crate::local::{functions, tensors};
use crate::norms::{of_functions, of_tensors};
use crate::pieces::{Pieces, Unknowns, stretch};
use crate::rule::Rule;
use crate::series::Series;
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::density::{Corner, Inside, outward};
use regge_curvature::field::{Combination, Evaluate, TensorField};
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::angle_defects;
use regge_curvature::jet::lower;
use regge_curvature::linalg::{Vector, inverse_and_det, sandwich};
use regge_curvature::metrics::Smooth;
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::riemann::Connection;
use regge_curvature::simplex::subsets;
use regge_curvature::spaces::ReggeFunction;

/// Σ_T Σ_j h_T^{2j} |·|²_{H^j(T)}, j ≤ top, of σ and of v.
fn both<const N: usize>(pieces: &Pieces<N>, u: &Unknowns<N>, top: usize) -> Result<Form, Error> {
    let terms: Vec<(usize, i32)> = (0..=top).map(|j| (j, 2 * j as i32)).collect();
    let mut norms = of_tensors(pieces, u, &terms)?;
    norms.add_form(1.0, &of_functions(pieces, u, &terms));
    Ok(norms)
}

/// lemma:einbound.
pub const A05: Claim = Claim {
    label: "A05",
    paper: &["lemma:einbound", "prop:ahbound"],
    title: "The Einstein tensor's part of a_h",
    statement: r"\Big|\sum_T\int_T\langle G(\tilde g),\sigma\rangle_{\tilde g}\,v\,\omega_T(\tilde g)\Big|
        \le C\|\sigma\|_{L^2(\Omega)}\|v\|_{L^2(\Omega)}",
    how: "The best constant over all σ and v is the greatest |G ω| over Ω, Euclidean: over the points of a rule in each cell, by \
        level, for Regge metrics of degree 1 with noise of h², whose derivatives stay bounded, as the lemma assumes. Forged: noise \
        of h^{1/2}, whose derivatives do not. G by the library. Together \
        with A06 and A07 it is prop:ahbound.",
    measure: einstein_part,
};

/// max |G(g) ω| over the points of a rule, Euclidean and relative to the Euclidean volume.
fn greatest_einstein(pieces: &Pieces<3>, g: &ReggeFunction<f64, 3>) -> f64 {
    let rule = Quadrature::new(3, 4);
    let table = Evaluate::<f64, 3>::tabulate(g, rule.points());
    let mut greatest = 0.0_f64;
    for cell in 0..pieces.mesh.cell_count() {
        let local = Evaluate::<f64, 3>::on_cell(g, cell);
        let stretch = stretch(&pieces.mesh, cell);
        // The inverse of the frame is the Jacobian, by which upper indices go to the coordinates of ℝ³.
        let jacobian = pieces.mesh.jacobian(cell).expect("there are coordinates");
        for point in 0..rule.len() {
            let jets = g.jet2(&local, &table, point);
            let connection = Connection::new(&lower(&jets));
            let (einstein, omega) = Inside::new(&PAPER, &jets, &connection).einstein();
            let raised = sandwich(&connection.inverse, &einstein) * (omega / stretch);
            greatest = greatest.max((jacobian * raised * jacobian.transpose()).norm());
        }
    }
    greatest
}

fn einstein_constants(side: usize, seed: u64) -> Result<(f64, [f64; 2]), Error> {
    let (pieces, h) = pieces::<3>(side, seed)?;
    let g = smooth(&pieces.mesh)?;
    let of = |a: f64| Ok::<_, Error>(greatest_einstein(&pieces, &near(&g, 1, a, seed)?));
    Ok((h, [of(0.03 * h * h)?, of(0.03 * h.sqrt())?]))
}

fn einstein_part(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let [best, rough] = effort.sweep(effort.levels(&[4, 6, 8, 12], 3), &einstein_constants)?;
    let finding = Finding::new("N = 3, g_h of degree 1", Rule::Bounded, best);
    Ok(vec![finding.forge(
        "derivatives of g_h that do not stay bounded",
        rough,
    )])
}

/// A torus in pieces, with a smooth metric on it and h.
fn closed(side: usize, seed: u64) -> Result<(Pieces<3>, Smooth<Waves, 3>, f64), Error> {
    let mesh = torus::<3>(side, seed)?;
    let (g, h) = (Smooth::new(&mesh, Waves)?, mesh.mesh_size());
    Ok((Pieces::new(mesh)?, g, h))
}

/// lemma:angledefectbound.
pub const A07: Claim = Claim {
    label: "A07",
    paper: &["lemma:angledefectbound", "prop:ahbound"],
    title: "The hinges' part of a_h",
    statement: r"\Big|\mathring{\sum_S}\int_S\langle\Theta_S(\tilde g)\tilde g|_S,\sigma|_S\rangle v\,\omega_S\Big|
        \le C\max_T\big(h_T^{-2}\|g_h-g\|_{L^\infty(T)}\big)
        \Big(\sum_{T,j\le2}h_T^{2j}|\sigma|_{H^j(T)}^2\Big)^{1/2}
        \Big(\sum_{T,j\le2}h_T^{2j}|v|_{H^j(T)}^2\Big)^{1/2}",
    how: "The best constant over Regge functions σ of degree 0 and v of degree 1 on tori, divided by the \
        prefactor, by level, for 5 % noise in the squares of edge lengths. Angle defects, traces and sizes of hinges by the library.",
    measure: hinge_part,
};

/// Twice the hinges' part of a_h for σ of degree 0, with Θ_S g|_S of the midpoint on all of a hinge.
fn hinges<const N: usize, G: TensorField<N, Scalar = f64>>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    g: &G,
) -> Result<Form, Error> {
    let (rule, mesh) = (Quadrature::new(N - 2, u.functions.degree()), &pieces.mesh);
    let (places, apart) = (subsets(N + 1, N - 1), pieces.regge_apart(0));
    let mut form = Form::zero(u.len());
    for defect in angle_defects(g, mesh, 1) {
        let side = mesh.first_side(N - 2, defect.hinge);
        let on = &places[side.place];
        let points = rule.points().embed(on, N + 1);
        let nu: Vec<Vector<f64, N>> = (0..=N).filter(|v| !on.contains(v)).map(outward).collect();
        let local = Evaluate::<f64, N>::on_cell(g, side.cell);
        let middle = Quadrature::new(N - 2, 1).points().embed(on, N + 1);
        let table = Evaluate::<f64, N>::tabulate(g, &middle);
        let (inverse, det) = inverse_and_det(&Evaluate::<f64, N>::value(g, &local, &table, 0));
        let corner = Corner::new(&PAPER, &inverse, det, [&nu[0], &nu[1]]);
        let (basis, psi) = (
            functions::<N>(u.functions.degree(), &points),
            tensors(&apart, &points)?,
        );
        let traces: Vec<f64> = psi[0]
            .iter()
            .map(|psi| corner.trace(&psi.map(|x: regge_curvature::jet::Jet2<f64, N>| x.value)))
            .collect();
        let v = |j: usize| -> f64 {
            let all = rule.weights().iter().zip(&basis);
            all.map(|(weight, basis)| weight * basis[j].value).sum()
        };
        let factor = defect.defect * corner.omega();
        let matrix = DMatrix::from_fn(traces.len(), basis[0].len(), |k, j| {
            factor * traces[k] * v(j)
        });
        form.add_between(
            &u.of_tensors(side.cell),
            &u.of_functions(side.cell),
            &matrix,
        );
    }
    Ok(form)
}

fn hinge_constants(side: usize, seed: u64) -> Result<(f64, [f64; 2]), Error> {
    let (pieces, g, h) = closed(side, seed)?;
    let g_h = near(&g, 0, 0.05, seed)?;
    let u = Unknowns::new(&pieces.mesh, [0, 1]);
    let best = best_constant(&hinges(&pieces, &u, &g_h)?, &both(&pieces, &u, 2)?)?;
    let distance = Distance::new(&pieces.mesh, &Combination::new(-1.0, &g, 1.0, &g_h), 4);
    Ok((h, [-2, -1].map(|power| best / distance.sup(0, power))))
}

fn hinge_part(effort: &Effort) -> Result<Vec<Finding>, Error> {
    if effort.quick {
        return Ok(Vec::new());
    }
    let [best, weaker]: [Series; 2] = effort.sweep(&[4, 6, 8], &hinge_constants)?;
    let finding = Finding::new("N = 3, r = 0", Rule::Bounded, best);
    Ok(vec![finding.forge("h⁻¹ for h⁻² in the prefactor", weaker)])
}
