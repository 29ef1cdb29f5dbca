"""Compares Python with C++ and with SciPy, in the same run, as ratios of shortest times.

Usage: compare.py MEASURE [MESH]

MEASURE is the program `measure` of this folder, which `cmake --build build/python --target measure`
makes. All use one thread. Rounds alternate.
"""

import pathlib
import resource
import subprocess
import sys
import time

import numpy as np
import scipy.sparse
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import ConvexHull

import approximate_geodesics as ag

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
from _sample_meshes import sample_mesh  # noqa: E402

ROUNDS, REPETITIONS, SEARCHES, ROWS = 5, 3, 100, 300


def shortest_time(run, repetitions=REPETITIONS):
    times = []
    for _ in range(repetitions):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def some_vertices(solver, number):
    return np.arange(number) * solver.number_of_vertices // number


def in_python(solver):
    def search(number):
        for v in some_vertices(solver, number).tolist():
            solver.distances(v)

    yield shortest_time(lambda: search(1), SEARCHES)
    yield shortest_time(lambda: search(SEARCHES))
    yield shortest_time(lambda: solver.distance_matrix(some_vertices(solver, ROWS), threads=1))


def in_cpp(program, mesh):
    arguments = [program, mesh, "0.1", str(SEARCHES), str(ROWS), str(REPETITIONS)]
    output = subprocess.run(arguments, check=True, capture_output=True, text=True).stdout
    return map(float, output.split())


def compare_with_cpp(program, mesh):
    solver = ag.Solver.from_file(mesh, 0.1, threads=1)
    rounds = [(list(in_python(solver)), list(in_cpp(program, mesh))) for _ in range(ROUNDS)]
    python, cpp = np.min(np.array(rounds), axis=0)
    for name, p, c in zip(("one search", f"{SEARCHES} searches", f"{ROWS} rows"), python, cpp):
        print(f"{name}: {1000 * p:.2f} ms in Python, {1000 * c:.2f} ms in C++, ratio {p / c:.3f}")


def edges(solver):
    """The matrix of the lengths of edges, as SciPy wants it."""
    vertices, faces = solver.vertices, solver.faces
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    ends = np.unique(np.sort(ends, axis=1), axis=0)
    lengths = np.linalg.norm(vertices[ends[:, 0]] - vertices[ends[:, 1]], axis=1)
    n = len(vertices)
    return scipy.sparse.csr_matrix((lengths, (ends[:, 0], ends[:, 1])), shape=(n, n))


def compare_with_scipy(mesh):
    solver = ag.Solver.from_file(mesh, threads=1)
    graph, sources = edges(solver), some_vertices(solver, 20)
    rows, theirs = solver.distance_matrix(sources), dijkstra(graph, False, sources)
    assert np.allclose(rows, theirs)
    bounded = ag.Solver.from_file(mesh, 0.1, threads=1)
    times = [
        [
            shortest_time(lambda: dijkstra(graph, directed=False, indices=sources)),
            shortest_time(lambda: solver.distance_matrix(sources)),
            shortest_time(lambda: bounded.distance_matrix(sources)),
        ]
        for _ in range(ROUNDS)
    ]
    theirs, ours, bound = np.min(times, axis=0)
    print(f"the same distances along edges by scipy.sparse.csgraph.dijkstra: {theirs / ours:.1f} "
          f"times as long; distances with epsilon=0.1: SciPy takes {theirs / bound:.1f} times as "
          "long as them")


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


def measure_local_matrix():
    vertices, faces = sphere(8192)  # as many as the surface in gdist's documentation
    size = len(vertices)
    exact = ag.local_gdist_matrix(vertices, faces, 0.4, epsilon=0)
    for epsilon in (0.1, 0.05):
        run = lambda: ag.local_gdist_matrix(vertices, faces, 0.4, epsilon=epsilon, threads=1)
        matrix, seconds = run(), shortest_time(run)
        both = matrix.multiply(exact > 0).tocsc()
        errors = both.data / exact.multiply(matrix > 0).tocsc().data - 1
        print(f"local_gdist_matrix, epsilon={epsilon}: {size} vertices, {matrix.nnz / size:.0f} "
              f"distances each, {1e6 * seconds / matrix.nnz:.3f} microseconds a distance, "
              f"mean error {100 * errors.mean():.3f} %")


def main(program, mesh=None):
    mesh = str(mesh or sample_mesh("bunny00.off"))
    compare_with_cpp(program, mesh)
    compare_with_scipy(mesh)
    measure_local_matrix()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    solver = ag.Solver.from_file(mesh, 0.1)
    print(f"the graph of {solver.number_of_vertices} vertices takes "
          f"{solver.memory / solver.number_of_vertices:.0f} bytes a vertex; "
          f"this process has taken {peak:.0f} MB at most")


main(*sys.argv[1:])
