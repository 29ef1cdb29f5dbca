import inspect

import numpy as np
import pytest
import scipy.sparse

import approximate_geodesics as ag
import approximate_geodesics.potpourri3d as pp3d
import approximate_geodesics.pygeodesic as geodesic
from meshes import great_circles, grid, sphere

VERTICES, FACES = sphere(3)
EXACT = ag.Solver(VERTICES, FACES, 0)


def test_arguments_are_those_of_gdist():
    def positional(function):
        parameters = inspect.signature(function).parameters.values()
        return [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD]

    mesh, ends = ["vertices", "triangles"], ["max_distance", "is_one_indexed"]
    assert positional(ag.local_gdist_matrix) == mesh + ends
    assert positional(ag.compute_gdist) == mesh + ["source_indices", "target_indices"] + ends


def test_distances_of_targets_are_exact():
    sources, targets = np.array([1, 500], dtype=np.int32), np.array([3, 77, 3], dtype=np.int32)
    distances = ag.compute_gdist(VERTICES, FACES, sources, targets)
    np.testing.assert_array_equal(distances, EXACT.distances(sources)[targets])
    np.testing.assert_array_equal(ag.compute_gdist(VERTICES, FACES), EXACT.distances(0))
    np.testing.assert_array_equal(
        ag.compute_gdist(VERTICES, FACES + 1, sources, targets, is_one_indexed=True), distances
    )
    assert np.isinf(ag.compute_gdist(VERTICES, FACES, [0], [3], max_distance=0.1)[0])


@pytest.mark.parametrize("epsilon, error", [(0, 1e-12), (0.1, 0.1)])
def test_distances_within_a_radius(epsilon, error):
    matrix = ag.local_gdist_matrix(VERTICES, FACES, 0.5, epsilon=epsilon)
    assert isinstance(matrix, scipy.sparse.csc_matrix) and matrix.dtype == np.float64
    for v in (0, 100, 641):
        exact = EXACT.distances(v)
        row = matrix[:, v].toarray()[:, 0]
        stored = row > 0
        assert not stored[v]
        np.testing.assert_allclose(row[stored], exact[stored], rtol=error)
        others = exact * (1 + error) < 0.5
        others[v] = False
        assert np.all(stored[others]) and np.all(exact[stored] <= 0.5)


def test_mean_error_by_default_is_small():
    matrix = ag.local_gdist_matrix(VERTICES, FACES, 0.6)
    exact = ag.local_gdist_matrix(VERTICES, FACES, 0.6, epsilon=0)
    both = matrix.multiply(exact > 0)
    errors = (both.data - exact.multiply(matrix > 0).data) / both.data
    assert 0 <= errors.mean() < 0.001


def test_names_are_those_of_potpourri3d():
    solver = pp3d.MeshHeatMethodDistanceSolver(VERTICES, FACES)
    np.testing.assert_allclose(
        solver.compute_distance(7), great_circles(VERTICES, 7), rtol=0.1, atol=1e-7
    )
    np.testing.assert_array_equal(
        solver.compute_distance_multisource(v_inds=[1, 2]),
        np.minimum(solver.compute_distance(1), solver.compute_distance(2)),
    )
    np.testing.assert_array_equal(
        pp3d.compute_distance(VERTICES, FACES, 7), solver.compute_distance(7)
    )
    np.testing.assert_array_equal(
        pp3d.compute_distance_multisource(VERTICES, FACES, [1, 2]),
        solver.compute_distance_multisource([1, 2]),
    )


def test_paths_between_two_vertices():
    solver = pp3d.EdgeFlipGeodesicSolver(VERTICES, FACES)
    points = solver.find_geodesic_path(v_start=14, v_end=300)
    np.testing.assert_array_equal(points[[0, -1]], VERTICES[[14, 300]])
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    np.testing.assert_allclose(length, EXACT.distances(14)[300], rtol=1e-3)
    same = pp3d.EdgeFlipGeodesicSolver(VERTICES, FACES, t_coef=2.0)
    np.testing.assert_array_equal(same.find_geodesic_path(14, 300, max_iterations=3), points)


