//! What pages say of proofs and of exact runs.

use super::markdown::cell;
use super::summary::Row;
use crate::harness::{Bound, Proof};
use std::fmt::Write;

/// What the verdicts of the index rest on.
pub(super) const EXACTLY: &str = "
## What *proved* rests on

A claim at a point is an equation between two expressions in the jets of a metric and of other fields: g, ∂g, ∂²g, σ = ġ \
and its derivatives, a function φ whose level set is the hypersurface. The library evaluates both sides. Nothing in its \
code depends on the value of a number, so that, run once with a scalar that writes down what is done with it, it leaves its \
own *program* behind: additions, multiplications, divisions and roots in a fixed order. Everything below is about this \
program, not about a copy of the formulas.

1. **A position.** A constant linear change of coordinates makes g(x) = δ and n(x) = e_N, and a constant triangular matrix \
makes the frame that of the coordinates. There nothing is divided by but 1, no root is taken but of 1, and both sides are \
polynomials in what is left of the jets. What a wedge adds is a positive parameter, u with tan(θ/2) = u or its reciprocal, in \
which both sides are rational; so are the lengths that a second metric adds (q, d). Roots of parameters are replaced by the \
rational functions that they are, and that they are is one more equation of the list. An equation between two metrics whose \
terms with the one and with the other vanish for themselves is proved in two parts, each in a position of its own metric; where \
an equation knows of a metric its inverse alone, or two vectors, it is proved for any matrix and any vectors in their place.
2. **Its monomials.** The program run with sets of degrees in place of numbers yields which monomials there can be, say \
∂²σ, (∂²g)σ, (∂g)(∂σ), (∂g)²σ for Ṙ, and the degree in the parameters, denominators cleared. Nobody counts by hand.
3. **A lattice.** A polynomial with these monomials that vanishes at certain whole points, the principal lattices of the \
groups of jets, is zero: a theorem of interpolation (`verify/src/exact/lattice.rs` has the argument). At each of these points the \
program is run over rational numbers of 127 bits; a larger number is an error, nothing is rounded. Left minus right is 0 \
at every point, so it is the zero polynomial. For N = 2 and 3 the proof assistant Coq comes to the same result by computing with \
polynomials ([certificates.md](certificates.md)).
4. **Every other metric.** That the equation holds in all coordinates if it holds in one is an identity of its own: each \
term changes as a tensor or a density does. This one is *tested*, not proved: at random elements of the fields with \
2⁶¹ − 1 and 2⁶² − 57 elements, four draws each, with the chance on the page that a wrong term passes. A lattice for it would \
be too large: for Ṙ and N = 3 it is of degree 66 in the six entries of g and 220 in the nine of A, which takes more than 10²³ points.

So *proved* does not rest on random metrics, floating point numbers or tolerances. It rests on the argument above, on the \
equivariance with the chance printed, and on the compiler. It says nothing of quadrature or of floating point numbers; those \
are tested. Every wrong version that has been thought of is refuted at one of the same points, or, where it is right in \
normal position, in other coordinates; the page prints the point.

*Tested exactly* means: the program, at random elements of the two fields. Its degree is counted as above, now \
cleared of all denominators, a root counting half of what is under it; g = AAᵀ + ½δ is of degree two in what is drawn. Of \
k roots 2ᵏ choices of signs make a polynomial of 2ᵏ times the degree, and one draw in 2ᵏ has all roots that are asked for \
(the second number). The chance is that of the draws from one field alone, since a false identity may hold modulo the \
other prime. *Tested (rounding)* means: in floating point numbers, up to the tolerance on the page.
";

/// What the proofs rest on.
pub(super) fn proofs(text: &mut String, row: &Row<'_>) {
    let proved = row
        .entries
        .iter()
        .filter_map(|e| Some((e.dimension, e.proof.as_ref()?)));
    let proved: Vec<(usize, &Proof)> = proved.collect();
    if proved.is_empty() {
        return;
    }
    text.push_str(PROOFS);
    for (dimension, proof) in proved {
        for part in &proof.equations {
            let parameters = match part.parameters {
                0 => String::new(),
                degree => format!("; degree {degree} in the parameters"),
            };
            let _ = writeln!(
                text,
                "| {dimension} | {} | {} | {}{parameters} | {} | {} |",
                cell(&part.equation),
                cell(&part.position),
                part.monomials.join(" + "),
                part.points,
                proof.motion()
            );
        }
    }
}

const PROOFS: &str = "
## Proof

Each equation is brought to a position where its sides are polynomials; it holds at points that determine such a polynomial \
(see the [index](index.md)). That it may be brought there is tested exactly.

| N | equation | position | monomials | points | equivariance |
|---|---|---|---|---|---|
";

/// What the chances of the exact runs are computed from.
pub(super) fn degrees(text: &mut String, row: &Row<'_>) {
    let bounds: Vec<(usize, &Bound)> = (row.entries.iter())
        .filter_map(|e| Some((e.dimension, e.bound.as_ref()?)))
        .collect();
    if bounds.is_empty() {
        return;
    }
    text.push_str(
        "\n## Degrees\n\n| N | degree | roots | degrees by what is drawn |\n|---|---|---|---|\n",
    );
    for (dimension, bound) in bounds {
        let by: Vec<String> = (bound.by_group.iter())
            .map(|(name, degree)| format!("{name}: {degree}"))
            .collect();
        let _ = writeln!(
            text,
            "| {dimension} | {} | {} of {} | {} |",
            bound.degree,
            bound.roots,
            bound.roots_drawn,
            by.join(", ")
        );
    }
}
