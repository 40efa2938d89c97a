"""Meshes of other packages as points and cells, and back; none of the packages is imported before it is needed."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from . import _arrays
from ._arrays import Floats, Integers
from ._errors import InputError

# VTK's numbers for a triangle and a tetrahedron.
_VTK = {2: 5, 3: 10}


def _used(points: Any, cells: Any) -> tuple[Floats, Integers]:
    """The points that cells use, without coordinates beyond N that are the same for all, and the cells by their numbers."""
    points = _arrays.floats(points, "points", ("n", "M"))
    cells = _arrays.integers(cells, "cells", ("m", "N+1"), len(points))
    used = np.unique(cells)
    number = np.full(len(points), -1, dtype=np.int64)
    number[used] = np.arange(len(used))
    points, cells = points[used], number[cells]
    n = cells.shape[1] - 1
    if points.shape[1] > n and (points[:, n:] == points[:1, n:]).all():
        points = points[:, :n]
    return points, cells


def from_meshio(mesh: Any) -> tuple[Floats, Integers]:
    blocks: dict[str, list[Integers]] = {"tetra": [], "triangle": []}
    for block in mesh.cells:
        if block.type in blocks:
            blocks[block.type].append(np.asarray(block.data))
        elif block.type not in ("vertex", "line"):
            raise InputError(f"the mesh has cells of the type {block.type!r}: triangles and tetrahedra are possible")
    found = blocks["tetra"] or blocks["triangle"]
    if not found:
        raise InputError("the mesh has neither triangles nor tetrahedra")
    return _used(mesh.points, np.concatenate(found))


def from_pyvista(mesh: Any) -> tuple[Floats, Integers]:
    if hasattr(mesh, "regular_faces"):
        if not mesh.is_all_triangles:
            raise InputError("the surface has faces that are no triangles: mesh.triangulate() makes some")
        return _used(np.asarray(mesh.points, dtype=float), mesh.regular_faces)
    cells = mesh.cells_dict
    for kind in (_VTK[3], _VTK[2]):
        if kind in cells:
            return _used(np.asarray(mesh.points, dtype=float), cells[kind])
    raise InputError("the grid has neither triangles nor tetrahedra")


def to_pyvista(points: Floats | None, cells: Integers, data: dict[str, Any]) -> Any:
    import pyvista

    n = cells.shape[1] - 1
    if n not in _VTK or points is None:
        raise InputError("PyVista draws meshes of dimension 2 and 3 with points")
    if points.shape[1] > 3:
        raise InputError(f"PyVista draws in space, and the points have {points.shape[1]} coordinates")
    in_space = np.zeros((len(points), 3))
    in_space[:, : points.shape[1]] = points
    grid = pyvista.UnstructuredGrid({_VTK[n]: cells}, in_space)
    for name, values in data.items():
        values = np.asarray(values)
        if len(values) == len(points):
            grid.point_data[name] = values
        elif len(values) == len(cells):
            grid.cell_data[name] = values
        else:
            raise InputError(f"{name}: has {len(values)} values; there are {len(points)} vertices and {len(cells)} cells")
    return grid


def from_ngsolve(mesh: Any) -> tuple[Floats, Integers]:
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
    return _used(netgen.Coordinates(), nodes)
