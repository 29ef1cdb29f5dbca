import numpy as np
import pytest

import approximate_geodesics as ag
import approximate_geodesics.potpourri3d as pp3d
from meshes import great_circles, grid, sphere, torus

SPHERE = ag.Solver(*sphere(3))
PLANE = ag.Solver(*grid(9))
TORUS = ag.Solver(*torus(24, 15))
INNER = 48 * (3 + np.cos(14 * np.pi / 15)) * np.sin(np.pi / 24)  # the polygon around the hole


def length_of(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def test_walks_are_straight_in_a_plane():
    points = PLANE.trace(10, [3, 4, 0])
    np.testing.assert_allclose(points[-1], PLANE.vertices[10] + [3, 4, 0], atol=1e-12)
    points, direction, length = PLANE.trace(((10, 11), 0.25), [0, 1, 0], 100, return_end=True)
    assert length == pytest.approx(7) and points[-1] == pytest.approx([1.25, 8, 0])
    np.testing.assert_allclose(direction, [0, 1, 0], atol=1e-12)


def test_logarithms_lead_back():
    vectors = SPHERE.logarithmic_map(17)
    assert vectors.shape == (642, 2) and vectors.dtype == np.float64
    lengths = np.linalg.norm(vectors, axis=1)
    np.testing.assert_allclose(lengths, great_circles(SPHERE.vertices, 17), rtol=0.02, atol=1e-7)
    ends = [SPHERE.trace(17, v)[-1] for v in vectors[lengths > 0]]
    gaps = np.linalg.norm(ends - SPHERE.vertices[lengths > 0], axis=1)
    assert np.mean(gaps < 1e-9) > 0.9


def test_frames_are_orthonormal():
    frames = np.stack(SPHERE.tangent_frames(), axis=1)
    products = frames @ frames.transpose(0, 2, 1)
    np.testing.assert_allclose(products, np.broadcast_to(np.eye(3), (642, 3, 3)), atol=1e-12)
    assert np.all(np.sum(frames[:, 2] * SPHERE.vertices, axis=1) > 0.99)


def test_vectors_are_transported():
    target = (40, [0.2, 0.3, 0.5])
    vector = PLANE.parallel_transport(10, target, [3, 4, 0])
    np.testing.assert_allclose(vector, [3, 4, 0], atol=1e-12)
    tangent = PLANE.parallel_transport(10, target, [3, 4])
    assert tangent.shape == (2,) and np.linalg.norm(tangent) == pytest.approx(5)


def in_space(vectors, frames):
    return vectors[:, :1] * frames[0] + vectors[:, 1:] * frames[1]


def test_vectors_of_the_nearest_point_are_extended():
    points, vectors = [7, 200], np.array([[3.0, 4.0], [0.0, -1.0]])
    extended = TORUS.extend_vectors(points, vectors)
    nearest = ag.Solver(TORUS.vertices, TORUS.faces, 0).distances(points, return_nearest=True)[1]
    for v in range(0, 360, 11):
        source = nearest[v]
        expected = TORUS.parallel_transport(points[source], v, vectors[source])
        np.testing.assert_allclose(extended[v], expected, atol=1e-9)
    frames, inner = PLANE.tangent_frames(), [10, 16, 40, 70]
    start = in_space(np.array([[3.0, 4.0]]), [axes[10] for axes in frames])
    carried = in_space(PLANE.extend_vectors([10], [[3, 4]]), frames)
    np.testing.assert_allclose(carried[inner], start.repeat(4, axis=0), atol=1e-12)


def test_means():
    assert PLANE.karcher_mean([0, 8]) == 4
    mean, deviation = PLANE.karcher_mean([0, 8], [1, 3], return_deviation=True)
    assert mean == 6 and deviation == pytest.approx(12**0.5)


def test_loops():
    outer = np.arange(0, 360, 30)
    loop, length = TORUS.shorten_loop(outer, return_length=True)
    assert length == pytest.approx(INNER) and length_of(loop) == pytest.approx(INNER)
    np.testing.assert_array_equal(loop[0], loop[-1])
    assert SPHERE.shorten_loop([0, 100, 200]).shape == (1, 3)
    through, length = TORUS.shortest_loop_through(7, return_length=True)
    np.testing.assert_array_equal(through[[0, -1]], TORUS.vertices[[7, 7]])
    assert length <= 30 * np.sin(np.pi / 15) + 1e-12
    assert SPHERE.shortest_loop_through(0, return_length=True)[1] == np.inf
    assert SPHERE.shortest_loop_through(0).shape == (0, 3)


def test_names_are_those_of_potpourri3d():
    loop = pp3d.EdgeFlipGeodesicSolver(*torus(24, 15)).find_geodesic_loop(np.arange(0, 360, 30))
    assert length_of(loop) == pytest.approx(INNER)
    vertices, faces = grid(9)
    tracer = pp3d.GeodesicTracer(vertices, faces)
    points = tracer.trace_geodesic_from_vertex(10, np.array([3, 4, 0]))
    np.testing.assert_allclose(points[-1], vertices[10] + [3, 4, 0], atol=1e-12)
    points = tracer.trace_geodesic_from_face(0, [0.5, 0.25, 0.25], [2, 1, 0], max_iterations=99)
    np.testing.assert_allclose(points[-1] - points[0], [2, 1, 0], atol=1e-12)
    points = tracer.trace_geodesic_from_vertex(10, [3, 4, 7])  # the part along the surface counts
    np.testing.assert_allclose(points[-1], vertices[10] + [3, 4, 0], atol=1e-12)
    points = tracer.trace_geodesic_from_face(0, [0.5, 0.25, 0.25], [2, 1, -7])
    np.testing.assert_allclose(points[-1] - points[0], [2, 1, 0], atol=1e-12)
    solver = pp3d.MeshVectorHeatSolver(*sphere(3))
    logarithms = solver.compute_log_map(17)
    np.testing.assert_array_equal(logarithms, SPHERE.logarithmic_map(17))
    x, y, _ = solver.get_tangent_frames()
    steps = logarithms[:, :1] * x[17] + logarithms[:, 1:] * y[17]  # near the vertex
    near = np.flatnonzero(np.linalg.norm(steps, axis=1) < 0.3)
    assert len(near) > 5
    gaps = np.linalg.norm(SPHERE.vertices[17] + steps[near] - SPHERE.vertices[near], axis=1)
    assert np.all(gaps < 0.06)


def test_vector_heat_solvers_extend_from_the_nearest_vertex():
    vertices, faces = sphere(3)
    apart = np.concatenate([vertices, [[9, 9, 9]]])  # a vertex in no face
    solver = pp3d.MeshVectorHeatSolver(apart, faces, use_intrinsic_delaunay=False)
    values = solver.extend_scalar([12, 17], [3.0, 4.0])
    assert values[12] == 3 and values[17] == 4 and values[-1] == 0
    nearer = great_circles(vertices, 12) - great_circles(vertices, 17)
    clear = np.abs(nearer) > 0.1
    np.testing.assert_array_equal(values[:-1][clear], np.where(nearer < 0, 3, 4)[clear])
    one = solver.transport_tangent_vector(17, [6.0, 6.0])
    np.testing.assert_array_equal(one[:-1], SPHERE.extend_vectors([17], [[6, 6]]))
    np.testing.assert_allclose(one[[17, -1]], [[6, 6], [0, 0]], rtol=1e-14)
    two = solver.transport_tangent_vectors([12, 17], [[1, 0], [6, 6]])
    np.testing.assert_array_equal(two[:-1][nearer > 0.1], one[:-1][nearer > 0.1])


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="start is vertex 999"):
        PLANE.trace(999, [1, 0, 0])
    with pytest.raises(ValueError, match="direction"):
        PLANE.trace(0, [1, 0, 0, 0])
    with pytest.raises(ValueError, match="the direction has no part along the surface"):
        PLANE.trace(10, [0, 0, 1])
    with pytest.raises(ValueError, match="length is -1"):
        PLANE.trace(10, [1, 0, 0], -1)
    with pytest.raises(ValueError, match="point 1 is vertex 99"):
        PLANE.shorten_loop([0, 99])
    with pytest.raises(ValueError, match="at least 2"):
        pp3d.EdgeFlipGeodesicSolver(*grid(3)).find_geodesic_loop([1])
    with pytest.raises(ValueError, match="weights"):
        PLANE.karcher_mean([0, 8], [1])
    with pytest.raises(ValueError, match=r"vectors must have the shape \(2, 2\)"):
        PLANE.extend_vectors([0, 8], [[1, 0]])
    with pytest.raises(ValueError, match="vector 1 is nan"):
        PLANE.extend_vectors([0, 8], [[1, 0], [np.nan, 0]])
    solver = pp3d.MeshVectorHeatSolver(*grid(3))
    with pytest.raises(ValueError, match="values must have the shape"):
        solver.extend_scalar([0, 8], [1.0])
    with pytest.raises(ValueError, match="vertex 99"):
        solver.transport_tangent_vector(99, [1, 0])
