#!/usr/bin/env python3
"""The H⁻² norm on meshes by Gmsh of growing size: steps, seconds, memory, a line for each mesh and degree.

    python3 benches/peer/series.py [--venv DIR] [--meshes DIR] [--shapes ball,…] [--degrees 0,1,2] [--sizes 0,1,2]

Runs `regge` of target/release (`cargo build --release`) beside nothing else, with quadrature of order 2r + 4. Meshes are
made with `gmsh`, which --venv has, and kept. The largest have a million tetrahedra (at r = 2 a third of that) or
triangles and are asked for by --sizes 2; all of it takes two hours on two cores.
"""

import argparse
import os
import sys
from pathlib import Path

from compare import ROOT, entry, run

# Gmsh's largest edge: three for r = 0 and 1, and for r = 2. `graded` is thirty times as fine in one corner.
SIZES = {
    "ball": ((0.106, 0.053, 0.0265), (0.106, 0.079, 0.0395)),
    "fichera": ((0.128, 0.064, 0.032), (0.128, 0.096, 0.048)),
    "holes": ((0.1265, 0.0632, 0.0316), (0.1265, 0.095, 0.048)),
    "torus": ((0.0964, 0.0482, 0.0241), (0.0964, 0.0724, 0.0362)),
    "graded": ((0.5, 0.25, 0.125), (0.5, 0.25, 0.125)),
    "lshape": ((0.0212, 0.0075, 0.00265), (0.0212, 0.0075, 0.00265)),
    "disc": ((0.0206, 0.00727, 0.00257), (0.0206, 0.00727, 0.00257)),
}
GRAPHS = {
    2: 'dimension = 2\ngraph = "(x^2 + y^2)/2 - (x^4 + y^4)/12"\n',
    3: 'dimension = 3\ngraph = "(x^2 + y^2 + z^2)/2 - (x^4 + y^4 + z^4)/12"\n',
}


def mesh_of(python, directory, shape, size):
    """The mesh of a shape, made if it is not there yet."""
    file = directory / f"{shape}-{size}.msh"
    if not file.exists():
        run([python, ROOT / "benches" / "peer" / "solids.py", shape, size, file])
    return file


def row(regge, directory, mesh, shape, degree):
    """Runs the command on a mesh and prints what it took."""
    metric = directory / f"graph{2 if shape in ('lshape', 'disc') else 3}.toml"
    report = directory / "report.json"
    arguments = ["--mesh", mesh, "--metric", metric, "--degree", degree, "--quadrature", 2 * degree + 4]
    before = os.times()
    _, seconds, memory = run([regge, "curvature", *arguments, "--norm", "hm2", "--json", report])
    after = os.times()
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    norm, cells = entry(report, "hm2"), entry(report, "cell_count")
    print(f"| {mesh.stem} | {cells} | {degree} | {norm['unknowns']} | ", end="")
    print(f"{norm['steps'] or norm['solver']} | {seconds:.1f} | {cpu:.1f} | {memory / 1e6:.0f} | ", end="")
    print(f"{memory / norm['unknowns']:.0f} | {norm['error']:.6e} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--venv", type=Path, default=ROOT / "target" / "peer")
    parser.add_argument("--meshes", type=Path, default=ROOT / "target" / "meshes")
    parser.add_argument("--shapes", default=",".join(SIZES))
    parser.add_argument("--degrees", default="0,1,2", help="of the metric")
    parser.add_argument("--sizes", default="0,1", help="which of three")
    arguments = parser.parse_args()
    shapes = arguments.shapes.split(",")
    if unknown := [shape for shape in shapes if shape not in SIZES]:
        parser.error(f"no such shape: {', '.join(unknown)}")
    python, regge = arguments.venv / "bin" / "python", ROOT / "target" / "release" / "regge"
    for program in (python, regge):
        if not program.exists():
            sys.exit(f"{program} is not there")
    arguments.meshes.mkdir(parents=True, exist_ok=True)
    for dimension, graph in GRAPHS.items():
        (arguments.meshes / f"graph{dimension}.toml").write_text(graph)
    print("| mesh | cells | r | unknowns | steps | wall, s | CPU s | peak, MB | bytes an unknown | norm |")
    print("|---|---|---|---|---|---|---|---|---|---|", flush=True)
    for which in map(int, arguments.sizes.split(",")):
        for shape in shapes:
            for degree in map(int, arguments.degrees.split(",")):
                size = SIZES[shape][degree // 2][which]
                mesh = mesh_of(python, arguments.meshes, shape, size)
                row(regge, arguments.meshes, mesh, shape, degree)


if __name__ == "__main__":
    main()
