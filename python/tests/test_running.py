"""How it runs: threads, signals, progress, forks, memory, time."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import regge


@pytest.fixture(scope="module")
def large():
    """Some seconds of work at order 40."""
    mesh = regge.Mesh.cube(3, 16)
    return regge.interpolate(mesh, regge.formula("trig"), 1)


@pytest.fixture
def hears_ctrl_c():
    """Python's own handler of SIGINT: what is started in the background of a shell inherits that it is ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("hears_ctrl_c")
def test_ctrl_c_stops_a_long_run(large):
    """The handler of SIGINT raises KeyboardInterrupt in the thread that waits."""
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    start = time.perf_counter()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            regge.curvature(large, order=40)
    assert time.perf_counter() - start < 2.0
    # And nothing is left behind that would disturb the next call.
    assert np.isfinite(regge.curvature(large, order=2).total).all()


def test_the_lock_is_released(large):
    """Another thread of Python runs while we compute."""
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.perf_counter()
    regge.curvature(large, order=8)
    end = time.perf_counter()
    stop.set()
    thread.join()
    inside = [t for t in ticks if start < t < end]
    assert len(inside) > 0.05 * (end - start) / 0.001


def test_progress_is_told(large, capsys):
    seen = []
    regge.curvature(large, order=12, progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1.0 and 0 <= seen[0] <= 1
    assert len(seen) > 1

    def refuse(fraction):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        regge.curvature(large, order=12, progress=refuse)
    regge.curvature(large, order=2, progress=True)
    assert "curvature" in capsys.readouterr().err


def test_results_do_not_depend_on_threads(sphere):
    g = regge.interpolate(regge.Mesh.cube(2, 20), sphere, 2)
    before, threads = regge.curvature(g).total, regge.num_threads()
    try:
        for number in (1, 3):
            regge.set_num_threads(number)
            assert regge.num_threads() == number
            np.testing.assert_array_equal(regge.curvature(g).total, before)
    finally:
        regge.set_num_threads(threads)


def _child(queue, coefficients):
    g = regge.ReggeSpace(regge.Mesh.cube(2, 4), 0).function(coefficients)
    queue.put(regge.curvature(g).total)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_computes(sphere):
    """The threads of the parent are not there."""
    g = regge.interpolate(regge.Mesh.cube(2, 4), sphere)
    known = regge.curvature(g).total
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    process = context.Process(target=_child, args=(queue, g.coefficients))
    process.start()
    np.testing.assert_array_equal(queue.get(timeout=20), known)
    process.join(timeout=20)
    assert process.exitcode == 0


def test_no_second_copy_of_the_coefficients():
    """Measured as the growth of the process while the curvature is computed: four times less than a copy would be."""
    pytest.importorskip("resource")
    code = """
import numpy as np, regge, resource
mesh = regge.Mesh.cube(2, 100)
g = regge.interpolate(mesh, regge.formula("trig"), 6)
regge.curvature(g, order=2)
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
for _ in range(3):
    regge.curvature(g, order=2)
print(g.coefficients.nbytes / 1024, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    coefficients, growth = map(float, output.split())
    assert coefficients > 8000
    assert growth < 0.25 * coefficients


def test_python_adds_little_to_a_large_mesh(sphere):
    """10⁵ triangles. The work runs in other threads, so that this thread's time is all that the door costs."""
    mesh = regge.Mesh.cube(2, 224)
    assert len(mesh.cells) > 10**5
    g = regge.interpolate(mesh, sphere, 1)
    whole, ours = time.process_time(), time.thread_time()
    total = regge.curvature(g, order=8).total
    whole, ours = time.process_time() - whole, time.thread_time() - ours
    assert len(total) == mesh.count(0)
    assert 0 < ours < 0.05 * whole
