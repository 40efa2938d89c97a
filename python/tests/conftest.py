"""What several test files use."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import regge

ROOT = Path(__file__).resolve().parents[2]
CASES = sorted((ROOT / "verify" / "oracle" / "cases").glob("*.json"))


class Oracle:
    """A case of verify/oracle: a mesh, g_h by samples, and what NGSolve computed of it."""

    def __init__(self, path: Path) -> None:
        self.data = json.loads(path.read_text())
        self.name = self.data["name"]
        self.mesh = regge.Mesh(self.data["vertices"], self.data["simplices"])
        space = regge.ReggeSpace(self.mesh, self.data["degree"])
        samples = self.data["samples"]
        x = np.array([sample["points"] for sample in samples])
        n = self.mesh.dimension
        values = np.array([sample["g"] for sample in samples]).reshape(*x.shape[:2], n, n)
        self.g = space.fit(barycentric(self.mesh, x), values)


def barycentric(mesh: regge.Mesh, x: np.ndarray) -> np.ndarray:
    """Barycentric coordinates of points x[cell, q] in their cells."""
    corners = mesh.corners
    jacobian = (corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
    xi = np.linalg.solve(jacobian, (x - corners[:, :1]).transpose(0, 2, 1)).transpose(0, 2, 1)
    return np.concatenate([1 - xi.sum(axis=2, keepdims=True), xi], axis=2)


@pytest.fixture(scope="session", params=CASES, ids=lambda path: path.stem)
def oracle(request: pytest.FixtureRequest) -> Oracle:
    return Oracle(request.param)


@pytest.fixture(scope="session")
def sphere() -> regge.Metric:
    """The unit sphere in the stereographic chart, R = N(N−1)."""
    return regge.formula("conformal-sphere")


@pytest.fixture(params=[2, 3, 4, 5])
def small(request: pytest.FixtureRequest) -> regge.ReggeFunction:
    """A Regge metric that is not flat, in each dimension; of degree 1 up to N = 3."""
    n = request.param
    mesh = regge.Mesh.cube(n, 2 if n < 5 else 1)
    return regge.interpolate(mesh, regge.formula("trig"), degree=1 if n < 4 else 0)
