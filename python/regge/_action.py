"""Regge's action."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from . import _curvature
from ._arrays import Floats
from ._functions import ReggeFunction
from ._metrics import _require_metric
from ._progress import Progress, resolve


class Action:
    """Regge's action of a Regge metric; its derivatives are in the edge lengths, for degree 0.

    Attributes
    ----------
    g : ReggeFunction
        The metric.
    interior : float
        ½⟨(Rω)_dist(g), 1⟩: for degree 0 Σ̊_S Θ_S |S|.
    boundary : float
        ½ of the terms of the boundary: for degree 0 Σ_{S⊂∂Ω} (π − Σ_T θ_ST) |S|.
    """

    def __init__(self, g: ReggeFunction, order: int, progress: Progress) -> None:
        self.g = g.copy()
        self.interior, self.boundary = g._native.action(order, resolve(progress, "action"))

    @property
    def value(self) -> float:
        """The action."""
        return self.interior + self.boundary

    @cached_property
    def _gradient(self) -> tuple[Floats, float]:
        return self.g._native.action_gradient()

    @property
    def gradient(self) -> Floats:
        """(n,) array: the derivative in each edge length, Σ_S Θ_S ∂|S|/∂ℓ, those of the boundary included.

        Regge's equations say that it vanishes in the edges that are free.

        Raises
        ------
        InputError
            If the degree is not 0.
        """
        return self._gradient[0]

    @property
    def schlaefli(self) -> float:
        """The largest |Σ_S |S| ∂θ_S/∂ℓ| over cells and edges: 0 by Schläfli's identity, up to rounding."""
        return self._gradient[1]

    @cached_property
    def hessian(self) -> Any:
        """(n, n) `scipy.sparse.csr_array`: the second derivatives in the edge lengths, symmetric.

        Raises
        ------
        InputError
            If the degree is not 0.
        ImportError
            If SciPy is not installed.
        """
        from scipy import sparse

        rows, columns, values = self.g._native.action_hessian()
        n = self.g.mesh.count(1)
        hessian = sparse.coo_array((values, (rows, columns)), shape=(n, n)).tocsr()
        hessian.sum_duplicates()
        return hessian

    def __repr__(self) -> str:
        return f"<regge.Action: {self.value!r}>"


def action(g: ReggeFunction, *, order: int | None = None, progress: Progress = None) -> Action:
    """Regge's action, half the Einstein–Hilbert action with the terms of the boundary that make it stationary.

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    order, progress
        As for `curvature`; degree 0 is integrated exactly.

    Returns
    -------
    Action
        With `.value`, `.gradient`, `.hessian`.

    Examples
    --------
    >>> import regge, numpy as np
    >>> mesh = regge.Mesh.simplex_boundary(3)
    >>> S = regge.action(regge.lengths(mesh, np.ones(len(mesh.edges))))
    >>> S.gradient.shape, S.hessian.shape, bool(S.schlaefli < 1e-14)
    ((10,), (10, 10), True)
    """
    g = _require_metric(g)
    return Action(g, _curvature._order(g, 1, order), progress)
