//! Integration of polynomials over simplices in a prime field, exactly.
//!
//! ∫ of a monomial over the reference simplex is a rational number, hence an element of the field if the degree is below p.
//! The rule is conical: one interpolatory rule in each direction, its nodes any distinct elements of the field. In
//! the last direction they are chosen where the integrand's square roots exist.

use regge_curvature::scalar::{Field, power};

/// Weights w_i = ∫₀¹ ℓ_i(t) dt of the interpolatory rule at these nodes: exact for degree < number of nodes.
fn weights<F: Field>(nodes: &[F]) -> Vec<F> {
    // The coefficients of ∏ (t − t_j), lowest first.
    let mut master = vec![F::one()];
    for node in nodes {
        master.insert(0, F::zero());
        for k in 0..master.len() - 1 {
            let next = master[k + 1];
            master[k] -= *node * next;
        }
    }
    nodes.iter().map(|&node| weight(&master, node)).collect()
}

/// ∫₀¹ of ∏ (t − t_j)/(t − node), divided by its value at the node.
fn weight<F: Field>(master: &[F], node: F) -> F {
    let (mut quotient, mut value, mut integral) = (F::zero(), F::zero(), F::zero());
    // Synthetic division from the highest coefficient down; the remainder is zero.
    for k in (1..master.len()).rev() {
        quotient = master[k] + node * quotient;
        value += quotient * power(node, k as u32 - 1);
        integral += quotient / F::from_int(k as i64);
    }
    integral / value
}

/// Calls `f(λ, weight)` at the points of a rule on the reference k-simplex that is exact for polynomials up to a
/// degree. Only points that `usable` accepts are taken; false if hardly any is, as where a root is asked of a constant that
/// is no square.
pub fn on_simplex<F: Field>(
    k: usize,
    degree: usize,
    usable: &dyn Fn(&[F]) -> bool,
    f: &mut dyn FnMut(&[F], F),
) -> bool {
    cone(k, degree, F::one(), &mut Vec::new(), F::one(), usable, f)
}

/// What is left of the simplex once the first coordinates are chosen: a k-simplex of size `rest`.
fn cone<F: Field>(
    k: usize,
    degree: usize,
    rest: F,
    lambda: &mut Vec<F>,
    weight: F,
    usable: &dyn Fn(&[F]) -> bool,
    f: &mut dyn FnMut(&[F], F),
) -> bool {
    if k == 0 {
        lambda.push(rest);
        f(lambda, weight);
        lambda.pop();
        return true;
    }
    // The Jacobian (1−u)^(k−1) adds to the degree.
    let nodes = nodes(k, degree + k, rest, lambda, usable);
    let Some(nodes) = nodes else {
        return false;
    };
    for (&u, w) in nodes.iter().zip(weights(&nodes)) {
        let left = F::one() - u;
        lambda.push(rest * u);
        let there = cone(
            k - 1,
            degree,
            rest * left,
            lambda,
            weight * w * power(left, k as u32 - 1),
            usable,
            f,
        );
        lambda.pop();
        if !there {
            return false;
        }
    }
    true
}

/// Distinct elements of the field; in the last direction (k = 1) only those whose points are usable.
fn nodes<F: Field>(
    k: usize,
    count: usize,
    rest: F,
    lambda: &[F],
    usable: &dyn Fn(&[F]) -> bool,
) -> Option<Vec<F>> {
    let fits = |u: F| {
        let point = [lambda, &[rest * u, rest * (F::one() - u)]].concat();
        k > 1 || usable(&point)
    };
    // Three roots exist at every eighth point; a hundred times as many candidates do not all lack them by chance.
    let candidates = (2..).take(100 * count).map(F::from_int);
    let nodes: Vec<F> = candidates.filter(|u| fits(*u)).take(count).collect();
    (nodes.len() == count).then_some(nodes)
}
