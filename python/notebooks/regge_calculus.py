# %% [markdown]
# # Regge calculus
#
# Edge lengths are all there is: they have angle defects, an action, and equations. Solved are the equations of a bulging cube
# whose boundary is held and whose inner edges are off. (Were its sides plane, their vertices could move outwards without any
# change of length to first order, and Newton's method would be slow.)

# %%
import numpy as np
from scipy.sparse import linalg

import regge

cube = regge.Mesh.cube(3, 2).perturbed(0.1, seed=1)
bulge = 1 - 0.1 * (cube.points**2).sum(axis=1, keepdims=True)
mesh = regge.Mesh(cube.points * bulge, cube.cells)
flat = regge.induced(mesh).lengths
free = np.setdiff1d(np.arange(len(flat)), mesh.boundary_edges)
print(len(flat), "edges,", len(free), "of them inside")

# %% [markdown]
# Every inner edge is made longer or shorter by up to 2 %. Then the edges have defects: the space is curved.

# %%
rng = np.random.default_rng(1)
lengths = flat.copy()
lengths[free] *= 1 + 0.02 * rng.uniform(-1, 1, len(free))
defects = regge.angle_defects(regge.lengths(mesh, lengths))
print("largest defect", np.abs(defects.defects).max())
assert np.abs(defects.defects).max() > 1e-2

# %% [markdown]
# The action S = Σ Θ |S| and its derivatives in the lengths. By Schläfli's identity the derivatives of the angles do not
# appear in the gradient.

# %%
action = regge.action(regge.lengths(mesh, lengths))
print(action, "gradient", np.abs(action.gradient[free]).max(), "Schläfli", action.schlaefli)
assert action.schlaefli < 1e-13

# %% [markdown]
# Newton's method. An inner vertex that moves in a flat space changes lengths and no defect, so that the Hessian is singular
# at the solution: steps are those of least norm.

# %%
for step in range(12):
    action = regge.action(regge.lengths(mesh, lengths))
    residual = action.gradient[free]
    print(f"{step:2d}  {np.abs(residual).max():.3e}")
    if np.abs(residual).max() < 1e-11:
        break
    hessian = action.hessian[free][:, free]
    lengths[free] -= linalg.lsmr(hessian, residual, atol=1e-14, btol=1e-14, conlim=1e10, maxiter=2000)[0]
assert np.abs(residual).max() < 1e-11

# %% [markdown]
# The boundary is that of a flat cube, and so is what is inside.

# %%
defects = regge.angle_defects(regge.lengths(mesh, lengths))
print("largest defect", np.abs(defects.defects).max())
assert np.abs(defects.defects).max() < 1e-10
checked = 3
