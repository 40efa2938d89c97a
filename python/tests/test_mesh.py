"""Meshes: arrays in and out, refusals with their place, files."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import ROOT

import regge

# Files of other programs, which the tests of the readers are about.
SEEDS = ROOT / "cli" / "readers" / "seeds"


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_cubes_and_their_simplices(n):
    mesh = regge.Mesh.cube(n, 2 if n < 5 else 1)
    assert mesh.dimension == n and mesh.euler_characteristic == 1 and not mesh.is_closed
    for k in range(n + 1):
        simplices = mesh.simplices(k)
        assert simplices.dtype == np.int64 and simplices.shape == (mesh.count(k), k + 1)
        assert (np.diff(simplices, axis=1) > 0).all()
        assert simplices.flags.c_contiguous and not simplices.flags.writeable
    for k in range(n):
        of_cells = mesh.of_cells(k)
        # Simplices of a cell consist of its vertices.
        ours = mesh.simplices(k)[of_cells].reshape(len(mesh.cells), -1)
        assert all(set(a) == set(b) for a, b in zip(ours.tolist(), mesh.cells.tolist()))
    on_boundary = (np.abs(mesh.points) == 1).any(axis=1)
    np.testing.assert_array_equal(mesh.boundary_points, np.flatnonzero(on_boundary))
    np.testing.assert_array_equal(mesh.corners, mesh.points[mesh.cells])


def test_a_mesh_of_arrays_is_the_mesh_of_the_arrays():
    cube = regge.Mesh.cube(3, 2).perturbed(0.05, seed=3)
    rng = np.random.default_rng(1)
    cells = np.array([rng.permutation(row) for row in cube.cells])
    again = regge.Mesh(cube.points, cells)
    np.testing.assert_array_equal(again.cells, cube.cells)
    np.testing.assert_array_equal(again.points, cube.points)
    np.testing.assert_array_equal(again.edges, cube.edges)
    # Any integers and any floats that hold the numbers.
    regge.Mesh(cube.points.astype(np.float32), cells.astype(np.uint8))


def test_a_torus_and_a_sphere_are_closed():
    torus = regge.Mesh.torus(2, 3)
    assert torus.is_closed and torus.euler_characteristic == 0
    assert torus.points is None and torus.corners.shape == (18, 3, 2)
    sphere = regge.Mesh.simplex_boundary(2)
    assert sphere.is_closed and sphere.euler_characteristic == 2 and sphere.corners is None


SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
HALVES = np.array([[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize(
    ("points", "cells", "says"),
    [
        (SQUARE[:, 0], HALVES, "points: has shape (4,)"),
        (SQUARE[:3], HALVES, "cells: row 1 has an index that does not exist"),
        (SQUARE, HALVES - 1, "cells: row 0 has an index that does not exist"),
        (SQUARE, HALVES * 1.0, "cells: has the type float64"),
        (SQUARE.astype(complex), HALVES, "points: has the type complex128"),
        (SQUARE.astype(str), HALVES, "points: has the type"),
        ([[0, 0], [1, 0], [1]], HALVES, "points"),
        (np.where(SQUARE == 0, np.nan, SQUARE), HALVES, "points: row 0 is not finite"),
        (SQUARE, HALVES[:, :2], "dimension 1"),
        (SQUARE[:, :1], HALVES, "points: have 1 coordinates"),
        (SQUARE, np.zeros((0, 3), int), "a mesh needs"),
        (SQUARE, np.zeros((2, 12), int), "dimension 11"),
        (None, HALVES, "points"),
    ],
)
def test_bad_arrays_are_value_errors_that_say_where(points, cells, says):
    with pytest.raises(ValueError) as caught:
        regge.Mesh(points, cells)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_what_is_no_mesh_is_named():
    with pytest.raises(regge.CellError) as caught:
        regge.Mesh(SQUARE, [[0, 1, 2], [0, 2, 2]])
    assert caught.value.cell == 1
    with pytest.raises(regge.VertexError) as caught:
        regge.Mesh(SQUARE, HALVES[:1])
    assert caught.value.vertex == 3
    with pytest.raises(regge.ManifoldError) as caught:
        regge.Mesh.abstract(5, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert caught.value.simplex == (0, 1) and isinstance(caught.value, (regge.ReggeError, ValueError))
    with pytest.raises(regge.CellError):
        regge.Mesh.cube(2, 2).perturbed(3.0, seed=1)
    with pytest.raises(regge.NoCoordinatesError):
        regge.Mesh.simplex_boundary(3).perturbed(0.1, seed=1)
    for absurd in (lambda: regge.Mesh.cube(5, 1000), lambda: regge.Mesh.cube(6, 1), lambda: regge.Mesh.cube(2, -1)):
        with pytest.raises(ValueError):
            absurd()


def test_files(tmp_path):
    files = ROOT / "examples" / "files"
    disc = regge.read(files / "disc.msh")
    assert disc.dimension == 2 and len(disc.cells) == 384
    assert regge.read(files / "disc.msh", coordinates=False).points is None
    assert regge.read(files / "pentachoron.json").is_closed
    with pytest.raises(regge.FileError):
        regge.read(files / "none.msh")
    broken = tmp_path / "broken.msh"
    broken.write_text((files / "disc.msh").read_text().replace("$Nodes", "$Nods", 1))
    with pytest.raises(regge.FileError) as caught:
        regge.read(broken)
    assert caught.value.file == str(broken)


def test_a_surface_from_a_file_is_immersed(tmp_path):
    """The boundary of a tetrahedron, as Gmsh writes it: four vertices with the defect π each."""
    points = [[0, 0, 0], [1, 1, 0], [1, 0, 1], [0, 1, 1]]
    faces = [[1, 2, 3], [1, 2, 4], [1, 3, 4], [2, 3, 4]]
    nodes = "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(points))
    elements = "".join(f"{i + 1} 2 2 1 1 {a} {b} {c}\n" for i, (a, b, c) in enumerate(faces))
    file = tmp_path / "surface.msh"
    file.write_text(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n{nodes}$EndNodes\n$Elements\n4\n{elements}$EndElements\n")
    mesh = regge.read(file)
    assert mesh.is_immersed and mesh.is_closed
    np.testing.assert_array_equal(mesh.points, points)
    g = regge.induced(mesh)
    np.testing.assert_allclose(regge.angle_defects(g).defects, np.pi, rtol=1e-14)
    with pytest.raises(regge.NoCoordinatesError):
        regge.interpolate(mesh, regge.formula("flat"))


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_a_curved_surface_has_the_metric_of_its_cells(order):
    """As Gmsh writes it, with its nodes moved outward: another area than the flat one's, and the same total 4πχ."""
    file = SEEDS / "curved" / f"gmsh-2d-order{order}-4.1-binary.msh"
    mesh = regge.read(file)
    g = regge.induced(mesh)
    assert mesh.is_immersed and g.degree == 2 * (order - 1)
    assert abs(regge.curvature(g, order=30).total.sum() - 8 * np.pi) < 1e-6
    flat = regge.induced(regge.Mesh(mesh.points, mesh.cells))
    larger = regge.cell_volumes(g).sum() / regge.cell_volumes(flat).sum()
    assert larger == pytest.approx(1) if order == 1 else larger > 1.01


def test_what_is_done_to_a_file_is_a_warning():
    with pytest.warns(UserWarning, match="12 corners were welded to 4 vertices"):
        regge.read(SEEDS / "stl" / "trimesh-binary.stl")
    with pytest.warns(UserWarning, match="cells of order 3 .* by their corners"):
        regge.read(SEEDS / "curved" / "gmsh-3d-order3-4.1-ascii.msh")
