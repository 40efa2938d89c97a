"""Quasi-uniform meshes of the domains of domains.py by Gmsh (`pip install gmsh`), for sizes at which Netgen takes too long.

    solids.py SHAPE SIZE FILE.msh    ball, fichera, holes, torus, graded (N = 3); lshape, disc (N = 2)

SIZE is the largest edge that Gmsh is asked for; `graded` is thirty times as fine in one corner.
"""

import json
import sys

import gmsh
from domains import HOLES

kernel = gmsh.model.occ


def cut(body, holes):
    """A body without others."""
    dimension = body[0][0]
    return kernel.cut(body, holes)[0] if holes else [(dimension, body[0][1])]


def solid(shape):
    """A domain in space."""
    if shape == "ball":
        return [(3, kernel.addSphere(0, 0, 0, 1))]
    if shape == "torus":
        return [(3, kernel.addTorus(0, 0, 0, 1, 0.4))]
    body = [(3, kernel.addBox(-1, -1, -1, 2, 2, 2))]
    if shape == "fichera":
        return cut(body, [(3, kernel.addBox(0, 0, 0, 1, 1, 1))])
    if shape == "holes":
        return cut(body, [(3, kernel.addCylinder(x, y, -1, 0, 0, 2, 0.22)) for x, y in HOLES[shape]])
    return body


def plane(shape):
    """A domain in the plane."""
    if shape == "lshape":
        return cut([(2, kernel.addRectangle(-1, -1, 0, 2, 2))], [(2, kernel.addRectangle(0, 0, 0, 1, 1))])
    disc = [(2, kernel.addDisk(0, 0, 0, 1, 1))]
    return cut(disc, [(2, kernel.addDisk(x, y, 0, 0.18, 0.18)) for x, y in HOLES[shape]])


def main():
    shape, size, file = sys.argv[1], float(sys.argv[2]), sys.argv[3]
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    dimension = 2 if shape in ("lshape", "disc") else 3
    (plane if dimension == 2 else solid)(shape)
    kernel.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    if shape == "graded":
        field = gmsh.model.mesh.field
        field.add("MathEval", 1)
        distance = "((x+1)^2+(y+1)^2+(z+1)^2)^0.5"
        field.setString(1, "F", f"{size / 30} + {size * 29 / 30 / 12**0.5} * {distance}")
        field.setAsBackgroundMesh(1)
        gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.model.mesh.generate(dimension)
    gmsh.write(file)
    types, elements, _ = gmsh.model.mesh.getElements(dimension)
    print(json.dumps({"cells": sum(map(len, elements))}))


if __name__ == "__main__":
    main()
