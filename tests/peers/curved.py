"""Convergence of the curvature of curved surfaces: an ellipsoid and a torus of revolution, elements of order 1 to 4.

    pip install gmsh numpy
    python tests/peers/curved.py target/release/regge

Meshes are put into Gmsh as discrete surfaces and written by it, so that the numbering of the nodes is Gmsh's own. Cells are
images of flat triangles: of the parameters' square for the torus, of a subdivided octahedron for the ellipsoid, and the nodes
lie on the surface. Two errors against closed forms, with their orders from one mesh to the next:

- K in L2: the square root of the sum over vertices of area times (K - exact)^2, K = R_h/2 at the vertex, R_h in hat
  functions
- the pairing with a fixed smooth function: v = cos v on the torus, v = z^2 of the unit sphere's point on the ellipsoid, in
  polynomials of degree order + 2, so that its own interpolation is no part of the error
"""

import itertools
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import gmsh
import numpy

TYPES = {1: 2, 2: 9, 3: 21, 4: 23}
RADII = (2.0, 1.0)
AXES = (1.0, 0.8, 0.6)


def lattice(order):
    return [a for a in itertools.product(range(order + 1), repeat=3) if sum(a) == order]


def torus_cells(n):
    """Corners in the plane of the parameters, and the vertices' names."""
    cells = []
    for i in range(2 * n):
        for j in range(n):
            a, b, c, d = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            for cell in [(a, b, c), (a, c, d)]:
                cells.append(numpy.array([(math.pi * i / n, 2 * math.pi * j / n) for i, j in cell]))
    return cells


def torus(p):
    big, small = RADII
    r = big + small * math.cos(p[1])
    return (r * math.cos(p[0]), r * math.sin(p[0]), small * math.sin(p[1]))


def torus_k(p):
    big, small = RADII
    return math.cos(p[1]) / (small * (big + small * math.cos(p[1])))


