"""What packages of automatic differentiation are given: the curvature and its reverse derivative, from arrays to arrays."""

from __future__ import annotations

from functools import cached_property
from math import comb
from typing import Any

import numpy as np

from . import _arrays
from ._arrays import Floats
from ._curvature import Boundary, _with_boundary, curvature, curvature_vjp
from ._functions import ReggeSpace


class OfCoefficients:
    """The function c ↦ `curvature(g).total` of the coefficients c of g.

    Parameters
    ----------
    space : ReggeSpace
        The space of g.
    test_degree, boundary, order
        As for `curvature`. Unless the boundary is "gauss-bonnet", entries of test functions that do not vanish on the boundary
        are 0, as their derivatives are.
    """

    def __init__(self, space: ReggeSpace, test_degree: int, boundary: Boundary, order: int | None) -> None:
        self.space = space
        self._test_degree = _arrays.degree(test_degree, "test_degree", low=1)
        self._with_boundary = _with_boundary(boundary)
        self._as_asked: dict[str, Any] = {"test_degree": test_degree, "boundary": boundary, "order": order}

    @cached_property
    def counted(self) -> Floats:
        """(m,) array of 1 for test functions that count, and 0 for the others."""
        mesh = self.space.mesh
        counted: list[Floats] = []
        for k in range(mesh.dimension + 1):
            # Bernstein polynomials that charge all k + 1 vertices of a k-simplex: C(q−1, k).
            of_simplices = np.ones(mesh.count(k))
            if not self._with_boundary:
                of_simplices[mesh.boundary(k)] = 0
            counted.append(np.repeat(of_simplices, comb(self._test_degree - 1, k)))
        return np.concatenate(counted)

    def value(self, c: Any) -> Floats:
        """(m,) array."""
        return self.counted * curvature(self.space.function(np.asarray(c)), **self._as_asked).total

    def pulled_back(self, c: Any, w: Any) -> Floats:
        """(n,) array: Jᵀ w at c. It is the theorem's, so that nothing of `value` is recorded for it."""
        return curvature_vjp(self.space.function(np.asarray(c)), np.asarray(w), **self._as_asked)
