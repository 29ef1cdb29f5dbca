import errno
import os
import re
import resource
import sys

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid

VERTICES, FACES = grid(4)
FLAT_FACES = np.insert(FACES, 0, 3, axis=1).ravel()  # as PyVista has them
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
        (VERTICES, FACES.ravel(), "faces must have the shape"),
        (VERTICES, FLAT_FACES, r"as PyVista's are; give faces\.reshape\(-1, 4\)\[:, 1:\]"),
        (VERTICES, FACES.astype(float), "faces must be integers"),
        (VERTICES, [[0, True, 2], *FACES[1:].tolist()], "faces must be integers, and some are bool"),
        ([[0, True, 0], *VERTICES[1:].tolist()], FACES, "vertices must be real .*some are bool"),
        ("abc", FACES, "vertices cannot be read as numbers"),
        (VERTICES.astype(str).astype(object), FACES, "vertices cannot be read as .* some are texts"),
    ],
)
def test_meshes_that_cannot_be_right(vertices, faces, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver(vertices, faces)


def test_what_the_error_says_of_flat_faces_is_right():
    assert np.array_equal(ag.Solver(VERTICES, FLAT_FACES.reshape(-1, 4)[:, 1:]).faces, FACES)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"epsilon": -1}, "epsilon is -1"),
        ({"epsilon": np.nan}, "epsilon is nan"),
        ({"threads": 0}, "threads is 0"),
        ({"face_weights": [1.0] * 17 + [True]}, "face_weights must be real .*some are bool"),
        ({"barriers": [[1, True]]}, "barriers must be integers, and some are bool"),
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
        (True, "the source True is not a vertex"),
        ("0", "the source '0' is not a point"),
        (b"ab", "is not a point"),
        (bytearray(b"ab"), r"the source bytearray\(b'ab'\) is not a point"),
        ({}, "the source {} is not a point"),
        ({0: 1}, "the source {0: 1} is not a point"),
        ({"vertex": 0}, "the source {'vertex': 0} is not a point"),
        ([{"vertex": 0}], "the source vertices must be integers"),
        (None, "the source None is not a vertex"),
        (np.nan, "the source nan is not a vertex"),
        ([np.nan], "must be integers"),
        (np.ones(16, bool), "the source vertices must be integers, and are bool"),
        (np.zeros(0, bool), "the source vertices must be integers, and are bool"),
        ([1, True], "the source vertices must be integers, and some are bool"),
        (np.array([1, "2"], object), "the source vertices must be integers, and are object"),
        (np.ma.masked_equal([1, 2], 2), r"the source vertices are masked at \[1\]"),
        (np.ma.array(1, mask=True), r"the source vertices are masked at \[\]"),
        ((0, np.ma.array([1.0, 0, 0], mask=[0, 0, 1])), r"the source coordinates are masked at \[2\]"),
        ([(0, np.ma.array([1.0, 0, 0], mask=[0, 0, 1]))], "the source coordinates are masked"),
        ([(np.ma.array([0, 1], mask=[0, 1]), 0.5)], r"the source edges are masked at \[1\]"),
        (([0, True], [[1, 0, 0], [1, 0, 0]]), "the source faces must be integers, and some are bool"),
        (([[0, True], [1, 2]], [0.5, 0.2]), "the source edges must be integers, and some are bool"),
        (([[0, 1], [1, 2]], [0.5, True]), "the source parameters must be real numbers, and some are"),
        ((18, (1, 0, 0)), "source 0 is face 18"),
        (([0, 1], [[1, 0, 0], [0.5, 0.6, 0]]), "source 1 has the barycentric .* 0.5, 0.6, 0"),
        ((0, (1, np.nan, 0)), "source 0 has the barycentric coordinates 1, nan, 0"),
        ((0, (1.5, -0.5, 0)), "must not be negative"),
        ((0, (1, 1, 0)), "source 0 has the barycentric coordinates 1, 1, 0"),
        ([(0, (1, 0, 0)), 3], "source 1 is not a face and three"),
        ((np.array([1, 2]), np.ones((3, 3)) / 3), "2 source faces, and coordinates of 3"),
        (([0, 1], [[1, 0, 0]]), "2 source faces, and coordinates of 1"),
        (2**70, f"the source is vertex {2**70}, which is too large"),
        (-(2**70), "too large"),
        ([0, 2**70], f"the source vertices contain {2**70}, which is too large"),
        ([0, 2**63], f"the source vertices contain {2**63}, which is too large"),
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
        (lambda: SOLVER.gradient(np.ones(16) * 1j), "values must be real numbers"),
        (lambda: SOLVER.gradient(np.zeros(16, "M8[s]")), "values must be real numbers"),
        (lambda: SOLVER.isolines(np.ones(16), np.nan), "not a number"),
        (lambda: SOLVER.isolines(np.ones(16), "3"), "the level must be real numbers"),
        (lambda: SOLVER.isolines(np.ones(16), [1, 2, np.inf]), "level 2 is inf"),
        (lambda: SOLVER.farthest_points(-1), "number of points is -1"),
        (lambda: SOLVER.iter_blocks([0], block_size=0), "block_size is 0"),
        (lambda: ag.Solver(np.ma.masked_equal(VERTICES, 3), FACES), r"vertices are masked at \[3, 0"),
        (lambda: ag.Solver(VERTICES, np.ma.masked_equal(FACES, 1)), r"faces are masked at \[0, 1\]"),
        (lambda: ag.compute_gdist(VERTICES, FACES, [0], [99]), "target 0 is vertex 99"),
    ],
)
def test_calls_that_cannot_be_right(call, message):
    with pytest.raises(ValueError, match=message):
        call()
    assert SOLVER.distances(0)[0] == 0  # it can still be used


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: ag.Solver(VERTICES, FACES, "0.1"), "epsilon is '0.1'; it must be a number"),
        (lambda: ag.Solver(VERTICES, FACES, True), "epsilon is True; it must be a number"),
        (lambda: ag.Solver(VERTICES, FACES, threads=1.5), "threads is 1.5; it must be an integer"),
        (lambda: SOLVER.distances(0, max_distance="1"), "max_distance is '1'; it must be a number"),
        (lambda: SOLVER.distance_matrix([0], k=2.5), "k is 2.5; it must be an integer"),
        (lambda: SOLVER.farthest_points(2.5), "number of points is 2.5; it must be an integer"),
        (lambda: SOLVER.farthest_points(True), "number of points is True; it must be an integer"),
        (lambda: SOLVER.distance_matrix([0], k=True), "k is True; it must be an integer"),
        (lambda: ag.Solver(VERTICES, FACES, np.bool_(True)), "epsilon is .*True.*must be a number"),
        (lambda: SOLVER.iter_blocks([0], [0], symmetric=True), "symmetric"),
        (lambda: ag.Solver(VERTICES, FACES, costs=ag.DirectionalCost()), "classes derived"),
    ],
)
def test_types_that_cannot_be_right(call, message):
    with pytest.raises(TypeError, match=message):
        call()


