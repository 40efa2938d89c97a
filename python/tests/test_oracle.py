"""The cases of verify/oracle, which NGSolve computed, through the Python door: the tolerances of tests/oracle*.rs."""

from __future__ import annotations

import numpy as np

import regge

# NGSolve differentiates by differences, which its README puts at 1e-9 to 1e-7 of an entry; a third code agrees to 1e-9 of
# the largest.
SUMS = 1e-8
# What the oracles' README asks for.
NORMS = 1e-6


def test_three_sums(oracle):
    known = oracle.data["curvature"]
    curvature = regge.curvature(oracle.g, order=20)
    pairs = [(curvature.cells, "element"), (curvature.faces, "face"), (curvature.hinges, "angle")]
    scale = max(np.abs(known[key]).max() for _, key in pairs)
    for ours, key in pairs:
        off = np.abs(ours[known["vertex"]] - known[key]).max()
        assert off < SUMS * scale, (key, off)


def test_norm(oracle):
    known = oracle.data.get("hm2")
    if known is None:
        return
    norm = regge.error_norm(oracle.g, regge.formula(oracle.data["metric"]), "H-2", order=20)
    assert abs(norm.value / known["error"] - 1) < NORMS
    assert abs(np.hypot.reduce(list(norm.parts.values())) / norm.value - 1) < 1e-14


def test_values_are_those_of_the_samples(oracle):
    n = oracle.mesh.dimension
    cell = len(oracle.mesh.cells) // 2
    sample = oracle.data["samples"][cell]
    x = np.array([sample["points"]])
    corners = oracle.mesh.corners[cell : cell + 1]
    jacobian = (corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
    xi = np.linalg.solve(jacobian, (x - corners[:, :1]).transpose(0, 2, 1))[0].T
    values = oracle.g(cell, np.column_stack([1 - xi.sum(axis=1), xi]))
    # Solving for the coefficients and back: rounding times the condition of the sample points.
    np.testing.assert_allclose(values, np.reshape(sample["g"], (-1, n, n)), rtol=0, atol=1e-11)
