import os
import signal
import threading

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid, sphere

PLANE = ag.Solver(*grid(9))
SPHERE = ag.Solver(*sphere(3))


def test_the_border_of_two_cells_is_their_bisector():
    faces, weights = PLANE.locate([[1.5, 4.5, 0], [4.5, 4.5, 0]])
    cells = PLANE.voronoi_borders((faces, weights))
    assert cells.areas == pytest.approx([24, 40])
    assert len(cells.borders) == 1 and cells.borders[0].shape[1] == 3
    np.testing.assert_allclose(cells.borders[0][:, 0], 3, atol=1e-9)
    np.testing.assert_array_equal(cells.border_sources, [[0, 1]])
    np.testing.assert_array_equal(cells.neighbors, [[0, 1]])
    assert cells.triangles.shape == (0, 3)


def test_initial_distances_make_hyperbolas():
    sources = PLANE.locate([[1.5, 4.5, 0], [4.5, 4.5, 0]])
    cells = PLANE.voronoi_borders(sources, initial_distances=[1, 0], chord_error=1e-4)
    border = cells.borders[0][:, :2]
    differences = np.linalg.norm(border - [4.5, 4.5], axis=1) - np.linalg.norm(
        border - [1.5, 4.5], axis=1
    )
    np.testing.assert_allclose(differences, 1, atol=1e-9)
    # x = 3 - cosh(s) / 2 and y = 4.5 + sqrt(2) sinh(s), with y from 0 to 8
    s, t = np.arcsinh(np.array([-4.5, 3.5]) / np.sqrt(2))
    area = 24 - np.sqrt(2) / 4 * ((t - s) + (np.sinh(2 * t) - np.sinh(2 * s)) / 2)
    assert cells.areas == pytest.approx([area, 64 - area], rel=1e-9)
    rough = PLANE.voronoi_borders(sources, initial_distances=[1, 0], chord_error=1)
    assert len(rough.borders[0]) < len(border)
    assert len(PLANE.cut_locus(sources, initial_distances=[4, 0]).borders) == 0


def test_cells_cover_a_sphere():
    sources = np.arange(12)
    cells = SPHERE.voronoi_borders(sources)
    corners = SPHERE.vertices[SPHERE.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert cells.areas.sum() == pytest.approx(np.linalg.norm(normals, axis=1).sum() / 2, rel=1e-9)
    assert len(cells.neighbors) == 30 and cells.triangles.shape == (20, 3)
    assert len(cells.borders) == len(cells.border_sources) == 30


def test_a_cut_locus_is_on_the_other_side():
    cells = SPHERE.cut_locus(0)
    assert len(cells.borders) > 0 and np.all(cells.border_sources == 0)
    farthest = min(points @ SPHERE.vertices[0] for border in cells.borders for points in border)
    assert farthest < -0.9
    assert len(PLANE.cut_locus(40).borders) == 0


def test_bad_sources_are_named():
    with pytest.raises(ValueError, match="source 1 is vertex 999"):
        PLANE.voronoi_borders([0, 999])
    with pytest.raises(ValueError, match="initial_distances"):
        PLANE.voronoi_borders([0, 1], initial_distances=[])
    with pytest.raises(ValueError, match="initial distance of source 1 is -1"):
        PLANE.cut_locus([0, 1], initial_distances=[0, -1])
    with pytest.raises(ValueError, match="chord error is 0"):
        PLANE.voronoi_borders([0, 1], chord_error=0)
    with pytest.raises(TypeError, match="chord_error"):
        PLANE.voronoi_borders([0, 1], chord_error="fine")


def test_an_interrupt_ends_the_division():
    solver = ag.Solver(*sphere(6))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):  # each takes seconds
            solver.cut_locus(np.arange(0, solver.number_of_vertices, 100))
