"""The curvature and its relatives: theorems, and other programs."""

from __future__ import annotations

import numpy as np
import pytest

import regge


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_gauss_bonnet(sphere, degree):
    mesh = regge.Mesh.cube(2, 6).perturbed(0.05, seed=1)
    g = regge.interpolate(mesh, sphere, degree)
    curvature = regge.curvature(g, boundary="gauss-bonnet", order=24)
    # The order is what the accuracy rests on: at 24 it is rounding of 10² terms.
    assert abs(curvature.total.sum() - 4 * np.pi * mesh.euler_characteristic) < 1e-10
    parts = [curvature.by_cell, curvature.by_face, curvature.by_hinge]
    assert [len(part) for part in parts] == [mesh.count(2), mesh.count(1), mesh.count(0)]
    assert abs(sum(part.sum() for part in parts) - 4 * np.pi) < 1e-10
    plain = regge.curvature(g, order=24)
    assert plain.boundary is None
    np.testing.assert_array_equal(plain.cells, curvature.cells)
    assert (plain.by_hinge[mesh.boundary_hinges] == 0).all()
    assert (curvature.by_hinge[mesh.boundary_hinges] != 0).all()


def test_by_simplex_adds_up(small):
    curvature = regge.curvature(small)
    for by_function, by_simplex in [
        (curvature.cells, curvature.by_cell),
        (curvature.faces, curvature.by_face),
        (curvature.hinges, curvature.by_hinge),
    ]:
        # Hat functions add up to one; rounding of 10³ terms of size 1.
        assert abs(by_function.sum() - by_simplex.sum()) < 1e-11


def test_density_is_the_curvature_of_the_sphere(sphere):
    """R = 2 away from the boundary, where R_h vanishes: its layer decays over a few cells of the sixteen."""
    mesh = regge.Mesh.cube(2, 16)
    curvature = regge.curvature(regge.interpolate(mesh, sphere, 2))
    density = curvature.density()
    assert len(density) == mesh.count(0) and (density[mesh.boundary_points] == 0).all()
    middle = np.abs(mesh.points).max(axis=1) < 0.5
    assert np.abs(density[middle] - 2).max() < 0.01
    assert len(curvature.density(2)) == mesh.count(0) + mesh.count(1)


def test_einstein_vanishes_in_the_plane_and_is_action_gradient_for_lengths():
    flat = regge.interpolate(regge.Mesh.cube(2, 3), regge.formula("trig"), 1)
    # N = 2: G = 0, II‾ = 0 and hinges are points.
    assert np.abs(regge.einstein(flat).total).max() < 1e-12
    mesh = regge.Mesh.simplex_boundary(3)
    rng = np.random.default_rng(4)
    g = regge.lengths(mesh, 1 + 0.1 * rng.random(10))
    action = regge.action(g)
    einstein = regge.einstein(g)
    assert len(einstein) == 10
    # δS = −½⟨Gω, δg⟩·… : the action is ½∫Rω, whose derivative in g is −½(Gω)_dist; g = ℓ², so that ∂g/∂ℓ = 2ℓ.
    np.testing.assert_allclose(action.gradient, -np.asarray(einstein) * g.lengths, rtol=1e-12)


def test_action_of_a_regular_sphere():
    """Five regular tetrahedra: ten edges with the defect 2π − 3 arccos(1/3) and length 1."""
    mesh = regge.Mesh.simplex_boundary(3)
    action = regge.action(regge.lengths(mesh, np.ones(10)))
    defect = 2 * np.pi - 3 * np.arccos(1 / 3)
    assert abs(action.value - 10 * defect) < 1e-13
    np.testing.assert_allclose(action.gradient, defect, rtol=1e-13)
    assert action.boundary == 0 and action.schlaefli < 1e-15


