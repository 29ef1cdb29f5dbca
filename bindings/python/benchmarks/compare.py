#!/usr/bin/env python3
"""Compares Python with C++ and with SciPy, in the same run, and measures what drop-ins take.

Usage: compare.py [--quick] [--csv PREFIX] --program MEASURE [MESH ...]

MEASURE is the program `measure` of this folder; `scripts/run_benchmarks python` makes it, and runs
this. All but the matrix by all cores use one thread. Contestants take turns; the shortest times
count.
"""

import argparse
import csv
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import scipy.sparse
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import ConvexHull

import approximate_geodesics as ag

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
from _sample_meshes import sample_mesh  # noqa: E402

GDIST_MICROSECONDS = 11  # a distance within 100 mm on 8,192 vertices, by gdist's documentation


class Effort:
    """How much is measured."""

    def __init__(self, is_quick):
        self.rounds, self.repetitions = (1, 1) if is_quick else (5, 3)
        self.searches, self.rows, self.scipy_rows = (3, 3, 2) if is_quick else (100, 300, 20)
        self.sphere, self.radii = (512, [0.4]) if is_quick else (8192, [0.2, 0.4])

    def shortest_time(self, run, repetitions=None):
        times = []
        for _ in range(repetitions or self.repetitions):
            start = time.perf_counter()
            run()
            times.append(time.perf_counter() - start)
        return min(times)

    def shortest_times(self, *runs):
        """Those of several, which take turns."""
        rounds = [[self.shortest_time(run) for run in runs] for _ in range(self.rounds)]
        return np.min(rounds, axis=0)


class Tables:
    """Are printed, and written to files if a prefix of their names is given."""

    def __init__(self, prefix):
        self.prefix = prefix

    def print(self, name, title, rows):
        print(f"\n{title}\n")
        widths = [max(map(len, column)) for column in zip(*rows)]
        for first, *others in rows:
            print(first.ljust(widths[0]), *(t.rjust(w) for t, w in zip(others, widths[1:])), sep="  ")
        if self.prefix is not None:
            with open(f"{self.prefix}python_{name}.csv", "w", newline="") as file:
                csv.writer(file).writerows(rows)


def some_vertices(solver, number):
    return np.arange(number) * solver.number_of_vertices // number


def in_python(solver, effort):
    def search(number):
        for v in some_vertices(solver, number).tolist():
            solver.distances(v)

    rows = some_vertices(solver, effort.rows)
    yield effort.shortest_time(lambda: search(1), effort.searches)
    yield effort.shortest_time(lambda: search(effort.searches))
    yield effort.shortest_time(lambda: solver.distance_matrix(rows, threads=1))


def in_cpp(program, mesh, effort):
    numbers = (effort.searches, effort.rows, effort.repetitions)
    arguments = [program, mesh, "0.1", *map(str, numbers)]
    output = subprocess.run(arguments, check=True, capture_output=True, text=True).stdout
    return map(float, output.split())


def compare_with_cpp(program, meshes, effort):
    yield ["mesh", "what", "Python ms", "C++ ms", "Python : C++"]
    for mesh in meshes:
        solver = ag.Solver.from_file(mesh, 0.1, threads=1)
        rounds = [
            (list(in_python(solver, effort)), list(in_cpp(program, mesh, effort)))
            for _ in range(effort.rounds)
        ]
        names = ("one search", f"{effort.searches} searches", f"{effort.rows} rows")
        for name, ours, theirs in zip(names, *np.min(np.array(rounds), axis=0)):
            yield [pathlib.Path(mesh).stem, name, f"{1000 * ours:.2f}", f"{1000 * theirs:.2f}",
                   f"{ours / theirs:.3f}"]


def edges(solver):
    """The matrix of the lengths of edges, as SciPy wants it."""
    vertices, faces = solver.vertices, solver.faces
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    ends = np.unique(np.sort(ends, axis=1), axis=0)
    lengths = np.linalg.norm(vertices[ends[:, 0]] - vertices[ends[:, 1]], axis=1)
    n = len(vertices)
    return scipy.sparse.csr_matrix((lengths, (ends[:, 0], ends[:, 1])), shape=(n, n))


def compare_with_scipy(meshes, effort):
    yield ["mesh", "distances", "SciPy ms", "ours ms", "SciPy : ours"]
    for mesh in meshes:
        along_edges = ag.Solver.from_file(mesh, threads=1)
        bounded = ag.Solver.from_file(mesh, 0.1, threads=1)
        graph = edges(along_edges)
        sources = some_vertices(along_edges, effort.scipy_rows)
        assert np.allclose(
            along_edges.distance_matrix(sources), dijkstra(graph, False, sources), rtol=1e-12
        )
        theirs, *ours = effort.shortest_times(
            lambda: dijkstra(graph, directed=False, indices=sources),
            lambda: along_edges.distance_matrix(sources),
            lambda: bounded.distance_matrix(sources),
        )
        for name, seconds in zip(("the same, along edges", "within 10 %"), ours):
            yield [pathlib.Path(mesh).stem, name, f"{1000 * theirs:.1f}", f"{1000 * seconds:.1f}",
                   f"{theirs / seconds:.1f}"]


