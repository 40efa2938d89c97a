//! def:optimalorder and the appendix: interpolation errors and the scaling of degrees of freedom.

use crate::best::{Form, best_constant};
use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{mesh, pieces, smooth};
use crate::finding::Finding;
use crate::local::local_function;
use crate::norms::of_tensors;
use crate::pieces::{Pieces, Unknowns};
use crate::rule::Rule;
use crate::series::Series;
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::field::Combination;
use regge_curvature::interpolate::{Canonical, Interpolant};
use regge_curvature::mesh::Mesh;
use regge_curvature::spaces::{ReggeSpace, TestSpace};

/// def:optimalorder for the canonical interpolant; eq. (errorterm1).
pub const A14: Claim = Claim {
    label: "A14",
    paper: &["def:optimalorder", "optimalorder", "errorterm1"],
    title: "The canonical interpolant has optimal order",
    statement: r"|\mathcal J_hg - g|_{W^{t,p}(T)} \le C\,h_T^{s-t}\,|g|_{W^{s,p}(T)},\qquad s = r+1",
    how: "The errors of the library's interpolant of a smooth metric, in L², L^∞ and, for t = 1, in broken H¹, on three families of \
        random meshes: orders r + 1 − t from one side. Forged: the interpolant of one degree less.",
    measure: canonical,
};

/// eq. (optimalorder_general) for the averages; eq. (errorterm2).
pub const A15: Claim = Claim {
    label: "A15",
    paper: &["optimalorder_general", "errorterm2"],
    title: "The averages have optimal order, and stay near the canonical interpolant",
    statement: r"|\mathcal I_hg - g|_{W^{t,p}(T)} \le C\,h_T^{s-t}\sum_{T'\cap T\ne\emptyset}|g|_{W^{s,p}(T')},\qquad
        |\mathcal I_hg - \mathcal J_hg|_{W^{t,p}(T)} \le C\,h_T^{s-t}\sum_{T'\cap T\ne\emptyset}|g|_{W^{s,p}(T')}",
    how: "As for the canonical interpolant, for both averages of the library; and of the paper's average the distance to the \
        canonical interpolant in L² and broken H¹.",
    measure: averages,
};

const SIDES: [[usize; 4]; 2] = [[8, 16, 32, 64], [3, 4, 6, 8]];

/// L², L^∞ and broken H¹ norms of I g − g, or of I g − J g.
fn errors<const N: usize>(
    mesh: &Mesh<N>,
    r: usize,
    interpolant: &Interpolant,
    other: Option<&Interpolant>,
) -> Result<[f64; 3], Error> {
    let (g, space, order) = (smooth(mesh)?, ReggeSpace::new(mesh, r), 2 * r + 6);
    let ours = interpolant.with_order(order).apply(&space, &g)?;
    let distance = match other {
        None => Distance::new(mesh, &Combination::new(-1.0, &g, 1.0, &ours), order),
        Some(other) => {
            let theirs = other.with_order(order).apply(&space, &g)?;
            Distance::new(mesh, &Combination::new(-1.0, &theirs, 1.0, &ours), order)
        }
    };
    Ok([distance.broken(0), distance.sup(0, 0), distance.broken(1)])
}

/// The rates of one interpolant for one degree.
fn rates<const N: usize>(
    effort: &Effort,
    r: usize,
    interpolant: &Interpolant,
    other: Option<&Interpolant>,
) -> Result<Vec<Finding>, Error> {
    let sides = effort.levels(&SIDES[N - 2], 3);
    let of = |degree: usize| {
        effort.sweep(sides, &|side, seed| {
            let mesh = mesh::<N>(side, seed)?;
            Ok((mesh.mesh_size(), errors(&mesh, degree, interpolant, other)?))
        })
    };
    let less = if r > 0 { Some(of(r - 1)?) } else { None };
    let names = ["L²", "L^∞", "broken H¹"];
    let mut all = Vec::new();
    for (i, series) in of(r)?.into_iter().enumerate() {
        let order = r as f64 + if i == 2 { 0.0 } else { 1.0 };
        // Of r = 0, derivatives of g_h vanish and their error is that of g: order 0 says nothing.
        if order == 0.0 {
            continue;
        }
        let with = other.map_or("", |_| " less the canonical one");
        let case = format!(
            "N = {N}, r = {r}, {}{with}, {}",
            interpolant.name(),
            names[i]
        );
        let finding = Finding::new(case, Rule::Order(order), series);
        let finding = match (interpolant.name(), other) {
            ("canonical", _) => finding,
            (_, None) => finding.about(&["optimalorder_general"]),
            (_, Some(_)) => finding.about(&["errorterm2"]),
        };
        all.push(match &less {
            Some(less) => finding.forge("one degree less", less[i].clone()),
            None => finding.forge_claim("an order more", Rule::Order(order + 1.0)),
        });
    }
    Ok(all)
}