def sphere_cells(n):
    """The octahedron's faces, each in n^2 triangles."""
    cells = []
    for signs in itertools.product((1, -1), repeat=3):
        corners = numpy.diag(signs).astype(float)
        at = lambda i, j: ((n - i - j) * corners[0] + i * corners[1] + j * corners[2]) / n
        for i in range(n):
            for j in range(n - i):
                cells.append(numpy.array([at(i, j), at(i + 1, j), at(i, j + 1)]))
                if i + j + 1 < n:
                    cells.append(numpy.array([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
    return cells


def ellipsoid(p):
    return tuple(numpy.array(AXES) * p / numpy.linalg.norm(p))


def ellipsoid_k(p):
    a, b, c = AXES
    x, y, z = ellipsoid(p)
    return 1 / (a * b * c * (x**2 / a**4 + y**2 / b**4 + z**2 / c**4)) ** 2


def ellipsoid_pairing():
    """The integral of K z^2 over the sphere's parameters, K times the area's density, by Gauss and equal angles."""
    a, b, c = AXES
    nodes, weights = numpy.polynomial.legendre.leggauss(200)
    angles = numpy.arange(400) * 2 * math.pi / 400
    z, t = numpy.meshgrid(nodes, angles, indexing="ij")
    r = numpy.sqrt(1 - z**2)
    n = (r * numpy.cos(t), r * numpy.sin(t), z)
    s = numpy.sqrt(sum((u / axis) ** 2 for u, axis in zip(n, AXES)))
    density = a * b * c * s / (a * b * c * s**2) ** 2
    return float((density * z**2 * weights[:, None]).sum() * 2 * math.pi / 400)


CASES = {
    "torus": (torus_cells, torus, torus_k, lambda p: math.cos(p[1]), 2 * math.pi**2, (6, 12, 24)),
    "ellipsoid": (
        sphere_cells,
        ellipsoid,
        ellipsoid_k,
        lambda p: (p[2] / numpy.linalg.norm(p)) ** 2,
        ellipsoid_pairing(),
        (3, 6, 12),
    ),
}


def write(path, cells, order, place):
    """The mesh in Gmsh's own format; the parameters of each vertex, by its number in the file, and the cells."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.addDiscreteEntity(2, 1)
    count = gmsh.model.mesh.getElementProperties(TYPES[order])
    local = numpy.array(count[4]).reshape(-1, 2)
    local = numpy.column_stack([1 - local.sum(1), local])
    known, tags, points, parameters = {}, [], [], []
    for cell in cells:
        for weights in local:
            p = weights @ cell
            x = place(p)
            key = tuple(round(c, 9) + 0.0 for c in x)
            if key not in known:
                known[key] = len(known) + 1
                points.extend(x)
                parameters.append(p)
            tags.append(known[key])
    gmsh.model.mesh.addNodes(2, 1, range(1, len(known) + 1), points)
    gmsh.model.mesh.addElementsByType(1, TYPES[order], [], tags)
    gmsh.write(str(path))
    gmsh.finalize()
    # Vertices are counted without the nodes that are no corners.
    corners = numpy.array(tags).reshape(len(cells), -1)[:, :3]
    number = {tag: i for i, tag in enumerate(sorted(set(corners.flat)))}
    named = numpy.array([[number[tag] for tag in cell] for cell in corners])
    return [parameters[tag - 1] for tag in sorted(set(corners.flat))], named


def control(values, order):
    """Bernstein coefficients from values at the lattice."""
    nodes = lattice(order)
    scale = [math.factorial(order) / math.prod(map(math.factorial, a)) for a in nodes]
    matrix = [[s * math.prod((x / order) ** e for x, e in zip(n, a)) for a, s in zip(nodes, scale)] for n in nodes]
    return dict(zip(nodes, numpy.linalg.solve(numpy.array(matrix), values)))


def coefficients(cells, named, order, function):
    """The coefficients of a function's interpolant, by the vertices of the simplex and the exponents on them."""
    found = {}
    for cell, vertices in zip(cells, named):
        values = [function(numpy.array(n) / order @ cell) for n in lattice(order)]
        for alpha, value in control(values, order).items():
            on = sorted((v, a) for v, a in zip(vertices.tolist(), alpha) if a)
            found[tuple(v for v, _ in on), tuple(a for _, a in on)] = value
    return found


def run(regge, mesh, out, *more):
    command = [regge, "curvature", "--mesh", mesh, "--json", out, *more]
    subprocess.run(command, check=True, capture_output=True)
    return json.loads(out.read_text())


def measure(regge, name, order, n, folder):
    make, place, exact_k, function, pairing, _ = CASES[name]
    cells, mesh, out = make(n), folder / "m.msh", folder / "m.json"
    parameters, named = write(mesh, cells, order, place)
    degree = order + 2
    rows = run(regge, mesh, out)["vertices"]
    l2 = math.sqrt(sum(r["area"] * (r["K"] - exact_k(parameters[r["vertex"]])) ** 2 for r in rows))
    report = run(regge, mesh, out, "--test-degree", str(degree))
    known = coefficients(cells, named, degree, function)
    total, seen = 0.0, {}
    for row in report["test_functions"]:
        simplex = tuple(row["simplex"])
        i = seen[simplex] = seen.get(simplex, -1) + 1
        # Those of one simplex come in descending lexicographic order of their exponents.
        inner = [a for a in itertools.product(range(degree, 0, -1), repeat=len(simplex)) if sum(a) == degree]
        total += 0.5 * row["total"] * known[simplex, inner[i]]
    return l2, abs(total - pairing), report["total_curvature"] / 2, len(cells)


def main():
    regge = sys.argv[1] if len(sys.argv) > 1 else "target/release/regge"
    with tempfile.TemporaryDirectory() as folder:
        for name, order in itertools.product(CASES, TYPES):
            last = None
            for n in CASES[name][5]:
                l2, pair, total, cells = measure(regge, name, order, n, pathlib.Path(folder))
                rates = [math.log2(a / b) for a, b in zip(last, (l2, pair))] if last else [math.nan] * 2
                print(
                    f"| {name} | {order} | {cells} | {l2:.2e} | {rates[0]:.2f} | {pair:.2e} | {rates[1]:.2f} | {total:.10f} |",
                    flush=True,
                )
                last = (l2, pair)


if __name__ == "__main__":
    main()
