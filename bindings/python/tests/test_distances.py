import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import great_circles, grid, sphere


@pytest.fixture(scope="module")
def ball():
    return sphere(4)


def test_exact_distances_on_a_sphere_are_great_circles(ball):
    vertices, faces = ball
    distances = ag.Solver(vertices, faces, epsilon=0).distances(3)
    expected = great_circles(vertices, 3)
    np.testing.assert_allclose(distances, expected, atol=0.005)
    assert distances[3] == 0


@pytest.mark.parametrize("epsilon", [0.5, 0.1, 0.01])
def test_the_bound_holds(ball, epsilon):
    exact = ag.Solver(*ball, epsilon=0).distances(7)
    distances = ag.Solver(*ball, epsilon=epsilon).distances(7)
    assert np.all(distances >= exact * (1 - 1e-12))
    assert np.all(distances <= exact * (1 + epsilon) * (1 + 1e-6))


def test_paths_along_edges_are_longer():
    vertices, faces = grid(5)
    along_edges = ag.Solver(vertices, faces).distances(0)
    # diagonals go the other way
    np.testing.assert_allclose(along_edges, vertices[:, 0] + vertices[:, 1])
    exact = ag.Solver(vertices, faces, 0).distances(0)
    np.testing.assert_allclose(exact, np.hypot(vertices[:, 0], vertices[:, 1]))


def test_several_sources_and_the_nearest_of_them(ball):
    solver = ag.Solver(*ball, epsilon=0.1)
    sources = [5, 100, 2000]
    distances, nearest = solver.distances(sources, return_nearest=True)
    rows = np.array([solver.distances(s) for s in sources])
    np.testing.assert_array_equal(distances, rows.min(axis=0))
    np.testing.assert_array_equal(rows[nearest, np.arange(len(distances))], distances)


def test_points_of_faces():
    vertices, faces = grid(6)
    solver = ag.Solver(vertices, faces, 0)
    for face, weights in [(7, (0.2, 0.3, 0.5)), (30, (0.5, 0.5, 0)), (12, (0, 0, 1))]:
        point = np.array(weights) @ vertices[faces[face]]
        expected = np.linalg.norm(vertices - point, axis=1)
        np.testing.assert_allclose(solver.distances((face, weights)), expected, atol=1e-12)
    single = np.random.default_rng(0).dirichlet([1, 1, 1], 100).astype(np.float32)
    faces_of_single = np.arange(100) % len(faces)
    points = np.einsum("ij,ijk->ik", single, vertices[faces[faces_of_single]])
    expected = np.linalg.norm(points[:, None] - vertices, axis=2)
    found = solver.distance_matrix((faces_of_single, single))
    np.testing.assert_allclose(found, expected, atol=1e-6)
    points = [(7, (0.2, 0.3, 0.5)), (30, (0.5, 0.5, 0))]
    as_arrays = (np.array([7, 30]), np.array([(0.2, 0.3, 0.5), (0.5, 0.5, 0)]))
    as_lists = tuple(part.tolist() for part in as_arrays)
    for same in (as_arrays, as_lists):
        np.testing.assert_array_equal(solver.distances(points), solver.distances(same))


def test_maximum_distance(ball):
    solver = ag.Solver(*ball, epsilon=0.1)
    everything, near = solver.distances(0), solver.distances(0, max_distance=0.5)
    np.testing.assert_array_equal(near, np.where(everything <= 0.5, everything, np.inf))


def test_parts_that_no_path_connects():
    vertices, faces = grid(3)
    both = np.concatenate([vertices, vertices + 100])
    solver = ag.Solver(both, np.concatenate([faces, faces + 9]), 0.1)
    distances, nearest = solver.distances(0, return_nearest=True)
    assert np.all(np.isinf(distances[9:])) and np.all(nearest[9:] == -1)
    points, length = solver.path(0, 10, return_length=True)
    assert points.shape == (0, 3) and np.isinf(length)


