"""The distributional curvature, its first variation, the Einstein tensor."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, Union

import numpy as np

from . import _arrays, _regge
from ._arrays import Floats, Integers
from ._functions import ReggeFunction, ReggeSpace
from ._metrics import _require_metric
from ._progress import Progress, resolve

Boundary = Literal["none", "gauss-bonnet"]


def _order(g: ReggeFunction, test_degree: int, order: int | None) -> int:
    if order is None:
        return _regge.default_order(g.degree, test_degree)
    return _arrays.order(order, g.mesh.dimension)


def _with_boundary(boundary: Boundary) -> bool:
    if boundary not in ("none", "gauss-bonnet"):
        raise ValueError(f"boundary: is to be 'none' or 'gauss-bonnet', not {boundary!r}")
    return boundary == "gauss-bonnet"


@dataclass(frozen=True)
class Sums:
    """Three sums for each function of a test space, signs and factors included.

    Attributes
    ----------
    cells, faces, hinges : (n,) ndarray
        Σ_T, Σ_F, Σ_S.
    """

    cells: Floats
    faces: Floats
    hinges: Floats

    @property
    def total(self) -> Floats:
        """(n,) array: the whole functional."""
        return self.cells + self.faces + self.hinges

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.asarray(self.total, dtype=dtype)

    def __len__(self) -> int:
        return len(self.cells)


class Curvature:
    """The distributional densitized scalar curvature of a Regge metric, as `curvature` computes it.

    Attributes
    ----------
    g : ReggeFunction
        The metric.
    test_degree : int
        The degree q of the Lagrange test functions. They are Bernstein polynomials: for q = 1 the hat functions in the order
        of the mesh's points; for q > 1 the functions of vertices, then those of edges, and so on.
    order : int
        The order of the rules of quadrature.
    cells, faces, hinges : (n,) ndarray
        Σ_T ∫_T R v ω, 2 Σ̊_F ∫_F ⟦H⟧ v ω_F, 2 Σ̊_S ∫_S Θ_S v ω_S for each test function v, faces and hinges inside.
    boundary : (n,) ndarray or None
        The terms of Gauss and Bonnet, if they were asked for: 2 Σ_{F⊂∂Ω} ∫ H v ω_F + 2 Σ_{S⊂∂Ω} ∫ (π − Σ θ) v ω_S.
    """

    def __init__(
        self, g: ReggeFunction, test_degree: int, order: int, boundary: Boundary, progress: Progress
    ) -> None:
        self.g = g.copy()
        self.test_degree = test_degree
        self.order = order
        self._with_boundary = _with_boundary(boundary)
        told = resolve(progress, "curvature")
        inner, outer = g._native.curvature(test_degree, order, self._with_boundary, told)
        self.cells, self.faces, self.hinges = inner
        self.boundary: Floats | None = None
        if outer is not None:
            self.boundary = outer[1] + outer[2]

    @cached_property
    def total(self) -> Floats:
        """(n,) array: ⟨(Rω)_dist(g), v⟩ for each test function v, with the terms of the boundary if they were asked for."""
        total = self.cells + self.faces + self.hinges
        return total if self.boundary is None else total + self.boundary

    @cached_property
    def _by_simplex(self) -> tuple[Floats, Floats, Floats]:
        inner, outer = self.g._native.curvature(None, self.order, self._with_boundary, None)
        sums = inner if outer is None else tuple(ours + theirs for ours, theirs in zip(inner, outer))
        n, mesh = self.g.mesh.dimension, self.g.mesh
        ends = np.cumsum([0] + [mesh.count(n - c) for c in range(3)])
        cells, faces, hinges = (sums[c][ends[c] : ends[c + 1]] for c in range(3))
        return cells, faces, hinges

    @property
    def by_cell(self) -> Floats:
        """∫_T R ω for each cell. The three by simplex are evaluated at once when one of them is first asked for."""
        return self._by_simplex[0]

    @property
    def by_face(self) -> Floats:
        """2 ∫_F ⟦H⟧ ω_F for each face in the order of `mesh.faces`; on the boundary 0, or what Gauss and Bonnet have there."""
        return self._by_simplex[1]

    @property
    def by_hinge(self) -> Floats:
        """2 ∫_S Θ_S ω_S for each hinge in the order of `mesh.hinges`; on the boundary 0, or what Gauss and Bonnet have there."""
        return self._by_simplex[2]

    def density(self, degree: int | None = None) -> Floats:
        """R_h, the curvature as a function: its L²(Ω, g)-projection onto Lagrange functions of a degree.

        Without the terms of the boundary onto those that vanish there, as in the paper's section 1; with them onto all, and the
        curvature of the boundary, a measure on it, then is a layer of the function.

        Parameters
        ----------
        degree : int, optional
            The degree; that of the test functions if there is none.

        Returns
        -------
        (n,) ndarray
            The coefficients in Bernstein's basis; of degree 1 the values at the mesh's points.
        """
        degree = self.test_degree if degree is None else _arrays.degree(degree, low=1)
        order = max(self.order, 2 * degree)
        load = self
        if degree != self.test_degree:
            boundary: Boundary = "gauss-bonnet" if self._with_boundary else "none"
            load = Curvature(self.g, degree, order, boundary, None)
        return self.g._native.density(degree, load.total, self._with_boundary, order)

    def __repr__(self) -> str:
        return f"<regge.Curvature: {len(self.cells)} test functions of degree {self.test_degree}, order {self.order}>"


def curvature(
    g: ReggeFunction,
    test_degree: int = 1,
    boundary: Boundary = "none",
    *,
    order: int | None = None,
    progress: Progress = None,
) -> Curvature:
    """The distributional densitized scalar curvature of a Regge metric. Paper: def:distcurv.

    ⟨(Rω)_dist(g), v⟩ = Σ_T ∫_T R v ω + 2 Σ̊_F ∫_F ⟦H⟧ v ω_F + 2 Σ̊_S ∫_S Θ_S v ω_S

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    test_degree : int
        The degree q ≥ 1 of the Lagrange functions v.
    boundary : {"none", "gauss-bonnet"}
        Test functions that do not vanish on the boundary are tested as they are, as in the paper; or the terms of the
        boundary are added, which for N = 2 make the total over all v equal to 4πχ.
    order : int, optional
        The order of the rules of quadrature; one at which integration is not what limits the accuracy if there is none.
        Degree 0 is integrated exactly.
    progress : callable or bool, optional
        Called with the fraction that is done, an estimate; True for a bar.

    Returns
    -------
    Curvature

    Raises
    ------
    IndefiniteError
        If g is no metric: with the cell and point.

    Examples
    --------
    >>> import regge, numpy as np
    >>> mesh = regge.Mesh.cube(2, 8)
    >>> g = regge.interpolate(mesh, regge.formula("conformal-sphere"), degree=2)
    >>> K = regge.curvature(g, boundary="gauss-bonnet")
    >>> bool(abs(K.total.sum() - 4 * np.pi) < 1e-8)
    True
    """
    g, q = _require_metric(g), _arrays.degree(test_degree, "test_degree", low=1)
    return Curvature(g, q, _order(g, q, order), boundary, progress)


SigmaLike = Union[ReggeFunction, Any]


def _sigma(g: ReggeFunction, sigma: SigmaLike, name: str) -> Floats:
    if isinstance(sigma, ReggeFunction):
        if sigma.space != g.space:
            raise ValueError(f"{name}: is to be of the space of g")
        return sigma.coefficients
    return _arrays.floats(sigma, name, (len(g.space),))


def b_h(
    g: ReggeFunction, sigma: SigmaLike, test_degree: int = 1, *, order: int | None = None, progress: Progress = None
) -> Sums:
    """b_h(g; σ, v) = Σ_T ∫ ⟨𝕊σ, ∇∇v⟩ ω − Σ_F ∫ 𝕊σ(n, n) ⟦∇_n v⟧ ω_F for each Lagrange function v. Paper: thm:distcurvdot.

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    sigma : ReggeFunction or (n,) array_like
        σ, a function of the space of g or its coefficients.
    test_degree, order, progress
        As for `curvature`.

    Returns
    -------
    Sums
        The sum over hinges is empty; that over faces is over all of them, with one-sided values on the boundary.
    """
    g, q = _require_metric(g), _arrays.degree(test_degree, "test_degree", low=1)
    sums = g._native.b_h(_sigma(g, sigma, "sigma"), q, _order(g, q, order), resolve(progress, "b_h"))
    return Sums(*sums)


def a_h(
    g: ReggeFunction, sigma: SigmaLike, test_degree: int = 1, *, order: int | None = None, progress: Progress = None
) -> Sums:
    """a_h(g; σ, v) = Σ_T ∫ ⟨G, σ⟩ v ω + Σ̊_F ∫ ⟨⟦II‾⟧, σ⟩ v ω_F − Σ̊_S ∫ ⟨Θ_S g|_S, σ⟩ v ω_S. Paper: thm:distcurvdot.

    Parameters and returned value as for `b_h`. d/dt ⟨(Rω)_dist(g + tσ), v⟩ = b_h − a_h for v that vanish on the boundary.
    """
    g, q = _require_metric(g), _arrays.degree(test_degree, "test_degree", low=1)
    sums = g._native.a_h(_sigma(g, sigma, "sigma"), q, _order(g, q, order), resolve(progress, "a_h"))
    return Sums(*sums)


def curvature_jvp(
    g: ReggeFunction,
    dg: SigmaLike,
    test_degree: int = 1,
    boundary: Boundary = "none",
    *,
    order: int | None = None,
    progress: Progress = None,
) -> Floats:
    """The derivative J dg of `curvature(g).total` in the direction dg: b_h − a_h. Paper: thm:distcurvdot.

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    dg : ReggeFunction or (n,) array_like
        A function of the space of g or its coefficients.
    test_degree, boundary, order, progress
        As for `curvature`.

    Returns
    -------
    (m,) ndarray
        By test function. The theorem is for those that vanish on the boundary, and the others have 0, unless the boundary is
        "gauss-bonnet": with its terms it holds for all of them.

    Notes
    -----
    The theorem integrates by parts, so that this is the derivative of the integrals and not of the rules that compute them:
    for degree 0 the same, else up to what the rules miss, which a higher `order` makes less.
    """
    g, q = _require_metric(g), _arrays.degree(test_degree, "test_degree", low=1)
    told = resolve(progress, "curvature_jvp")
    sigma = _sigma(g, dg, "dg")
    return Sums(*g._native.curvature_jvp(sigma, q, _with_boundary(boundary), _order(g, q, order), told)).total


def curvature_vjp(
    g: ReggeFunction,
    weights: Any,
    test_degree: int = 1,
    boundary: Boundary = "none",
    *,
    order: int | None = None,
    progress: Progress = None,
) -> Floats:
    """The gradient Jᵀ w of Σ_i w_i `curvature(g).total`_i in the coefficients of g: the transpose of `curvature_jvp`.

    One evaluation, whatever the number of coefficients, and nothing is recorded.

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    weights : (m,) array_like of float
        w, by test function. Those of functions that do not vanish on the boundary do not count, unless the boundary is
        "gauss-bonnet".
    test_degree, boundary, order, progress
        As for `curvature`.

    Returns
    -------
    (n,) ndarray
        By coefficient of g: ⟨w, J dg⟩ = ⟨Jᵀ w, dg⟩ up to rounding.

    Examples
    --------
    >>> import regge, numpy as np
    >>> g = regge.interpolate(regge.Mesh.cube(2, 4), regge.formula("conformal-sphere"), degree=1)
    >>> w, dg = np.ones(25), g.coefficients
    >>> bool(abs(w @ regge.curvature_jvp(g, dg) - regge.curvature_vjp(g, w) @ dg) < 1e-12)
    True
    """
    g, q = _require_metric(g), _arrays.degree(test_degree, "test_degree", low=1)
    told = resolve(progress, "curvature_vjp")
    w = _arrays.floats(weights, "weights", ("m",))
    return Sums(*g._native.curvature_vjp(w, q, _with_boundary(boundary), _order(g, q, order), told)).total


def einstein(
    g: ReggeFunction, test_degree: int | None = None, *, order: int | None = None, progress: Progress = None
) -> Sums:
    """The distributional Einstein tensor ⟨(Gω)_dist(g), ψ_i⟩ against every function of a Regge space. Paper: def:distein.

    Parameters
    ----------
    g : ReggeFunction
        The metric.
    test_degree : int, optional
        The degree of the Regge functions ψ_i; that of g if there is none.
    order, progress
        As for `curvature`.

    Returns
    -------
    Sums
        By degree of freedom; `numpy.asarray` of it is its total.
    """
    g = _require_metric(g)
    q = g.degree if test_degree is None else _arrays.degree(test_degree, "test_degree")
    return Sums(*g._native.einstein(q, _order(g, q, order), resolve(progress, "einstein")))


@dataclass(frozen=True)
class AngleDefects:
    """The interior hinges, each with its defect and its size.

    Attributes
    ----------
    hinges : (n,) ndarray of int
        Their rows in `mesh.hinges`; for N = 2 vertices.
    defects : (n,) ndarray
        Θ_S = 2π − Σ_T θ_ST at the barycentre, in radians.
    sizes : (n,) ndarray
        |S| = ∫_S ω_S; 1 for N = 2.
    """

    hinges: Integers
    defects: Floats
    sizes: Floats


def angle_defects(g: ReggeFunction, *, order: int | None = None) -> AngleDefects:
    """The angle defect at the barycentre of each interior hinge, and its size by rules of an order."""
    g = _require_metric(g)
    return AngleDefects(*g._native.angle_defects(_order(g, 1, order)))


def cell_volumes(g: ReggeFunction, *, order: int | None = None) -> Floats:
    """(m,) array: ∫_T ω of each cell."""
    g = _require_metric(g)
    return g._native.cell_volumes(_order(g, 1, order))