def test_hessian_by_differences():
    pytest.importorskip("scipy")
    mesh = regge.Mesh.cube(3, 1)
    lengths = regge.induced(mesh).lengths * (1 + 0.02 * np.sin(np.arange(mesh.count(1))))
    hessian = regge.action(regge.lengths(mesh, lengths)).hessian
    assert hessian.shape == (len(lengths),) * 2
    assert np.abs((hessian - hessian.T).toarray()).max() < 1e-12
    v = np.cos(np.arange(len(lengths)))
    step = 1e-5
    ends = [regge.action(regge.lengths(mesh, lengths + s * step * v)).gradient for s in (1, -1)]
    # Central differences: step² times third derivatives of size 10².
    np.testing.assert_allclose(hessian @ v, (ends[0] - ends[1]) / (2 * step), atol=1e-7)


@pytest.mark.parametrize("boundary", ["none", "gauss-bonnet"])
def test_derivative_by_differences(small, boundary):
    g, mesh = small, small.mesh
    rng = np.random.default_rng(7)
    dg = rng.standard_normal(len(g.space)) * g.coefficients
    order = 16 if mesh.dimension < 4 else None
    jvp = regge.curvature_jvp(g, dg, boundary=boundary, order=order)
    step = 1e-5
    ends = [
        regge.curvature(g.space.function(g.coefficients + s * step * dg), boundary=boundary, order=order).total
        for s in (1, -1)
    ]
    known = (ends[0] - ends[1]) / (2 * step)
    if boundary == "none":
        assert (jvp[mesh.boundary_points] == 0).all()
        known[mesh.boundary_points] = 0
    # Central differences: step² times third derivatives; and the rules, which are exact for degree 0 only.
    assert np.abs(jvp - known).max() < 1e-5 * max(np.abs(known).max(), 1)


@pytest.mark.parametrize("boundary", ["none", "gauss-bonnet"])
@pytest.mark.parametrize("test_degree", [1, 2])
def test_vjp_is_the_transpose(small, boundary, test_degree):
    rng = np.random.default_rng(8)
    dg = rng.standard_normal(len(small.space))
    jvp = regge.curvature_jvp(small, dg, test_degree, boundary)
    w = rng.standard_normal(len(jvp))
    vjp = regge.curvature_vjp(small, w, test_degree, boundary)
    assert vjp.shape == dg.shape
    # Rounding, relative to the terms that are added up.
    size = np.abs(w * jvp).sum() + np.abs(vjp * dg).sum()
    # One cube in five dimensions has no inner vertex or edge.
    assert size > 0 or (small.mesh.dimension == 5 and boundary == "none")
    assert abs(w @ jvp - vjp @ dg) <= 1e-12 * size


def test_jvp_is_b_h_less_a_h(sphere):
    g = regge.interpolate(regge.Mesh.cube(2, 3), sphere, 1)
    dg = np.cos(np.arange(len(g.space)))
    b, a = regge.b_h(g, dg), regge.a_h(g, dg)
    inner = np.setdiff1d(np.arange(16), g.mesh.boundary_points)
    difference = (b.total - a.total)[inner]
    np.testing.assert_allclose(regge.curvature_jvp(g, dg)[inner], difference, rtol=1e-12, atol=1e-13)
    assert (b.hinges == 0).all()
    sigma = g.space.function(dg)
    np.testing.assert_array_equal(regge.b_h(g, sigma).total, b.total)


def test_norm_converges_and_says_what_it_did(sphere):
    def error(side, metric):
        g = regge.interpolate(regge.Mesh.cube(2, side), sphere, 1)
        return regge.error_norm(g, metric, norm="H^-2")

    def conformal(x):
        return (4 / (1 + (x**2).sum(axis=1)) ** 2)[:, None, None] * np.eye(2)

    coarse, fine = error(4, sphere), error(8, sphere)
    assert fine.value < coarse.value / 3
    assert set(fine.parts) == {"u_l2", "grad_l2", "sigma_l2"} and fine.norm == "hm2" and fine.steps == 0
    by_function = error(8, regge.metric(conformal, scalar_curvature=lambda x: np.full(len(x), 2.0)))
    assert abs(by_function.value / fine.value - 1) < 1e-9
    with pytest.raises(ValueError, match="scalar"):
        error(4, conformal)
    with pytest.raises(ValueError, match="hm2"):
        regge.error_norm(regge.interpolate(regge.Mesh.cube(2, 4), sphere), sphere, norm="L2")
    trig = regge.formula("trig")
    with pytest.raises(ValueError, match="dimension 4"):
        regge.error_norm(regge.interpolate(regge.Mesh.cube(4, 1), trig), trig)