@pytest.mark.parametrize(
    "call",
    [
        lambda progress: ag.Solver(VERTICES, FACES, progress=progress),
        lambda progress: SOLVER.distances(0, progress=progress),
        lambda progress: SOLVER.distance_matrix([0], progress=progress),
        lambda progress: SOLVER.voronoi(0, progress=progress),
        lambda progress: SOLVER.farthest_points(1, progress=progress),
    ],
)
def test_progress_that_cannot_be_called(call):
    with pytest.raises(TypeError, match="progress is 5; it must be callable"):
        call(5)


def test_want_of_scipy_is_told_before_the_run(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.sparse", None)
    assert SOLVER.distance_matrix([0]).shape == (1, 16)
    for options in ({"max_distance": 1}, {"k": 2}):
        with pytest.raises(ImportError, match="which need SciPy"):
            SOLVER.distance_matrix([0], progress=lambda *numbers: 1 / 0, **options)


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


def test_a_folder_may_not_be_written_to(tmp_path, monkeypatch):
    def refuse(name, *arguments):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), name)

    file = tmp_path / "solver.bin"
    file.write_text("what was there")
    monkeypatch.setattr(os, "open", refuse)
    reason = re.escape(f"Permission denied; no file can be created in {tmp_path}: '{file}'")
    with pytest.raises(PermissionError, match=reason):
        SOLVER.save(file)
    assert file.read_text() == "what was there"


def test_a_file_is_replaced_when_the_new_one_is_complete(tmp_path):
    file, link = tmp_path / "solver.bin", tmp_path / "link.bin"
    file.write_text("what was there")
    file.chmod(0o640)
    link.symlink_to(file)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))  # bytes
    try:
        with pytest.raises(OSError, match="File too large: '.*link.bin'$"):
            SOLVER.save(link)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert file.read_text() == "what was there"
    assert sorted(tmp_path.iterdir()) == [link, file]
    SOLVER.save(link)
    assert link.is_symlink() and file.stat().st_mode & 0o777 == 0o640
    assert sorted(tmp_path.iterdir()) == [link, file]
    assert ag.Solver.load(file).number_of_vertices == 16


def test_devices_are_not_replaced():
    with pytest.raises(OSError, match="No space left on device: '/dev/full'$"):
        SOLVER.save("/dev/full")
    SOLVER.save("/dev/null")
    to_read, to_write = os.pipe()
    SOLVER.save(f"/dev/fd/{to_write}")
    os.close(to_write)
    with open(to_read, "rb") as pipe:
        assert pipe.read() == SOLVER.__getstate__()[0]


@pytest.mark.parametrize("name, contents, message", [
    ("empty.off", "", "it is empty"),
    ("short.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "it ends after 1 of 2 faces"),
    ("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: face 0 has vertex 3"),
    ("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "face 0 of .* has 4 vertices"),
    ("mesh.xyz", "0 0 0\n", "its file name extension must be"),
])
def test_files_that_hold_no_mesh(tmp_path, name, contents, message):
    (tmp_path / name).write_text(contents)
    with pytest.raises(ValueError, match=message):
        ag.read_mesh(tmp_path / name)


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
