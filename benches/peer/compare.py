#!/usr/bin/env python3
"""regge beside NGSolve and ngsdiffgeo, on the same meshes, in one run.

    python3 benches/peer/compare.py [--venv DIR] [--only functional,accuracy,table1,norm,domains] [--degrees 0,1,2] [--threads 2]
        [--shapes fichera,ball,holes,torus] [--turns 1]

Builds our programs, makes a virtual environment with `ngsolve` and `ngsdiffgeo` from PyPI (if it is not there), and
prints a table for each comparison, ours and the peer's figures measured one after the other. Leave the machine alone
meanwhile: of several --turns, one program after the other, domains take each program's fastest. Where that cannot be
had, --threads 1 compares the functional by the processor's time instead of the clock's.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("functional", "accuracy", "table1", "norm", "domains")
# Shapes with Netgen's largest edge.
DOMAINS = (("fichera", 0.12), ("fichera", 0.1), ("ball", 0.095), ("ball", 0.07), ("holes", 0.12), ("torus", 0.2))
SHAPES = tuple(dict.fromkeys(shape for shape, _ in DOMAINS))
GRAPH = 'dimension = 3\ngraph = "(x^2 + y^2 + z^2)/2 - (x^4 + y^4 + z^4)/12"\n'


def run(command):
    """The last line of its output as JSON, the seconds it took and its peak memory in bytes."""
    start = time.perf_counter()
    with tempfile.TemporaryFile("w+") as out:
        process = subprocess.Popen(list(map(str, command)), stdout=out, cwd=ROOT)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        out.seek(0)
        lines = out.read().strip().splitlines()
    if status != 0:
        sys.exit(f"{' '.join(map(str, command))} failed")
    try:
        result = json.loads(lines[-1])
    except (IndexError, json.JSONDecodeError):
        result = None
    return result, seconds, usage.ru_maxrss * 1024


def entry(report, key):
    """An entry of a report, without reading its long lists: what this process has in memory counts as the peak of what it runs."""
    with open(report) as file:
        head = file.read(1 << 16)
    begin = head.index(f'"{key}":') + len(key) + 3
    return json.JSONDecoder().raw_decode(head[begin:].lstrip())[0]


def build(command_line):
    """Our program and, if it is needed, our command line."""
    cargo = ["cargo", "build", "--release", "--quiet"]
    subprocess.run([*cargo, "-p", "regge-benches", "--bin", "ours"], cwd=ROOT, check=True)
    if command_line:
        subprocess.run([*cargo, "-p", "regge-cli"], cwd=ROOT, check=True)
    target = ROOT / "target" / "release"
    return target / "ours", target / "regge"


def peer_in(directory):
    """The command that runs the peer."""
    python = directory / "bin" / "python"
    if not python.exists():
        venv.create(directory, with_pip=True)
        subprocess.run([python, "-m", "pip", "install", "-q", "ngsolve", "ngsdiffgeo"], check=True)
    return [python, ROOT / "benches" / "peer" / "peer.py"]


def mesh_file(ours, directory, n, k, seed=3):
    """Our mesh for the peer. The command line has a seed for each level, which stands in its rows."""
    path = Path(directory) / f"mesh-{n}-{k}-{seed}.json"
    if not path.exists():
        path.write_text(json.dumps(run([ours, "mesh", n, k, seed])[0]))
    return path


def functional(ours, peer, directory, degrees):
    """The best of several runs each, and how far the two agree."""
    print("\nFunctional, N = 3, k = 3, hat functions, rules of order 2(r+2), µs a tetrahedron")
    print(" r      ours     peer    ratio   angles alone (r = 0)    ratio   largest difference of a sum, of its largest entry")
    for r in degrees:
        mesh = mesh_file(ours, directory, 3, 3)
        mine = run([ours, "functional", 3, 3, r, 1, "lanes", 20])[0]
        other = run([*peer, "functional", mesh, r, 4])[0]
        a, b, c = mine["microseconds_per_cell"], other["microseconds_per_cell"], other["spared_per_cell"]
        names = [name for name in ("element", "face", "hinge") if name in other]
        worst = max(difference(mine[name], other[name]) for name in names)
        print(f"{r:2} {a:9.2f} {b:8.1f} {b / a:8.1f} {c:22.1f} {c / a:8.1f}   {worst:.1e}")


def difference(mine, other):
    scale = max(map(abs, other)) or 1.0
    return max(abs(a - b) for a, b in zip(mine, other)) / scale


def accuracy(ours, peer, directory):
    print("\nLargest error of R of a quadratic metric, which the Regge space of degree 2 holds, N = 3")
    print(" k      ours      peer")
    for k in range(1, 5):
        mine = run([ours, "accuracy", k])[0]["error"]
        other = run([*peer, "accuracy", mesh_file(ours, directory, 3, k)])[0]["error"]
        print(f"{k:2}   {mine:.1e}   {other:.1e}")


def table1(ours, regge, peer, directory, degrees):
    """All rows, k = 0…7, each program with its own quadrature."""
    names = ",".join(map(str, degrees))
    print(f"\nTable 1 (N = 2, r = {names}, k = 0…7), seconds")
    file = Path(directory) / "table1.json"
    _, mine, _ = run([regge, "reproduce", "table1", "--degrees", names, "--json", file])
    theirs = 0.0
    for row in json.loads(file.read_text())["rows"]:
        mesh = mesh_file(ours, directory, 2, row["level"], row["seed"])
        other = run([*peer, "norm", mesh, row["degree"]])[0]
        theirs += other["functional"] + other["solve"]
    print(f"ours, the whole command {mine:.1f}; peer, functional and solve alone {theirs:.1f}; ", end="")
    print(f"ratio {theirs / mine:.1f}")


def norm(ours, regge, peer, directory, degrees):
    print("\nH⁻² error, N = 3, k = 4 (24576 tetrahedra): ours is the whole command, with mesh and interpolation")
    print(" r   seconds: ours   functional + solve: peer   ratio   GB: ours   peer   ratio   norm: ours     peer")
    for r in degrees:
        rows = Path(directory) / f"norm-{r}.json"
        order = 2 * (r + 2)
        arguments = ["--metric", "graph-quartic", "--dimension", 3, "--degree", r, "--levels", "4..=4"]
        arguments += ["--interpolant", "canonical", "--quadrature", order, "--json", rows]
        _, seconds, memory = run([regge, "converge", *arguments])
        row = json.loads(rows.read_text())["rows"][-1]
        mesh = mesh_file(ours, directory, 3, 4, row["seed"])
        other, _, peak = run([*peer, "norm", mesh, r])
        theirs = other["functional"] + other["solve"]
        print(f"{r:2} {seconds:15.1f} {other['functional']:12.1f} + {other['solve']:<10.1f}", end=" ")
        print(f"{theirs / seconds:8.1f} {memory / 1e9:10.2f} {peak / 1e9:6.2f} {peak / memory:7.1f}", end="   ")
        print(f"{row['error']:.4e} {other['norm']:.4e}")


def domains(regge, peer, directory, degrees, shapes, turns):
    """Meshes that Netgen makes, read by both."""
    print("\nH⁻² error on unstructured meshes, N = 3: ours is the whole command, with reading and interpolation")
    print(" r  domain   tetrahedra   seconds: ours   functional + solve: peer   ratio   GB: ours   peer   ratio", end="")
    print("   steps: ours   peer   norm: ours     peer")
    metric = Path(directory) / "graph.toml"
    metric.write_text(GRAPH)
    maker = peer[0], ROOT / "benches" / "peer" / "domains.py"
    for shape, size in (domain for domain in DOMAINS if domain[0] in shapes):
        mesh = Path(directory) / f"{shape}-{size}.json"
        cells = run([*maker, shape, size, mesh])[0]["cells"]
        for r in degrees:
            report = Path(directory) / "report.json"
            arguments = ["--mesh", mesh, "--metric", metric, "--degree", r, "--quadrature", 2 * (r + 2)]
            mine, others = [], []
            for _ in range(turns):
                mine.append(run([regge, "curvature", *arguments, "--norm", "hm2", "--json", report]))
                others.append(run([*peer, "norm", mesh, r]))
            ours = entry(report, "hm2")
            _, seconds, memory = min(mine, key=lambda turn: turn[1])
            other, _, peak = min(others, key=lambda turn: turn[0]["functional"] + turn[0]["solve"])
            theirs = other["functional"] + other["solve"]
            print(f"{r:2}  {shape:8} {cells:10} {seconds:15.1f}", end="")
            print(f"{other['functional']:13.1f} + {other['solve']:<10.1f}", end="")
            print(f"{theirs / seconds:8.1f} {memory / 1e9:10.2f} {peak / 1e9:6.2f} {peak / memory:7.1f}", end="")
            print(f"{ours['steps'] or ours['solver']:>14} {other['steps']:6}", end="   ")
            print(f"{ours['error']:.6e} {other['norm']:.6e}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--venv", type=Path, default=ROOT / "target" / "peer")
    parser.add_argument("--only", default=",".join(PARTS), help="a list of " + ", ".join(PARTS))
    parser.add_argument("--degrees", default="0,1,2", help="of the metric")
    parser.add_argument("--threads", type=int, default=2, help="of both programs")
    parser.add_argument("--shapes", default=",".join(SHAPES), help="of domains")
    parser.add_argument("--turns", type=int, default=1, help="of both programs on domains")
    arguments = parser.parse_args()
    os.environ["RAYON_NUM_THREADS"] = os.environ["PEER_THREADS"] = str(arguments.threads)
    degrees = [int(r) for r in arguments.degrees.split(",")]
    chosen = arguments.only.split(",")
    if unknown := [part for part in chosen if part not in PARTS]:
        parser.error(f"no such part: {', '.join(unknown)}")
    shapes = arguments.shapes.split(",")
    if unknown := [shape for shape in shapes if shape not in SHAPES]:
        parser.error(f"no such shape: {', '.join(unknown)}")
    ours, regge = build({"table1", "norm", "domains"} & set(chosen))
    peer = peer_in(arguments.venv)
    with tempfile.TemporaryDirectory() as directory:
        if "functional" in chosen:
            functional(ours, peer, directory, degrees)
        if "accuracy" in chosen:
            accuracy(ours, peer, directory)
        if "table1" in chosen:
            table1(ours, regge, peer, directory, degrees)
        if "norm" in chosen:
            norm(ours, regge, peer, directory, degrees)
        if "domains" in chosen:
            domains(regge, peer, directory, degrees, shapes, arguments.turns)


if __name__ == "__main__":
    main()
