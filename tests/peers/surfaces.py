"""Angle defects of surfaces that others made, beside those of libigl and trimesh.

    pip install libigl trimesh gmsh && pip install --no-deps pyvista nilearn
    python tests/peers/surfaces.py target/release/regge

The surfaces are files that these packages ship; none of them is part of this repository:

- gmsh (examples/, GPL 2 or later with the package): STL
- pyvista (examples/, MIT): PLY
- nilearn (datasets/data/fsaverage5, BSD 3-clause; the surfaces are FreeSurfer's fsaverage): the cortex, GIFTI

Each is read by `regge` itself where it knows the format (GIFTI is written as OBJ with all digits), and the points and triangles
that it read go to the peers by way of the PLY file that it writes. Printed are the largest differences of ∫K at a vertex, and
what is left of the total. The program fails if one is larger than its bound.
"""

import base64
import csv
import math
import pathlib
import site
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zlib

import gzip
import igl
import numpy
import trimesh

# libigl and trimesh take the arc cosine of a cosine. Near 0 and π it has a derivative of 1/sin θ: an angle of 1e-3 or π − 1e-3 is
# off by 1e-13 where the cosine is by one unit in the last place. The reference below has no such cancellation; what the peers
# differ from it is theirs. Ours knows squared edge lengths, whose rounding changes the area of a triangle with an angle of s by a part
# of eps/s^2, and its other angles with it: where that is more than the bound, it is the bound, and the surface is none of the five.
BOUND = 1e-12
TOTAL = 1e-10


def packages(*parts):
    """Files below the places where Python's packages are."""
    for root in [sys.prefix, *site.getsitepackages()]:
        yield from sorted(pathlib.Path(root).glob("/".join(parts)))


def gifti(path):
    """Points and triangles of a GIFTI file."""
    arrays = []
    text = gzip.open(path).read()
    for array in xml.etree.ElementTree.fromstring(text).iter("DataArray"):
        kind = {"NIFTI_TYPE_FLOAT32": "f4", "NIFTI_TYPE_INT32": "i4"}[array.get("DataType")]
        order = "<" if array.get("Endian") == "LittleEndian" else ">"
        data = zlib.decompress(base64.b64decode(array.find("Data").text))
        arrays.append(numpy.frombuffer(data, order + kind).reshape(-1, 3))
    return arrays


def obj(path, points, triangles):
    with open(path, "w") as out:
        out.writelines(f"v {float(x)!r} {float(y)!r} {float(z)!r}\n" for x, y, z in points)
        out.writelines(f"f {a} {b} {c}\n" for a, b, c in triangles + 1)


def surfaces(folder):
    """Names and files."""
    for path in packages("share/doc/gmsh/**/*.stl"):
        yield f"gmsh {path.name}", path
    for path in packages("pyvista/examples/*.ply"):
        yield f"pyvista {path.name}", path
    for name in ["pial_left", "pial_right", "white_left", "infl_left"]:
        for path in packages(f"nilearn/datasets/data/fsaverage5/{name}.gii.gz"):
            target = folder / f"{name}.obj"
            obj(target, *gifti(path))
            yield f"nilearn {name}", target


def read_ply(path):
    """Points and triangles of what `regge --ply` writes."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    count = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element")}
    width = sum(line.startswith("property double") for line in lines)
    numbers = numpy.frombuffer(body, "<f8", count["vertex"] * width).reshape(-1, width)
    faces = numpy.frombuffer(body, [("n", "u1"), ("v", "<i4", 3)], count["face"], numbers.nbytes)
    return numbers[:, :3].copy(), faces["v"].astype(numpy.int64)


def defects(points, triangles):
    """2π − Σθ by atan2 of cross and dot products."""
    sums = numpy.full(len(points), 2 * math.pi)
    for i in range(3):
        a, b, c = (points[triangles[:, (i + j) % 3]] for j in range(3))
        cross = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
        numpy.subtract.at(sums, triangles[:, i], numpy.arctan2(cross, ((b - a) * (c - a)).sum(1)))
    return sums


def ours(regge, path, folder):
    """∫K at the vertices, points, triangles; None with the reason where the surface is refused."""
    table, ply = folder / "out.csv", folder / "out.ply"
    command = [regge, "curvature", "--mesh", path, "--csv", table, "--ply", ply]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip()
    rows = list(csv.DictReader(table.open()))
    points, triangles = read_ply(ply)
    return (numpy.array([float(row["K_integral"]) for row in rows]), points, triangles), done.stdout


def compare(name, regge, path, folder):
    """A line of the table; is it within the bounds, and within those of any surface?"""
    result, said = ours(regge, path, folder)
    if result is None:
        print(f"{name:26} refused: {said}")
        return None
    k, points, triangles = result
    if len(k) != len(points):
        print(f"{name:26} has a boundary")
        return None
    shape = trimesh.Trimesh(points, triangles, process=False)
    theirs = {
        "atan2": defects(points, triangles),
        "libigl": igl.gaussian_curvature(points, triangles),
        "trimesh": shape.vertex_defects,
    }
    # The smallest angle to 0 or π says what an arc cosine can know.
    angles = shape.face_angles
    sharpest = min(angles.min(), math.pi - angles.max())
    apart = {peer: abs(k - values).max() for peer, values in theirs.items()}
    left = abs(k.sum() - 2 * math.pi * shape.euler_number) * 2
    eps = numpy.finfo(float).eps
    known = max(BOUND, eps / sharpest**2)
    bound = max(known, 8 * eps / sharpest)
    row = "  ".join(f"{peer} {value:7.1e}" for peer, value in apart.items())
    print(f"{name:26} {len(triangles):7} triangles  chi {shape.euler_number:3}  {row}  total {left:7.1e}  sharpest {sharpest:.1e}")
    within = apart["atan2"] <= known and max(apart.values()) <= bound and left <= TOTAL
    return within, within and max(apart.values()) <= BOUND


def main():
    regge = sys.argv[1] if len(sys.argv) > 1 else "target/release/regge"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        results = [compare(name, regge, path, folder) for name, path in surfaces(folder)]
    closed = [result for result in results if result is not None]
    within, best = (sum(column) for column in zip(*closed))
    print(f"{len(closed)} closed surfaces, {best} equal to {BOUND:.0e}, {within} within what their triangles allow")
    sys.exit(0 if best >= 5 and within == len(closed) else 1)


if __name__ == "__main__":
    main()
