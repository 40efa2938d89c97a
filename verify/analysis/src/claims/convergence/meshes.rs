//! thm:conv and cor:conv on other meshes, and for a metric that is not smooth.

use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::errors::{dual_norm, error, right_side};
use crate::families::{alfeld, graded, mesh, smooth, squeezed, torus};
use crate::fields::Pointed;
use crate::finding::Finding;
use crate::pieces::shape_regularity;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::field::Combination;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::spaces::ReggeSpace;

type MakeMesh<const N: usize> = fn(usize, u64) -> Result<Mesh<N>, Error>;

/// Shape regularity, and thm:conv on meshes that are not Freudenthal's.
pub const A37: Claim = Claim {
    label: "A37",
    paper: &["thm:conv", "cor:conv"],
    title: "The shape regularity of the meshes, and the estimate on graded ones and on Alfeld's",
    statement: r"C_0 = \sup_h\max_T\frac{h_T}{\rho_T} < \infty;\qquad \|(R\omega)_{\rm dist}(g_h)-(R\omega)(g)\|_{H^{-2}} \le C\,(\ldots)\ \text{as in thm:conv}",
    how: "max h_T/ρ_T by level, ρ_T the radius of the inscribed ball: of the periodically perturbed meshes of these measurements, of tori, of \
        meshes graded towards a point (squares of distances) and of Alfeld's splits. Forged: meshes that are squeezed by h. The meshes of the paper's section 5 are beside it, \
        without a claim. On the graded meshes and Alfeld's, left over right side of thm:conv for the average, and the order in h.",
    measure: other_meshes,
};

fn shapes<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 5]), Error> {
    let plain = mesh::<N>(side, seed)?;
    let h = plain.mesh_size();
    let flat = squeezed(
        &plain,
        std::array::from_fn(|i| if i == 0 { h } else { 1.0 }),
    )?;
    Ok((
        h,
        [
            shape_regularity(&plain),
            shape_regularity(&torus::<N>(side, seed)?),
            shape_regularity(&graded::<N>(side, seed)?),
            shape_regularity(&alfeld::<N>(side, seed)?),
            shape_regularity(&flat),
        ],
    ))
}

fn of_the_paper<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 1]), Error> {
    let mesh: Mesh<N> = regge_study::mesh(side.ilog2(), seed)?;
    Ok((mesh.mesh_size(), [shape_regularity(&mesh)]))
}

/// The error of the average, and left over right side.
fn quotient<const N: usize>(mesh: &Mesh<N>, r: usize, effort: &Effort) -> Result<[f64; 2], Error> {
    let (g, norm) = (smooth(mesh)?, dual_norm(mesh, r)?);
    let g_h = Interpolant::average()
        .with_order(2 * r + 6)
        .apply(&ReggeSpace::new(mesh, r), &g)?;
    let [prefactor, size] = right_side(&g, &g_h);
    let error = error(&g, &g_h, &*norm, effort.formulas)?;
    Ok([error, error / (prefactor * size)])
}

fn on_meshes<const N: usize>(
    effort: &Effort,
    make: MakeMesh<N>,
    case: &str,
    r: usize,
    sides: &[usize],
) -> Result<Vec<Finding>, Error> {
    let [errors, quotients] = effort.sweep(sides, &|side, seed| {
        let mesh = make(side, seed)?;
        Ok((mesh.mesh_size(), quotient(&mesh, r, effort)?))
    })?;
    let case = format!("N = {N}, r = {r}, {case}");
    let ratio = Finding::new(
        format!("{case}, left over right side"),
        Rule::Bounded,
        quotients,
    )
    .about(&["thm:conv"]);
    let order = r as f64 + 1.0;
    let finding = Finding::new(format!("{case}, order"), Rule::Order(order), errors);
    Ok(vec![
        ratio,
        finding
            .forge_claim("an order and a half more", Rule::Order(order + 1.5))
            .about(&["cor:conv"]),
    ])
}