def test_paths_have_the_length_of_their_points(ball):
    vertices, _ = ball
    for epsilon in (None, 0.1, 0):
        solver = ag.Solver(*ball, epsilon=epsilon)
        points, length = solver.path(0, 900, return_length=True)
        np.testing.assert_allclose(np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), length)
        np.testing.assert_allclose(length, solver.distances(0)[900], rtol=1e-6)
        np.testing.assert_array_equal(points[[0, -1]], vertices[[0, 900]])


def test_straightened_paths_are_not_longer():
    vertices, faces = grid(9)
    solver = ag.Solver(vertices, faces)
    points, length = solver.path(0, 80, return_length=True, straighten=True)
    np.testing.assert_allclose(length, np.hypot(8, 8))
    np.testing.assert_allclose(points[:, 0], points[:, 1], atol=1e-12)


def test_weights_of_faces():
    vertices, faces = grid(6)
    cheap = ag.Solver(vertices, faces, 0.1, face_weights=np.ones(len(faces)))
    dear = ag.Solver(vertices, faces, 0.1, face_weights=np.full(len(faces), 3.0))
    np.testing.assert_allclose(dear.distances(0), 3 * cheap.distances(0))
    assert cheap.error_bound == pytest.approx(0.1)


def test_barriers():
    vertices, faces = grid(5)
    wall = [(2, 7), (7, 12), (12, 17)]  # from the border up, with a gap at the top
    free, closed = ag.Solver(vertices, faces, 0.05), ag.Solver(vertices, faces, 0.05, barriers=wall)
    detour = np.hypot(1, 3) * 2  # over the upper end of the wall
    assert free.distances(1)[3] == pytest.approx(2, rel=0.05)
    assert detour <= closed.distances(1)[3] <= detour * 1.05


def test_no_barriers():
    vertices, faces = grid(5)
    for none in ([], np.empty((0, 2), dtype=int)):
        solver = ag.Solver(vertices, faces, 0, barriers=none)  # which barriers would not allow
        assert solver.distances(0)[24] == pytest.approx(np.hypot(4, 4))


def test_repeated_searches_give_the_same(ball):
    solver = ag.Solver(*ball, epsilon=0.1)
    first = solver.distances(11)
    solver.distances([1, 2, 3])
    solver.path(0, 5)
    np.testing.assert_array_equal(solver.distances(11), first)


def test_no_sources_reach_nothing(ball):
    assert np.all(np.isinf(ag.Solver(*ball).distances([])))


@pytest.mark.parametrize("epsilon", [None, 0.1, 0])
def test_predecessors_lead_back_to_the_sources(ball, epsilon):
    solver, sources = ag.Solver(*ball, epsilon=epsilon), [5, 100]
    distances, nearest, before = solver.distances(
        sources, return_nearest=True, return_predecessors=True
    )
    np.testing.assert_array_equal(before[sources], sources)
    moves = np.flatnonzero(before != np.arange(len(before)))
    assert len(moves) == len(before) - 2
    assert np.all(distances[before[moves]] < distances[moves])
    np.testing.assert_array_equal(nearest[before], nearest)
    ways = np.linalg.norm(ball[0][before] - ball[0], axis=1)
    assert np.all(distances[before] + ways <= distances * (1 + 1e-6))
    if epsilon is None:  # along edges
        edges = {tuple(edge) for i in range(3) for edge in np.roll(ball[1], i, axis=1)[:, :2]}
        assert all((v, before[v]) in edges for v in moves)
    np.testing.assert_array_equal(solver.distances(sources, return_predecessors=True)[0], distances)


def test_predecessors_with_weights_are_vertices():
    vertices, faces = grid(6)
    solver = ag.Solver(vertices, faces, 0.1, face_weights=np.arange(1.0, len(faces) + 1))
    distances, before = solver.distances(14, return_predecessors=True, max_distance=30)
    assert before[14] == 14
    np.testing.assert_array_equal(before == -1, np.isinf(distances))
    reached = np.flatnonzero(before >= 0)
    assert np.all(distances[before[reached]] <= distances[reached])
    from_face, alone = solver.distances((3, (0.2, 0.3, 0.5)), return_predecessors=True)
    assert np.all(alone >= 0) and np.any(alone == np.arange(36))