def test_paths_through_several_vertices():
    solver = pp3d.EdgeFlipGeodesicSolver(VERTICES, FACES)
    points = solver.find_geodesic_path_poly(v_list=[14, 300, 7])
    np.testing.assert_array_equal(points[[0, -1]], VERTICES[[14, 7]])
    flat, triangles = grid(9)
    plane = pp3d.EdgeFlipGeodesicSolver(flat, triangles)
    points = plane.find_geodesic_path_poly([0, 34, 60, 80])  # between them, it gets straight
    np.testing.assert_allclose(points[:, 0], points[:, 1], atol=1e-12)
    in_hole = np.all(np.isin(triangles, [30, 31, 32, 39, 40, 41]), axis=1)
    around = pp3d.EdgeFlipGeodesicSolver(flat, triangles[~in_hole])
    for middle, corner in ((6, 32), (78, 39)):  # and stays on its side of a hole
        points = around.find_geodesic_path_poly([27, middle, 44])
        assert flat[corner].tolist() in points.tolist()
        length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        assert length == pytest.approx(5 + 10**0.5)
    with pytest.raises(ValueError, match="1 vertices"):
        solver.find_geodesic_path_poly([14])


def test_faces_are_named_as_they_are_numbered():
    for wrong in (0, 643):
        faces = FACES + 1
        faces[7, 2] = wrong
        with pytest.raises(ValueError, match=f"face 7 has vertex {wrong}; .* from 1, .* are 642"):
            ag.local_gdist_matrix(VERTICES, faces, 0.5, is_one_indexed=True)


def test_local_matrices_are_symmetric():
    x, y = np.meshgrid(np.arange(30.0), np.arange(30.0))
    vertices = np.stack([x, y, np.sin(x / 3) + np.cos(y / 2)], axis=-1).reshape(-1, 3)
    corner = (np.arange(29)[:, None] * 30 + np.arange(29)).ravel()
    faces = np.concatenate(
        [
            np.stack([corner, corner + 1, corner + 31], axis=-1),
            np.stack([corner, corner + 31, corner + 30], axis=-1),
        ]
    )
    for epsilon in (0.05, 0):
        matrix = ag.local_gdist_matrix(vertices, faces, 4.5, epsilon=epsilon)
        difference = abs(matrix - matrix.T)
        assert matrix.nnz > 10 * len(vertices)
        assert difference.nnz == 0
        # distances of the radius itself, which rounding errors of one direction would leave out
        turn, _ = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))
        flat, triangles = grid(20)
        matrix = ag.local_gdist_matrix(flat @ turn.T, triangles, 5, epsilon=epsilon)
        assert abs(matrix - matrix.T).nnz == 0 and matrix.has_sorted_indices


def test_names_are_those_of_pygeodesic():
    algorithm = geodesic.PyGeodesicAlgorithmExact(VERTICES, FACES)
    length, path = algorithm.geodesicDistance(14, 300)
    np.testing.assert_array_equal(path[[0, -1]], VERTICES[[300, 14]])  # from the target
    assert length == pytest.approx(EXACT.distances(14)[300])
    assert np.linalg.norm(np.diff(path, axis=0), axis=1).sum() == pytest.approx(length)
    distances, best_source = algorithm.geodesicDistances()
    np.testing.assert_array_equal(distances, EXACT.distances(0))
    assert distances.dtype == np.float64 and best_source.dtype == np.int32
    assert not best_source.any()
    sources, targets = np.array([3, 500]), [7, 500, 7]
    distances, best_source = algorithm.geodesicDistances(sources, targets)
    expected, nearest = EXACT.distances(sources, return_nearest=True)
    np.testing.assert_array_equal(distances, expected[targets])
    np.testing.assert_array_equal(best_source, nearest[targets])
    near = algorithm.geodesicDistances([3], max_distance=0.3)
    np.testing.assert_array_equal(np.isinf(near[0]), EXACT.distances(3) > 0.3)
    np.testing.assert_array_equal(near[1] == -1, np.isinf(near[0]))


