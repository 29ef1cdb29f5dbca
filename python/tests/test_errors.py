import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid

VERTICES, FACES = grid(4)
SOLVER = ag.Solver(VERTICES, FACES, 0.1)


def changed(array, place, value):
    result = array.copy()
    result[place] = value
    return result


@pytest.mark.parametrize(
    "vertices, faces, message",
    [
        (changed(VERTICES, (5, 1), np.nan), FACES, "vertex 5 is not finite"),
        (VERTICES, changed(FACES, (7, 2), 99), "face 7 has vertex 99.*there are 16"),
        (VERTICES, changed(FACES, (7, 2), -1), "face 7 has vertex -1"),
        (VERTICES, changed(FACES, 3, (2, 2, 5)), "face 3 has vertex 2 twice"),
        (VERTICES, np.append(FACES, [(0, 1, 9)], axis=0), "face 0 and face 18.*vertices 0 and 1"),
        (VERTICES, np.append(FACES, [(5, 1, 15)], axis=0), "between vertices 1 and 5 is not manifold"),
        (VERTICES, [(0, 1, 2), (0, 3, 4)], "vertex 0 is not manifold"),
        (VERTICES[:, :2], FACES, "vertices must have the shape"),
        (VERTICES, FACES[:, :2], "faces must have the shape"),
        (VERTICES, FACES.astype(float), "faces must be integers"),
        ("abc", FACES, "vertices cannot be read as numbers"),
    ],
)
def test_meshes_that_cannot_be_right(vertices, faces, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver(vertices, faces)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"epsilon": -1}, "epsilon is -1"),
        ({"epsilon": np.nan}, "epsilon is nan"),
        ({"threads": 0}, "threads is 0"),
        ({"face_weights": [1, 2]}, "face_weights must have the shape"),
        ({"face_weights": changed(np.ones(18), 4, -1), "epsilon": 0.1}, "face 4 has weight -1"),
        ({"face_weights": np.ones(18), "epsilon": 0}, "no exact distances with face weights"),
        ({"barriers": [(0, 1), (0, 15)]}, "barrier 1 is not an edge"),
        ({"barriers": [(0, 99)]}, "barrier 0 has vertex 99"),
        ({"barriers": [(0, 1, 2)]}, r"barriers must have the shape \(any, 2\)"),
    ],
)
def test_parameters_that_cannot_be_right(options, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver(VERTICES, FACES, **options)


@pytest.mark.parametrize(
    "sources, message",
    [
        (16, "source 0 is vertex 16; they are numbered from 0, and there are 16"),
        ([0, -1], "source 1 is vertex -1"),
        (1.5, "not a vertex"),
        ([0.5], "must be integers"),
        ((18, (1, 0, 0)), "source 0 is face 18"),
        ((0, (1, 1, 0)), "barycentric coordinates are 1, 1, 0"),
        ([(0, (1, 0, 0)), 3], "source 1 is not a face and three"),
        ((np.array([1, 2]), np.ones((3, 3)) / 3), "2 source faces, and coordinates of 3"),
        (([0, 1], [[1, 0, 0]]), "2 source faces, and coordinates of 1"),
        (2**70, f"the source is vertex {2**70}, which is too large"),
        (-(2**70), "too large"),
        ([0, 2**70], f"the source vertices contain {2**70}, which is too large"),
        ([[0], [1, 2]], "the source vertices cannot be read as integers"),
        ([[0, 1]], r"the source vertices must have the shape \(any,\)"),
    ],
)
def test_sources_that_cannot_be_right(sources, message):
    with pytest.raises(ValueError, match=message):
        SOLVER.distances(sources)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: SOLVER.distances(0, max_distance=-1), "max_distance is -1"),
        (lambda: SOLVER.path(0, 99), "target is vertex 99"),
        (lambda: SOLVER.path([0, 1], 2), "source must be one point"),
        (lambda: SOLVER.distance_matrix([0], k=0), "k is 0"),
        (lambda: SOLVER.distance_matrix([0], [99]), "target 0 is vertex 99"),
        (lambda: SOLVER.distance_matrix([0, 1], [1, 0], symmetric=True), "not the same points"),
        (lambda: SOLVER.distance_matrix([0], [0], k=1, symmetric=True), "nearest columns"),
        (lambda: SOLVER.gradient(np.ones(3)), "values must have the shape"),
        (lambda: SOLVER.isolines(np.ones(16), np.nan), "not a number"),
        (lambda: SOLVER.farthest_points(-1), "number of points is -1"),
        (lambda: list(SOLVER.iter_blocks([0], block_size=0)), "block_size is 0"),
        (lambda: ag.compute_gdist(VERTICES, FACES, [0], [99]), "target 0 is vertex 99"),
    ],
)
def test_calls_that_cannot_be_right(call, message):
    with pytest.raises(ValueError, match=message):
        call()
    assert SOLVER.distances(0)[0] == 0  # it can still be used


@pytest.mark.parametrize(
    "call",
    [
        lambda progress: SOLVER.distances(0, progress=progress),
        lambda progress: SOLVER.distance_matrix([0], progress=progress),
        lambda progress: SOLVER.voronoi(0, progress=progress),
        lambda progress: SOLVER.farthest_points(1, progress=progress),
    ],
)
def test_progress_that_cannot_be_called(call):
    with pytest.raises(TypeError, match="progress is 5; it must be callable"):
        call(5)


def test_folders_are_not_files(tmp_path):
    for call in (SOLVER.save, ag.Solver.load, ag.read_mesh):
        with pytest.raises(IsADirectoryError, match=tmp_path.name):
            call(tmp_path)


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(FileNotFoundError):
        ag.Solver.load(tmp_path / "none.bin")
    with pytest.raises(FileNotFoundError):
        ag.read_mesh(tmp_path / "none.off")
    with pytest.raises(OSError):
        SOLVER.save(tmp_path / "none" / "solver.bin")


def test_damaged_files(tmp_path):
    file = tmp_path / "solver.bin"
    SOLVER.save(file)
    contents = file.read_bytes()
    for damaged in (b"", contents[:100], contents[:-1], b"x" + contents[1:],
                    contents[:200] + b"\x7f" + contents[201:], contents + b"x"):
        file.write_bytes(damaged)
        with pytest.raises(ValueError):
            ag.Solver.load(file)


@pytest.mark.parametrize("name, message", [("a\0b", "null character"), ("\udcff", "not UTF-8")])
def test_names_of_files_that_cannot_be(name, message):
    solver = ag.Solver([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    for refuse in (solver.save, ag.Solver.load, ag.read_mesh):
        with pytest.raises(ValueError, match=message):
            refuse(name)
