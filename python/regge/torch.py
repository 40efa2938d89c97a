"""The curvature as a function of PyTorch, with its derivative by the theorem instead of by a record of the computation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import torch

from . import _curvature
from ._curvature import Boundary
from ._functions import ReggeSpace


def curvature(
    space: ReggeSpace, test_degree: int = 1, boundary: Boundary = "none", *, order: int | None = None
) -> Callable[[Any], Any]:
    """The function c ↦ `regge.curvature(g).total` of the coefficients c of g, with its reverse derivative.

    Parameters
    ----------
    space : ReggeSpace
        The space of g.
    test_degree, boundary, order
        As for `regge.curvature`. Unless the boundary is "gauss-bonnet", entries of test functions that do not vanish on the
        boundary are 0, as their derivatives are.

    Returns
    -------
    callable
        For float64 tensors of length `len(space)` on the CPU.
    """
    inner = torch.from_numpy(_curvature._counted(space, test_degree, boundary))

    class Curvature(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, c: Any) -> Any:
            g = space.function(c.detach().numpy())
            ctx.g = g
            return inner * torch.from_numpy(_curvature.curvature(g, test_degree, boundary, order=order).total)

        @staticmethod
        def backward(ctx: Any, *w: Any) -> Any:
            weights = w[0].detach().numpy()
            return torch.from_numpy(_curvature.curvature_vjp(ctx.g, weights, test_degree, boundary, order=order))

    def call(c: Any) -> Any:
        if c.dtype != torch.float64 or c.device.type != "cpu":
            raise ValueError(f"regge computes in float64 on the CPU, not in {c.dtype} on {c.device}")
        return Curvature.apply(c)

    return call
