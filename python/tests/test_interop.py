"""Meshes of meshio and PyVista, where they are installed."""

from __future__ import annotations

import numpy as np
import pytest

import regge


def test_meshio():
    meshio = pytest.importorskip("meshio", reason="meshio is not installed (pip install meshio)")
    cube = regge.Mesh.cube(3, 2)
    # Points that no cell uses are left out, cells of lower dimensions too.
    points = np.vstack([[[9.0, 9, 9]], cube.points])
    theirs = meshio.Mesh(points, [("triangle", cube.faces[:3] + 1), ("tetra", cube.cells + 1)])
    ours = regge.Mesh.from_meshio(theirs)
    np.testing.assert_array_equal(ours.cells, cube.cells)
    np.testing.assert_array_equal(ours.points, cube.points)
    square = regge.Mesh.cube(2, 2)
    in_space = np.column_stack([square.points, np.full(len(square.points), 7.0)])
    flat = regge.Mesh.from_meshio(meshio.Mesh(in_space, [("triangle", square.cells)]))
    assert not flat.is_immersed
    np.testing.assert_array_equal(flat.points, square.points)
    for cells in ([("quad", [[0, 1, 3, 2]])], [("line", [[0, 1]])]):
        with pytest.raises(regge.InputError):
            regge.Mesh.from_meshio(meshio.Mesh(in_space, cells))


def test_pyvista():
    pyvista = pytest.importorskip("pyvista", reason="PyVista is not installed (pip install pyvista)")
    for mesh in (regge.Mesh.cube(2, 2), regge.Mesh.cube(3, 2)):
        grid = mesh.to_pyvista(height=mesh.points[:, 0], number=np.arange(len(mesh.cells)))
        assert grid.n_cells == len(mesh.cells) and "height" in grid.point_data and "number" in grid.cell_data
        again = regge.Mesh.from_pyvista(grid)
        np.testing.assert_array_equal(again.cells, mesh.cells)
        np.testing.assert_array_equal(again.points, mesh.points)
    surface = regge.Mesh.from_pyvista(pyvista.Sphere(theta_resolution=12, phi_resolution=12))
    assert surface.is_immersed and surface.euler_characteristic == 2
    total = regge.curvature(regge.induced(surface)).total.sum()
    assert abs(total - 8 * np.pi) < 1e-10
    with pytest.raises(regge.InputError):
        regge.Mesh.cube(4, 1).to_pyvista()
    with pytest.raises(regge.InputError, match="values"):
        regge.Mesh.cube(2, 1).to_pyvista(wrong=[1, 2, 3])