def test_paths_of_pygeodesic_have_each_point_once():
    vertices, faces = grid(9)
    algorithm = geodesic.PyGeodesicAlgorithmExact(vertices * 0.1, faces[:, [1, 2, 0]])
    for target in (80, 72, 40, 8, 1, 0):
        length, path = algorithm.geodesicDistance(0, target)
        steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
        assert np.all(steps > 1e-9) and steps.sum() == pytest.approx(length)
        np.testing.assert_array_equal(path[[0, -1]], 0.1 * vertices[[target, 0]])
    same = geodesic.PyGeodesicAlgorithmExact(np.zeros((3, 3)), [(0, 1, 2)])
    assert same.geodesicDistance(0, 1)[1].shape == (2, 3)
    far = geodesic.PyGeodesicAlgorithmExact(np.eye(3).repeat(2, axis=0), [(0, 2, 4), (1, 5, 3)])
    length, path = far.geodesicDistance(0, 1)
    assert np.isinf(length) and path.shape == (0, 3)


def test_errors_of_pygeodesic_are_exceptions():
    algorithm = geodesic.PyGeodesicAlgorithmExact(VERTICES, FACES)
    for call, message in [
        (lambda: geodesic.PyGeodesicAlgorithmExact(VERTICES, FACES + 1), "has vertex 642"),
        (lambda: algorithm.geodesicDistance(0, 642), "target is vertex 642"),
        (lambda: algorithm.geodesicDistance(1.7, 0), "source 1.7 is not a vertex"),
        (lambda: algorithm.geodesicDistance(0, "3"), "target '3' is not a point"),
        (lambda: algorithm.geodesicDistances([642]), "source 0 is vertex 642"),
        (lambda: algorithm.geodesicDistances(None, [-1]), "target 0 is vertex -1"),
    ]:
        with pytest.raises(ValueError, match=message):
            call()


def test_files_of_pygeodesic_are_read(tmp_path):
    file = tmp_path / "mesh.txt"
    file.write_text("4 2\n0 0 0\n1 0 0\n1 1e0 0\n0\t1 0\n0 1 2\n0 2 3\n")
    points, faces = geodesic.read_mesh_from_file(file)
    np.testing.assert_array_equal(points, [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    np.testing.assert_array_equal(faces, [[0, 1, 2], [0, 2, 3]])
    for contents in ("", "4 2\n0 0 0\n", "a b", "1 1\n0 0 0\n0 0 0.5\n", "-1 0"):
        file.write_text(contents)
        with pytest.raises(ValueError, match="mesh.txt has no mesh"):
            geodesic.read_mesh_from_file(file)
    for contents, message in [
        ("3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 18446744073709551616\n", "contain 18446744073709551616"),
        ("1 1\n0 0 0\n0 0 9223372036854775808\n", "contain 9223372036854775808"),
        ("1 1\n0 0 0\n0 0 0\n7\n", "9 numbers.* 1 points and 1 faces take 8"),
        ("1 9223372036854775808\n0 0 0\n", "1 points and 9223372036854775808 faces take"),
    ]:
        file.write_text(contents)
        with pytest.raises(ValueError, match=f"mesh.txt has no mesh: .*{message}"):
            geodesic.read_mesh_from_file(file)
    with pytest.raises(FileNotFoundError):
        geodesic.read_mesh_from_file(tmp_path / "none.txt")


def test_faces_of_drop_ins_may_have_any_orientation():
    two = np.concatenate([FACES, FACES + len(VERTICES)])
    vertices = np.concatenate([VERTICES, VERTICES + 5])
    turned = two.copy()
    turned[::3] = turned[::3, ::-1]
    with pytest.raises(ValueError, match="same orientation"):
        ag.Solver(vertices, turned)
    algorithm = geodesic.PyGeodesicAlgorithmExact(vertices, turned)
    expected = ag.Solver(vertices, two, 0).distances([7, 800])
    np.testing.assert_allclose(algorithm.geodesicDistances([7, 800])[0], expected, rtol=1e-12)
    np.testing.assert_allclose(
        ag.compute_gdist(vertices, turned, [7, 800]), expected, rtol=1e-12
    )
    one_side = [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 0, 4), (4, 0, 1)]  # a Moebius strip
    corners = np.random.default_rng(1).normal(size=(5, 3))
    messages = []
    for make in (geodesic.PyGeodesicAlgorithmExact, ag.Solver):
        with pytest.raises(ValueError, match="same orientation") as error:
            make(corners, one_side)
        messages.append(str(error.value))
    assert messages[0] == messages[1]  # of the faces as they were