fn other_meshes(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize,
                   [plain, torus, graded, alfeld, flat]: [Series; 5],
                   [paper]: [Series; 1]| {
        let finding =
            |name: &str, rule, series| Finding::new(format!("N = {n}, h/ρ, {name}"), rule, series);
        let first = finding("perturbed", Rule::Bounded, plain);
        all.push(first.forge("squeezed", flat));
        all.push(finding("tori", Rule::Bounded, torus));
        all.push(finding("graded", Rule::Bounded, graded));
        all.push(finding("Alfeld", Rule::Bounded, alfeld));
        all.push(finding("the paper's, random", Rule::Seen, paper));
    };
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    add(
        2,
        effort.sweep(sides, &shapes::<2>)?,
        effort.sweep(sides, &of_the_paper::<2>)?,
    );
    if !effort.quick {
        let sides = [4, 8, 16];
        add(
            3,
            effort.sweep(&sides, &shapes::<3>)?,
            effort.sweep(&sides, &of_the_paper::<3>)?,
        );
    }
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    for r in 0..if effort.quick { 1 } else { 2 } {
        all.extend(on_meshes::<2>(effort, graded::<2>, "graded", r, sides)?);
        all.extend(on_meshes::<2>(effort, alfeld::<2>, "Alfeld", r, sides)?);
    }
    Ok(all)
}

/// cor:conv with p.
pub const A38: Claim = Claim {
    label: "A38",
    paper: &["cor:conv"],
    title: "The corollary for a metric with few derivatives: what p is for",
    statement: r"\|(R\omega)_{\rm dist}(g_h)-(R\omega)(g)\|_{H^{-2}} \le C\Big(\sum_Th_T^{p(r+1)}|g|_{W^{r+1,p}(T)}^p\Big)^{1/p},
        \qquad g = \delta+|x|^{5/2}A,\ N=2,\ r=2,\ p=2",
    how: "A metric with a singularity |x|^α at a vertex of the mesh, α = 5/2: it has three derivatives in L^p for p < 4 only, and none of the third ones is \
        bounded. The order of the error is still r + 1 = 3, as for p = 2; by p = ∞ nothing is said, by W^{5/2,∞} no more than 5/2. Interpolants: canonical and average. |g|_{W^{2,∞}}, of which \
        the theorem asks that it is finite, is. Forged: α = 3/2, which has three derivatives in no L^p, p ≥ 2. Beside it the norm of g_h − g of the right side.",
    measure: pointed,
};

/// The vertex in the middle stays where the singularity is.
fn centred(side: usize, seed: u64) -> Result<Mesh<2>, Error> {
    let mesh = mesh::<2>(side, seed)?;
    let points = mesh.points().ok_or(Error::NoCoordinates("a mesh"))?;
    let shift = points[points.len() / 2];
    // A smooth map that moves the middle vertex to 0 and leaves the boundary alone.
    let moved = points.iter().map(|p| {
        let share: f64 = p.iter().map(|x| 1.0 - x * x).product();
        *p - shift * share
    });
    let moved = moved.collect();
    let cell = |cell| mesh.vertices(2, cell).iter().map(|v| *v as usize).collect();
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count()).map(cell).collect();
    let mut all: Vec<_> = moved;
    let middle = all.len() / 2;
    all[middle] = regge_curvature::linalg::Vector::zeros();
    Mesh::new(all, &cells)
}

fn errors_of<M: SmoothTensor<2>>(
    effort: &Effort,
    mesh: &Mesh<2>,
    formula: M,
) -> Result<[f64; 3], Error> {
    let r = 2;
    let (g, norm) = (Smooth::new(mesh, formula)?, dual_norm(mesh, r)?);
    let by = |interpolant: Interpolant| {
        interpolant
            .with_order(2 * r + 10)
            .apply(&ReggeSpace::new(mesh, r), &g)
    };
    let (canonical, average) = (by(Interpolant::canonical())?, by(Interpolant::average())?);
    let sigma = Combination::new(-1.0, &g, 1.0, &average);
    let square = |j: usize| {
        let points = Distance::at_points(mesh, &sigma, &Quadrature::new(2, 8), j);
        points.iter().map(|(w, x)| w * x * x).sum::<f64>()
    };
    Ok([
        error(&g, &canonical, &*norm, effort.formulas)?,
        error(&g, &average, &*norm, effort.formulas)?,
        (square(0) + square(1)).sqrt(),
    ])
}

fn pointed(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    let series = effort.sweep(sides, &|side, seed| {
        let mesh = centred(side, seed)?;
        let [a, b, c] = errors_of(effort, &mesh, Pointed { k: 2 })?;
        let [d, e, f] = errors_of(effort, &mesh, Pointed { k: 1 })?;
        Ok((mesh.mesh_size(), [a, b, c, d, e, f]))
    })?;
    let [a, b, c, d, e, f] = series;
    let finding = |name: &str, series, wrong| {
        let finding = Finding::new(format!("α = 5/2, {name}"), Rule::Order(3.0), series);
        finding.forge("α = 3/2", wrong)
    };
    Ok(vec![
        finding("canonical", a, d),
        finding("average", b, e),
        finding("norm of g_h − g, average", c, f),
    ])
}
