"""What `regge action --certified` proves, beside the same numbers by Arb's ball arithmetic (python-flint), at 200 bits.

    pip install python-flint
    python tests/peers/enclosures.py target/release/regge

Angle defects, sizes of hinges, the action and its gradient, from edge lengths alone: of the boundaries of simplices with random
lengths (N = 2 … 5), of the 16-cell, of the reference meshes of degree 0 in verify/oracle/cases and of needles. Lengths have 24
bits, so that their squares are exact. Every enclosure must contain Arb's ball, and must not when it is moved by 1e-9 (on needles,
whose enclosures may be wider, by twice their width); printed are the widths, relative to the numbers. The program fails if one
does not.
"""

import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile

from flint import arb, arb_mat, ctx

ctx.prec = 200
SHIFT = 1e-9


def short(x):
    """x to 24 bits."""
    mantissa, exponent = float(x).hex().split("p")
    return float.fromhex(mantissa[: mantissa.index(".") + 7] + "p" + exponent)


def edges_of(cells):
    return sorted({tuple(sorted(pair)) for cell in cells for pair in itertools.combinations(cell, 2)})


def gram(vertices, square):
    """g_ij of the simplex with these vertices, the first being the origin."""
    o, rest = vertices[0], vertices[1:]
    half = arb(1) / 2
    entry = lambda i, j: half * (square(o, i) + square(o, j) - (arb(0) if i == j else square(i, j)))
    return arb_mat([[entry(i, j) for j in rest] for i in rest])


def gradients(inverse):
    """⟨dλ_a, dλ_b⟩ for all vertices."""
    n = inverse.nrows()
    inner = [[inverse[i, j] for j in range(n)] for i in range(n)]
    first = [-sum(row[1:], row[0]) for row in inner]
    corner = -sum(first[1:], first[0])
    return [[corner, *first], *([first[i], *inner[i]] for i in range(n))]


def factorial(n):
    return 1 if n < 2 else n * factorial(n - 1)


def regge(cells, lengths):
    """Defects and sizes by hinge, the action, and its gradient by edge, all edges of the boundary included."""
    n = len(cells[0]) - 1
    square = lambda a, b: arb(lengths[tuple(sorted((a, b)))]) ** 2
    angles, faces = {}, {}
    for cell in map(sorted, cells):
        inner = gradients(gram(cell, square).inv())
        for a, b in itertools.combinations(range(n + 1), 2):
            hinge = tuple(v for k, v in enumerate(cell) if k not in (a, b))
            cos = -inner[a][b] / (inner[a][a] * inner[b][b]).sqrt()
            angles.setdefault(hinge, []).append(cos.acos())
        for face in itertools.combinations(cell, n):
            faces[face] = faces.get(face, 0) + 1
    outside = {h for face, count in faces.items() if count == 1 for h in itertools.combinations(face, n - 1)}
    defects = {h: (1 if h in outside else 2) * arb.pi() - sum(all[1:], all[0]) for h, all in angles.items()}
    sizes, gradient = {}, dict.fromkeys(lengths, arb(0))
    for h in angles:
        if n == 2:
            sizes[h] = arb(1)
            continue
        g = gram(h, square)
        sizes[h] = g.det().sqrt() / factorial(n - 2)
        inverse = g.inv()
        for e in itertools.combinations(h, 2):
            only = lambda a, b: arb(1 if tuple(sorted((a, b))) == e else 0)
            rate = (inverse * gram(h, only)).trace() / 2 * sizes[h]
            # From squared lengths to lengths.
            gradient[e] += defects[h] * rate * 2 * arb(lengths[e])
    terms = [defects[h] * sizes[h] for h in angles]
    return defects, sizes, sum(terms[1:], terms[0]), gradient


def certified(program, folder, cells, lengths):
    mesh, table, out = (folder / name for name in ("m.json", "l.csv", "out.json"))
    mesh.write_text(json.dumps({"dimension": len(cells[0]) - 1, "cells": cells}))
    rows = [f"{a},{b},{length!r}" for (a, b), length in lengths.items()]
    table.write_text("\n".join(["i,j,length", *rows]) + "\n")
    command = [program, "action", "--mesh", mesh, "--lengths", table, "--certified", "--json", out]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return json.loads(out.read_text())["enclosures"]


def encloses(bounds, ball):
    low, high = (arb(x) for x in bounds)
    return low <= ball and ball <= high


class Count:
    """How many enclosures there were, and the widest, relative to a number of size 1e-3 at least."""

    def __init__(self):
        self.all = self.wrong = 0
        self.widest = 0.0

    def add(self, bounds, ball):
        self.all += 1
        shift = max(SHIFT, 2 * (bounds[1] - bounds[0]))
        right = encloses(bounds, ball) and not encloses(bounds, ball + shift) and not encloses(bounds, ball - shift)
        self.wrong += not right
        size = max(abs(float(ball.mid())), 1e-3)
        self.widest = max(self.widest, (bounds[1] - bounds[0]) / size)


def compare(name, program, folder, cells, lengths):
    found = certified(program, folder, cells, lengths)
    defects, sizes, action, gradient = regge(cells, lengths)
    counts = {what: Count() for what in ("defects", "sizes", "action", "gradient")}
    for hinge in found["hinges"]:
        vertices = tuple(hinge["vertices"])
        counts["defects"].add(hinge["defect"], defects[vertices])
        counts["sizes"].add(hinge["size"], sizes[vertices])
    counts["action"].add(found["action"], action)
    for edge in found["gradient"]:
        counts["gradient"].add(edge["derivative"], gradient[tuple(edge["vertices"])])
    row = "  ".join(f"{what} {c.all - c.wrong}/{c.all} to {c.widest:.1e}" for what, c in counts.items())
    print(f"{name:28} {row}")
    return not any(c.wrong for c in counts.values())


def simplex_boundary(n):
    return [list(cell) for cell in itertools.combinations(range(n + 2), n + 1)]


def cases():
    random.seed(1)
    for n in (2, 3, 4, 5):
        cells = simplex_boundary(n)
        yield f"boundary of a simplex, N = {n}", cells, {e: short(1 + 0.1 * random.random()) for e in edges_of(cells)}
    opposite = lambda v: v ^ 1
    sixteen = [list(c) for c in itertools.combinations(range(8), 4) if not any(opposite(v) in c for v in c)]
    yield "16-cell", sixteen, dict.fromkeys(edges_of(sixteen), 1.0)
    disc = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 3, 4]]
    yield "needles", disc, {e: 1.0 if 4 in e else 2.0**-20 for e in edges_of(disc)}
    folder = pathlib.Path(__file__).parents[2] / "verify/oracle/cases"
    for path in sorted(folder.glob("*-r0.json")):
        case = json.loads(path.read_text())
        points, lengths = case["vertices"], {}
        for cell, sample in zip(case["simplices"], case["samples"]):
            n, g = len(cell) - 1, sample["g"][0]
            for a, b in itertools.combinations(sorted(cell), 2):
                t = [y - x for x, y in zip(points[a], points[b])]
                lengths[a, b] = short(sum(g[n * i + j] * t[i] * t[j] for i in range(n) for j in range(n)) ** 0.5)
        yield path.stem, case["simplices"], lengths


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "target/release/regge"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        right = [compare(what, program, folder, cells, lengths) for what, cells, lengths in cases()]
    print(f"{sum(right)} of {len(right)} meshes: every enclosure contains Arb's ball")
    sys.exit(0 if all(right) else 1)


if __name__ == "__main__":
    main()
