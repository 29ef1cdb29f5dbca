"""Points in space, and points on edges."""

import pickle
import threading

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid, sphere

VERTICES, FACES = sphere(3)
SOLVER = ag.Solver(VERTICES, FACES, 0)
FLAT, TRIANGLES = grid(6)
SQUARE = ag.Solver(FLAT, TRIANGLES, 0)


def positions(vertices, faces, points):
    numbers, weights = points
    return np.einsum("ij,ijk->ik", weights, vertices[faces[numbers]])


def test_nearest_points_are_found():
    generator = np.random.default_rng(5)
    inside = generator.uniform(0, 5, (200, 2))
    above = generator.uniform(-3, 3, 200)
    found, distances = SQUARE.locate(np.column_stack([inside, above]), return_distance=True)
    np.testing.assert_allclose(positions(FLAT, TRIANGLES, found)[:, :2], inside, atol=1e-9)
    np.testing.assert_allclose(distances, np.abs(above), atol=1e-12)
    assert found[0].dtype == np.int64 and found[1].shape == (200, 3)
    outside = SQUARE.locate([[-3, 2, 0], [7, 9, 1]])
    np.testing.assert_allclose(positions(FLAT, TRIANGLES, outside), [[0, 2, 0], [5, 5, 0]])


def test_nearest_points_are_nearest():
    points = np.random.default_rng(7).normal(size=(50, 3))
    found, distances = SOLVER.locate(points, return_distance=True)
    weights = np.random.default_rng(8).dirichlet([1, 1, 1], 30)
    samples = np.einsum("sj,fjk->fsk", weights, VERTICES[FACES]).reshape(-1, 3)
    for point, place, distance in zip(points, positions(VERTICES, FACES, found), distances):
        assert np.linalg.norm(point - place) == pytest.approx(distance, abs=1e-12)
        assert distance <= np.linalg.norm(samples - point, axis=1).min() + 1e-12


def test_vertices_are_located_exactly():
    numbers = [0, 17, 300]
    np.testing.assert_array_equal(
        SOLVER.distances(SOLVER.locate(VERTICES[numbers])), SOLVER.distances(numbers)
    )


def test_one_point_is_a_source_and_a_target():
    source = SQUARE.locate((1.25, 0.5, 2))
    target, distance = SQUARE.locate([4.25, 4.5, -1], return_distance=True)
    assert distance == 1 and isinstance(source[0], int) and source[1].shape == (3,)
    path, length = SQUARE.path(source, target, return_length=True)
    assert length == pytest.approx(5)
    np.testing.assert_allclose(path[[0, -1]], [[1.25, 0.5, 0], [4.25, 4.5, 0]], atol=1e-12)
    assert SQUARE.distance_matrix(source, [target])[0, 0] == pytest.approx(5)


@pytest.mark.parametrize("scale", [1e-170, 1e-30, 1.0, 1e30, 1e170])
def test_sizes_of_meshes_do_not_matter(scale):
    solver = ag.Solver(FLAT * scale, TRIANGLES)
    point = np.array([2.3, 1.4, 3])
    (face, weights), distance = solver.locate(point * scale, return_distance=True)
    np.testing.assert_allclose(weights @ FLAT[TRIANGLES[face]], [2.3, 1.4, 0], atol=1e-9)
    assert distance == pytest.approx(3 * scale)


def test_no_points_are_located():
    faces, coordinates = SQUARE.locate(np.empty((0, 3)))
    assert faces.shape == (0,) and coordinates.shape == (0, 3)
    assert np.all(np.isinf(SQUARE.distances((faces, coordinates))))


@pytest.mark.parametrize(
    "points, message",
    [
        ([[0, 0, 0], [0, np.nan, 0]], r"point 1 is \(0, .*nan, 0\); coordinates must be finite"),
        ([np.inf, 0, 0], "point 0 is"),
        ([1e200, 0, 0], "at most 1e100 times as large"),
        ([[0, 0]], r"points must have the shape \(any, 3\)"),
        ([0, 0], r"points must have the shape \(3,\)"),
        ("abc", "points"),
    ],
)
def test_points_that_cannot_be_located(points, message):
    with pytest.raises(ValueError, match=message):
        SQUARE.locate(points)