def _defects_of_trimesh(surface):
    return surface.vertex_defects


def _defects_of_libigl(surface):
    igl = pytest.importorskip("igl", reason="libigl is not installed (pip install libigl)")
    # It numbers vertices in 32 or 64 bits, as its version has it, and takes whole rows.
    faces = np.ascontiguousarray(surface.faces, dtype=np.int64)
    return igl.gaussian_curvature(np.ascontiguousarray(surface.vertices, dtype=float), faces)


@pytest.mark.parametrize("theirs", [_defects_of_trimesh, _defects_of_libigl])
def test_angle_defects_of_other_programs(theirs):
    """libigl's and trimesh's defects on trimesh's own meshes; by_hinge is twice ours, and the total is 4πχ."""
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed (pip install trimesh)")
    for surface in (
        trimesh.creation.icosphere(subdivisions=3),
        trimesh.creation.torus(2.0, 0.7, 16, 12),
        trimesh.creation.box().subdivide(),
    ):
        mesh = regge.Mesh(surface.vertices, surface.faces)
        assert mesh.is_immersed and mesh.is_closed
        g = regge.induced(mesh)
        defects = regge.angle_defects(g)
        np.testing.assert_array_equal(defects.hinges, np.arange(len(surface.vertices)))
        # Angles by arc cosine there, which loses digits at small angles; no angle of these meshes is below 0.1.
        np.testing.assert_allclose(defects.defects, theirs(surface), rtol=0, atol=1e-12)
        np.testing.assert_allclose(regge.curvature(g).by_hinge, 2 * defects.defects, atol=1e-13)
        total = regge.curvature(g).total.sum()
        assert abs(total - 4 * np.pi * surface.euler_number) < 1e-10
        np.testing.assert_allclose(regge.cell_volumes(g).sum(), surface.area, rtol=1e-12)


@pytest.mark.parametrize(
    "call",
    [
        lambda g: regge.curvature("g"),
        lambda g: regge.curvature(g, test_degree=0),
        lambda g: regge.curvature(g, test_degree=1.5),
        lambda g: regge.curvature(g, test_degree=99),
        lambda g: regge.curvature(g, order=-1),
        lambda g: regge.curvature(g, order=10**9),
        lambda g: regge.curvature(g, boundary="yes"),
        lambda g: regge.curvature(g, progress=3),
        lambda g: regge.b_h(g, np.ones(3)),
        lambda g: regge.curvature_vjp(g, np.ones(3)),
        lambda g: regge.curvature_jvp(g, np.full(len(g.space), np.inf)),
        lambda g: regge.einstein(g, -1),
        lambda g: g(99, [[1, 0, 0]]),
        lambda g: g(0, [[1, 1, 1]]),
        lambda g: g(0, [[1, 0]]),
        lambda g: g([0, 1], [[1, 0, 0]]),
        lambda g: g(0, [[1, 0, 0]], frame="other"),
        lambda g: regge.interpolate(g.mesh, regge.formula("flat"), 13),
        lambda g: regge.interpolate(g.mesh, regge.formula("flat"), kind="best"),
        lambda g: regge.set_num_threads(0),
    ],
)
def test_bad_arguments_are_value_errors(sphere, call):
    g = regge.interpolate(regge.Mesh.cube(2, 4), sphere)
    with pytest.raises(ValueError):
        call(g)
