# %% [markdown]
# # A metric with a prescribed curvature
#
# Sought are factors u of the vertices, such that the metric with squared edge lengths e^(u_i + u_j) ℓ_ij² has a given
# curvature at the inner vertices; on the boundary u is known. The gradient of the misfit comes from `curvature_vjp`:
# one evaluation, whatever the number of unknowns.

# %%
import numpy as np
from scipy import optimize

import regge

mesh = regge.Mesh.cube(2, 6).perturbed(0.03, seed=2)
flat = regge.induced(mesh)
space, (first, second) = flat.space, mesh.edges.T
inner = np.setdiff1d(np.arange(mesh.count(0)), mesh.boundary_points)


def metric(u):
    return space.function(np.exp(u[first] + u[second]) * flat.coefficients)


# %% [markdown]
# The given curvature is that of a sphere's factors, which are to be found again.

# %%
known = np.log(2 / (1 + (mesh.points**2).sum(axis=1)))
target = regge.curvature(metric(known)).total
start = known.copy()
start[inner] = 0.3


def misfit(x):
    u = start.copy()
    u[inner] = x
    g = metric(u)
    residual = np.zeros(len(u))
    residual[inner] = (regge.curvature(g).total - target)[inner]
    by_square = regge.curvature_vjp(g, residual) * g.coefficients
    gradient = np.bincount(first, by_square, len(u)) + np.bincount(second, by_square, len(u))
    return 0.5 * residual @ residual, gradient[inner]


# %% [markdown]
# The gradient against differences.

# %%
x, v = start[inner], np.cos(np.arange(len(inner)))
by_difference = (misfit(x + 1e-5 * v)[0] - misfit(x - 1e-5 * v)[0]) / 2e-5
print(misfit(x)[1] @ v, by_difference)
assert abs(misfit(x)[1] @ v / by_difference - 1) < 1e-7

# %% [markdown]
# Descent along gradients, by SciPy's L-BFGS. A discrete conformal factor is determined by its curvature, so that the
# sphere's comes back.

# %%
found = optimize.minimize(
    misfit, x, jac=True, method="L-BFGS-B", options={"ftol": 0, "gtol": 1e-15, "maxiter": 5000, "maxfun": 10000, "maxcor": 30}
)
u = start.copy()
u[inner] = found.x
off = np.abs(regge.curvature(metric(u)).total - target)[inner].max()
print(found.nit, "steps; the curvature is off by", off, "and the factor by", np.abs(u - known).max())
assert off < 1e-8
assert np.abs(u - known).max() < 1e-7
checked = 2
