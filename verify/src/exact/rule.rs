//! Integration of polynomials over simplices in F_p, exactly.
//!
//! ∫ of a monomial over the reference simplex is a rational number, hence an element of F_p if the degree is below p.
//! The rule is conical: one interpolatory rule in each direction, its nodes any distinct elements of the field. In
//! the last direction they are chosen where the integrand's square roots exist.

use super::field::Fp;
use regge_curvature::scalar::Field;

/// Weights w_i = ∫₀¹ ℓ_i(t) dt of the interpolatory rule at these nodes: exact for degree < number of nodes.
fn weights(nodes: &[Fp]) -> Vec<Fp> {
    // The coefficients of ∏ (t − t_j), lowest first.
    let mut master = vec![Fp::one()];
    for node in nodes {
        master.insert(0, Fp::zero());
        for k in 0..master.len() - 1 {
            let next = master[k + 1];
            master[k] -= *node * next;
        }
    }
    nodes.iter().map(|&node| weight(&master, node)).collect()
}

/// ∫₀¹ of ∏ (t − t_j)/(t − node), divided by its value at the node.
fn weight(master: &[Fp], node: Fp) -> Fp {
    let (mut quotient, mut value, mut integral) = (Fp::zero(), Fp::zero(), Fp::zero());
    // Synthetic division from the highest coefficient down; the remainder is zero.
    for k in (1..master.len()).rev() {
        quotient = master[k] + node * quotient;
        value += quotient * node.pow(k as u64 - 1);
        integral += quotient / Fp::from_int(k as i64);
    }
    integral / value
}

/// Calls `f(λ, weight)` at the points of a rule on the reference k-simplex that is exact for polynomials up to a
/// degree. Only points that `usable` accepts are taken; if hardly any is, as where a root is asked of a constant that
/// is no square, the points have the weight [`Fp::POISON`].
pub fn on_simplex(
    k: usize,
    degree: usize,
    usable: &dyn Fn(&[Fp]) -> bool,
    f: &mut dyn FnMut(&[Fp], Fp),
) {
    cone(k, degree, Fp::one(), &mut Vec::new(), Fp::one(), usable, f);
}

/// What is left of the simplex once the first coordinates are chosen: a k-simplex of size `rest`.
fn cone(
    k: usize,
    degree: usize,
    rest: Fp,
    lambda: &mut Vec<Fp>,
    weight: Fp,
    usable: &dyn Fn(&[Fp]) -> bool,
    f: &mut dyn FnMut(&[Fp], Fp),
) {
    if k == 0 {
        lambda.push(rest);
        f(lambda, weight);
        lambda.pop();
        return;
    }
    // The Jacobian (1−u)^(k−1) adds to the degree.
    let nodes = nodes(k, degree + k, rest, lambda, usable);
    let Some(nodes) = nodes else {
        lambda.extend(std::iter::repeat_n(rest, k + 1));
        f(lambda, Fp::POISON);
        lambda.truncate(lambda.len() - k - 1);
        return;
    };
    for (&u, w) in nodes.iter().zip(weights(&nodes)) {
        let left = Fp::one() - u;
        lambda.push(rest * u);
        cone(
            k - 1,
            degree,
            rest * left,
            lambda,
            weight * w * left.pow(k as u64 - 1),
            usable,
            f,
        );
        lambda.pop();
    }
}

/// Distinct elements of the field; in the last direction (k = 1) only those whose points are usable.
fn nodes(
    k: usize,
    count: usize,
    rest: Fp,
    lambda: &[Fp],
    usable: &dyn Fn(&[Fp]) -> bool,
) -> Option<Vec<Fp>> {
    let fits = |u: Fp| {
        let point = [lambda, &[rest * u, rest * (Fp::one() - u)]].concat();
        k > 1 || usable(&point)
    };
    // Three roots exist at every eighth point; a hundred times as many candidates do not all lack them by chance.
    let candidates = (2..).take(100 * count).map(Fp::from_int);
    let nodes: Vec<Fp> = candidates.filter(|u| fits(*u)).take(count).collect();
    (nodes.len() == count).then_some(nodes)
}
