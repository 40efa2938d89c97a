//! Section 4: trace inequalities, on faces and on hinges.

use crate::best::{Form, best_constant};
use crate::claim::{Claim, Effort};
use crate::families::pieces;
use crate::finding::Finding;
use crate::local::{Gram, function_components, functions};
use crate::pieces::{Pieces, stretch};
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::density::{Corner, Normal, outward};
use regge_curvature::formulas::PAPER;
use regge_curvature::linalg::{Vector, inverse_and_det};
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::simplex::{binomial, factorial, subsets};

/// eq. (traceineq).
pub const A12: Claim = Claim {
    label: "A12",
    paper: &["traceineq"],
    title: "The trace inequality on faces, with an explicit constant",
    statement: r"\|u\|_{L^2(F)}^2 \le C\big(h_T^{-1}\|u\|_{L^2(T)}^2 + h_T|u|_{H^1(T)}^2\big),\qquad
        C = \frac{h_T|F|}{|T|}\Big(\tfrac12 + \sqrt{\tfrac14 + N^{-2}}\Big)",
    how: "The best constant over polynomials of degree p, over the explicit one, by p: the greatest over all cells of random \
        meshes and their faces. The explicit constant: the divergence theorem for u²(x − P), P opposite to F. The components of \
        dv are such u.",
    measure: on_faces,
};

/// The greatest best constants over cells and simplices of codimension c: with all terms, and without derivatives. `explicit`
/// is what they are divided by.
fn trace_constants<const N: usize>(
    pieces: &Pieces<N>,
    c: usize,
    p: usize,
    explicit: &dyn Fn(usize, usize) -> f64,
) -> Result<[f64; 2], Error> {
    let (rule, on) = (Quadrature::new(N, 2 * p), subsets(N + 1, N + 1 - c));
    let basis = functions::<N>(p, rule.points());
    let all: Vec<usize> = (0..basis[0].len()).collect();
    let mut greatest = [0.0_f64; 2];
    for cell in 0..pieces.mesh.cell_count() {
        let (frame, h) = (pieces.euclidean_frame(cell), pieces.diameter(cell));
        let volume = stretch(&pieces.mesh, cell);
        let norm = |top: usize| {
            let mut gram = Gram::new(all.len());
            for (point, weight) in rule.weights().iter().enumerate() {
                for order in 0..=top {
                    let of = |v| function_components(v, &frame, order);
                    let components: Vec<_> = basis[point].iter().map(of).collect();
                    gram.add(
                        weight * volume * h.powi(2 * order as i32 - c as i32),
                        &components,
                    );
                }
            }
            let mut form = Form::zero(all.len());
            form.add(&all, &gram.matrix());
            form
        };
        let norms = [norm(c), norm(0)];
        for (place, vertices) in on.iter().enumerate() {
            let mut form = Form::zero(all.len());
            form.add(&all, &trace_gram(pieces, cell, vertices, p).matrix());
            for (greatest, norm) in greatest.iter_mut().zip(&norms) {
                *greatest = greatest.max(best_constant(&form, norm)? / explicit(cell, place));
            }
        }
    }
    Ok(greatest)
}

/// ∫ v_i v_j over a simplex of codimension 1 or 2 of a cell.
fn trace_gram<const N: usize>(
    pieces: &Pieces<N>,
    cell: usize,
    vertices: &[usize],
    p: usize,
) -> Gram {
    let rule = Quadrature::new(vertices.len() - 1, 2 * p);
    let basis = functions::<N>(p, &rule.points().embed(vertices, N + 1));
    let size = size(pieces, cell, vertices);
    let mut gram = Gram::new(basis[0].len());
    for (weight, basis) in rule.weights().iter().zip(&basis) {
        let values: Vec<Vec<f64>> = basis.iter().map(|v| vec![v.value]).collect();
        gram.add(weight * size, &values);
    }
    gram
}

