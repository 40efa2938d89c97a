"""Progress: a bar where one is wanted."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, Union

Progress = Union[None, bool, Callable[[float], Any]]


class _Bar:
    """The bar of tqdm if it is installed, else a percentage on standard error."""

    def __init__(self, label: str) -> None:
        self._label = label
        self._last = 0.0
        try:
            from tqdm.auto import tqdm
        except ImportError:
            self._bar: Any = None
        else:
            self._bar = tqdm(total=100, desc=label, unit="%", leave=False)

    def __call__(self, fraction: float) -> None:
        if self._bar is not None:
            self._bar.update(100 * (fraction - self._last))
            if fraction >= 1.0:
                self._bar.close()
        else:
            end = "\n" if fraction >= 1.0 else ""
            print(f"\r{self._label}: {100 * fraction:3.0f} %", end=end, file=sys.stderr, flush=True)
        self._last = fraction


def resolve(progress: Progress, label: str) -> Callable[[float], Any] | None:
    """The function to be called with the fraction that is done."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _Bar(label)
    if not callable(progress):
        raise ValueError(f"progress: is to be a function of a fraction, True or None, not {progress!r}")
    return progress
