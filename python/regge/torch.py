"""The curvature as a function of PyTorch, with its derivative by the theorem instead of by a record of the computation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import torch

from ._autodiff import OfCoefficients
from ._curvature import Boundary
from ._functions import ReggeSpace


class _Curvature(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, ours: OfCoefficients, c: Any) -> Any:
        ctx.ours = ours
        ctx.save_for_backward(c)
        return torch.from_numpy(ours.value(c.detach().numpy()))

    @staticmethod
    def backward(ctx: Any, *w: Any) -> Any:
        (c,) = ctx.saved_tensors
        return None, torch.from_numpy(ctx.ours.pulled_back(c.detach().numpy(), w[0].detach().numpy()))


def curvature(
    space: ReggeSpace, test_degree: int = 1, boundary: Boundary = "none", *, order: int | None = None
) -> Callable[[Any], Any]:
    """As `regge.jax.curvature`, for float64 tensors of length `len(space)` on the CPU."""
    ours = OfCoefficients(space, test_degree, boundary, order)

    def call(c: Any) -> Any:
        if c.dtype != torch.float64 or c.device.type != "cpu":
            raise ValueError(f"regge computes in float64 on the CPU, not in {c.dtype} on {c.device}")
        return _Curvature.apply(ours, c)

    return call
