"""Regge spaces and Regge functions."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Literal

import numpy as np

from . import _arrays, _regge
from ._arrays import Floats, Integers, read_only
from ._errors import InputError, NoCoordinatesError
from ._mesh import Mesh

Frame = Literal["cartesian", "cell"]


class ReggeSpace:
    """Piecewise polynomial symmetric tensors of degree r with single-valued tangential-tangential components.

    Parameters
    ----------
    mesh : Mesh
        The mesh.
    degree : int
        r ≥ 0.

    Notes
    -----
    On a cell a tensor g is known by its edge components q_ab = g(t_ab, t_ab), one polynomial for each edge ab; each is
    expanded in Bernstein's polynomials B_α. A degree of freedom is a coefficient of B_α in q_ab; it belongs to the simplex
    {a, b} ∪ supp α and is numbered there: first all edges, then all triangles, and so on. For r = 0 they are the squared
    edge lengths in the order of `Mesh.edges`.

    Examples
    --------
    >>> import regge
    >>> space = regge.ReggeSpace(regge.Mesh.cube(2, 1), 1)
    >>> len(space), space.cell_dofs.shape
    (16, (2, 9))
    """

    def __init__(self, mesh: Mesh, degree: int) -> None:
        self.mesh = mesh
        self._native = mesh._native.space(_arrays.degree(degree))

    @property
    def degree(self) -> int:
        """r."""
        return self._native.degree

    def __len__(self) -> int:
        return self._native.len

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, ReggeSpace):
            return NotImplemented
        return self.mesh is other.mesh and self.degree == other.degree

    def __hash__(self) -> int:
        return hash((id(self.mesh), self.degree))

    @cached_property
    def cell_dofs(self) -> Integers:
        """(m, L) array: the numbers of the functions of each cell, by edge ab, then by α, both in lexicographic order."""
        return read_only(self._native.cell_dofs())

    @cached_property
    def owners(self) -> Integers:
        """(n, 2) array: the dimension and the number of the simplex that each degree of freedom belongs to."""
        return read_only(self._native.owners())

    def tabulate(self, points: Any) -> Floats:
        """The functions of a cell at points, in the coordinates ξ_i = λ_i of its vertices 1…N.

        Parameters
        ----------
        points : (q, N+1) array_like of float
            Barycentric coordinates.

        Returns
        -------
        (q, L, N, N) ndarray
            The components of each function in the order of `cell_dofs`; the same for all cells.
        """
        points = _arrays.points_in_cells(points, "points", self.mesh.dimension, "q")
        return self._native.tabulate(points)

    def function(self, coefficients: Any) -> ReggeFunction:
        """The function with these coefficients.

        Parameters
        ----------
        coefficients : (n,) array_like of float
            As many as the space has dimensions; they are copied.
        """
        return ReggeFunction(self, coefficients)

    def zero(self) -> ReggeFunction:
        """The function 0."""
        return ReggeFunction(self, np.zeros(len(self)))

    def fit(self, points: Any, values: Any, *, frame: Frame = "cartesian", rtol: float = 1e-8) -> ReggeFunction:
        """The function with given values at the same points of every cell.

        Parameters
        ----------
        points : (m, q, N+1) or (q, N+1) array_like of float
            Barycentric coordinates in each cell, by its ascending vertices; q ≥ dim P_r.
        values : (m, q, N, N) array_like of float
            The tensor there, on each cell.
        frame : {"cartesian", "cell"}
            Components in the coordinates of ℝ^N, or in those of the cell.
        rtol : float
            By how much neighbours may differ on what they share, relative to the largest coefficient.

        Raises
        ------
        InputError
            If the points do not determine a polynomial, or neighbours do not agree on what they share: values of a
            function of another space, or of no Regge function.
        """
        mesh, n = self.mesh, self.mesh.dimension
        cells = len(mesh.cells)
        values = _arrays.floats(values, "values", (cells, "q", n, n))
        q = values.shape[1]
        points = np.asarray(points)
        if points.ndim == 2:
            points = np.broadcast_to(points, (cells, *points.shape))
        points = _arrays.floats(points, "points", (cells, q, n + 1))
        basis = self._native.bernstein(points.reshape(-1, n + 1)).reshape(cells, q, -1)
        if q < basis.shape[2] or (np.linalg.matrix_rank(basis) < basis.shape[2]).any():
            raise InputError(f"points: do not determine polynomials of degree {self.degree} in a cell")
        first, second = np.triu_indices(n + 1, 1)
        if frame == "cartesian":
            if mesh.corners is None:
                raise NoCoordinatesError("the mesh has no vertex coordinates, which the frame 'cartesian' needs")
            edges = mesh.corners[:, second] - mesh.corners[:, first]
        else:
            reference = np.vstack([np.zeros(n), np.eye(n)])
            edges = np.broadcast_to(reference[second] - reference[first], (cells, len(first), n))
        components = np.einsum("cei,cqij,cej->cqe", edges, values, edges)
        local = np.linalg.pinv(basis) @ components
        local = local.transpose(0, 2, 1).reshape(cells, -1)
        coefficients = np.zeros(len(self))
        coefficients[self.cell_dofs] = local
        off = np.abs(coefficients[self.cell_dofs] - local).max(axis=1)
        if off.max() > rtol * np.abs(coefficients).max():
            cell = int(np.argmax(off))
            raise InputError(f"values: cell {cell} and a neighbour differ by {off[cell]:.1e} on what they share")
        return self.function(coefficients)

    def __repr__(self) -> str:
        return f"<regge.ReggeSpace: degree {self.degree}, {len(self)} degrees of freedom on {self.mesh!r}>"


class ReggeFunction:
    """A Regge function, a Regge metric if it is positive definite.

    Parameters
    ----------
    space : ReggeSpace
        The space.
    coefficients : (n,) array_like of float
        Its coefficients, see `ReggeSpace`; they are copied.

    Attributes
    ----------
    space : ReggeSpace
    mesh : Mesh
    degree : int
    """

    def __init__(self, space: ReggeSpace, coefficients: Any) -> None:
        self.space = space
        self.coefficients = coefficients

    @classmethod
    def _of(cls, space: ReggeSpace, native: _regge.Function) -> ReggeFunction:
        function = cls.__new__(cls)
        function.space = space
        function._native = native
        return function

    @property
    def mesh(self) -> Mesh:
        return self.space.mesh

    @property
    def degree(self) -> int:
        return self.space.degree

    @property
    def coefficients(self) -> Floats:
        """A copy of the coefficients; setting it changes the function."""
        return self._native.coefficients()

    @coefficients.setter
    def coefficients(self, values: Any) -> None:
        values = _arrays.floats(values, "coefficients", (len(self.space),))
        self._native: _regge.Function = self.space._native.function(values)

    @property
    def lengths(self) -> Floats:
        """The edge lengths, for degree 0.

        Raises
        ------
        InputError
            If the degree is not 0.
        """
        if self.degree != 0:
            raise InputError(f"a metric has edge lengths for coefficients in degree 0, not {self.degree}")
        return np.sqrt(self.coefficients)

    def check(self) -> None:
        """Is it a metric?

        Raises
        ------
        IndefiniteError
            With the first cell and point, of a rule of order 2r + 2, where it is not positive definite.
        """
        self._native.check()

    def __call__(self, cells: Any, points: Any, frame: Frame = "cartesian") -> Floats:
        """Values at points in cells.

        Parameters
        ----------
        cells : (n,) array_like of int, or int
            The cell of each point; one number for all of them.
        points : (n, N+1) array_like of float
            Barycentric coordinates, by the ascending vertices of the cell.
        frame : {"cartesian", "cell"}
            Components g_ij in the coordinates of ℝ^N, or in those of the cell, ξ_i = λ_i.

        Returns
        -------
        (n, N, N) ndarray

        Raises
        ------
        NoCoordinatesError
            If the frame is "cartesian" and the mesh has no coordinates.
        """
        points = _arrays.points_in_cells(points, "points", self.mesh.dimension)
        cells = np.asarray(cells)
        if cells.ndim == 0:
            cells = np.full(len(points), cells)
        cells = _arrays.integers(cells, "cells", (len(points),), len(self.mesh.cells))
        if frame not in ("cartesian", "cell"):
            raise ValueError(f"frame: is to be 'cartesian' or 'cell', not {frame!r}")
        return self._native.values(cells, points, frame == "cartesian")

    def canonical_dofs(self, order: int | None = None) -> Floats:
        """The canonical degrees of freedom: ∫_D q_ab λ^β for each simplex D, each edge ab of D and |β| = r − dim D + 1.

        By rules that are exact for them unless an order is given. Paper: appendix.
        """
        order = 2 * self.degree + 1 if order is None else _arrays.order(order, self.mesh.dimension)
        return self._native.canonical(order)

    def copy(self) -> ReggeFunction:
        """A function of its own with the same coefficients."""
        return ReggeFunction._of(self.space, self._native)

    def __repr__(self) -> str:
        return f"<regge.ReggeFunction: degree {self.degree} on {self.mesh!r}>"