def test_surfaces_without_faces_have_no_points():
    with pytest.raises(ValueError, match="no faces to locate points in"):
        ag.Solver([[0, 0, 0]], np.empty((0, 3), int)).locate([0, 0, 0])


def test_trees_are_not_copied_with_solvers():
    solver = ag.Solver(FLAT, TRIANGLES)
    empty = len(pickle.dumps(solver))
    solver.locate([0, 0, 0])
    assert len(pickle.dumps(solver)) == empty
    copy = pickle.loads(pickle.dumps(solver))
    del solver  # a tree keeps its mesh
    np.testing.assert_allclose(copy.locate([2, 2, 1], return_distance=True)[1], 1)


def test_several_threads_locate_points():
    solver, points = ag.Solver(VERTICES, FACES), np.random.default_rng(3).normal(size=(5000, 3))
    results = [None] * 4

    def locate(number):
        results[number] = solver.locate(points)

    threads = [threading.Thread(target=locate, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for faces, coordinates in results[1:]:
        np.testing.assert_array_equal(faces, results[0][0])
        np.testing.assert_array_equal(coordinates, results[0][1])


def test_points_on_edges():
    point = ((7, 8), 0.25)  # (1.25, 1, 0)
    expected = np.linalg.norm(FLAT - (1.25, 1, 0), axis=1)
    np.testing.assert_allclose(SQUARE.distances(point), expected, atol=1e-12)
    np.testing.assert_array_equal(SQUARE.distances(((8, 7), 0.75)), SQUARE.distances(point))
    path = SQUARE.path(point, ((0, 6), 0.5))
    np.testing.assert_allclose(path[[0, -1]], [[1.25, 1, 0], [0, 0.5, 0]])
    for end, vertex in [(0, 7), (1, 8)]:
        np.testing.assert_array_equal(SQUARE.distances(((7, 8), end)), SQUARE.distances(vertex))


def test_sequences_of_points_on_edges():
    points = [((7, 8), 0.25), ((0, 6), 0.5), ((13, 7), 0.125)]
    as_arrays = np.array([p[0] for p in points], np.int32), np.array([p[1] for p in points])
    as_lists = tuple(part.tolist() for part in as_arrays)
    matrix = SQUARE.distance_matrix(points)
    assert matrix.shape == (3, 36)
    np.testing.assert_array_equal(matrix, [SQUARE.distances(p) for p in points])
    for same in (as_arrays, as_lists, tuple(points)):
        np.testing.assert_array_equal(SQUARE.distance_matrix(same), matrix)
    blocks = [block for _, block in SQUARE.iter_blocks(points, points, block_size=2)]
    np.testing.assert_array_equal(
        np.concatenate(blocks), SQUARE.distance_matrix(points, points)
    )
    np.testing.assert_array_equal(
        SQUARE.distances(points, return_nearest=True)[1], matrix.argmin(axis=0)
    )


@pytest.mark.parametrize(
    "sources, message",
    [
        (((0, 7), 0.5), "source 0 is not on an edge: no face has both vertex 0 and vertex 7"),
        (((0, 99), 0.5), "source 0 is on an edge of vertex 99; .* there are 36"),
        (((-1, 0), 0.5), "source 0 is on an edge of vertex -1"),
        (((0, 1), 1.5), "source 0 has the parameter 1.5; it must be from 0"),
        ([((0, 1), 0.5), ((0, 1), np.nan)], "source 1 has the parameter nan"),
        ([((0, 1), 0.5), 3], "source 1 is not two vertices and a parameter, as others are"),
        (((0.5, 1), 0.5), "the source edges must be integers"),
        (([[0, 1]], [0.5, 0.5]), "1 source edges, and parameters of 2"),
        (([[0, 1, 2]], [0.5]), r"the source edges must have the shape \(any, 2\)"),
    ],
)
def test_edges_that_cannot_be_right(sources, message):
    with pytest.raises(ValueError, match=message):
        SQUARE.distances(sources)


def test_farthest_points_start_from_vertices():
    with pytest.raises(ValueError, match="must be vertices"):
        SQUARE.farthest_points(2, ((0, 1), 0.5))
