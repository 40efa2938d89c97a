"""JAX and PyTorch, where they are installed."""

from __future__ import annotations

import numpy as np
import pytest

import regge


@pytest.fixture
def g(sphere):
    return regge.interpolate(regge.Mesh.cube(2, 4), sphere, 1)


@pytest.mark.parametrize(("test_degree", "boundary"), [(1, "none"), (2, "none"), (2, "gauss-bonnet")])
def test_jax(g, test_degree, boundary):
    jax = pytest.importorskip("jax", reason="JAX is not installed (pip install jax)")
    import regge.jax

    jax.config.update("jax_enable_x64", True)
    curvature = regge.jax.curvature(g.space, test_degree, boundary)
    c = jax.numpy.asarray(g.coefficients)
    value = curvature(c)
    ours = regge.curvature(g, test_degree, boundary).total
    counted = np.asarray(value) != 0
    np.testing.assert_array_equal(np.asarray(value)[counted], ours[counted])
    gradient = jax.jit(jax.grad(lambda c: 0.5 * (curvature(c) ** 2).sum()))(c)
    known = regge.curvature_vjp(g, np.asarray(value), test_degree, boundary)
    np.testing.assert_allclose(np.asarray(gradient), known, rtol=1e-12, atol=1e-15)
    with pytest.raises(ValueError, match="x64"):
        curvature(c.astype(np.float32))


@pytest.mark.parametrize("boundary", ["none", "gauss-bonnet"])
def test_torch(g, boundary):
    torch = pytest.importorskip("torch", reason="PyTorch is not installed (pip install torch)")
    import regge.torch

    curvature = regge.torch.curvature(g.space, boundary=boundary)
    c = torch.from_numpy(g.coefficients).requires_grad_()
    value = curvature(c)
    (0.5 * (value**2).sum()).backward()
    known = regge.curvature_vjp(g, value.detach().numpy(), boundary=boundary)
    np.testing.assert_allclose(c.grad.numpy(), known, rtol=1e-12, atol=1e-15)
    with pytest.raises(ValueError, match="float64"):
        curvature(c.float())


def test_the_mask_is_that_of_the_derivative(small):
    """Test functions that do not count are those whose derivative is 0 for every variation."""
    from regge._autodiff import OfCoefficients

    for degree in (1, 2, 3):
        mask = OfCoefficients(small.space, degree, "none", None).counted
        rng = np.random.default_rng(1)
        jvp = regge.curvature_jvp(small, rng.standard_normal(len(small.space)), degree)
        assert len(mask) == len(jvp)
        np.testing.assert_array_equal(jvp[mask == 0], 0)
        assert (OfCoefficients(small.space, degree, "gauss-bonnet", None).counted == 1).all()
