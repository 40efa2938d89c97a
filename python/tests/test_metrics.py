"""Metrics by formulas, functions and lengths, and what is made of them."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import ROOT

import regge


def conformal(points):
    factor = 4 / (1 + (points**2).sum(axis=1)) ** 2
    return factor[:, None, None] * np.eye(points.shape[1])


@pytest.mark.parametrize("kind", ["canonical", "average", "average-hierarchical"])
@pytest.mark.parametrize(("n", "degree"), [(2, 0), (2, 2), (3, 1), (4, 0), (5, 0)])
def test_a_function_is_as_good_as_a_formula(kind, n, degree):
    mesh = regge.Mesh.cube(n, 2 if n < 4 else 1)
    square = " + ".join(f"x{i + 1}^2" for i in range(n))
    stated = regge.formula(conformal=f"exp(-({square})/4)", dimension=n)
    # Rules in five dimensions have many points; the same ones are taken for both.
    order = 4 if n > 3 else None
    of_formula = regge.interpolate(mesh, stated, degree, kind, order=order)

    def gauss(x):
        return np.exp(-(x**2).sum(axis=1) / 4)[:, None, None] * np.eye(n)

    of_function = regge.interpolate(mesh, gauss, degree, kind, order=order)
    # The same points, the same weights: what differs is how the factor is rounded.
    np.testing.assert_allclose(of_function.coefficients, of_formula.coefficients, rtol=0, atol=1e-12)


def test_four_ways_to_state_a_graph():
    mesh = regge.Mesh.cube(2, 3)
    ways = [
        regge.formula(graph="x^2/2 + x*y", dimension=2),
        regge.formula(embedding=["x", "y", "x^2/2 + x*y"], dimension=2),
        regge.formula(g=[["1 + (x+y)^2", "(x+y)*x"], ["(x+y)*x", "1 + x^2"]]),
        regge.formula('dimension = 2\ngraph = "x^2/2 + x*y"'),
    ]
    first, *others = [regge.interpolate(mesh, way, 2).coefficients for way in ways]
    for other in others:
        np.testing.assert_allclose(other, first, rtol=0, atol=1e-13)
    assert ways[0].dimension == 2
    assert regge.read_metric(ROOT / "examples" / "files" / "sphere.toml").dimension == 2


def test_geodesic_lengths_are_those_of_the_sphere():
    """In the stereographic chart, through the centre: the distance of 0 and x is 2 atan |x|."""
    mesh = regge.Mesh([[0.0, 0.0], [0.5, 0.0], [0.0, 0.7]], [[0, 1, 2]])
    g = regge.interpolate(mesh, regge.formula("conformal-sphere"), kind="geodesic")
    np.testing.assert_allclose(g.lengths[:2], 2 * np.arctan([0.5, 0.7]), rtol=1e-9)
    with pytest.raises(ValueError, match="formula"):
        regge.interpolate(mesh, conformal, kind="geodesic")
    with pytest.raises(ValueError, match="degree"):
        regge.interpolate(mesh, regge.formula("conformal-sphere"), 1, kind="geodesic")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({}, "exactly one"),
        ({"graph": "x", "conformal": "1"}, "exactly one"),
        ({"graph": "x"}, "dimension"),
        ({"graph": "x +", "dimension": 2}, "graph"),
        ({"graph": "q", "dimension": 2}, "q"),
        ({"g": [["1", "x"], ["y", "1"]]}, "not symmetric"),
        ({"g": [["1", "0"]]}, "dimension"),
        ({"text": "no such metric"}, "graph-quartic"),
        ({"text": 3}, "str"),
        ({"graph": "x\" \n'", "dimension": 2}, "graph"),
    ],
)
def test_bad_formulas(arguments, says):
    with pytest.raises(ValueError) as caught:
        regge.formula(**arguments)
    assert says in str(caught.value)


def test_bad_functions_say_where():
    mesh = regge.Mesh.cube(2, 2)
    with pytest.raises(ValueError, match="has shape"):
        regge.interpolate(mesh, lambda x: np.ones(len(x)))
    with pytest.raises(ValueError, match="is not symmetric"):
        regge.interpolate(mesh, lambda x: np.tile([[1.0, 0.5], [0.1, 1.0]], (len(x), 1, 1)))
    with pytest.raises(ValueError, match="is not finite"):
        regge.interpolate(mesh, lambda x: np.full((len(x), 2, 2), np.nan))
    with pytest.raises(ZeroDivisionError):
        regge.interpolate(mesh, lambda x: 1 / 0)
    with pytest.raises(regge.IndefiniteError) as caught:
        regge.interpolate(mesh, lambda x: np.tile(np.diag([1.0, -1.0]), (len(x), 1, 1)))
    assert caught.value.cell == 0 and caught.value.pivot < 0 and len(caught.value.point) == 3
    with pytest.raises(regge.NoCoordinatesError):
        regge.interpolate(regge.Mesh.simplex_boundary(2), conformal)
    with pytest.raises(ValueError, match="dimension"):
        regge.interpolate(regge.Mesh.cube(3, 1), regge.formula(graph="x", dimension=2))


def test_functions_run_in_the_thread_that_called():
    import threading

    seen = set()

    def metric(points):
        seen.add(threading.get_ident())
        return conformal(points)

    regge.interpolate(regge.Mesh.cube(2, 2), metric)
    assert seen == {threading.get_ident()}


def test_lengths():
    mesh = regge.Mesh.simplex_boundary(3)
    g = regge.lengths(mesh, np.ones(10))
    np.testing.assert_array_equal(g.coefficients, 1.0)
    with pytest.raises(ValueError, match="row 3, edge"):
        regge.lengths(mesh, np.where(np.arange(10) == 3, 0, 1))
    with pytest.raises(regge.IndefiniteError) as caught:
        regge.lengths(mesh, np.where(np.arange(10) == 9, 9.0, 1.0))
    assert {3, 4} <= set(mesh.cells[caught.value.cell])


def test_induced_metrics_are_euclidean():
    mesh = regge.Mesh.cube(3, 2).perturbed(0.1, seed=5)
    flat = regge.interpolate(mesh, regge.formula("flat"))
    np.testing.assert_allclose(regge.induced(mesh).coefficients, flat.coefficients, rtol=1e-13)
    torus = regge.Mesh.torus(2, 3)
    flat = regge.interpolate(torus, regge.formula("flat"))
    np.testing.assert_allclose(regge.induced(torus).coefficients, flat.coefficients, rtol=1e-13)


def test_coefficients_are_copies_that_can_be_set(sphere):
    g = regge.interpolate(regge.Mesh.cube(2, 2), sphere, 1)
    before = g.coefficients
    before *= 4
    assert (g.coefficients != before).all()
    curvature = regge.curvature(g).total
    g.coefficients = before
    np.testing.assert_array_equal(g.coefficients, before)
    # N = 2: Rω does not change when g is scaled.
    np.testing.assert_allclose(regge.curvature(g).total, curvature, atol=1e-13)
    for bad in (before[:-1], before * np.nan, before.astype(str), before[None]):
        with pytest.raises(ValueError):
            g.coefficients = bad
    g.coefficients = -before
    with pytest.raises(regge.IndefiniteError):
        regge.curvature(g)


def test_spaces_and_their_tables(small):
    """Σ_i c_i ψ_i by the table is what the function says."""
    space, mesh = small.space, small.mesh
    n = mesh.dimension
    rng = np.random.default_rng(2)
    points = rng.dirichlet(np.ones(n + 1), 5)
    table = space.tabulate(points)
    cell = len(mesh.cells) - 1
    by_table = np.einsum("qlij,l->qij", table, small.coefficients[space.cell_dofs[cell]])
    np.testing.assert_allclose(small(cell, points, frame="cell"), by_table, atol=1e-14)
    jacobian = (mesh.corners[cell, 1:] - mesh.corners[cell, 0]).T
    cartesian = small(cell, points)
    np.testing.assert_allclose(jacobian.T @ cartesian @ jacobian, by_table, atol=1e-13)
    owners = space.owners
    assert (np.diff(owners[:, 0]) >= 0).all() and (owners[:, 0] >= 1).all()
    again = space.fit(np.vstack([np.eye(n + 1), points]) if small.degree else points, np.array(
        [small(c, np.vstack([np.eye(n + 1), points]) if small.degree else points) for c in range(len(mesh.cells))]
    ))
    np.testing.assert_allclose(again.coefficients, small.coefficients, atol=1e-12)


def test_what_is_no_regge_function_is_not_fitted():
    mesh = regge.Mesh.cube(2, 1)
    values = np.array([np.eye(2), 2 * np.eye(2)])[:, None]
    with pytest.raises(regge.InputError, match="differ by"):
        regge.ReggeSpace(mesh, 0).fit([[1 / 3] * 3], values)
    with pytest.raises(regge.InputError, match="do not determine"):
        regge.ReggeSpace(mesh, 1).fit([[1 / 3] * 3], values)


def test_interpolation_keeps_canonical_degrees_of_freedom(sphere):
    """Of a metric of degree 2 all are kept, and it itself."""
    mesh = regge.Mesh.cube(2, 2)
    quadratic = regge.formula(g=[["3 + x^2", "x*y"], ["x*y", "3 + y^2"]])
    fine = regge.interpolate(mesh, quadratic, 2)
    values = fine(0, [[0.2, 0.3, 0.5]])[0]
    x, y = np.array([0.2, 0.3, 0.5]) @ mesh.corners[0]
    np.testing.assert_allclose(values, [[3 + x * x, x * y], [x * y, 3 + y * y]], rtol=1e-13)
    edges = mesh.corners[:, [1, 2, 2]] - mesh.corners[:, [0, 0, 1]]
    coarse = regge.interpolate(regge.Mesh.cube(2, 2), regge.formula("flat"), 0)
    squares = np.empty(mesh.count(1))
    squares[mesh.of_cells(1)] = (edges**2).sum(axis=2)
    np.testing.assert_allclose(coarse.canonical_dofs(), squares, rtol=1e-13)