/// The volume of a simplex of codimension 1 or 2 of a cell, relative to that of the reference simplex of its dimension.
fn size<const N: usize>(pieces: &Pieces<N>, cell: usize, vertices: &[usize]) -> f64 {
    let jacobian = pieces.mesh.jacobian(cell).expect("there are coordinates");
    let (inverse, det) = inverse_and_det(&(jacobian.transpose() * jacobian));
    let nu: Vec<Vector<f64, N>> = (0..=N)
        .filter(|v| !vertices.contains(v))
        .map(outward)
        .collect();
    match &nu[..] {
        [nu] => Normal::new(&PAPER, &inverse, det, nu).omega,
        [a, b, ..] => Corner::new(&PAPER, &inverse, det, [a, b]).omega(),
        [] => det.sqrt(),
    }
}

fn degrees(effort: &Effort, all: &[usize]) -> Vec<usize> {
    effort.levels(all, 3).to_vec()
}

fn faces_in<const N: usize>(effort: &Effort, degrees: &[usize]) -> Result<Finding, Error> {
    let (pieces, _) = pieces::<N>(2, effort.seed)?;
    let places = subsets(N + 1, N);
    let explicit = |cell: usize, place: usize| {
        let n = N as f64;
        let face = size(&pieces, cell, &places[place]) / factorial(N - 1);
        let volume = stretch(&pieces.mesh, cell) / factorial(N);
        pieces.diameter(cell) * face / volume * (0.5 + (0.25 + 1.0 / (n * n)).sqrt())
    };
    let (mut stated, mut without) = (Vec::new(), Vec::new());
    for &p in degrees {
        let [full, values] = trace_constants(&pieces, 1, p, &explicit)?;
        stated.push((p as f64, full));
        without.push((p as f64, values));
    }
    let finding = Finding::new(
        format!("N = {N}"),
        Rule::AtMost(1.0),
        Series::over_degree(&[stated]),
    );
    Ok(finding.forge("no derivatives", Series::over_degree(&[without])))
}

fn on_faces(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = vec![faces_in::<2>(
        effort,
        &degrees(effort, &[1, 2, 4, 6, 8, 10]),
    )?];
    if !effort.quick {
        all.push(faces_in::<3>(effort, &[1, 2, 3, 4, 5])?);
    }
    Ok(all)
}

/// The trace inequality of codimension 2.
pub const A13: Claim = Claim {
    label: "A13",
    paper: &["lemma:angledefectbound"],
    title: "The trace inequality on hinges",
    statement: r"\|v\|_{L^2(S)}^2 \le C\big(h_T^{-2}\|v\|_{L^2(T)}^2 + |v|_{H^1(T)}^2 + h_T^2|v|_{H^2(T)}^2\big)",
    how: "The best constant over polynomials of degree p, by p: the greatest over all cells of random meshes and their hinges. \
        It is a step in the proof of lemma:angledefectbound.",
    measure: on_hinges,
};

fn hinges_in<const N: usize>(effort: &Effort, degrees: &[usize]) -> Result<Finding, Error> {
    let (pieces, _) = pieces::<N>(2, effort.seed)?;
    let (mut stated, mut without) = (Vec::new(), Vec::new());
    for &p in degrees {
        let [full, values] = trace_constants(&pieces, 2, p, &|_, _| 1.0)?;
        stated.push((p as f64, full));
        without.push((p as f64, values));
    }
    let dimension = |p: usize| binomial(N + p, N);
    let case = format!(
        "N = {N}, {} to {} functions",
        dimension(degrees[0]),
        dimension(degrees[degrees.len() - 1])
    );
    let finding = Finding::new(case, Rule::Bounded, Series::over_degree(&[stated]));
    Ok(finding.forge("no derivatives", Series::over_degree(&[without])))
}

fn on_hinges(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = vec![hinges_in::<2>(effort, &degrees(effort, &[2, 3, 4, 6, 8]))?];
    if !effort.quick {
        all.push(hinges_in::<3>(effort, &[2, 3, 4, 5])?);
    }
    Ok(all)
}
