"""Functions of NGSolve, which is not imported before it is needed."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import Floats
from ._functions import ReggeFunction, ReggeSpace


def fit_ngsolve(space: ReggeSpace, function: Any, mesh: Any = None) -> ReggeFunction:
    """A function of NGSolve as a Regge function.

    Parameters
    ----------
    space : ReggeSpace
        A space on `Mesh.from_ngsolve(mesh)`.
    function : ngsolve.CoefficientFunction
        N × N, in the coordinates of ℝ^N: a `GridFunction` in `HCurlCurl` of an order not above the degree is taken over
        exactly. For a smooth metric take `interpolate` with `from_ngsolve_metric`.
    mesh : ngsolve.Mesh, optional
        The mesh; that of a `GridFunction` if there is none.

    Raises
    ------
    InputError
        If the function is no Regge function of this degree on this mesh.
    """
    import ngsolve

    n = space.mesh.dimension
    if mesh is None:
        mesh = function.space.mesh
    shape = {2: ngsolve.ET.TRIG, 3: ngsolve.ET.TET}[n]
    points = mesh.MapToAllElements(ngsolve.IntegrationRule(shape, 2 * space.degree + 1), ngsolve.VOL)
    coordinates = ngsolve.CoefficientFunction((ngsolve.x, ngsolve.y, ngsolve.z)[:n])
    cells = len(space.mesh.cells)
    x: Floats = coordinates(points).reshape(cells, -1, n)
    values = function(points).reshape(cells, -1, n, n)
    corners = space.mesh.corners
    assert corners is not None
    jacobian = (corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
    xi = np.linalg.solve(jacobian, (x - corners[:, :1]).transpose(0, 2, 1)).transpose(0, 2, 1)
    return space.fit(np.concatenate([1 - xi.sum(axis=2, keepdims=True), xi], axis=2), values)


def from_ngsolve_metric(function: Any, mesh: Any) -> Any:
    """A CoefficientFunction of NGSolve, smooth on the whole domain, as a function of points for `interpolate`.

    Parameters
    ----------
    function : ngsolve.CoefficientFunction
        N × N, in the coordinates of ℝ^N.
    mesh : ngsolve.Mesh
        The mesh on which it is evaluated.
    """

    def values(points: Floats) -> Floats:
        n = points.shape[1]
        return np.asarray(function(mesh(*points.T))).reshape(len(points), n, n)

    return values
