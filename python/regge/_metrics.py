"""Smooth metrics, and Regge metrics made of them or of lengths."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Sequence
from typing import Any, Literal, Union

import numpy as np

from . import _arrays, _regge
from ._arrays import Floats
from ._errors import InputError, NoCoordinatesError
from ._functions import ReggeFunction, ReggeSpace
from ._mesh import Mesh
from ._progress import Progress, resolve

Kind = Literal["canonical", "average", "average-hierarchical", "geodesic"]


class Metric:
    """A smooth metric on a part of ℝ^N: made by `formula` or `metric`."""

    def __init__(self, native: _regge.Source, label: str) -> None:
        self._native = native
        self._label = label

    @property
    def dimension(self) -> int | None:
        """N; None if it is a metric in any dimension."""
        return self._native.dimension

    def __repr__(self) -> str:
        return f"<regge.Metric: {self._label}>"


MetricLike = Union[Metric, Callable[[Floats], Any]]


def _toml(fields: dict[str, Any]) -> str:
    """As TOML: its strings are those of JSON, as far as these fields go."""
    return "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in fields.items())


def formula(
    text: str | None = None,
    *,
    g: Sequence[Sequence[str]] | None = None,
    graph: str | None = None,
    conformal: str | None = None,
    embedding: Sequence[str] | None = None,
    dimension: int | None = None,
    scalar_curvature: str | None = None,
) -> Metric:
    """A metric by a formula; its derivatives are exact.

    Parameters
    ----------
    text : str, optional
        All of it as TOML, as in the metric files of the command line; or the name of a metric that the library knows
        (`regge.known_metrics()`), which is there in every dimension.
    g : sequence of sequences of str, optional
        The components g_ij, row by row.
    graph : str, optional
        f, for the metric I + ∇f ⊗ ∇f of its graph.
    conformal : str, optional
        c, for the metric c δ.
    embedding : sequence of str, optional
        X: ℝ^N → ℝ^M, for the metric ∂_i X · ∂_j X.
    dimension : int, optional
        N; needed with `graph`, `conformal` and `embedding`.
    scalar_curvature : str, optional
        R, if it is known; else it is computed from the derivatives of the formula.

    Notes
    -----
    Formulas are in the coordinates x1, x2, … (up to N = 3 also x, y, z), with ^ for powers, the usual functions,
    pi and e.

    Raises
    ------
    FileError
        With the key and the column of what is wrong in a formula.
    ValueError
        If not exactly one of the five ways is taken.

    Examples
    --------
    >>> import regge
    >>> regge.formula(conformal="4/(1 + x^2 + y^2)^2", dimension=2, scalar_curvature="2")
    <regge.Metric: conformal 4/(1 + x^2 + y^2)^2>
    >>> regge.formula("conformal-sphere")
    <regge.Metric: conformal-sphere>
    """
    ways = {"g": g, "graph": graph, "conformal": conformal, "embedding": embedding}
    given = {key: value for key, value in ways.items() if value is not None}
    if (text is not None) + len(given) != 1:
        raise ValueError("formula: exactly one of a text, g, graph, conformal and embedding is needed")
    if text is not None:
        if not isinstance(text, str):
            raise ValueError(f"formula: is to be a str, not {text!r}")
        if dimension is not None or scalar_curvature is not None:
            raise ValueError("formula: a text states its dimension and its scalar curvature itself")
        known = _regge.Source.known(text)
        if known is not None:
            return Metric(known, text)
        if "=" not in text:
            raise ValueError(f"formula: {text!r} is neither TOML nor one of {', '.join(_regge.known_metrics())}")
        return Metric(_regge.Source.toml("formula", text), " ".join(text.split()))
    ((key, value),) = given.items()
    if key == "g":
        rows = [list(row) if not isinstance(row, str) else [row] for row in value]
        value, dimension = rows, len(rows) if dimension is None else dimension
    elif key == "embedding":
        value = [value] if isinstance(value, str) else list(value)
    if dimension is None:
        raise ValueError(f"formula: {key} needs the dimension")
    fields = {"dimension": _arrays.integer(dimension, "dimension", 2, 5), key: value}
    if scalar_curvature is not None:
        fields["exact_scalar_curvature"] = scalar_curvature
    return Metric(_regge.Source.toml("formula", _toml(fields)), f"{key} {value}")


def read_metric(path: str | os.PathLike[str]) -> Metric:
    """Reads a metric from a TOML file of the command line.

    Raises
    ------
    FileError
        With the line and key of what is wrong.
    """
    return Metric(_regge.Source.file(os.fspath(path)), os.fspath(path))


def metric(
    g: Callable[[Floats], Any], *, scalar_curvature: Callable[[Floats], Any] | None = None
) -> Metric:
    """A metric by a function.

    Parameters
    ----------
    g : callable
        Points, an (n, N) array, to the components g_ij there, an (n, N, N) array of symmetric matrices.
    scalar_curvature : callable, optional
        Points to R there, an (n,) array. A function has no derivatives, so that `error_norm` needs it.

    Notes
    -----
    The function is called once for all points of a rule of quadrature in all cells, in the thread that called: memory for
    these points and values is needed at once. The interpolant "geodesic" needs derivatives, hence a formula.
    """

    def components(points: Floats) -> Floats:
        n = points.shape[1]
        values = _arrays.floats(g(points), "the metric's values", (len(points), n, n))
        skew = np.abs(values - values.transpose(0, 2, 1)).max(axis=(1, 2))
        # Two ways to compute one number agree to a few units in the last place, times their condition.
        bad = skew > 1e-9 * np.abs(values).max(axis=(1, 2))
        if bad.any():
            row = int(np.argmax(bad))
            raise ValueError(f"the metric's values: row {row}, at x = {points[row]}, is not symmetric")
        return values

    def curvature(points: Floats) -> Floats:
        assert scalar_curvature is not None
        return _arrays.floats(scalar_curvature(points), "the scalar curvature's values", (len(points),))

    for name, function in (("g", g), ("scalar_curvature", scalar_curvature)):
        if function is not None and not callable(function):
            raise ValueError(f"{name}: is to be a function of points, not {function!r}")
    native = _regge.Source.functions(components, None if scalar_curvature is None else curvature)
    return Metric(native, getattr(g, "__name__", repr(g)))


def _as_metric(value: MetricLike, name: str = "metric") -> Metric:
    if isinstance(value, Metric):
        return value
    if callable(value):
        return metric(value)
    raise ValueError(f"{name}: is to be a regge.Metric or a function of points, not {value!r}")


def interpolate(
    mesh: Mesh,
    metric: MetricLike,
    degree: int = 0,
    kind: Kind = "canonical",
    *,
    order: int | None = None,
    progress: Progress = None,
) -> ReggeFunction:
    """A Regge metric from a smooth one.

    Parameters
    ----------
    mesh : Mesh
        A mesh with coordinates in ℝ^N.
    metric : Metric or callable
        The smooth metric; a function takes points (n, N) to components (n, N, N).
    degree : int
        r.
    kind : {"canonical", "average", "average-hierarchical", "geodesic"}
        What agrees or is averaged: the canonical degrees of freedom agree (edge lengths squared in the mean for r = 0);
        local L² projections with their canonical degrees of freedom averaged (the paper's appendix) or their hierarchical
        coefficients (the printed tables); the edge lengths are geodesic distances (r = 0 only, formulas only).
    order : int, optional
        The order of the rules by which the metric is integrated; 2r + 12 if there is none.
    progress : callable or bool, optional
        Called with the fraction that is done, an estimate; True for a bar.

    Returns
    -------
    ReggeFunction
        Positive definite at the points of a rule of order 2r + 2.

    Raises
    ------
    IndefiniteError
        If the metric, or its interpolant, is not positive definite: with the cell and point.
    EdgeError
        If an edge has no geodesic: with its vertices.
    NoCoordinatesError
        If the mesh has no coordinates in ℝ^N.
    ValueError
        If the metric is of another dimension, or its values are no symmetric matrices: with the point.

    Examples
    --------
    >>> import regge
    >>> sphere = regge.formula("conformal-sphere")
    >>> regge.interpolate(regge.Mesh.cube(2, 4), sphere, degree=1)
    <regge.ReggeFunction: degree 1 on <regge.Mesh: N = 2, 32 cells, 25 vertices>>
    """
    source = _as_metric(metric)
    space = ReggeSpace(mesh, degree)
    if kind not in kinds():
        raise ValueError(f"kind: {kind!r} is none of {', '.join(kinds())}")
    if mesh.is_immersed:
        raise NoCoordinatesError("the mesh is immersed, and has no coordinates in ℝ^N for a formula: take regge.induced")
    if order is not None:
        order = _arrays.order(order, mesh.dimension)
    told = resolve(progress, "interpolate")
    native = mesh._native.interpolate(source._native, space.degree, kind, order, told)
    return ReggeFunction._of(space, native)


def kinds() -> list[str]:
    """The names of the interpolants."""
    return [name for name, _ in _regge.interpolants()]


def lengths(mesh: Mesh, lengths: Any) -> ReggeFunction:
    """The Regge metric of degree 0 with these edge lengths: classical Regge calculus.

    Parameters
    ----------
    mesh : Mesh
        Any mesh; its coordinates do not matter.
    lengths : (n,) array_like of float
        The length of each edge, in the order of `mesh.edges`.

    Raises
    ------
    ValueError
        If a length is not positive and finite: with its row.
    IndefiniteError
        If no simplex has the lengths of a cell: with the cell.

    Examples
    --------
    >>> import regge, numpy as np
    >>> sphere = regge.Mesh.simplex_boundary(3)
    >>> g = regge.lengths(sphere, np.ones(len(sphere.edges)))
    >>> round(regge.action(g).value, 10)
    25.9030705516
    """
    values = _arrays.floats(lengths, "lengths", (mesh.count(1),))
    if (values <= 0).any():
        row = int(np.argmax(values <= 0))
        raise ValueError(f"lengths: row {row}, edge {mesh.edges[row].tolist()}, is {values[row]}, not positive")
    function = ReggeFunction(ReggeSpace(mesh, 0), values**2)
    function.check()
    return function


def induced(mesh: Mesh) -> ReggeFunction:
    """The metric of the space that the points of a mesh lie in: degree 0, the edges as long as they are there.

    On curved cells of order k, which a file may have, it is F*δ of their map F to space, of degree 2(k − 1).

    Parameters
    ----------
    mesh : Mesh
        With points in ℝ^M, M ≥ N. For M = N it is flat; for a surface in space it has the curvature of its angle defects.

    Raises
    ------
    NoCoordinatesError
        If the mesh has no points.
    """
    if mesh._curved is not None:
        function = ReggeFunction._of(ReggeSpace(mesh, mesh._curved.degree), mesh._curved)
        function.check()
        return function
    if mesh.points is not None:
        ends = mesh.points[mesh.edges]
        squares = ((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1)
    elif mesh.corners is not None:
        first, second = np.triu_indices(mesh.dimension + 1, 1)
        squares = np.empty(mesh.count(1))
        squares[mesh.of_cells(1)] = ((mesh.corners[:, second] - mesh.corners[:, first]) ** 2).sum(axis=2)
    else:
        raise NoCoordinatesError("the mesh has no vertex coordinates, which an induced metric needs")
    function = ReggeFunction(ReggeSpace(mesh, 0), squares)
    function.check()
    return function


def _require_metric(g: Any) -> ReggeFunction:
    if not isinstance(g, ReggeFunction):
        raise InputError(f"g: is to be a ReggeFunction, not {type(g).__name__}: see regge.interpolate, regge.lengths")
    return g
