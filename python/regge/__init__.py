"""The curvature of Regge metrics in any dimension: cells, faces and hinges, for piecewise polynomial metrics.

>>> import regge
>>> mesh = regge.Mesh.cube(2, 8)
>>> g = regge.interpolate(mesh, regge.formula("conformal-sphere"), degree=1)
>>> regge.curvature(g).total.shape
(81,)

Labels such as def:distcurv are those of Gawlik and Neunteufel, *Finite element approximation of scalar curvature in
arbitrary dimension*. Arrays are C-contiguous float64 and int64. While something is computed the interpreter's lock is
released, Ctrl-C stops it, and results do not depend on the number of threads.
"""

from ._action import Action, action
from ._curvature import (
    AngleDefects,
    Curvature,
    Sums,
    a_h,
    angle_defects,
    b_h,
    cell_volumes,
    curvature,
    curvature_jvp,
    curvature_vjp,
    einstein,
)
from ._errors import (
    CellError,
    EdgeError,
    FileError,
    IndefiniteError,
    InputError,
    ManifoldError,
    NoCoordinatesError,
    ReggeError,
    SolverError,
    VertexError,
)
from ._functions import ReggeFunction, ReggeSpace
from ._mesh import Mesh, read
from ._metrics import (
    Metric,
    formula,
    induced,
    interpolate,
    kinds,
    lengths,
    metric,
    read_metric,
)
from ._ngsolve import fit_ngsolve, from_ngsolve_metric
from ._norms import ErrorNorm, error_norm, norms
from ._regge import known_metrics, num_threads, set_num_threads, unused_width

__version__ = "0.1.0"

__all__ = [
    "Action",
    "AngleDefects",
    "CellError",
    "Curvature",
    "EdgeError",
    "ErrorNorm",
    "FileError",
    "IndefiniteError",
    "InputError",
    "ManifoldError",
    "Mesh",
    "Metric",
    "NoCoordinatesError",
    "ReggeError",
    "ReggeFunction",
    "ReggeSpace",
    "SolverError",
    "Sums",
    "VertexError",
    "a_h",
    "action",
    "angle_defects",
    "b_h",
    "cell_volumes",
    "curvature",
    "curvature_jvp",
    "curvature_vjp",
    "einstein",
    "error_norm",
    "fit_ngsolve",
    "formula",
    "from_ngsolve_metric",
    "induced",
    "interpolate",
    "kinds",
    "known_metrics",
    "lengths",
    "metric",
    "norms",
    "num_threads",
    "read",
    "read_metric",
    "set_num_threads",
    "unused_width",
]
