import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid, sphere

PLANE = ag.Solver(*grid(9))


def test_distances_are_those_from_the_nearest_point():
    distances = PLANE.distances_from_curve([18, 26])
    np.testing.assert_allclose(distances, abs(PLANE.vertices[:, 1] - PLANE.vertices[18, 1]))
    square = PLANE.distances_from_curve([20, 24, 60, 56], closed=True)
    assert square[40] == pytest.approx(2) and square[58] == pytest.approx(0)
    region = PLANE.distances_from_region([0])
    assert np.count_nonzero(region == 0) == 3


def test_distances_are_negative_to_the_left_if_wanted():
    square = [20, 24, 60, 56]
    distances = PLANE.distances_from_curve(square, closed=True)
    signed = PLANE.distances_from_curve(square, closed=True, signed=True)
    np.testing.assert_array_equal(np.abs(signed), distances)
    x, y = PLANE.vertices[:, 0], PLANE.vertices[:, 1]
    corner, opposite = PLANE.vertices[20], PLANE.vertices[60]
    inside = (corner[0] < x) & (x < opposite[0]) & (corner[1] < y) & (y < opposite[1])
    np.testing.assert_array_equal(signed < 0, inside)
    turned = PLANE.distances_from_curve(square[::-1], closed=True, signed=True)
    np.testing.assert_array_equal(turned, -signed)
    with pytest.raises(ValueError, match="no two sides"):
        PLANE.distances_from_curve(square, signed=True)


def test_progress_is_told():
    told = []
    solver = ag.Solver(*sphere(6))
    solver.offset_curves(0, [0.5, 1], progress=lambda *numbers: told.append(numbers))
    assert told[-1][0] == told[-1][1] > 0
    with pytest.raises(TypeError, match="progress"):
        PLANE.distances_from_curve(0, progress=1)


def test_offsets_have_their_distance():
    circles = PLANE.offset_curves(40, [1, 2.5])
    for radius, [circle] in zip([1, 2.5], circles):
        radii = np.linalg.norm(circle - PLANE.vertices[40], axis=1)
        np.testing.assert_allclose(radii, radius, atol=0.01)
        np.testing.assert_array_equal(circle[0], circle[-1])
    assert len(PLANE.offset_curves([18, 26], 1)) == 2
    assert PLANE.offset_curves([18, 26], 1000) == []


def test_curves_that_are_none_are_named():
    with pytest.raises(ValueError, match="point 1 is vertex 99"):
        PLANE.distances_from_curve([0, 99])
    with pytest.raises(ValueError, match="face 999"):
        PLANE.distances_from_region([999])
    with pytest.raises(ValueError, match="offset 0"):
        PLANE.offset_curves(0, -1)
