"""Meshes and functions of other packages, none of which is imported before it is needed."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arrays
from ._arrays import Floats, Integers
from ._errors import InputError

if TYPE_CHECKING:
    from ._functions import ReggeFunction, ReggeSpace
    from ._mesh import Mesh

# VTK's numbers for a triangle and a tetrahedron.
_VTK = {2: 5, 3: 10}


def _mesh(cls: type[Mesh], points: Any, cells: Any) -> Mesh:
    points = _arrays.floats(points, "points", ("n", "M"))
    cells = _arrays.integers(cells, "cells", ("m", "N+1"), len(points))
    used = np.unique(cells)
    number = np.full(len(points), -1, dtype=np.int64)
    number[used] = np.arange(len(used))
    points, cells = points[used], number[cells]
    n = cells.shape[1] - 1
    if points.shape[1] > n and (points[:, n:] == points[:1, n:]).all():
        points = points[:, :n]
    return cls(points, cells)


def from_meshio(cls: type[Mesh], mesh: Any) -> Mesh:
    blocks: dict[str, list[Integers]] = {"tetra": [], "triangle": []}
    for block in mesh.cells:
        if block.type in blocks:
            blocks[block.type].append(np.asarray(block.data))
        elif block.type not in ("vertex", "line"):
            raise InputError(f"the mesh has cells of the type {block.type!r}: triangles and tetrahedra are possible")
    found = blocks["tetra"] or blocks["triangle"]
    if not found:
        raise InputError("the mesh has neither triangles nor tetrahedra")
    return _mesh(cls, mesh.points, np.concatenate(found))


def from_pyvista(cls: type[Mesh], mesh: Any) -> Mesh:
    if hasattr(mesh, "regular_faces"):
        if not mesh.is_all_triangles:
            raise InputError("the surface has faces that are no triangles: mesh.triangulate() makes some")
        return _mesh(cls, np.asarray(mesh.points, dtype=float), mesh.regular_faces)
    cells = mesh.cells_dict
    for kind in (_VTK[3], _VTK[2]):
        if kind in cells:
            return _mesh(cls, np.asarray(mesh.points, dtype=float), cells[kind])
    raise InputError("the grid has neither triangles nor tetrahedra")


def to_pyvista(mesh: Mesh, data: dict[str, Any]) -> Any:
    import pyvista

    n = mesh.dimension
    if n not in _VTK or mesh.points is None:
        raise InputError("PyVista draws meshes of dimension 2 and 3 with points")
    points = np.zeros((len(mesh.points), 3))
    if mesh.points.shape[1] > 3:
        raise InputError(f"PyVista draws in space, and the points have {mesh.points.shape[1]} coordinates")
    points[:, : mesh.points.shape[1]] = mesh.points
    grid = pyvista.UnstructuredGrid({_VTK[n]: mesh.cells}, points)
    for name, values in data.items():
        values = np.asarray(values)
        if len(values) == len(points):
            grid.point_data[name] = values
        elif len(values) == len(mesh.cells):
            grid.cell_data[name] = values
        else:
            raise InputError(f"{name}: has {len(values)} values; there are {len(points)} vertices and {len(mesh.cells)} cells")
    return grid


def from_ngsolve(cls: type[Mesh], mesh: Any) -> Mesh:
    netgen = getattr(mesh, "ngmesh", mesh)
    if getattr(mesh, "GetCurveOrder", lambda: 1)() > 1:
        warnings.warn("the mesh has curved elements, which are taken by their vertices", stacklevel=3)
    elements, simplex = netgen.Elements2D(), 3
    if netgen.dim == 3 and len(netgen.Elements3D()) > 0:
        elements, simplex = netgen.Elements3D(), 4
    if len(elements) == 0 or any(len(element.vertices) != simplex for element in elements):
        raise InputError("the mesh is to consist of triangles, or of tetrahedra")
    # Netgen counts from 1, and lists further nodes of curved elements behind the vertices.
    nodes = elements.NumPy()["nodes"][:, :simplex].astype(np.int64) - 1
    return _mesh(cls, netgen.Coordinates(), nodes)


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
