"""The boundary of a tetrahedron as other programs write it: what readers are tested on, and where their fuzz targets begin.

    pip install vtk meshio trimesh gmsh
    python cli/readers/seeds/make.py

makes a folder for each reader, and in it a file for each way in which a program writes that format. `curved` has cells of
order 1 to 4: the same surface, and the tetrahedron itself, their nodes moved outward.
"""

import itertools
import pathlib

import gmsh
import meshio
import numpy
import trimesh
import vtk

HERE = pathlib.Path(__file__).parent
# Numbers that float32 has exactly: STL and some PLY files know no others.
POINTS = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1.5, 0], [0, 0, -0.25]])
CELLS = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
# Gmsh's numbers of triangles and tetrahedra of order 1 to 4.
KINDS = {2: (2, 9, 21, 23), 3: (4, 11, 29, 30)}


def place(folder, name):
    (HERE / folder).mkdir(exist_ok=True)
    return str(HERE / folder / name)


def by_trimesh():
    surface = trimesh.Trimesh(POINTS, CELLS, process=False)
    surface.export(place("obj", "trimesh.obj"))
    surface.export(place("off", "trimesh.off"))
    surface.export(place("stl", "trimesh-binary.stl"))
    surface.export(place("stl", "trimesh-ascii.stl"), file_type="stl_ascii")
    surface.export(place("ply", "trimesh-binary.ply"))
    surface.export(place("ply", "trimesh-ascii.ply"), encoding="ascii")


def by_meshio():
    surface = meshio.Mesh(POINTS, [("triangle", CELLS)])
    for version, binary in itertools.product(("vtk42", "vtk51"), (False, True)):
        name = f"meshio-{version}-{'binary' if binary else 'ascii'}.vtk"
        surface.write(place("vtk", name), file_format=version, binary=binary)
    surface.write(place("vtu", "meshio-ascii.vtu"), binary=False)
    for compression in (None, "zlib"):
        name = f"meshio-{compression or 'plain'}.vtu"
        surface.write(place("vtu", name), binary=True, compression=compression)
    for binary in (False, True):
        name = f"meshio-{'binary' if binary else 'ascii'}.ply"
        surface.write(place("ply", name), binary=binary)
    surface.write(place("obj", "meshio.obj"))
    surface.write(place("off", "meshio.off"))
    surface.write(place("medit", "meshio.mesh"))


def by_vtk():
    grid, surface, points = vtk.vtkUnstructuredGrid(), vtk.vtkPolyData(), vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for x in POINTS:
        points.InsertNextPoint(x)
    for data in (grid, surface):
        data.SetPoints(points)
        data.Allocate(len(CELLS))
        for cell in CELLS:
            data.InsertNextCell(vtk.VTK_TRIANGLE, 3, cell.tolist())
    for kind, data in (("grid", grid), ("surface", surface)):
        legacy(kind, data)
        xml(kind, data)


def legacy(kind, data):
    writer = vtk.vtkUnstructuredGridWriter() if kind == "grid" else vtk.vtkPolyDataWriter()
    writer.SetInputData(data)
    for version, binary in itertools.product((42, 51), (False, True)):
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        writer.SetFileName(place("vtk", f"vtk-{kind}-{version}-{'binary' if binary else 'ascii'}.vtk"))
        writer.Write()


def xml(kind, data):
    grid = kind == "grid"
    make = vtk.vtkXMLUnstructuredGridWriter if grid else vtk.vtkXMLPolyDataWriter
    ways = itertools.product(("ascii", "binary", "appended-base64", "appended-raw"), ("plain", "zlib"), (32, 64), (False, True))
    for mode, compressor, header, big in ways:
        # Each choice is tried, not all of their products.
        if (mode == "ascii" and (compressor, header, big) != ("plain", 32, False)) or (big and (header, kind) != (64, "grid")):
            continue
        writer = make()
        writer.SetInputData(data)
        {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
        writer.SetEncodeAppendedData(mode == "appended-base64")
        writer.SetCompressorTypeToZLib() if compressor == "zlib" else writer.SetCompressorTypeToNone()
        writer.SetHeaderTypeToUInt32() if header == 32 else writer.SetHeaderTypeToUInt64()
        writer.SetByteOrderToBigEndian() if big else writer.SetByteOrderToLittleEndian()
        ending = ("vtu" if grid else "vtp") if mode == "ascii" else f"{header}{'-big' if big else ''}.{'vtu' if grid else 'vtp'}"
        name = f"vtk-{mode}.{ending}" if mode == "ascii" else f"vtk-{mode}-{compressor}-{ending}"
        writer.SetFileName(place("vtu", name))
        writer.Write()


def by_gmsh():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for dimension, order in itertools.product((2, 3), (1, 2, 3, 4)):
        gmsh.model.add(f"{dimension}-{order}")
        gmsh.model.addDiscreteEntity(dimension, 1)
        cells = CELLS if dimension == 2 else numpy.arange(4)[None]
        nodes(dimension, order, cells)
        for version, binary in itertools.product((2.2, 4.1), (0, 1)):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            name = f"gmsh-{dimension}d-order{order}-{version}-{'binary' if binary else 'ascii'}.msh"
            gmsh.write(place("curved", name))
        gmsh.option.setNumber("Mesh.Binary", 0)
        if (dimension, order) == (2, 1):
            for folder, ending in (("medit", "mesh"), ("off", "off"), ("vtk", "vtk")):
                gmsh.write(place(folder, f"gmsh.{ending}"))
    gmsh.finalize()


def nodes(dimension, order, cells):
    """Nodes at the places that Gmsh has for them, moved outward where they are no corners."""
    kind = KINDS[dimension][order - 1]
    local = numpy.array(gmsh.model.mesh.getElementProperties(kind)[4]).reshape(-1, dimension)
    local = numpy.column_stack([1 - local.sum(1), local])
    known, coordinates, tags = {}, [], []
    for cell in cells:
        for weights in local:
            x = weights @ POINTS[cell]
            key = tuple(numpy.round(x, 9) + 0.0)
            if key not in known:
                known[key] = len(known) + 1
                centre = POINTS.mean(axis=0)
                bulge = 0.1 * (1 - (weights**2).sum())
                coordinates.extend(x + bulge * (x - centre))
            tags.append(known[key])
    gmsh.model.mesh.addNodes(dimension, 1, range(1, len(known) + 1), coordinates)
    gmsh.model.mesh.addElementsByType(1, kind, [], tags)


if __name__ == "__main__":
    by_trimesh()
    by_meshio()
    by_vtk()
    by_gmsh()