fn canonical(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let interpolant = Interpolant::canonical();
    let mut all = Vec::new();
    for r in 0..if effort.quick { 2 } else { 3 } {
        all.extend(rates::<2>(effort, r, &interpolant, None)?);
        if !effort.quick {
            all.extend(rates::<3>(effort, r, &interpolant, None)?);
        }
    }
    Ok(all)
}

fn averages(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let (average, other) = (Interpolant::average(), Interpolant::average_hierarchical());
    let canonical = Interpolant::canonical();
    let mut all = Vec::new();
    for r in 0..if effort.quick { 2 } else { 3 } {
        all.extend(rates::<2>(effort, r, &average, None)?);
        if effort.quick {
            continue;
        }
        all.extend(rates::<2>(effort, r, &average, Some(&canonical))?);
        all.extend(rates::<3>(effort, r, &average, None)?);
        if r > 0 {
            all.extend(rates::<2>(effort, r, &other, None)?);
            all.extend(rates::<3>(effort, r, &other, None)?);
        }
    }
    Ok(all)
}

/// eq. (scaling1).
pub const A16: Claim = Claim {
    label: "A16",
    paper: &["scaling1"],
    title: "The size of the shape functions dual to the canonical degrees of freedom",
    statement: r"\|\psi_i^T\|_{L^p(T)} \le C\,h_T^{N/p-2}",
    how: "The greatest h_T^{2−N/p} ‖ψ_i‖ over all cells and shape functions of random meshes, by level, for p = 2 and p = ∞: it stays \
        bounded. The shape functions by the library, on every cell for itself.",
    measure: shape_functions,
};

fn shape_sizes<const N: usize>(side: usize, seed: u64, r: usize) -> Result<(f64, [f64; 3]), Error> {
    let (pieces, h) = pieces::<N>(side, seed)?;
    let space = pieces.regge_apart(r);
    let canonical = Canonical::new(&space);
    let mut greatest = [0.0_f64; 3];
    for k in 0..TestSpace::cell_len(&space) {
        let values = local_function(&space, k)?.coefficients().to_vec();
        let psi = space.function(canonical.solve(&values))?;
        for cell in Distance::new(space.mesh(), &psi, 2 * r).cells {
            let l2 = cell.squares[0].sqrt();
            let all = [
                cell.h.powf(2.0 - N as f64 / 2.0) * l2,
                cell.h.powi(2) * cell.sup[0],
                cell.h.powf(-(N as f64) / 2.0) * l2,
            ];
            for (greatest, value) in greatest.iter_mut().zip(all) {
                *greatest = greatest.max(value);
            }
        }
    }
    Ok((h, greatest))
}

fn shape_functions(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, r: usize, [square, sup, without]: [Series; 3]| {
        let finding =
            |p, series| Finding::new(format!("N = {n}, r = {r}, p = {p}"), Rule::Bounded, series);
        all.push(finding("2", square).forge("no −2 in the exponent", without));
        all.push(finding("∞", sup));
    };
    for r in 0..3 {
        let sides = effort.levels(&[4, 8, 16, 32], 3);
        add(
            2,
            r,
            effort.sweep(sides, &|side, seed| shape_sizes::<2>(side, seed, r))?,
        );
        if !effort.quick {
            add(
                3,
                r,
                effort.sweep(&[2, 3, 4, 6], &|side, seed| shape_sizes::<3>(side, seed, r))?,
            );
        }
    }
    Ok(all)
}

