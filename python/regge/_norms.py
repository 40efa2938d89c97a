"""Norms of the error of the curvature."""

from __future__ import annotations

from dataclasses import dataclass

from . import _arrays, _regge
from ._functions import ReggeFunction
from ._metrics import MetricLike, _as_metric, _require_metric
from ._progress import Progress, resolve


@dataclass(frozen=True)
class ErrorNorm:
    """A norm of the error of the curvature.

    Attributes
    ----------
    value : float
        The norm.
    parts : dict of str to float
        Its parts: for H⁻² `u_l2`, `grad_l2`, `sigma_l2`, whose squares add up to its square.
    steps : int
        How many steps an iterative solver took; 0 for a direct one.
    solver : str
        The solver.
    norm : str
        The norm's name.
    """

    value: float
    parts: dict[str, float]
    steps: int
    solver: str
    norm: str

    def __float__(self) -> float:
        return self.value


def _plain(name: str) -> str:
    return name.lower().replace("^", "").replace("⁻²", "-2").replace("⁻¹", "-1")


def norms() -> dict[str, str]:
    """The names of the norms, with what each is; they are there for N = 2 and 3."""
    return {name: about for name, _, about in _regge.norms()}


def error_norm(
    g: ReggeFunction,
    metric: MetricLike,
    norm: str = "H-2",
    *,
    order: int | None = None,
    progress: Progress = None,
) -> ErrorNorm:
    """‖(Rω)_dist(g) − (Rω)(metric)‖ in a norm.

    Parameters
    ----------
    g : ReggeFunction
        The Regge metric, on a mesh in ℝ^N.
    metric : Metric or callable
        The smooth metric that it is compared with; if it is by a function, `regge.metric` must have been told R.
    norm : str
        A name or a symbol of `norms()`: "H-2".
    order : int, optional
        The order of the rules of quadrature for both functionals.
    progress : callable or bool, optional
        Called with the fraction that is done, an estimate; True for a bar.

    Raises
    ------
    ValueError
        If the norm is not known or not there in this dimension, or R of a function is not known.
    NoCoordinatesError
        If the mesh has no coordinates in ℝ^N.
    SolverError
        If the solver gives up.

    Examples
    --------
    >>> import regge
    >>> sphere = regge.formula("conformal-sphere")
    >>> g = regge.interpolate(regge.Mesh.cube(2, 4), sphere, degree=1)
    >>> regge.error_norm(g, sphere).solver
    'cholesky'
    """
    g = _require_metric(g)
    known = {_plain(key): name for name, symbol, _ in _regge.norms() for key in (name, symbol)}
    name = known.get(_plain(norm)) if isinstance(norm, str) else None
    if name is None:
        raise ValueError(f"norm: {norm!r} is none of {', '.join(norms())}")
    if order is not None:
        order = _arrays.order(order, g.mesh.dimension)
    told = resolve(progress, "error_norm")
    value, parts, steps, solver = g._native.error_norm(_as_metric(metric)._native, name, order, told)
    return ErrorNorm(value, dict(parts), steps, solver, name)
