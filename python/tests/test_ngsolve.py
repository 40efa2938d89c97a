"""A mesh and a metric from a live NGSolve, and ngsdiffgeo's curvature of it."""

from __future__ import annotations

import numpy as np
import pytest

import regge

ngsolve = pytest.importorskip("ngsolve", reason="NGSolve is not installed (pip install ngsolve ngsdiffgeo)")


@pytest.fixture(scope="module")
def square():
    from netgen.geom2d import unit_square

    return ngsolve.Mesh(unit_square.GenerateMesh(maxh=0.3))


def _factor():
    x, y = ngsolve.x, ngsolve.y
    return 4 / (1 + x * x + y * y) ** 2


def test_meshes_keep_their_order(square):
    mesh = regge.Mesh.from_ngsolve(square)
    np.testing.assert_array_equal(mesh.points, [v.point for v in square.vertices])
    theirs = [sorted(v.nr for v in element.vertices) for element in square.Elements(ngsolve.VOL)]
    np.testing.assert_array_equal(mesh.cells, theirs)
    from netgen.csg import unit_cube

    cube = regge.Mesh.from_ngsolve(unit_cube.GenerateMesh(maxh=0.6))
    assert cube.dimension == 3 and cube.euler_characteristic == 1


def test_a_coefficient_function_is_a_metric(square):
    mesh = regge.Mesh.from_ngsolve(square)
    metric = ngsolve.CoefficientFunction((_factor(), 0, 0, _factor()), dims=(2, 2))
    ours = regge.interpolate(mesh, regge.formula("conformal-sphere"), 1)
    theirs = regge.interpolate(mesh, regge.from_ngsolve_metric(metric, square), 1)
    np.testing.assert_allclose(theirs.coefficients, ours.coefficients, atol=1e-12)


@pytest.mark.parametrize("order", [0, 1, 2])
def test_sums_are_those_of_ngsdiffgeo(square, order):
    """NGSolve differentiates Regge functions by differences: 1e-7, as verify/oracle's README says."""
    dg = pytest.importorskip("ngsdiffgeo", reason="ngsdiffgeo is not installed")
    metric = ngsolve.CoefficientFunction((_factor(), 0, 0, _factor()), dims=(2, 2))
    g = ngsolve.GridFunction(ngsolve.HCurlCurl(square, order=order))
    g.Set(metric, dual=True, bonus_intorder=12)
    mesh = regge.Mesh.from_ngsolve(square)
    ours = regge.fit_ngsolve(regge.ReggeSpace(mesh, order), g)
    points = np.array([[0.2, 0.3, 0.5]])
    x = points[0] @ mesh.corners[3]
    np.testing.assert_allclose(ours(3, points).ravel(), g(square(*x)), atol=1e-12)
    curvature = regge.curvature(ours, order=16)
    inner = np.setdiff1d(np.arange(len(mesh.points)), mesh.boundary_points)
    for sums, known in zip((curvature.cells, curvature.faces, curvature.hinges), _theirs(dg, square, g)):
        assert np.abs(sums - known)[inner].max() < 1e-7


def _theirs(dg, mesh, g):
    """Their three sums for the hat functions. Their mean curvature is minus the paper's."""
    hats = ngsolve.H1(mesh, order=1)
    v, manifold = hats.TestFunction(), dg.RiemannianManifold(g)
    rule = lambda shape: {"intrules": {shape: ngsolve.IntegrationRule(shape, 16)}}  # noqa: E731
    terms = [
        manifold.Scalar * v * manifold.VolumeForm(ngsolve.VOL) * ngsolve.dx(**rule(ngsolve.TRIG)),
        -2
        * manifold.MeanCurvature
        * v
        * manifold.VolumeForm(ngsolve.BND)
        * ngsolve.dx(element_boundary=True, **rule(ngsolve.SEGM)),
        2 * manifold.AngleDefect * v * manifold.VolumeForm(ngsolve.BBND) * ngsolve.dx(element_vb=ngsolve.BBND),
    ]
    for term in terms:
        form = ngsolve.LinearForm(hats)
        form += term
        form.Assemble()
        yield form.vec.FV().NumPy().copy()
