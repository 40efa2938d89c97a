//! thm:conv and cor:conv on other meshes, and for a metric that is not smooth.

use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::errors::{dual_norm, error, right_side};
use crate::families::{alfeld, graded, mesh, noisy, smooth, squeezed, torus, unstructured};
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

/// The meshes that are not Freudenthal's.
fn families<const N: usize>() -> [(MakeMesh<N>, &'static str); 3] {
    [
        (graded, "graded"),
        (alfeld, "Alfeld"),
        (unstructured, "Delaunay"),
    ]
}

/// Shape regularity, and thm:conv on meshes that are not Freudenthal's.
pub const A37: Claim = Claim {
    label: "A37",
    paper: &["thm:conv", "cor:conv"],
    title: "The shape regularity of the meshes, and the estimate on graded ones, Alfeld's and Delaunay's",
    statement: r"C_0 = \sup_h\max_T\frac{h_T}{\rho_T} < \infty;\qquad \|(R\omega)_{\rm dist}(g_h)-(R\omega)(g)\|_{H^{-2}} \le C\,(\ldots)\ \text{as in thm:conv}",
    how: "max h_T/ρ_T by level, ρ_T the radius of the inscribed ball: of the periodically perturbed meshes of these measurements, of tori, of \
        meshes graded towards a point (squares of distances), of Alfeld's splits, and of Delaunay's triangulations of points so far from a lattice that for N = 3 between 3 and 8 cells meet at an edge \
        (patterns of points with slivers, h/ρ above 20, are passed over). Forged: meshes that are squeezed by h. The meshes of the paper's section 5 are beside it, \
        without a claim. On the graded meshes, Alfeld's and Delaunay's, N = 2 and 3: left over right side of thm:conv for the average and for the canonical interpolant with noise, and the order in h where the corollary states one. \
        A20 and A21 have the same on the perturbed meshes. Seen and not judged: the shapes of graded meshes for N = 3, whose map has creases along diagonals with flatter cells across them on each level, and the order on Alfeld's for N = 3, r = 1, which are coarse.",
    measure: other_meshes,
};

/// max h_T/ρ_T of a family of meshes.
fn shapes<const N: usize>(
    effort: &Effort,
    sides: &[usize],
    make: MakeMesh<N>,
) -> Result<Series, Error> {
    let [series] = effort.sweep(sides, &|side, seed| {
        let mesh = make(side, seed)?;
        Ok((mesh.mesh_size(), [shape_regularity(&mesh)]))
    })?;
    Ok(series)
}

/// Meshes that are no shape-regular family: flatter by h.
fn flattened<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    let plain = mesh::<N>(side, seed)?;
    let h = plain.mesh_size();
    squeezed(
        &plain,
        std::array::from_fn(|i| if i == 0 { h } else { 1.0 }),
    )
}

fn of_the_paper<const N: usize>(side: usize, seed: u64) -> Result<Mesh<N>, Error> {
    regge_study::mesh(side.ilog2(), seed)
}

/// Of all families; graded meshes, whose worst cells are far from the centre, from a level further on.
fn all_shapes<const N: usize>(
    effort: &Effort,
    sides: &[usize],
    further: &[usize],
) -> Result<Vec<Finding>, Error> {
    let finding =
        |name: &str, rule, series| Finding::new(format!("N = {N}, h/ρ, {name}"), rule, series);
    let perturbed = shapes::<N>(effort, sides, mesh)?;
    let flat = shapes::<N>(effort, sides, flattened)?;
    let first = finding("perturbed", Rule::Bounded, perturbed);
    let mut all = vec![first.forge("squeezed", flat)];
    let others: [(&str, MakeMesh<N>, &[usize]); 4] = [
        ("tori", torus, sides),
        ("graded", graded, further),
        ("Alfeld", alfeld, sides),
        ("Delaunay", unstructured, sides),
    ];
    for (name, make, sides) in others {
        let series = shapes(effort, sides, make)?;
        // In space a few cells across a crease of the graded meshes' map are flatter on every level so far.
        let rule = match (N, name) {
            (3, "graded") => Rule::Seen,
            _ => Rule::Bounded,
        };
        all.push(finding(name, rule, series));
    }
    let paper = shapes::<N>(effort, sides, of_the_paper)?;
    all.push(finding("the paper's, random", Rule::Seen, paper));
    Ok(all)
}

