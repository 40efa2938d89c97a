//! Points that determine a polynomial.
//!
//! A polynomial of degree ≤ d in n variables that vanishes at the whole points α ≥ 0 with |α| ≤ d, its principal lattice, is
//! zero; one that is homogeneous of degree d is zero if it vanishes where |α| = d. In several groups of variables one takes
//! products.
//!
//! Let a polynomial be a sum of parts P_D, each homogeneous of degree D_k in group k. Where the groups outside of a set S are
//! zero, only the parts with D_k = 0 outside of S are left. So, smaller sets first, it is enough to see for every S that the
//! parts with D_k > 0 in S and only there vanish together. A single one is determined by the products of the points
//! |α_k| = D_k; several by those of all smaller degrees, as long as these are positive, for such a sum vanishes anyhow where a
//! group of S is zero.

use super::program::MultiDegree;
use std::collections::{BTreeMap, BTreeSet};

/// A point, by the variables that are not zero: their numbers, each with its value.
pub type Sparse = Vec<(usize, i64)>;

/// Points at which a polynomial whose terms have these multi-degrees must vanish in order to be zero; `groups[k]` lists the
/// variables of group k.
pub fn determining(supports: &BTreeSet<MultiDegree>, groups: &[Vec<usize>]) -> Vec<Sparse> {
    let mut faces: BTreeMap<Vec<usize>, BTreeSet<MultiDegree>> = BTreeMap::new();
    for degree in supports {
        let face = (0..degree.len()).filter(|k| degree[*k] > 0).collect();
        faces.entry(face).or_default().insert(degree.clone());
    }
    let mut points = Vec::new();
    for degrees in faces.values() {
        for degree in closed(degrees) {
            let mut product: Vec<Sparse> = vec![Vec::new()];
            for (variables, d) in groups.iter().zip(&degree) {
                product = times(&product, &homogeneous(variables, *d));
            }
            points.extend(product);
        }
    }
    points.sort_by_key(Vec::len);
    points
}

/// The multi-degrees of one face; if there are several, with all that are smaller and positive in the same groups.
fn closed(degrees: &BTreeSet<MultiDegree>) -> BTreeSet<MultiDegree> {
    if degrees.len() == 1 {
        return degrees.clone();
    }
    let (mut all, mut new) = (degrees.clone(), Vec::from_iter(degrees.iter().cloned()));
    while let Some(degree) = new.pop() {
        for k in 0..degree.len() {
            let mut smaller = degree.clone();
            smaller[k] = smaller[k].saturating_sub(1);
            if smaller[k] > 0 && all.insert(smaller.clone()) {
                new.push(smaller);
            }
        }
    }
    all
}

/// All points with |α| = d in these variables.
fn homogeneous(variables: &[usize], d: u8) -> Vec<Sparse> {
    if d == 0 {
        return vec![Vec::new()];
    }
    let Some((first, rest)) = variables.split_first() else {
        return Vec::new();
    };
    let mut points = Vec::new();
    for a in (0..=d).rev() {
        let own: Sparse = Vec::from_iter((a > 0).then_some((*first, i64::from(a))));
        points.extend(times(&[own], &homogeneous(rest, d - a)));
    }
    points
}

/// Every point of one list with every point of the other.
fn times(one: &[Sparse], other: &[Sparse]) -> Vec<Sparse> {
    let with = |a: &Sparse| {
        other
            .iter()
            .map(move |b| [a.as_slice(), b].concat())
            .collect()
    };
    one.iter()
        .flat_map(|a: &Sparse| -> Vec<Sparse> { with(a) })
        .collect()
}

/// The principal lattice of degree d in these variables, moved to where all of them are positive: 1 + α with |α| ≤ d.
pub fn positive(variables: &[usize], d: u64) -> Vec<Sparse> {
    let Some((first, rest)) = variables.split_first() else {
        return vec![Vec::new()];
    };
    let mut points = Vec::new();
    for a in 0..=d {
        points.extend(times(
            &[vec![(*first, 1 + a as i64)]],
            &positive(rest, d - a),
        ));
    }
    points
}