def sphere(size):
    """Points of the unit sphere that are spread evenly, and their convex hull."""
    i = np.arange(size) + 0.5
    z, angle = 1 - 2 * i / size, i * np.pi * (3 - 5**0.5)
    r = np.sqrt(1 - z**2)
    vertices = np.stack([r * np.cos(angle), r * np.sin(angle), z], axis=1)
    faces = ConvexHull(vertices).simplices
    inward = np.linalg.det(vertices[faces]) < 0
    faces[inward] = faces[inward][:, ::-1]
    return vertices, faces


def local_matrices(effort):
    yield ["radius", "epsilon", "distances", "us/distance", "gdist : this", "mean error %",
           "largest %"]
    vertices, faces = sphere(effort.sphere)
    for radius in effort.radii:
        exact = ag.local_gdist_matrix(vertices, faces, radius, epsilon=0)
        for epsilon in (0.1, 0.05, 0):
            seconds = effort.shortest_time(
                lambda: ag.local_gdist_matrix(vertices, faces, radius, epsilon=epsilon, threads=1),
                1 if epsilon == 0 else None,
            )
            matrix = ag.local_gdist_matrix(vertices, faces, radius, epsilon=epsilon)
            common = matrix.multiply(exact > 0).tocsc()  # some are just within the radius
            errors = common.data / exact.multiply(matrix > 0).tocsc().data - 1
            each = 1e6 * seconds / matrix.nnz
            yield [f"{radius:g}", f"{epsilon:g}", str(matrix.nnz), f"{each:.3f}",
                   f"{GDIST_MICROSECONDS / each:.0f}", f"{100 * errors.mean():.4f}",
                   f"{100 * errors.max():.2f}"]


def seconds_until_interrupted(run, seconds):
    """How long `run` goes on after a signal, which stands for Ctrl-C."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    start = time.perf_counter()
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        run()
        raise RuntimeError("the run has ended before the signal")
    except KeyboardInterrupt:
        return time.perf_counter() - start - seconds
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def in_two_threads(run):
    threads = [threading.Thread(target=run) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def running(meshes, effort):
    yield ["mesh", "two threads : one after the other", "Ctrl-C amid rows ms", "amid construction ms"]
    for mesh in meshes:
        solver = ag.Solver.from_file(mesh, 0.1, threads=1)
        vertices, faces = solver.vertices, solver.faces

        def search():
            for v in some_vertices(solver, effort.searches).tolist():
                solver.distances(v)

        together, each = effort.shortest_times(
            lambda: in_two_threads(search), lambda: [search() for _ in range(2)]
        )
        latencies = [
            max(seconds_until_interrupted(run, 0.02 * (i + 1)) for i in range(effort.rounds))
            for run in (
                lambda: solver.distance_matrix(range(solver.number_of_vertices), [0]),
                lambda: ag.Solver(vertices, faces, 1e-6),
            )
        ]
        yield [pathlib.Path(mesh).stem, f"{together / each:.2f}",
               *(f"{1000 * latency:.0f}" for latency in latencies)]


def memory(meshes):
    """What a process takes that reads a mesh and finds distances, beyond one that imports this."""
    program = """
import re, sys
import approximate_geodesics as ag
def peak(): # of this program; other figures include that of the process that has started it
    with open("/proc/self/status") as file:
        return 1024 * int(re.search(r"VmHWM:\\s*(\\d+)", file.read()).group(1))
before = peak()
mesh, epsilon = sys.argv[1], sys.argv[2]
solver = ag.Solver.from_file(mesh, None if epsilon == "None" else float(epsilon))
solver.distances(0)
print((peak() - before) / solver.number_of_vertices, solver.memory / solver.number_of_vertices)
"""
    yield ["mesh", "epsilon", "solver.memory bytes/vertex", "peak bytes/vertex"]
    for mesh in meshes:
        for epsilon in (None, 0.1, 0):
            output = subprocess.run(
                [sys.executable, "-c", program, mesh, str(epsilon)],
                check=True, capture_output=True, text=True,
            ).stdout
            peak, of_solver = map(float, output.split())
            yield [pathlib.Path(mesh).stem, str(epsilon), f"{of_solver:.0f}", f"{peak:.0f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="the program `measure` of this folder")
    parser.add_argument("--quick", action="store_true", help="only to see whether this runs")
    parser.add_argument("--csv", help="prefix of the names of files for the tables")
    parser.add_argument("meshes", nargs="*")
    arguments = parser.parse_args()
    effort, tables = Effort(arguments.quick), Tables(arguments.csv)
    names = ["elephant.off"] if arguments.quick else ["bunny00.off", "armadillo.off"]
    meshes = arguments.meshes or [str(sample_mesh(name)) for name in names]
    tables.print("cpp", "Python beside C++, epsilon=0.1, one thread",
                 list(compare_with_cpp(arguments.program, meshes, effort)))
    tables.print("scipy", f"Matrices of {effort.scipy_rows} rows beside scipy.sparse.csgraph."
                 "dijkstra, one thread", list(compare_with_scipy(meshes, effort)))
    tables.print("local", f"local_gdist_matrix on a sphere of {effort.sphere} vertices, one thread, "
                 f"beside the {GDIST_MICROSECONDS} microseconds that gdist's documentation tells",
                 list(local_matrices(effort)))
    tables.print("running", f"Twice {effort.searches} searches by two threads of Python; the longest "
                 f"time until a run ends after a signal, of {effort.rounds}",
                 list(running(meshes, effort)))
    tables.print("memory", "Memory of a solver and one search", list(memory(meshes)))


main()
