"""Meshes."""

from __future__ import annotations

import os
import warnings
from functools import cached_property
from typing import Any

import numpy as np

from . import _arrays, _interop, _regge
from ._arrays import Floats, Integers, read_only
from ._errors import NoCoordinatesError


class Mesh:
    """A triangulated manifold of dimension N = 2…5, with or without boundary.

    Parameters
    ----------
    points : (n, M) array_like of float
        A point for each vertex. With M = N the mesh is a domain in ℝ^N, and formulas can be given for its
        metric; with M > N it is immersed in ℝ^M (a surface in space), and `induced` is its metric.
    cells : (m, N+1) array_like of int
        The vertices of each cell, in any order and with any orientation.

    Raises
    ------
    ValueError
        If an array has the wrong shape or type, or a row of it is not finite or names a vertex that is not there.
    CellError, VertexError, ManifoldError
        If a cell is degenerate or overlaps its neighbour, a vertex belongs to no cell, or the cells form no manifold.
        All are `InputError`, hence `ValueError`.

    Notes
    -----
    A mesh cannot be changed. Vertices and cells keep their order; the vertices of a cell are listed in ascending order,
    and those of all other simplices too.

    Examples
    --------
    >>> import regge
    >>> square = regge.Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]])
    >>> square.dimension, len(square.edges), square.euler_characteristic
    (2, 5, 1)
    >>> regge.Mesh.cube(3, 2).perturbed(0.05, seed=1)
    <regge.Mesh: N = 3, 48 cells, 27 vertices>
    """

    __slots__ = ("_native", "_embedding", "_curved", "__dict__")

    def __init__(self, points: Any, cells: Any) -> None:
        points = _arrays.floats(points, "points", ("n", "M"))
        cells = _arrays.integers(cells, "cells", ("m", "N+1"), len(points))
        dimension = cells.shape[1] - 1
        if points.shape[1] < dimension:
            raise ValueError(
                f"points: have {points.shape[1]} coordinates, and cells of dimension {dimension} need {dimension}"
            )
        self._embedding: Floats | None = None
        # The metric of curved cells, which only files have.
        self._curved: _regge.Function | None = None
        if points.shape[1] == dimension:
            self._native = _regge.Mesh.of_points(points, cells)
        else:
            self._native = _regge.Mesh.of_cells(len(points), cells)
            self._embedding = read_only(points.copy())

    @classmethod
    def _of(
        cls, native: _regge.Mesh, embedding: Floats | None = None, curved: _regge.Function | None = None
    ) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._native = native
        mesh._embedding = embedding
        mesh._curved = curved
        return mesh

    @classmethod
    def abstract(cls, n_vertices: int, cells: Any) -> Mesh:
        """A manifold without coordinates: edge lengths are its metric.

        Parameters
        ----------
        n_vertices : int
            How many vertices there are.
        cells : (m, N+1) array_like of int
            The vertices of each cell.

        Raises
        ------
        ValueError
            As for `Mesh`.
        """
        n_vertices = _arrays.integer(n_vertices, "n_vertices", 1, 2**31)
        cells = _arrays.integers(cells, "cells", ("m", "N+1"), n_vertices)
        return cls._of(_regge.Mesh.of_cells(n_vertices, cells))

    @classmethod
    def cube(cls, dimension: int, side: int) -> Mesh:
        """The cube (−1, 1)^N cut into `side`^N cubes of N! simplices each, as in the paper's section 5."""
        dimension = _arrays.integer(dimension, "dimension", 2, 5)
        return cls._of(_regge.Mesh.cube(dimension, _arrays.cubes(dimension, side, "side")))

    @classmethod
    def torus(cls, dimension: int, side: int) -> Mesh:
        """The cube with opposite faces identified, `side` ≥ 3 cubes a direction.

        It has a chart for each cell (`corners`) and no `points`.
        """
        dimension = _arrays.integer(dimension, "dimension", 2, 5)
        return cls._of(_regge.Mesh.torus(dimension, _arrays.cubes(dimension, side, "side")))

    @classmethod
    def simplex_boundary(cls, dimension: int) -> Mesh:
        """The boundary of one simplex of dimension N + 1: a sphere of N + 2 cells, without coordinates."""
        return cls._of(_regge.Mesh.simplex_boundary(_arrays.integer(dimension, "dimension", 2, 5)))

    @classmethod
    def from_meshio(cls, mesh: Any) -> Mesh:
        """From a mesh of meshio: its cells of the highest dimension, triangles or tetrahedra.

        Coordinates beyond N are dropped if they are the same for all points. Points that no cell uses are left out.
        """
        return cls(*_interop.from_meshio(mesh))

    @classmethod
    def from_pyvista(cls, mesh: Any) -> Mesh:
        """From a PolyData of triangles, or an UnstructuredGrid of triangles or tetrahedra, of PyVista."""
        return cls(*_interop.from_pyvista(mesh))

    @classmethod
    def from_ngsolve(cls, mesh: Any) -> Mesh:
        """From a mesh of NGSolve or Netgen, of triangles or tetrahedra.

        Vertices and elements keep their order. Cells are affine: curved elements are taken by their vertices, and a
        warning says so.
        """
        return cls(*_interop.from_ngsolve(mesh))

    def to_pyvista(self, **data: Any) -> Any:
        """As a `pyvista.UnstructuredGrid`, N ≤ 3.

        Parameters
        ----------
        **data : array_like
            Values by vertex or by cell, by name.
        """
        return _interop.to_pyvista(self.points, self.cells, data)

    def perturbed(self, amount: float, seed: int) -> Mesh:
        """The mesh with every coordinate of its inner vertices moved by up to `amount`, the same for a seed on every machine.

        Raises
        ------
        CellError
            If a cell would be inverted.
        NoCoordinatesError
            If the mesh has no points in ℝ^N.
        """
        amount = _arrays.number(amount, "amount")
        return Mesh._of(self._native.perturbed(amount, _arrays.integer(seed, "seed", 0, 2**64 - 1)))

    @property
    def dimension(self) -> int:
        """N."""
        return self._native.dimension

    @cached_property
    def points(self) -> Floats | None:
        """(n, M) array, read-only: the points of the vertices; None for abstract meshes and those with several charts."""
        points = self._native.points() if self._embedding is None else self._embedding
        return None if points is None else read_only(points)

    @property
    def is_immersed(self) -> bool:
        """Are the points in a space of more than N dimensions?"""
        return self._embedding is not None

    @cached_property
    def corners(self) -> Floats | None:
        """(m, N+1, N) array: the corners of the cells in ℝ^N, in the order of their vertices; None without coordinates."""
        corners = self._native.corners()
        return None if corners is None else read_only(corners)

    def simplices(self, k: int) -> Integers:
        """(n_k, k+1) array, read-only: the vertices of the k-simplices, 0 ≤ k ≤ N, ascending in each row."""
        k = _arrays.integer(k, "k", 0, self.dimension)
        cached: dict[int, Integers] = self.__dict__.setdefault("_simplices", {})
        if k not in cached:
            cached[k] = read_only(self._native.vertices(k))
        return cached[k]

    @property
    def cells(self) -> Integers:
        """(m, N+1) array: the vertices of the cells, ascending."""
        return self.simplices(self.dimension)

    @property
    def faces(self) -> Integers:
        """(n, N) array: the vertices of the faces, the simplices of codimension 1."""
        return self.simplices(self.dimension - 1)

    @property
    def hinges(self) -> Integers:
        """(n, N−1) array: the vertices of the hinges, the simplices of codimension 2."""
        return self.simplices(self.dimension - 2)

    @property
    def edges(self) -> Integers:
        """(n, 2) array: the vertices of the edges."""
        return self.simplices(1)

    def count(self, k: int) -> int:
        """How many k-simplices."""
        return self._native.count(_arrays.integer(k, "k", 0, self.dimension))

    def boundary(self, k: int) -> Integers:
        """The numbers of the k-simplices in the boundary, 0 ≤ k ≤ N, ascending."""
        return self._native.boundary(_arrays.integer(k, "k", 0, self.dimension))

    @property
    def boundary_points(self) -> Integers:
        """The numbers of the vertices in the boundary."""
        return self.boundary(0)

    @property
    def boundary_edges(self) -> Integers:
        """The numbers of the edges in the boundary."""
        return self.boundary(1)

    @property
    def boundary_faces(self) -> Integers:
        """The numbers of the faces in the boundary."""
        return self.boundary(self.dimension - 1)

    @property
    def boundary_hinges(self) -> Integers:
        """The numbers of the hinges in the boundary."""
        return self.boundary(self.dimension - 2)

    def of_cells(self, k: int) -> Integers:
        """(m, C(N+1, k+1)) array: the numbers of the k-simplices of each cell, k < N, by local vertices in lexicographic order."""
        return self._native.of_each_cell(_arrays.integer(k, "k", 0, self.dimension - 1))

    @property
    def euler_characteristic(self) -> int:
        """χ = Σ_k (−1)^k n_k."""
        return self._native.euler_characteristic

    @property
    def is_closed(self) -> bool:
        """Has it no boundary?"""
        return len(self.boundary_faces) == 0

    @property
    def mesh_size(self) -> float:
        """h: the longest edge in ℝ^N.

        Raises
        ------
        NoCoordinatesError
            If there are no coordinates.
        """
        if self._embedding is not None:
            ends = self._embedding[self.edges]
            return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).max())
        if self.corners is None:
            raise NoCoordinatesError("the mesh has no vertex coordinates, which its size needs")
        return self._native.mesh_size

    def __repr__(self) -> str:
        n = self.dimension
        kind = " without coordinates" if self._embedding is None and self.corners is None else ""
        return f"<regge.Mesh: N = {n}, {self.count(n)} cells, {self.count(0)} vertices{kind}>"


def read(path: str | os.PathLike[str], *, coordinates: bool = True) -> Mesh:
    """Reads a mesh from a file, in the formats of the command line.

    A surface in space is immersed, see `Mesh`; `induced` is its metric, for curved cells too. What was done to the contents of the
    file (points that no cell uses are left out, corners of STL are welded) is a warning each.

    Parameters
    ----------
    path : path_like
        The file.
    coordinates : bool
        False to leave out its coordinates, if it has any.

    Raises
    ------
    FileError
        With the line or byte of what is wrong.
    """
    native, points, curved, notes = _regge.Mesh.read(os.fspath(path), not coordinates)
    for note in notes:
        warnings.warn(f"{os.fspath(path)}: {note}", stacklevel=2)
    return Mesh._of(native, None if points is None else read_only(points), curved)
