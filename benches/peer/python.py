#!/usr/bin/env python3
"""What the door to Python costs: `regge.curvature` beside the same call in Rust, on 131 072 triangles.

    cargo build --release -p regge-benches --bin ours
    pip install ./python
    python benches/peer/python.py [--degree 1] [--pairs 20] [--callgrind]

Both are to be built for the same processor. Each side runs in one thread, in a process of its own that calls it a few times or many
times: the difference is what the calls take. Processor time varies with what else the machine does, so that pairs are measured one
after the other and the median of their ratios counts. `--callgrind` counts instructions instead, in one pair, which does not vary
(valgrind knows no AVX-512: build both with RUSTFLAGS="-C target-cpu=x86-64-v3").
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEVEL = 8
# How often each side is called: often enough for a clock, and for what counts instructions.
TIMED, COUNTED = (2, 12), (1, 3)


def called(degree, times):
    """Our side, in a process of its own."""
    import regge

    mesh = regge.Mesh.cube(2, 2**LEVEL)
    g = regge.interpolate(mesh, regge.formula("graph-quartic"), degree)
    for _ in range(times):
        total = regge.curvature(g, order=2 * (degree + 2)).total
    assert len(total) == mesh.count(0)


def commands(ours, degree, times):
    rust = [ours, "functional", 2, LEVEL, degree, 1, "lanes", times]
    python = [sys.executable, __file__, "--called", times, "--degree", degree]
    return [list(map(str, command)) for command in (rust, python)]


def processor_time(command):
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, env={**os.environ, "RAYON_NUM_THREADS": "1"})
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)} failed")
    return usage.ru_utime + usage.ru_stime


def instructions(command):
    with tempfile.TemporaryDirectory() as folder:
        grind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", *command]
        env = {**os.environ, "RAYON_NUM_THREADS": "1"}
        out = subprocess.run(grind, capture_output=True, text=True, env=env)
    found = re.search(r"Collected : (\d+)", out.stderr)
    if out.returncode or not found:
        sys.exit(out.stderr)
    return int(found[1])


def pair(measure, times, ours, degree):
    """What a call takes on each side."""
    few, many = (commands(ours, degree, number) for number in times)
    return [(measure(m) - measure(f)) / (times[1] - times[0]) for f, m in zip(few, many)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ours", default=ROOT / "target" / "release" / "ours")
    parser.add_argument("--degree", type=int, default=1)
    parser.add_argument("--pairs", type=int, default=20)
    parser.add_argument("--callgrind", action="store_true")
    parser.add_argument("--called", type=int, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.called is not None:
        called(given.degree, given.called)
    elif given.callgrind:
        rust, python = pair(instructions, COUNTED, given.ours, given.degree)
        print(f"{rust:.4g} instructions a call in Rust, {python:.4g} from Python, {python / rust:.4f} times as many")
    else:
        all_pairs = [pair(processor_time, TIMED, given.ours, given.degree) for _ in range(given.pairs)]
        ratios = [python / rust for rust, python in all_pairs]
        low, middle, high = statistics.quantiles(ratios, n=4)
        rust = statistics.median(rust for rust, _ in all_pairs)
        print(f"{rust:.4f} s a call in Rust; from Python {middle:.3f} times that (quartiles {low:.3f}, {high:.3f})")


if __name__ == "__main__":
    main()
