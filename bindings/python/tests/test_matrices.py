import numpy as np
import pytest
import scipy.sparse

import approximate_geodesics as ag
from meshes import sphere


@pytest.fixture(scope="module")
def solver():
    return ag.Solver(*sphere(3), epsilon=0.1)


def test_rows_are_searches(solver):
    sources = [5, 0, 600, 5]
    matrix = solver.distance_matrix(sources)
    assert matrix.shape == (4, 642) and matrix.dtype == np.float64
    for row, source in zip(matrix, sources):
        np.testing.assert_array_equal(row, solver.distances(source))


def test_columns_are_targets(solver):
    everything = solver.distance_matrix(range(10))
    some = solver.distance_matrix(range(10), [600, 3])
    np.testing.assert_array_equal(some, everything[:, [600, 3]])


def test_points_of_faces_as_sources_and_targets(solver):
    points = [(3, (0.2, 0.3, 0.5)), (70, (0.1, 0.1, 0.8))]
    matrix = solver.distance_matrix(points, points)
    assert np.all(np.diag(matrix) == 0)
    np.testing.assert_allclose(matrix, matrix.T, rtol=0.1)


def test_one_source_is_one_row(solver):
    np.testing.assert_array_equal(solver.distance_matrix(3), solver.distances(3)[None])


def test_rows_up_to_a_distance(solver):
    sources = [1, 0, 30]
    dense = solver.distance_matrix(sources)
    sparse = solver.distance_matrix(sources, max_distance=0.4)
    assert scipy.sparse.issparse(sparse) and sparse.shape == dense.shape
    within = dense <= 0.4
    assert sparse.nnz == within.sum()
    np.testing.assert_array_equal(sparse.toarray(), np.where(within, dense, 0))


def test_nearest_columns(solver):
    sources = [4, 17]
    dense = solver.distance_matrix(sources)
    sparse = solver.distance_matrix(sources, k=7)
    assert np.all(np.diff(sparse.indptr) == 7)
    np.testing.assert_array_equal(sparse.data.reshape(2, 7), np.sort(dense, axis=1)[:, :7])


def test_symmetric_matrices():
    solver = ag.Solver(*sphere(3), epsilon=0.5)
    points = np.arange(200)
    any_, symmetric = (
        solver.distance_matrix(points, points, symmetric=wanted) for wanted in (False, True)
    )
    assert np.any(any_ != any_.T)
    np.testing.assert_array_equal(symmetric, np.minimum(any_, any_.T))
    near = solver.distance_matrix(points, points, max_distance=0.5, symmetric=True)
    assert near.nnz > 200 and abs(near - near.T).max() == 0


def test_no_rows(solver):
    assert solver.distance_matrix([]).shape == (0, 642)
    assert solver.distance_matrix([], max_distance=1).shape == (0, 642)
    assert solver.distance_matrix([2], []).shape == (1, 0)


def test_the_number_of_threads_changes_nothing(solver):
    one, two = (solver.distance_matrix(range(100), threads=t) for t in (1, 2))
    np.testing.assert_array_equal(one, two)


def test_blocks_are_parts_of_the_matrix(solver):
    sources = np.arange(0, 600, 7)
    whole = solver.distance_matrix(sources)
    parts = list(solver.iter_blocks(sources, block_size=20))
    assert [rows.start for rows, _ in parts] == [0, 20, 40, 60, 80]
    np.testing.assert_array_equal(np.concatenate([block for _, block in parts]), whole)
    sparse = [block for _, block in solver.iter_blocks(sources, max_distance=0.3)]
    assert sparse[0].nnz == (whole <= 0.3).sum()
    told = []
    blocks = solver.iter_blocks(
        iter([3, 4, 5]), (v for v in (7, 8)), block_size=2, progress=lambda *n: told.append(n)
    )
    parts = [block for _, block in blocks]
    np.testing.assert_array_equal(
        np.concatenate(parts), solver.distance_matrix([3, 4, 5], [7, 8])
    )
    assert told == [(2, 3), (3, 3)]
    places = ([0, 1, 2], np.full((3, 3), 1 / 3))
    blocks = [block for _, block in solver.iter_blocks(places, places, block_size=1)]
    np.testing.assert_array_equal(
        np.concatenate(blocks), solver.distance_matrix(places, places)
    )


def test_the_largest_distance_from_some_points_falls(solver):
    points, radius = solver.farthest_points(12, return_radius=True)
    assert points[0] == 0 and len(set(points)) == 12
    assert radius == solver.distances(points).max()
    fewer, larger = solver.farthest_points(6, return_radius=True)
    np.testing.assert_array_equal(fewer, points[:6])
    assert larger > radius
    away = solver.farthest_points(1, sources=[0])
    assert away[0] == np.argmax(solver.distances(0))
    told = []
    everything = solver.farthest_points(1000, progress=lambda *numbers: told.append(numbers))
    assert len(everything) == 642 and told[-1] == (642, 642)


def test_faces_belong_to_the_nearest_source(solver):
    sources = solver.farthest_points(5)
    _, nearest = solver.distances(sources, return_nearest=True)
    cells = solver.voronoi(sources)
    assert cells.shape == (1280,) and set(cells) == set(range(5))
    corners = nearest[solver.faces]
    assert np.all((corners == cells[:, None]).any(axis=1))


def test_gradients_are_unit_vectors_away_from_the_source(solver):
    vertices, faces = solver.vertices, solver.faces
    heights = vertices[:, 2]
    gradients = solver.gradient(heights)
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    for p, q in ((a, b), (b, c)):
        rise = np.einsum("ij,ij->i", gradients, q - p)
        np.testing.assert_allclose(rise, (q - p)[:, 2], atol=1e-12)


def test_isolines_lie_on_their_level(solver):
    heights = solver.vertices[:, 2]
    lines = solver.isolines(heights, 0.25)
    assert len(lines) == 1
    np.testing.assert_allclose(lines[0][:, 2], 0.25)
    np.testing.assert_array_equal(lines[0][0], lines[0][-1])
    several = solver.isolines(heights, [0.25, 2])
    assert len(several) == 2 and several[1] == []
    north = solver.isolines(np.ma.masked_less(heights, 0), [-0.2, 0.25])
    assert north[0] == [] and len(north[1]) == 1
    np.testing.assert_array_equal(several[0][0], lines[0])
