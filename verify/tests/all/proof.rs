//! Proofs by a determining set: the set determines, the numbers are exact, and what is not true in all coordinates is not proved.

use proptest::prelude::*;
use regge_curvature::formulas::{Formulas, PAPER};
use regge_curvature::linalg::identity;
use regge_curvature::riemann::trace;
use regge_curvature::scalar::{Algebraic, Field, power};
use regge_verify::claims::at_a_point;
use regge_verify::exact::{
    Fp, MultiDegree, Ratio, Sparse, determining, positive, record, supports,
};
use regge_verify::harness::{Catalogue, Entry, Equation, Method, Record, Timed, Verdict};
use regge_verify::stage::point::{Instance, Pointwise, add};
use regge_verify::{Options, run_catalogue};
use std::collections::BTreeSet;

/// All monomials in these variables with these degrees by group.
fn monomials(supports: &BTreeSet<MultiDegree>, groups: &[Vec<usize>]) -> Vec<Vec<u32>> {
    let count = groups.iter().map(Vec::len).sum();
    let mut all = vec![vec![0; count]];
    let most = supports.iter().flatten().max().copied().unwrap_or(0);
    for k in 0..count {
        let with = |m: &Vec<u32>| {
            let raised = |e| {
                let mut m = m.clone();
                m[k] = e;
                m
            };
            (0..=u32::from(most)).map(raised).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(with).collect();
    }
    let degree = |m: &Vec<u32>| -> MultiDegree {
        let of = |g: &Vec<usize>| g.iter().map(|k| m[*k]).sum::<u32>() as u8;
        groups.iter().map(of).collect()
    };
    all.retain(|m| supports.contains(&degree(m)));
    all
}

/// The rank of the monomials' values at the points, by elimination over F_p.
fn rank(monomials: &[Vec<u32>], points: &[Sparse]) -> usize {
    let value = |m: &Vec<u32>, point: &Sparse| {
        let at = |k: usize| point.iter().find(|(l, _)| *l == k).map_or(0, |(_, x)| *x);
        let factors = m
            .iter()
            .enumerate()
            .map(|(k, e)| power(Fp::from_int(at(k)), *e));
        factors.fold(Fp::one(), |product, x| product * x)
    };
    let mut rows: Vec<Vec<Fp>> = (points.iter())
        .map(|p| monomials.iter().map(|m| value(m, p)).collect())
        .collect();
    let mut rank = 0;
    for column in 0..monomials.len() {
        let Some(pivot) = (rank..rows.len()).find(|r| rows[*r][column] != Fp::zero()) else {
            continue;
        };
        rows.swap(rank, pivot);
        for r in rank + 1..rows.len() {
            let factor = rows[r][column] / rows[rank][column];
            for c in column..monomials.len() {
                let x = rows[rank][c];
                rows[r][c] -= factor * x;
            }
        }
        rank += 1;
    }
    rank
}

#[test]
fn the_points_determine_the_polynomials() {
    let groups = vec![vec![0, 1], vec![2, 3, 4]];
    let cases: [&[[u8; 2]]; 5] = [
        &[[1, 1]],
        &[[2, 1], [0, 2], [1, 0]],
        &[[0, 0], [3, 0]],
        // Two in the same groups.
        &[[2, 1], [1, 2], [1, 0]],
        &[[1, 1], [2, 2]],
    ];
    for case in cases {
        let supports: BTreeSet<MultiDegree> = case.iter().map(|d| d.to_vec()).collect();
        let monomials = monomials(&supports, &groups);
        let points = determining(&supports, &groups);
        assert_eq!(rank(&monomials, &points), monomials.len(), "{case:?}");
    }
    // Where no two are in the same groups, there is no point too many.
    let supports = BTreeSet::from([vec![2, 1], vec![0, 2]]);
    let points = determining(&supports, &groups);
    assert_eq!(points.len(), monomials(&supports, &groups).len());
    assert!(rank(&monomials(&supports, &groups), &points[1..]) < points.len());
}

#[test]
fn positive_points_determine_too() {
    let groups = vec![vec![0, 1, 2]];
    let supports: BTreeSet<MultiDegree> = (0..=4).map(|d| vec![d]).collect();
    let (points, all) = (positive(&groups[0], 4), monomials(&supports, &groups));
    assert_eq!(points.len(), all.len());
    assert_eq!(rank(&all, &points), all.len());
    assert!(points.iter().flatten().all(|(_, x)| *x > 0));
}

#[test]
fn supports_are_those_of_the_expanded_polynomial() {
    let of = |f: fn(&[regge_verify::exact::Recorded]) -> regge_verify::exact::Recorded| {
        let (program, result) = record(3, f);
        let needed = program.needed([result]);
        supports(&program, &[Some(0), Some(1), None], 2, &needed, &[result])
    };
    let set = |d: &[[u8; 2]]| Some(d.iter().map(|d| d.to_vec()).collect::<BTreeSet<_>>());
    assert_eq!(of(|x| x[0] * x[0] + x[1]), set(&[[2, 0], [0, 1]]));
    assert_eq!(of(|x| (x[0] + x[1]) * x[1]), set(&[[1, 1], [0, 2]]));
    // Parameters may be anywhere, jets not.
    assert_eq!(of(|x| x[0] / x[2].sqrt()), set(&[[1, 0]]));
    assert_eq!(of(|x| x[2] / x[0]), None);
    assert_eq!(of(|x| x[1].sqrt()), None);
}

proptest! {
    #[test]
    fn rational_numbers_are_exact(a in -99i64..99, b in 1i64..99, c in -99i64..99, d in 1i64..99) {
        let (x, y) = (Ratio::ratio(a, b), Ratio::ratio(c, d));
        prop_assert_eq!(x + y, Ratio::ratio(a * d + c * b, b * d));
        prop_assert_eq!(x - y, Ratio::ratio(a * d - c * b, b * d));
        prop_assert_eq!(x * y, Ratio::ratio(a * c, b * d));
        prop_assert_eq!((x * x).sqrt(), if a < 0 { -x } else { x });
        if c == 0 {
            prop_assert!((x / y).is_poison());
        } else {
            prop_assert_eq!(x / y, Ratio::ratio(a * d, b * c));
        }
    }
}

#[test]
fn nothing_is_rounded() {
    let two = Ratio::from_int(2);
    assert!(two.sqrt().is_poison());
    let large = power(two, 126);
    assert!(!large.is_poison());
    assert!((large * two).is_poison());
    assert!((large + large).is_poison());
    assert!((Ratio::POISON * Ratio::zero()).is_poison());
    assert!((Ratio::POISON + two).is_poison());
    assert!((two / Ratio::POISON).is_poison());
}

/// The proofs of some claims when N = 3.
fn proofs(mut all: Catalogue, only: &[&str], formulas: Formulas) -> Vec<Entry> {
    all.retain(|c| c.method == Method::Proof && c.dimension == 3);
    let options = Options {
        only: only.iter().map(|l| (*l).to_owned()).collect(),
        formulas,
        ..Options::default()
    };
    let report = run_catalogue(all, &options, &|_| ());
    report.unwrap_or_else(|e| panic!("{e}")).claims
}

#[test]
fn the_variation_of_the_curvature_is_proved() {
    let entries = proofs(at_a_point(), &["P01", "P20", "P24"], PAPER);
    assert_eq!(entries.len(), 3);
    for entry in &entries {
        assert_eq!(entry.verdict, Verdict::Pass, "{}", entry.describe_failure());
        let proof = entry.proof.as_ref().expect("a proof");
        assert!(proof.points > 0 && proof.motion_log2 < -60.0, "{proof:?}");
        for forgery in &entry.forgeries {
            assert!(
                forgery.refuted_at.is_some(),
                "{}: {}",
                entry.label,
                forgery.name
            );
        }
    }
    // Ṙ when N = 3: 36 ∂²σ, 36·6 (∂²g)σ, 18·18 (∂g)(∂σ), C(19,2)·6 (∂g)²σ; not all of these variables are in it.
    let proof = entries[0].proof.as_ref().expect("a proof");
    let monomials = ["(∂²σ)", "(∂²g) (σ)", "(∂g) (∂σ)", "(∂g)² (σ)"];
    let found: BTreeSet<&str> = proof.equations[0]
        .monomials
        .iter()
        .map(String::as_str)
        .collect();
    assert_eq!(found, BTreeSet::from(monomials));
    assert_eq!(proof.degree, 3);
}

#[test]
fn equations_between_two_metrics_are_proved() {
    let entries = proofs(at_a_point(), &["D08", "D13", "I01", "I02", "I20"], PAPER);
    assert_eq!(entries.len(), 5);
    for entry in &entries {
        assert_eq!(entry.verdict, Verdict::Pass, "{}", entry.describe_failure());
        assert!(entry.forgeries.iter().all(|f| f.refuted_at.is_some()));
        let proof = entry.proof.as_ref().expect("a proof");
        // None has many points; with all entries of a second metric it was 29 322 for ⟦II⟧.
        assert!((1..1000).contains(&proof.points), "{proof:?}");
        // ⟦II⟧ and the cosines are proved metric by metric. 1/√a − 1/√b is one equation of both.
        let names = proof.equations.iter().map(|e| e.equation.as_str());
        let parts: Vec<&str> = names.filter(|n| n.contains("(the terms ")).collect();
        let wanted = if ["D08", "I20"].contains(&entry.label.as_str()) {
            2
        } else {
            0
        };
        assert_eq!(parts.len(), wanted, "{}: {parts:?}", entry.label);
        if entry.label == "I20" {
            assert!(parts.contains(&"cos θ − cos θ̃ (the terms cos θ; −g(n¹,n²))"));
        }
    }
}

/// These formulas, and claims that are refuted with them; others that are proved all the same.
fn refuted(formulas: Formulas, broken: &[&str], sound: &[&str]) {
    let entries = proofs(at_a_point(), broken, formulas);
    assert_eq!(entries.len(), broken.len(), "{broken:?}");
    for entry in entries {
        assert_eq!(entry.verdict, Verdict::Fail, "{}", entry.label);
        let failure = entry.failure.as_ref().expect("a failure");
        assert!(failure.what.contains("left − right = "), "{failure:?}");
        // A point of the lattice: one, two or three jets are not zero, beside parameters.
        let jets = failure.instance.iter().filter(|x| !x.starts_with("u = "));
        assert!((1..=3).contains(&jets.count()), "{failure:?}");
    }
    let entries = proofs(at_a_point(), sound, formulas);
    assert!(entries.iter().all(|e| e.verdict == Verdict::Pass));
}

#[test]
fn a_broken_formula_has_a_counterexample() {
    let second_form = Formulas {
        second_form: -1,
        ..PAPER
    };
    refuted(second_form, &["D03", "P13", "P20"], &["P01", "P22"]);
    let reverse_trace_halves = Formulas {
        reverse_trace_halves: 1,
        ..PAPER
    };
    refuted(
        reverse_trace_halves,
        &["D13", "I09", "P03", "P17"],
        &["P10"],
    );
    let dihedral_cos = Formulas {
        dihedral_cos: -1,
        ..PAPER
    };
    refuted(dihedral_cos, &["D09", "I20", "P24"], &["D13", "P01"]);
    let trace_reversed = Formulas {
        trace_reversed: 0,
        ..PAPER
    };
    refuted(trace_reversed, &["D07", "P19"], &["P13"]);
}

/// Σσ_ii is the trace where g = δ, and nowhere else.
struct Euclidean;

impl Pointwise for Euclidean {
    const RECORD: Record = Record {
        label: "X01",
        paper: &[],
        title: "",
        statement: "",
        sides: "",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        vec![
            Equation::new("trace")
                .left("Σσ_ii", trace(&identity(), &i.sigma0()))
                .right("Tr σ", i.still0().trace(&i.sigma0())),
        ]
    }
}

#[test]
fn what_holds_in_normal_position_alone_is_not_proved() {
    let mut all = Catalogue::new();
    add::<Euclidean, 3>(&mut all);
    let entries = proofs(all, &[], PAPER);
    assert_eq!(entries.len(), 1);
    assert_eq!(entries[0].verdict, Verdict::Fail);
}
