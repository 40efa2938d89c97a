"""The curvature as a function of JAX, with its derivative by the theorem instead of by a record of the computation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import numpy as np

from ._autodiff import OfCoefficients
from ._curvature import Boundary
from ._functions import ReggeSpace


def curvature(
    space: ReggeSpace, test_degree: int = 1, boundary: Boundary = "none", *, order: int | None = None
) -> Callable[[Any], Any]:
    """The function c ↦ `regge.curvature(g).total` of the coefficients c of g, with its reverse derivative.

    Parameters
    ----------
    space : ReggeSpace
        The space of g.
    test_degree, boundary, order
        As for `regge.curvature`. Unless the boundary is "gauss-bonnet", entries of test functions that do not vanish on the
        boundary are 0, as their derivatives are.

    Returns
    -------
    callable
        For float64 arrays of length `len(space)`: JAX computes in float32 unless `jax_enable_x64` is set, and a ValueError
        says so. It runs on the host, and can be jitted.
    """
    ours = OfCoefficients(space, test_degree, boundary, order)

    def on_host(function: Callable[..., Any], length: int, *arguments: Any) -> Any:
        if any(a.dtype != np.float64 for a in arguments):
            raise ValueError("regge computes in float64: jax.config.update('jax_enable_x64', True)")
        return jax.pure_callback(function, jax.ShapeDtypeStruct((length,), np.float64), *arguments)

    @jax.custom_vjp
    def primal(c: Any) -> Any:
        return on_host(ours.value, len(ours.counted), c)

    def backward(c: Any, w: Any) -> Any:
        return (on_host(ours.pulled_back, len(space), c, w),)

    primal.defvjp(lambda c: (primal(c), c), backward)
    return primal
