"""Random malformed arrays: an exception each, no crash."""

from __future__ import annotations

import numpy as np

import regge

ROUNDS = 1000


def _spoil(rng: np.random.Generator, array: np.ndarray):
    """The array, wrong in one way."""
    array = array.copy()
    row = rng.integers(len(array))
    match rng.integers(12):
        case 0:
            return array[..., None]
        case 1:
            return array.ravel()[:-1]
        case 2:
            return array.astype(complex)
        case 3:
            return array.astype(str)
        case 4:
            return array.astype(object)
        case 5:
            return None
        case 6:
            return "array"
        case 7:
            return [[1], [2, 3]]
        case 8:
            return {"a": 1}
        case 9:
            array = array.astype(float)
            array[row] = rng.choice([np.nan, np.inf, -np.inf])
            return array
        case 10:
            return array[:0]
        case _:
            array[row] = rng.choice([-1, -(2**40), 2**40])
            return array


def test_a_thousand_malformed_arrays():
    rng = np.random.default_rng(2026)
    mesh = regge.Mesh.cube(2, 2)
    g = regge.interpolate(mesh, regge.formula("conformal-sphere"))
    cells, points, ones = mesh.cells.astype(np.int64), mesh.points, np.ones(mesh.count(1))
    barycentric = np.full((3, 3), 1 / 3)
    doors = [
        lambda: regge.Mesh(_spoil(rng, points), cells),
        lambda: regge.Mesh(points, _spoil(rng, cells)),
        lambda: regge.Mesh.abstract(9, _spoil(rng, cells)),
        lambda: regge.lengths(mesh, _spoil(rng, ones)),
        lambda: regge.curvature(regge.ReggeSpace(mesh, 0).function(_spoil(rng, ones))),
        lambda: regge.b_h(g, _spoil(rng, ones) if rng.random() < 0.5 else np.ones(3) * np.nan),
        lambda: regge.curvature_vjp(g, np.full(9, np.nan) if rng.random() < 0.2 else _spoil(rng, np.ones((9, 1)))),
        lambda: g(0, _spoil(rng, barycentric)),
        lambda: regge.interpolate(mesh, lambda x: _spoil(rng, np.tile(np.eye(2), (len(x), 1, 1)))),
    ]
    refused = 0
    for i in range(ROUNDS):
        try:
            doors[i % len(doors)]()
        except (ValueError, regge.ReggeError) as error:
            assert "\n" not in str(error)
            refused += 1
        # Some numbers are only large: a vertex far away, a variation of size 2⁴⁰. Everything else must not get here.
    assert refused > 0.9 * ROUNDS