/// eq. (scaling2), as it should be.
pub const A17: Claim = Claim {
    label: "A17",
    paper: &["scaling2"],
    title: "The size of the canonical degrees of freedom, with the term that the paper leaves out",
    statement: r"|\ell_i^T(g)| \le C\,h_T^{-N/p+2}\big(\|g\|_{L^p(T)} + h_T^s|g|_{W^{s,p}(T)}\big),\qquad s > (N-1)/p",
    how: "The best constant for p = 2 over all g of degree q, by q, the greatest over all degrees of freedom of some cells: with the \
        seminorms up to the least whole s it converges; as printed, without them, it grows, for ℓ_i integrates g over edges. Degrees \
        of freedom by the library. Counterexample: docs/errata.md.",
    measure: functionals,
};

/// The greatest best constants, squared, over the degrees of freedom of degree r of one cell, for g of degree q.
fn functional_sizes<const N: usize>(
    cell: &Pieces<N>,
    r: usize,
    q: usize,
) -> Result<[f64; 2], Error> {
    let canonical = Canonical::new(&cell.regge_apart(r));
    let tensors = cell.regge_apart(q);
    let unknowns = Unknowns::new(&cell.mesh, [q, 1]).tensors_only();
    let columns: Result<Vec<Vec<f64>>, Error> = (0..TestSpace::cell_len(&tensors))
        .map(|k| Ok(canonical.evaluate(&local_function(&tensors, k)?, q + r + 1)))
        .collect();
    let columns = columns?;
    let s = N - 1;
    let terms: Vec<(usize, i32)> = (0..=s).map(|j| (j, 2 * j as i32 + 4 - N as i32)).collect();
    let norms = [
        of_tensors(cell, &unknowns, &terms)?,
        of_tensors(cell, &unknowns, &terms[..1])?,
    ];
    let mut greatest = [0.0_f64; 2];
    for i in 0..columns[0].len() {
        let row: Vec<f64> = columns.iter().map(|column| column[i]).collect();
        let square = DMatrix::from_fn(row.len(), row.len(), |a, b| row[a] * row[b]);
        let mut form = Form::zero(unknowns.len());
        form.add(&unknowns.of_tensors(0), &square);
        for (greatest, norm) in greatest.iter_mut().zip(&norms) {
            *greatest = greatest.max(best_constant(&form, norm)?);
        }
    }
    Ok(greatest)
}

/// A few cells of a random mesh, each a mesh of its own.
fn single_cells<const N: usize>(seed: u64, count: usize) -> Result<Vec<Pieces<N>>, Error> {
    let mesh = mesh::<N>(2, seed)?;
    let single = |cell: usize| {
        let corners = (0..=N).filter_map(|i| mesh.corner(cell, i)).collect();
        Pieces::new(Mesh::new(corners, &[(0..=N).collect()])?)
    };
    (0..count).map(single).collect()
}

fn functionals_in<const N: usize>(
    effort: &Effort,
    r: usize,
    degrees: &[usize],
) -> Result<Finding, Error> {
    let (mut stated, mut printed) = (Vec::new(), Vec::new());
    let cells = single_cells::<N>(effort.seed, if effort.quick { 1 } else { 4 })?;
    for &q in degrees {
        let mut greatest = [0.0_f64; 2];
        for cell in &cells {
            let sizes = functional_sizes(cell, r, q)?;
            greatest = [greatest[0].max(sizes[0]), greatest[1].max(sizes[1])];
        }
        stated.push((q as f64, greatest[0].sqrt()));
        printed.push((q as f64, greatest[1].sqrt()));
    }
    let finding = Finding::new(
        format!("N = {N}, r = {r}, by q"),
        Rule::Bounded,
        Series::over_degree(&[stated]),
    );
    Ok(finding.forge("as printed", Series::over_degree(&[printed])))
}

fn functionals(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = vec![functionals_in::<2>(
        effort,
        0,
        effort.levels(&[1, 2, 3, 4, 5, 6, 7], 5),
    )?];
    if !effort.quick {
        all.push(functionals_in::<2>(effort, 1, &[2, 3, 4, 5, 6, 7])?);
        all.push(functionals_in::<3>(effort, 0, &[1, 2, 3, 4, 5])?);
    }
    Ok(all)
}
