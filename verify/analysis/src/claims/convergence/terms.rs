//! remark:suboptimal: the four terms of the error, and why the hinges' one is better for the canonical interpolant.

use crate::claim::{Claim, Effort};
use crate::errors::{dual_norm, rules};
use crate::families::{mesh, smooth};
use crate::finding::Finding;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::functional::angle_defects;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::spaces::ReggeSpace;
use regge_study::Quantity;

/// remark:suboptimal, eq. (einO) and (angledefectO).
pub const A23: Claim = Claim {
    label: "A23",
    paper: &["remark:suboptimal", "einO", "angledefectO"],
    title: "The four terms of the error for N = 3",
    statement: r"b_h = O(h^{r+1}),\quad \sum_T\int_T\langle G,\sigma\rangle v\,\omega = O(h^{r+1}),\quad
        \mathring{\sum_F}\int_F\langle[\![\overline{II}]\!],\sigma|_F\rangle v\,\omega_F = O(h^{\max(1,2r)}),\quad
        \mathring{\sum_S}\int_S\langle\Theta_S\tilde g|_S,\sigma|_S\rangle v\,\omega_S = O(h^{2r})",
    how: "The H⁻² norms of the four functionals, integrated over t from 0 to 1, for r = 0 and 1, the canonical interpolant and the \
        average, by the library: orders from one side. That the canonical interpolant has order 2(r + 1) in the last term is \
        asserted by the paper from its experiments, and judged in the same way. Where the meshes are too coarse for an order, what is \
        seen is reported.",
    measure: terms,
};

const TERMS: [(Quantity, &str); 4] = [
    (Quantity::BTerm, "b_h"),
    (Quantity::EinsteinTerm, "Einstein term"),
    (Quantity::SecondFormTerm, "second-form term"),
    (Quantity::CriticalTerm, "hinge term"),
];

/// What of the paper each of them is about.
pub(super) const LABELS: [&[&str]; 4] = [
    &["remark:suboptimal"],
    &["remark:suboptimal", "einO"],
    &["remark:suboptimal"],
    &["remark:suboptimal", "angledefectO"],
];

fn norms(
    side: usize,
    seed: u64,
    r: usize,
    interpolant: &Interpolant,
) -> Result<(f64, [f64; 4]), Error> {
    let mesh = mesh::<3>(side, seed)?;
    let (g, norm) = (smooth(&mesh)?, dual_norm(&mesh, r)?);
    let g_h = interpolant
        .with_order(2 * r + 6)
        .apply(&ReggeSpace::new(&mesh, r), &g)?;
    let mut all = [0.0; 4];
    for (value, (quantity, _)) in all.iter_mut().zip(TERMS) {
        let load = quantity.load(&g, &g_h, norm.space(), &rules(3, r));
        *value = norm.of(&load, None)?.total;
    }
    Ok((mesh.mesh_size(), all))
}

/// Where meshes of up to twelve cubes a side (eight for r = 1) are too coarse for an order: what is seen there is reported, and
/// it may be below what is claimed by about half an order.
fn is_coarse(r: usize, is_canonical: bool, term: usize) -> bool {
    match (r, is_canonical) {
        (0, false) => term == 0,
        (1, true) => term == 3,
        (1, false) => term != 1,
        _ => false,
    }
}

fn terms(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    if effort.quick {
        return Ok(all);
    }
    for (r, sides) in [(0, [4, 8, 12]), (1, [4, 6, 8])] {
        for (interpolant, is_canonical) in [
            (Interpolant::canonical(), true),
            (Interpolant::average(), false),
        ] {
            let series: [Series; 4] =
                effort.sweep(&sides, &|side, seed| norms(side, seed, r, &interpolant))?;
            let power = |i: usize| match i {
                0 | 1 => r + 1,
                2 => (2 * r).max(1),
                _ if is_canonical => 2 * (r + 1),
                _ => 2 * r,
            };
            for (i, (series, (_, name))) in series.into_iter().zip(TERMS).enumerate() {
                let order = power(i) as f64;
                let case = format!("r = {r}, {}, {name}", interpolant.name());
                let rule = if is_coarse(r, is_canonical, i) {
                    Rule::Seen
                } else {
                    Rule::Order(order)
                };
                let finding = Finding::new(case, rule, series);
                let wrong = Rule::Order(order + 2.5);
                let finding = finding.forge_claim("two and a half orders more", wrong);
                all.push(finding.about(LABELS[i]));
            }
        }
    }
    Ok(all)
}

/// The mechanism behind remark:suboptimal.
pub const A24: Claim = Claim {
    label: "A24",
    paper: &["remark:suboptimal"],
    title: "The angle defects of the canonical interpolant and of the average, r = 0",
    statement: r"\max_S|\Theta_S(g_h)| = O(h^2)\ \text{(canonical)},\qquad O(h)\ \text{(average)}",
    how: "The greatest |Θ_S| over interior hinges of meshes, by level, N = 2, 3 and 4: why the hinges' term is better for the canonical \
        interpolant. The average is not better than its order: half an order more is refused. For N = 4 the meshes are \
        too coarse to judge the average: what is seen is reported.",
    measure: defects,
};

fn greatest<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 2]), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let (g, space) = (smooth(&mesh)?, ReggeSpace::new(&mesh, 0));
    let of = |interpolant: Interpolant| {
        let g_h = interpolant.with_order(6).apply(&space, &g)?;
        let all = angle_defects(&g_h, &mesh, 1);
        Ok::<_, Error>(all.iter().fold(0.0, |max: f64, s| max.max(s.defect.abs())))
    };
    Ok((
        mesh.mesh_size(),
        [of(Interpolant::canonical())?, of(Interpolant::average())?],
    ))
}

fn defects(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [canonical, average]: [Series; 2]| {
        let case = |name: &str| format!("N = {n}, {name}");
        let finding = Finding::new(case("canonical"), Rule::Order(2.0), canonical);
        all.push(finding.forge("the average", average.clone()));
        // Meshes of eight cubes a side are too coarse for an order when N = 4.
        let rule = if n == 4 { Rule::Seen } else { Rule::Order(1.0) };
        let finding = Finding::new(case("average"), rule, average);
        all.push(finding.forge_claim("half an order more", Rule::Order(1.5)));
    };
    add(
        2,
        effort.sweep(effort.levels(&[16, 32, 64, 128], 3), &greatest::<2>)?,
    );
    if !effort.quick {
        add(3, effort.sweep(&[6, 8, 12, 16], &greatest::<3>)?);
        add(4, effort.sweep(&[4, 6, 8], &greatest::<4>)?);
    }
    Ok(all)
}
