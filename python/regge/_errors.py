"""Exceptions: one family, with the place of what is wrong as attributes."""

from __future__ import annotations

from collections.abc import Sequence


class ReggeError(Exception):
    """The family of all exceptions of this package."""


class InputError(ReggeError, ValueError):
    """What was given makes no sense as a whole: no cells, a list of the wrong length."""


class CellError(InputError):
    """A cell cannot be part of a mesh, or a metric has no values in it.

    Attributes
    ----------
    cell : int
        Its row in the array of cells.
    """

    def __init__(self, message: str, cell: int) -> None:
        super().__init__(message)
        self.cell = cell


class VertexError(InputError):
    """A vertex cannot be part of a mesh.

    Attributes
    ----------
    vertex : int
        Its row in the array of points.
    """

    def __init__(self, message: str, vertex: int) -> None:
        super().__init__(message)
        self.vertex = vertex


class ManifoldError(InputError):
    """The cells form no manifold.

    Attributes
    ----------
    simplex : tuple of int
        The vertices of the simplex along which they do not.
    cell : int
        A cell that contains it.
    """

    def __init__(self, message: str, simplex: Sequence[int], cell: int) -> None:
        super().__init__(message)
        self.simplex = tuple(simplex)
        self.cell = cell


class NoCoordinatesError(InputError):
    """The mesh has no coordinates, and what was asked for needs them."""


class FileError(InputError):
    """A file was refused.

    Attributes
    ----------
    file : str
        Its name.
    line : int or None
        The line, from 1.
    byte : int or None
        The byte of a binary file, from 0.
    """

    def __init__(
        self, message: str, file: str, line: int | None = None, byte: int | None = None
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.byte = byte


class IndefiniteError(ReggeError):
    """A metric is not positive definite.

    Attributes
    ----------
    cell : int
        The cell.
    point : tuple of float
        Barycentric coordinates in the cell, vertices in ascending order.
    pivot : float
        The pivot of LDLᵀ that is not positive, or NaN.
    """

    def __init__(self, message: str, cell: int, point: Sequence[float], pivot: float) -> None:
        super().__init__(message)
        self.cell = cell
        self.point = tuple(point)
        self.pivot = pivot


class EdgeError(ReggeError):
    """An edge has no length: the geodesic left the domain of the formula, or was not found.

    Attributes
    ----------
    vertices : tuple of int
        The two vertices.
    """

    def __init__(self, message: str, vertices: Sequence[int]) -> None:
        super().__init__(message)
        self.vertices = tuple(vertices)


class SolverError(ReggeError):
    """A linear system could not be solved, or sums are not finite."""
