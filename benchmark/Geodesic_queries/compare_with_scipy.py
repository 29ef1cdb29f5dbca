#!/usr/bin/env python3
# Copyright (c) 2026  The Approximate Geodesics authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances along edges from some sources to all vertices, by bench_edge_rows and by SciPy, which
take turns: times, and how the distances differ. Both have the graph and one thread."""
import argparse
import csv
import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy
import scipy.sparse
import scipy.sparse.csgraph

HEADER = ["mesh", "vertices", "rows", "ours s", "SciPy s", "SciPy us/distance", "SciPy : ours",
          "largest difference"]


def print_table(rows):
    widths = [max(map(len, column)) for column in zip(*rows)]
    for first, *others in rows:
        print(first.ljust(widths[0]), *(t.rjust(w) for t, w in zip(others, widths[1:])), sep="  ")
    print()


def largest_difference(ours, theirs):
    """In relation to the distance; the one of a source to itself is zero in both."""
    assert numpy.array_equal(ours == 0, theirs == 0) and numpy.isfinite(ours).all()
    return numpy.max(numpy.abs(ours - theirs) / numpy.where(theirs > 0, theirs, 1))


def edges_in(folder):
    """The sparse matrix of the lengths of edges."""
    columns = numpy.fromfile(folder + "/columns", numpy.int32)
    starts = numpy.append(0, numpy.cumsum(numpy.fromfile(folder + "/degrees", numpy.int32)))
    return scipy.sparse.csr_matrix((numpy.fromfile(folder + "/lengths"), columns, starts))


def compare(program, mesh, number_of_sources, rounds, folder):
    """A row of the table."""
    with subprocess.Popen([program, mesh, str(number_of_sources), folder + "/"], text=True,
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE) as ours:
        sources = [int(number) for number in ours.stdout.readline().split()]
        edges = edges_in(folder)
        our_seconds, their_seconds = [], []
        for _ in range(rounds):
            ours.stdin.write("again\n")
            ours.stdin.flush()
            our_seconds.append(float(ours.stdout.readline()))
            start = time.perf_counter()
            distances = scipy.sparse.csgraph.dijkstra(edges, indices=sources)
            their_seconds.append(time.perf_counter() - start)
        ours.stdin.close()
    difference = largest_difference(numpy.load(folder + "/rows.npy"), distances)
    our, their = map(statistics.median, (our_seconds, their_seconds))
    return [mesh, str(edges.shape[0]), str(len(sources)), f"{our:.3f}", f"{their:.3f}",
            f"{their / distances.size * 1e6:.3f}", f"{their / our:.1f}", f"{difference:.1e}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="bench_edge_rows")
    parser.add_argument("--quick", action="store_true", help="only see whether it runs")
    parser.add_argument("--csv", default="", help="write the table, too, to a file that starts so")
    parser.add_argument("mesh", nargs="*", help="as for all programs, or sphereN: 10 N^2 + 2 vertices")
    options = parser.parse_args()
    meshes = options.mesh or (["sphere10"] if options.quick else ["bunny00", "sphere57"])
    number, rounds = (5, 3) if options.quick else (500, 5)
    table = [HEADER]
    for mesh in meshes:
        with tempfile.TemporaryDirectory() as folder:
            table.append(compare(options.program, mesh, number, rounds, folder))
    print(f"Rows of all distances along edges, beside scipy.sparse.csgraph.dijkstra of SciPy "
          f"{scipy.__version__} (medians of {rounds} rounds):\n")
    print_table(table)
    if options.csv:
        with open(options.csv + "matrix_scipy.csv", "w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows(table)


main()
