import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import sphere


@pytest.fixture(scope="module")
def solver():
    return ag.Solver(*sphere(3), epsilon=0.1)


@pytest.fixture(scope="module")
def pairs():
    return np.random.default_rng(1).integers(0, 642, (200, 2)) // [7, 1]  # sources are shared


def test_distances_are_entries_of_matrices(solver, pairs):
    distances = solver.pair_distances(pairs)
    assert distances.shape == (200,) and distances.dtype == np.float64
    matrix = solver.distance_matrix(range(642))
    np.testing.assert_array_equal(distances, matrix[pairs[:, 0], pairs[:, 1]])


def test_pairs_may_be_sources_and_targets(solver, pairs):
    expected = solver.pair_distances(pairs)
    np.testing.assert_array_equal(solver.pair_distances(*pairs.T), expected)
    np.testing.assert_array_equal(solver.pair_distances(pairs.tolist()), expected)
    np.testing.assert_array_equal(solver.pair_distances(pairs.astype(np.uint16)), expected)


def test_pairs_of_points_of_all_kinds(solver):
    faces = [(3, (0.2, 0.3, 0.5)), (70, (0.1, 0.1, 0.8)), (3, (0.2, 0.3, 0.5))]
    assert solver.pair_distances(faces, faces).tolist() == [0, 0, 0]
    places = solver.locate(np.eye(3))
    from_vertices = solver.pair_distances([5, 6, 5], places)
    matrix = solver.distance_matrix([5, 6, 5], places)
    np.testing.assert_array_equal(from_vertices, np.diag(matrix))
    assert solver.pair_distances([], []).shape == (0,)
    assert solver.pair_distances(np.empty((0, 2), dtype=int)).shape == (0,)


def test_intervals_contain_exact_distances(solver, pairs):
    exact = ag.Solver(solver.vertices, solver.faces, 0).pair_distances(pairs)
    lower, upper = solver.pair_distances(pairs, return_intervals=True).T
    assert np.all(lower <= exact) and np.all(exact <= upper) and np.all(upper <= 1.11 * lower)
    along_edges = ag.Solver(solver.vertices, solver.faces)
    lower, upper = along_edges.pair_distances(pairs, return_intervals=True).T
    assert np.all(lower == 0) and np.all(exact <= upper)


def test_paths(solver, pairs):
    paths, lengths = solver.paths(pairs, return_lengths=True)
    np.testing.assert_allclose(lengths, solver.pair_distances(pairs), rtol=1e-6)
    assert len(paths) == 200
    for path, length, (source, target) in zip(paths, lengths, pairs):
        np.testing.assert_array_equal(path[[0, -1]], solver.vertices[[source, target]])
        np.testing.assert_allclose(
            np.linalg.norm(np.diff(path, axis=0), axis=1).sum(), length, rtol=1e-9
        )
    _, straight = solver.paths(pairs, straighten=True, return_lengths=True)
    assert np.all(straight <= lengths)


def test_what_is_not_reached():
    vertices, faces = sphere(1)
    both = np.concatenate([vertices, vertices + 9]), np.concatenate([faces, faces + len(vertices)])
    solver = ag.Solver(*both)
    pairs = [[0, len(vertices)], [0, 0], [0, 5]]
    distances = solver.pair_distances(pairs, max_distance=0.1)
    assert distances.tolist() == [np.inf, 0, np.inf]
    paths, lengths = solver.paths(pairs, return_lengths=True)
    assert paths[0].shape == (0, 3) and paths[1].shape == (1, 3) and lengths[0] == np.inf


def test_the_number_of_threads_changes_nothing(solver, pairs):
    one, two = (solver.pair_distances(pairs, threads=t) for t in (1, 2))
    np.testing.assert_array_equal(one, two)


def test_progress_is_that_of_sources(solver):
    calls = []
    solver.pair_distances([[4, 1], [3, 1], [4, 2]], progress=lambda *call: calls.append(call))
    assert calls[-1] == (2, 2)


@pytest.mark.parametrize("epsilon", [0.1, 0])
def test_prepared_pairs_are_the_same(solver, pairs, epsilon):
    prepared = ag.Solver(solver.vertices, solver.faces, epsilon)
    expected = prepared.pair_distances(pairs)
    prepared.prepare_pairs(4)
    np.testing.assert_allclose(prepared.pair_distances(pairs), expected, rtol=1e-12)
    with pytest.raises(ValueError, match="landmarks is 0"):
        prepared.prepare_pairs(0)


def test_prepared_intervals_contain_distances(solver, pairs):
    prepared = ag.Solver(solver.vertices, solver.faces, 0.1)
    expected = prepared.pair_distances(pairs)
    prepared.prepare_intervals(0.05)
    lower, upper = prepared.pair_distances(pairs, return_intervals=True).T
    assert np.all(lower <= expected) and np.all(upper >= expected / 1.1)
    assert np.all(upper <= 1.05 * 1.1 * 1.0001 * lower)
    with pytest.raises(ValueError, match="epsilon is"):
        prepared.prepare_intervals(0)
    with pytest.raises(ValueError, match="exact"):
        ag.Solver(solver.vertices, solver.faces, 0).prepare_intervals()


def test_wrong_pairs_are_named(solver):
    with pytest.raises(ValueError, match="the target of pair 1 is vertex 642"):
        solver.pair_distances([[0, 1], [0, 642]])
    with pytest.raises(ValueError, match="the source of pair 0 is vertex -1"):
        solver.paths([-1], [0])
    with pytest.raises(ValueError, match="2 sources and 1 targets"):
        solver.pair_distances([0, 1], [2])
    with pytest.raises(ValueError, match="shape"):
        solver.pair_distances([0, 1])
    with pytest.raises(ValueError, match="max_distance"):
        solver.pair_distances([[0, 1]], max_distance=-1)
