"""What is given as an array is looked at here: shape, type, numbers; refusals name the row."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

_LARGEST_DEGREE = 12
_MOST_POINTS = 2_000_000
_MOST_CELLS = 10**8


def _array(values: Any, name: str) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except Exception as error:
        raise ValueError(f"{name}: is no array: {error}") from None
    if array.dtype == object:
        raise ValueError(f"{name}: is no array of numbers (rows of different lengths?)")
    return array


def _check_shape(array: npt.NDArray[Any], name: str, shape: tuple[int | str, ...]) -> None:
    wanted = ", ".join(str(size) for size in shape) + ("," if len(shape) == 1 else "")
    fits = len(shape) == array.ndim and all(
        isinstance(size, str) or size == given for size, given in zip(shape, array.shape)
    )
    if not fits:
        raise ValueError(f"{name}: has shape {array.shape}, not ({wanted})")


def floats(values: Any, name: str, shape: tuple[int | str, ...]) -> Floats:
    """A C-contiguous array of finite float64; a string in `shape` stands for any size."""
    array = _array(values, name)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name}: has the type {array.dtype}, not floating point numbers")
    _check_shape(array, name, shape)
    array = np.ascontiguousarray(array, dtype=np.float64)
    finite = np.isfinite(array)
    if not finite.all():
        row = int(np.argwhere(~finite)[0][0])
        raise ValueError(f"{name}: row {row} is not finite: {array[row].tolist()}")
    return array


def integers(values: Any, name: str, shape: tuple[int | str, ...], below: int | None = None) -> Integers:
    """A C-contiguous array of int64 that are not negative, and below a number if there is one."""
    array = _array(values, name)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name}: has the type {array.dtype}, not integers")
    _check_shape(array, name, shape)
    bad = array < 0
    if below is not None:
        bad |= array >= below
    if bad.any():
        row = int(np.argwhere(bad)[0][0])
        limit = "" if below is None else f": there are {below}, counted from 0"
        raise ValueError(f"{name}: row {row} has an index that does not exist, {array[row].tolist()}{limit}")
    return np.ascontiguousarray(array, dtype=np.int64)


def integer(value: Any, name: str, low: int, high: int) -> int:
    """An integer in a range."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise ValueError(f"{name}: is to be an integer, not {value!r}")
    if not low <= value <= high:
        raise ValueError(f"{name}: {value} is not in {low}..{high}")
    return int(value)


def number(value: Any, name: str) -> float:
    """A finite number."""
    try:
        result = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: is to be a number, not {value!r}") from None
    if not np.isfinite(result):
        raise ValueError(f"{name}: is not finite")
    return result


def degree(value: Any, name: str = "degree", low: int = 0) -> int:
    """A polynomial degree."""
    return integer(value, name, low, _LARGEST_DEGREE)


def order(value: Any, dimension: int) -> int:
    """An order of quadrature whose rules have a number of points that fits into memory."""
    largest = int(2 * _MOST_POINTS ** (1 / dimension)) - 2
    return integer(value, "order", 0, min(largest, 200))


def cubes(dimension: int, side: Any, most: str) -> int:
    """The number of cubes a side of a mesh that fits into memory."""
    side = integer(side, most, 1, 2**31)
    cells = side**dimension * int(np.prod(range(1, dimension + 1)))
    if cells > _MOST_CELLS:
        raise ValueError(f"{most}: {side} makes {cells} cells; at most {_MOST_CELLS} are possible")
    return side


def points_in_cells(values: Any, name: str, dimension: int, rows: int | str = "n") -> Floats:
    """Barycentric coordinates, which add up to one."""
    points = floats(values, name, (rows, dimension + 1))
    off = np.abs(points.sum(axis=1) - 1.0)
    # Rounding of a sum of numbers of size one.
    if (off > 1e-9).any():
        row = int(np.argmax(off > 1e-9))
        raise ValueError(f"{name}: the barycentric coordinates of row {row} add up to {points[row].sum()}")
    return points


def read_only(array: Any) -> Any:
    """The array, which cannot be written to from now on."""
    array.flags.writeable = False
    return array
