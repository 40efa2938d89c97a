"""Unstructured meshes by Netgen, which comes with NGSolve, as files for `regge curvature --mesh` and for peer.py.

    domains.py SHAPE SIZE FILE.json    ball, fichera, holes, torus, graded (N = 3); lshape, disc (N = 2)

SIZE is the largest edge that Netgen is asked for; the domains are about two wide. `graded` is finest in one corner, thirty times as
fine. A ball by Netgen is finer at its poles.
"""

import json
import sys

from netgen.csg import CSGeometry, Cylinder, OrthoBrick, Pnt, Sphere, Torus, Vec
from netgen.geom2d import SplineGeometry
from netgen.meshing import MeshingParameters

CUBE = (Pnt(-1, -1, -1), Pnt(1, 1, 1))
HOLES = {"holes": [(-0.45, -0.45), (0.45, 0.45), (0.45, -0.45)], "disc": [(0.4, 0.4), (-0.4, 0.3), (0, -0.5)]}


def solid(shape):
    """A domain in space."""
    if shape == "ball":
        return Sphere(Pnt(0, 0, 0), 1)
    if shape == "torus":
        return Torus(Pnt(0, 0, 0), Vec(0, 0, 1), 1, 0.4)
    body = OrthoBrick(*CUBE)
    if shape == "fichera":
        return body - OrthoBrick(Pnt(0, 0, 0), Pnt(2, 2, 2))
    if shape == "holes":
        for x, y in HOLES[shape]:
            body = body - Cylinder(Pnt(x, y, -2), Pnt(x, y, 2), 0.22)
    return body


def plane(shape):
    """A domain in the plane."""
    geometry = SplineGeometry()
    if shape == "lshape":
        corners = [(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]
        points = [geometry.AppendPoint(*x) for x in corners]
        for a, b in zip(points, points[1:] + points[:1]):
            geometry.Append(["line", a, b])
        return geometry
    geometry.AddCircle((0, 0), 1, leftdomain=1, rightdomain=0)
    for centre in HOLES["disc"]:
        geometry.AddCircle(centre, 0.18, leftdomain=0, rightdomain=1)
    return geometry


def mesh(shape, size):
    if shape in ("lshape", "disc"):
        result = plane(shape).GenerateMesh(maxh=size)
        return 2, result, result.Elements2D()
    geometry = CSGeometry()
    geometry.Add(solid(shape))
    parameters = MeshingParameters(maxh=size)
    if shape == "graded":
        parameters = MeshingParameters(maxh=size, grading=0.3)
        parameters.RestrictH(x=-1, y=-1, z=-1, h=size / 30)
    result = geometry.GenerateMesh(mp=parameters)
    return 3, result, result.Elements3D()


def main():
    shape, size, file = sys.argv[1:]
    dimension, result, elements = mesh(shape, float(size))
    cells = [[vertex.nr - 1 for vertex in element.vertices] for element in elements]
    # Netgen keeps points that no cell has.
    used = sorted({vertex for cell in cells for vertex in cell})
    number = {vertex: i for i, vertex in enumerate(used)}
    points = [point.p for point in result.Points()]
    document = {
        "dimension": dimension,
        "vertices": [list(points[vertex][:dimension]) for vertex in used],
        "cells": [[number[vertex] for vertex in cell] for cell in cells],
    }
    with open(file, "w") as out:
        json.dump(document, out)
    print(json.dumps({"cells": len(cells)}))


if __name__ == "__main__":
    main()
