"""What is copied, and what is not: told by addresses."""

import numpy as np
import pytest

import approximate_geodesics as ag
from approximate_geodesics import _arrays, _native
from meshes import grid, sphere

VERTICES, FACES = grid(10)


def address(array):
    return array.__array_interface__["data"][0]


@pytest.mark.parametrize("kind", [np.int32, np.int64])
def test_fitting_arrays_are_read_where_they_are(kind):
    faces = FACES.astype(kind)
    assert address(_arrays.numbers(VERTICES, "vertices", (-1, 3))) == address(VERTICES)
    assert address(_arrays.integers(faces, "faces", (-1, 3))) == address(faces)
    # the module underneath refuses what it would have to convert
    _native.Solver(VERTICES, faces, 0.1, None, None, np.inf, False, 0, None, False, 0, None)
    for vertices, corners in [
        (VERTICES.astype(np.float32), faces),
        (np.asfortranarray(VERTICES), faces),
        (VERTICES, faces.astype(np.int16)),
        (VERTICES, faces[::2]),
    ]:
        with pytest.raises(TypeError):
            _native.Solver(vertices, corners, 0.1, None, None, np.inf, False, 0, None, False, 0, None)


def test_other_arrays_are_converted():
    expected = ag.Solver(VERTICES, FACES, 0.1).distances(0)
    wide = np.zeros((200, 6))
    wide[::2, ::2] = VERTICES
    for vertices, faces in [
        (VERTICES.tolist(), FACES.tolist()),
        (np.asfortranarray(VERTICES), np.asfortranarray(FACES)),
        (wide[::2, ::2], FACES[:, ::-1][:, ::-1]),
        (VERTICES.astype(np.float32), FACES.astype(np.uint8)),
        (VERTICES.astype(">f8"), FACES.astype(">i4")),
    ]:
        np.testing.assert_array_equal(ag.Solver(vertices, faces, 0.1).distances(0), expected)


def test_unaligned_arrays_are_copied():
    def unaligned(array):
        bytes_ = np.zeros(array.nbytes + 1, dtype=np.uint8)
        result = bytes_[1:].view(array.dtype).reshape(array.shape)
        result[:] = array
        assert not result.flags.aligned
        return result

    vertices, faces = unaligned(VERTICES), unaligned(FACES)
    assert address(_arrays.numbers(vertices, "vertices", (-1, 3))) != address(vertices)
    expected = ag.Solver(VERTICES, FACES, 0.1).distances([0, 3])
    solver = ag.Solver(vertices, faces, 0.1)
    np.testing.assert_array_equal(solver.distances(unaligned(np.array([0, 3]))), expected)


def test_arrays_that_cannot_be_written_are_read():
    vertices, faces = VERTICES.copy(), FACES.copy()
    vertices.flags.writeable = faces.flags.writeable = False
    sources = np.array([0, 3])
    sources.flags.writeable = False
    solver = ag.Solver(vertices, faces, 0.1)
    assert solver.distances(sources)[3] == 0


def test_the_solver_does_not_need_the_arrays_any_more():
    vertices, faces = VERTICES.copy(), FACES.copy()
    solver = ag.Solver(vertices, faces)
    expected = solver.distances(0)
    vertices[:], faces[:] = 0, 0
    np.testing.assert_array_equal(solver.distances(0), expected)


def test_sparse_rows_are_those_of_the_sink():
    solver = ag.Solver(*sphere(3), epsilon=0.1)
    request = (np.arange(50), None, None, 0.5, None, False, False, 0, None)
    distances, columns, starts = solver._solver.matrix(*request)
    assert distances.base is not None and columns.base is distances.base
    from approximate_geodesics._solver import _sparse_arrays

    matrix = _sparse_arrays()((distances, columns, starts), shape=(50, 642), copy=False)
    assert address(matrix.data) == address(distances)
    assert address(matrix.indices) == address(columns)
    assert address(matrix.indptr) == address(starts)
    del distances, columns, starts  # the matrix keeps what it shows
    np.testing.assert_array_equal(
        matrix.toarray(), solver.distance_matrix(range(50), max_distance=0.5).toarray()
    )


def test_results_outlive_the_solver_and_can_be_written():
    solver = ag.Solver(VERTICES, FACES, 0.1)
    results = [solver.distances(0), solver.path(0, 99), solver.distance_matrix([0, 1])]
    results.append(solver.distance_matrix([0, 1], max_distance=3).data)
    del solver
    for result in results:
        result += 1
        assert np.all(result.reshape(-1) >= 1)


def test_memory_is_told():
    small, large = (ag.Solver(*sphere(level), epsilon=0.1).memory for level in (2, 4))
    assert 10 * small < large