/// What g_h is made by on these meshes.
const MADE_BY: [&str; 2] = ["average", "canonical with noise of (h_T/2)^{r+1}/100"];

/// The errors of what g_h is made by, and left over right side.
fn quotients<const N: usize>(
    effort: &Effort,
    make: MakeMesh<N>,
    [side, r]: [usize; 2],
    seed: u64,
) -> Result<(f64, [f64; 4]), Error> {
    let mesh = make(side, seed)?;
    let (g, norm, h) = (smooth(&mesh)?, dual_norm(&mesh, r)?, mesh.mesh_size());
    let average = Interpolant::average().with_order(2 * r + 6);
    let made = [
        average.apply(&ReggeSpace::new(&mesh, r), &g)?,
        noisy(&g, r, &|h| 0.01 * (0.5 * h).powi(r as i32 + 1), seed)?,
    ];
    let mut all = [0.0; 4];
    for (i, g_h) in made.iter().enumerate() {
        let [prefactor, size] = right_side(&g, g_h);
        all[i] = error(&g, g_h, &*norm, effort.formulas)?;
        all[i + 2] = all[i] / (prefactor * size);
    }
    Ok((h, all))
}

fn on_meshes<const N: usize>(
    effort: &Effort,
    (make, mesh): (MakeMesh<N>, &str),
    r: usize,
    sides: &[usize],
) -> Result<Vec<Finding>, Error> {
    let series = effort.sweep(sides, &|side, seed| {
        quotients(effort, make, [side, r], seed)
    })?;
    let (errors, ratios) = series.split_at(MADE_BY.len());
    let mut all = Vec::new();
    for ((made_by, error), ratio) in MADE_BY.iter().zip(errors).zip(ratios) {
        let case = |what: &str| format!("N = {N}, r = {r}, {mesh}, {made_by}, {what}");
        // Of degree 0 in space the right side is of the order of 1, and these interpolants do better than that: by an order of up to 2.
        let (name, power) = match (N, r) {
            (3, 0) => ("over three more powers of h", 3),
            _ => ("over one more power of h", 1),
        };
        let over = ratio.over_h_power(power);
        let bounded = Finding::new(case("left over right side"), Rule::Bounded, ratio.clone());
        let bounded = bounded.forge(name, over);
        all.push(bounded.about(&["thm:conv"]));
        // The corollary says nothing of degree 0 in space.
        if N == 2 || r > 0 {
            let order = r as f64 + 1.0;
            // Alfeld's splits of six cubes a side are too coarse for an order in space.
            let rule = match (N, mesh) {
                (3, "Alfeld") => Rule::Seen,
                _ => Rule::Order(order),
            };
            let finding = Finding::new(case("order"), rule, error.clone());
            let finding = finding.forge_claim("an order more", Rule::Order(order + 1.0));
            all.push(finding.about(&["cor:conv"]));
        }
    }
    Ok(all)
}

fn other_meshes(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    let mut all = all_shapes::<2>(effort, sides, sides)?;
    if !effort.quick {
        all.extend(all_shapes::<3>(effort, &[4, 8, 16], &[8, 16, 32])?);
    }
    for r in 0..if effort.quick { 1 } else { 2 } {
        for family in families::<2>() {
            all.extend(on_meshes(effort, family, r, sides)?);
        }
    }
    for r in 0..if effort.quick { 0 } else { 2 } {
        let sides = [[6, 8, 12], [3, 4, 6], [6, 8, 10]];
        for (family, sides) in families::<3>().into_iter().zip(sides) {
            all.extend(on_meshes(effort, family, r, &sides)?);
        }
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
