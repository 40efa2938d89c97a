"""Gmsh's own demos: each is meshed by Gmsh and given to `regge curvature`, which must take it or say what is true.

    pip install gmsh
    python tests/peers/demos.py target/release/regge

The demos are the .geo files that the package gmsh ships (share/doc/gmsh: examples/simple_geo, examples/boolean, examples/api and
the tutorials; GPL, not part of this repository). Each is meshed in its own process, as 4.1, 2.2 and by bytes, for at most five
minutes. Printed are what became of each and how many of each kind there are. It fails if the program neither succeeds nor refuses
in one line with code 2 or 1, or refuses a mesh of triangles and tetrahedra alone for a reason that is not true of what Gmsh itself
reads from the file.
"""

import collections
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import gmsh

FOLDERS = ("examples/simple_geo", "examples/boolean", "examples/api", "tutorials")
WAYS = {"4.1": ("msh41", "0"), "2.2": ("msh22", "0"), "4.1 bytes": ("msh41", "1"), "2.2 bytes": ("msh22", "1")}
# Gmsh's numbers of points, lines, triangles and tetrahedra of order 1 to 4.
SIMPLICES = {15, 1, 8, 26, 27, 2, 9, 21, 23, 4, 11, 29, 30}
def demos():
    home = pathlib.Path(gmsh.__file__).resolve()
    root = next(p / "share/doc/gmsh" for p in home.parents if (p / "share/doc/gmsh").is_dir())
    return [path for folder in FOLDERS for path in sorted((root / folder).glob("*.geo"))]


def mesh(demo, folder, way):
    """The file that Gmsh writes, or None."""
    out = folder / "m.msh"
    out.unlink(missing_ok=True)
    form, binary = WAYS[way]
    program = str(pathlib.Path(sys.executable).with_name("gmsh"))
    command = [sys.executable, program, str(demo), "-3", "-format", form, "-nt", "1", "-v", "1", "-o", str(out)]
    command += ["-setnumber", "Mesh.Binary", binary]
    try:
        subprocess.run(command, cwd=folder, capture_output=True, timeout=300, env={**os.environ, "DISPLAY": ""})
    except subprocess.TimeoutExpired:
        return None
    return out if out.exists() and out.stat().st_size else None


def truth(path):
    """What is true of a mesh by Gmsh's own reader, in a process of its own: are there only simplices, and what is wrong with them."""
    out = subprocess.run([sys.executable, __file__, "--truth", str(path)], capture_output=True, text=True, check=True)
    return set(out.stdout.split("\n")) - {""}


def say_truth(path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(path)
    types = {int(kind) for kind in gmsh.model.mesh.getElementTypes()}
    if types <= SIMPLICES:
        print("simplices")
    cells = {2: set(), 3: set()}
    for kind in types & SIMPLICES:
        _, dimension, _, count, _, corners = gmsh.model.mesh.getElementProperties(kind)
        if dimension > 1:
            nodes = gmsh.model.mesh.getElementsByType(kind)[1].reshape(-1, count)[:, :corners]
            new = {tuple(sorted(cell)) for cell in nodes.tolist()}
            cells[dimension] |= new
            if len(new) < len(nodes):
                print("an element that is there already")
    top = max((d for d in cells if cells[d]), default=0)
    if top == 0:
        print("there is no triangle and no tetrahedron")
        return
    sides = collections.Counter(side for cell in cells[top] for side in itertools.combinations(cell, top))
    if top == 3 and cells[2] - set(sides):
        print("mixed dimension")
    if max(sides.values()) > 2:
        print("cells share this face")
    used = {node for cell in cells[top] for node in cell}
    if len({tuple(gmsh.model.mesh.getNode(node)[0]) for node in used}) < len(used):
        print("merge the duplicated nodes")


def main():
    regge = str(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "target/release/regge").resolve())
    ways = sys.argv[2:] or list(WAYS)
    counts, wrong = collections.Counter(), []
    all_demos = demos()
    for demo in all_demos:
        for way in ways:
            with tempfile.TemporaryDirectory() as folder:
                path = mesh(demo, pathlib.Path(folder), way)
                if path is None:
                    what, said = "Gmsh writes no mesh", ""
                else:
                    true = truth(path)
                    run = subprocess.run([regge, "curvature", "--mesh", path], capture_output=True, text=True)
                    refused = [line for line in run.stderr.splitlines() if not line.startswith("note: ")]
                    said = re.sub(r"\S*/m\.msh", "m.msh", " | ".join(refused))
                    only = "simplices" in true
                    what = ("taken" if run.returncode == 0 else "refused") + (", simplices" if only else ", other cells too")
                    if run.returncode not in (0, 1, 2) or (run.returncode and len(refused) != 1):
                        wrong.append((demo.name, way, said))
                    elif run.returncode and only and not any(reason in said for reason in true):
                        wrong.append((demo.name, way, said))
            counts[what] += 1
            print(f"{demo.parent.name}/{demo.name}  {way}: {what}  {said}", flush=True)
    print(len(all_demos), "demos;", *(f"{what}: {count};" for what, count in sorted(counts.items())))
    for line in wrong:
        print("WRONG", *line)
    sys.exit(bool(wrong))


if __name__ == "__main__":
    say_truth(sys.argv[2]) if sys.argv[1:2] == ["--truth"] else main()
