"""What type checkers are to know: mypy reads this, and nobody runs it."""

from typing import assert_type

import numpy as np
import numpy.typing as npt

import approximate_geodesics as ag

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]


class Named(ag.Solver):
    pass


def check(solver: ag.Solver, values: Floats) -> None:
    assert_type(solver.distances(0), Floats)
    assert_type(solver.distances([0, 1], return_nearest=True), tuple[Floats, Integers])
    assert_type(solver.distances(0, return_predecessors=True), tuple[Floats, Integers])
    assert_type(
        solver.distances(0, return_nearest=True, return_predecessors=True),
        tuple[Floats, Integers, Integers],
    )
    assert_type(solver.path(0, 1), Floats)
    assert_type(solver.path(0, 1, return_length=True), tuple[Floats, float])
    assert_type(solver.pair_distances([[0, 1]]), Floats)
    assert_type(solver.paths([0], [1]), list[Floats])
    assert_type(solver.paths([0], [1], return_lengths=True), tuple[list[Floats], Floats])
    assert_type(solver.farthest_points(5), Integers)
    assert_type(solver.farthest_points(5, return_radius=True), tuple[Integers, float])
    assert_type(solver.isolines(values, 0.5), list[Floats])
    assert_type(solver.isolines(values, [0.5, 1]), list[list[Floats]])
    assert_type(solver.voronoi_borders([0, 1]), ag.Cells)
    assert_type(solver.voronoi_borders([0, 1], initial_distances=[0, 1.5], chord_error=1), ag.Cells)
    assert_type(solver.cut_locus(0).areas, Floats)
    assert_type(solver.trace(0, [1, 0, 0]), Floats)
    assert_type(solver.trace(0, [1, 0], 2, return_end=True), tuple[Floats, Floats, float])
    assert_type(solver.logarithmic_map(0), Floats)
    assert_type(solver.extend_vectors([0, 1], values), Floats)
    assert_type(solver.shorten_loop([0, 1, 2]), Floats)
    assert_type(solver.shorten_loop([0, 1, 2], return_length=True), tuple[Floats, float])
    assert_type(solver.shorten_curve([0, 1, 2]), Floats)
    assert_type(solver.shorten_curve([0, 1, 2], return_length=True), tuple[Floats, float])
    assert_type(solver.shortest_loop_through(0), Floats)
    assert_type(Named.load("file"), Named)
    assert_type(Named.from_file("file"), Named)
    assert_type(Named.from_trimesh(values, 0.1), Named)


def check_grid(grid: ag.Grid, values: Floats) -> None:
    assert_type(grid.distances((0, 1)), Floats)
    assert_type(grid.distances([(0, 1)], return_nearest=True), tuple[Floats, Integers])
    assert_type(grid.distances((0, 1), return_predecessors=True), tuple[Floats, Integers])
    assert_type(
        grid.distances((0, 1), return_nearest=True, return_predecessors=True),
        tuple[Floats, Integers, Integers],
    )
    assert_type(grid.path((0, 1), (2, 3)), Floats)
    assert_type(grid.path((0, 1), (2, 3), return_length=True), tuple[Floats, float])
    assert_type(grid.isolines(values, 0.5), list[Floats])
    assert_type(grid.isolines(values, [0.5, 1]), list[list[Floats]])
