# %% [markdown]
# # A first curvature
#
# A metric by a formula becomes a Regge metric on a mesh; its curvature is a number for every vertex; refined, it converges.

# %%
import numpy as np

import regge

sphere = regge.formula(conformal="4/(1 + x^2 + y^2)^2", dimension=2, scalar_curvature="2")
mesh = regge.Mesh.cube(2, 16).perturbed(0.03, seed=3)
g = regge.interpolate(mesh, sphere, degree=1)
curvature = regge.curvature(g, boundary="gauss-bonnet")
curvature

# %% [markdown]
# The unit sphere in the stereographic chart: R = 2. The curvature has a part in cells, one that jumps across faces and one
# at hinges, which are vertices here. Together with the terms of the boundary they add up to 4πχ (Gauss and Bonnet).

# %%
parts = {name: getattr(curvature, name).sum() for name in ("cells", "faces", "hinges", "boundary")}
total = curvature.total.sum()
print(parts)
print("total / 4π =", total / (4 * np.pi))
assert abs(total / (4 * np.pi) - mesh.euler_characteristic) < 1e-7

# %% [markdown]
# A picture: R_h, the projection of the curvature onto continuous functions. It vanishes on the boundary, and is 2 inside.

# %%
density = regge.curvature(g).density()
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("there is no picture without matplotlib")
else:
    figure, axes = plt.subplots(figsize=(4.5, 3.6))
    drawn = axes.tripcolor(*mesh.points.T, mesh.cells, density, shading="gouraud", vmin=0, vmax=3)
    axes.triplot(*mesh.points.T, mesh.cells, linewidth=0.3, color="white")
    axes.set_aspect("equal")
    figure.colorbar(drawn, label="R_h")
    plt.show()

# %% [markdown]
# Convergence in H⁻²: of order r + 1 for metrics of degree r.

# %%
print(" r  side   error in H^-2   order")
checked = 0
for degree in (0, 1, 2):
    before = None
    for side in (4, 8, 16, 32):
        fine = regge.Mesh.cube(2, side).perturbed(0.2 / side, seed=3)
        norm = regge.error_norm(regge.interpolate(fine, sphere, degree), sphere, "H-2")
        order = np.nan if before is None else np.log2(before / norm.value)
        print(f"{degree:2d}  {side:4d}   {norm.value:.6e}   {order:5.2f}")
        before = norm.value
    assert order > degree + 0.6, order
    checked += 1
