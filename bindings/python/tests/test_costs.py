"""Costs that depend on the direction."""

import pickle

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid

VERTICES, FACES = grid(9)
SIZE = len(FACES)


def slope(rise):
    """The grid, rising in the direction of x."""
    vertices = VERTICES.copy()
    vertices[:, 2] = rise * vertices[:, 0]
    return vertices


def everywhere(vector):
    return np.tile(vector, (SIZE, 1))


def seconds_per_meter(rise):
    return 0.6 * np.exp(3.5 * np.abs(rise + 0.05))


def test_hiking_takes_the_time_of_the_slope():
    solver = ag.Solver(slope(0.1), FACES, 0.1, costs=ag.HikingTime())
    length = 8 * np.hypot(1, 0.1)
    up, down = solver.distances(0)[8], solver.distances(8)[0]
    assert up == pytest.approx(length * seconds_per_meter(0.1), rel=1e-6)
    assert down == pytest.approx(length * seconds_per_meter(-0.1), rel=1e-6)
    off_paths = ag.Solver(slope(0.1), FACES, 0.1, costs=ag.HikingTime(factor=0.5))
    assert off_paths.distances(0)[8] == pytest.approx(2 * up)
    assert solver.error_bound == pytest.approx(0.1)


def test_distances_to_the_sources():
    solver = ag.Solver(slope(0.1), FACES, 0.2, costs=ag.HikingTime())
    to_first = solver.distances(0, direction_to_source=True)
    np.testing.assert_allclose(to_first, solver.distance_matrix(range(81), [0])[:, 0], rtol=1e-6)
    assert np.all(to_first[1:9] < solver.distances(0)[1:9])  # downhill
    row = solver.distance_matrix([0], direction_to_source=True)[0]
    np.testing.assert_array_equal(row, to_first)
    cells = solver.voronoi([0, 8]), solver.voronoi([0, 8], direction_to_source=True)
    assert np.count_nonzero(cells[0] == 0) < np.count_nonzero(cells[1] == 0)


def test_walking_uphill_takes_more_energy():
    solver = ag.Solver(slope(0.2), FACES, 0.2, costs=ag.WalkingEnergy(), accept_weaker_bound=True)
    assert solver.distances(0)[8] > 2 * solver.distances(8)[0]


def test_drift_takes_along():
    solver = ag.Solver(VERTICES, FACES, 0.1, costs=ag.DriftTime(everywhere((1, 0, 0)), speed=3))
    assert solver.distances(0)[8] == pytest.approx(8 / 4)
    assert solver.distances(8)[0] == pytest.approx(8 / 2)


def test_one_way_faces():
    solver = ag.Solver(VERTICES, FACES, costs=ag.OneWay(everywhere((1, 0, 0)), cost=2))
    assert solver.distances(0)[8] == pytest.approx(16)
    assert np.isinf(solver.distances(8)[0])
    with pytest.raises(ValueError, match="free or forbidden.*accept_weaker_bound"):
        ag.Solver(VERTICES, FACES, 0.1, costs=ag.OneWay(everywhere((1, 0, 0))))
    weaker = ag.Solver(
        VERTICES, FACES, 0.1, costs=ag.OneWay(everywhere((1, 0, 0))), accept_weaker_bound=True
    )
    assert np.isinf(weaker.error_bound)


def test_number_of_points_is_limited():
    def solver(**options):
        return ag.Solver(VERTICES, FACES, 0.01, face_weights=np.arange(len(FACES)), **options)

    with pytest.raises(ValueError, match="points on edges, .* maximum_number_of_points is 100"):
        solver(maximum_number_of_points=100)
    assert solver(maximum_number_of_points=10**6).error_bound == 0.01
    weaker = solver(maximum_number_of_points=1000, accept_weaker_bound=True)
    assert weaker.error_bound > 0.01
    with pytest.raises(ValueError, match="must be at least 1"):
        solver(maximum_number_of_points=0)


def test_tensors():
    matrix = np.array([[4.0, 0.5, 0], [0.5, 1, 0], [0, 0, 1]])
    entries = matrix[np.triu_indices(3)]
    solvers = [
        ag.Solver(VERTICES, FACES, 0.1, costs=ag.TensorCost(np.broadcast_to(t, (SIZE, *t.shape))))
        for t in (matrix, entries)
    ]
    distances = [solver.distances(0) for solver in solvers]
    np.testing.assert_array_equal(*distances)
    turn, _ = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))
    rounded = turn @ np.diag([4.0, 1, 1]) @ turn.T  # not symmetric to the last bit
    rounded[0, 1] += 1e-12
    for kind in (np.float64, np.float32):
        ag.Solver(VERTICES, FACES, 0.1, costs=ag.TensorCost(np.array([rounded] * SIZE, kind)))
    expected = np.sqrt(np.einsum("ni,ij,nj->n", VERTICES, matrix, VERTICES))
    assert np.all(distances[0] >= expected * (1 - 1e-9))
    assert np.all(distances[0] <= expected * 1.1)


@pytest.mark.parametrize(
    "costs, options",
    [
        (ag.HikingTime(0.6), {}),
        (ag.WalkingEnergy(), {"epsilon": 0.3, "accept_weaker_bound": True}),
        (ag.DriftTime(everywhere((0.5, 0.1, 0)), 2), {"epsilon": 0.2}),
        (ag.OneWay(everywhere((1, 1, 0)), 1, -0.5), {"barriers": FACES[:1, :2]}),
        (ag.TensorCost(everywhere((1, 0, 0, 2, 0, 1))), {"epsilon": 0.2, "threads": 1}),
        (ag.CostFunction(lambda faces, ways: 2 + ways[:, 0]), {"epsilon": 0.2}),
    ],
    ids=lambda value: type(value).__name__,
)
def test_copies_of_solvers_are_the_same(costs, options, tmp_path):
    solver = ag.Solver(slope(0.1), FACES, costs=costs, **options)
    solver.save(tmp_path / "solver.bin")
    for copy in (pickle.loads(pickle.dumps(solver)), ag.Solver.load(tmp_path / "solver.bin")):
        assert repr(copy) == repr(solver)
        assert copy.error_bound == solver.error_bound
        np.testing.assert_array_equal(copy.distances([1, 7]), solver.distances([1, 7]))
        np.testing.assert_array_equal(copy.path(3, 70), solver.path(3, 70))


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: ag.HikingTime(0), "factor of hiking speeds is 0"),
        (lambda: ag.DriftTime(everywhere((1, 0, 0)), -1), "speed through the drift is -1"),
        (lambda: ag.DriftTime(np.ones((5, 3)), 2), "velocities are those of 5 faces.* has 128"),
        (lambda: ag.DriftTime(np.ones((SIZE, 2)), 2), r"velocities must have the shape \(any, 3\)"),
        (lambda: ag.OneWay(everywhere((1, np.nan, 0))), "face 0 has the number nan"),
        (lambda: ag.OneWay(everywhere((1, 0, 0)), -1), "cost of one-way faces is -1"),
        (lambda: ag.OneWay(everywhere((1, 0, 0)), 1, 2), "smallest cosine is 2"),
        (lambda: ag.TensorCost(everywhere((-1, 0, 0, 1, 0, 1))), "face with vertices .* cost"),
        (lambda: ag.TensorCost(np.arange(9.0).reshape(1, 3, 3)), "face 0 is not symmetric"),
        (lambda: ag.TensorCost(np.ones((4, 5))), r"tensors must have the shape \(any, 6\)"),
    ],
)
def test_costs_that_cannot_be_right(make, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver(VERTICES, FACES, 0.5, costs=make())


def test_costs_do_not_change_with_the_array():
    velocities = everywhere((0.5, 0.1, 0))
    costs = ag.DriftTime(velocities, 2)
    expected = ag.Solver(VERTICES, FACES, 0.5, costs=costs).distances(0)
    velocities *= -1
    np.testing.assert_array_equal(
        ag.Solver(VERTICES, FACES, 0.5, costs=costs).distances(0), expected
    )


def test_parameters_that_do_not_go_with_costs():
    for options, message in [
        ({"epsilon": 0}, "no exact distances"),
        ({"face_weights": np.ones(SIZE)}, "only one of them"),
    ]:
        with pytest.raises(ValueError, match=message):
            ag.Solver(VERTICES, FACES, costs=ag.HikingTime(), **options)
    with pytest.raises(TypeError, match="costs are of type int"):
        ag.Solver(VERTICES, FACES, costs=7)
    solver = ag.Solver(VERTICES, FACES, 0.5, costs=ag.HikingTime())
    with pytest.raises(ValueError, match="cannot be straightened"):
        solver.path(0, 80, straighten=True)
    with pytest.raises(ValueError, match="symmetric: costs depend on the direction"):
        solver.distance_matrix([0, 1], [0, 1], symmetric=True)


def test_slopes_are_limited():
    size, steepness, limit = 9, 0.5, 0.3
    vertices, faces = grid(size)
    vertices[:, 2] = steepness * vertices[:, 1]
    height = steepness * (size - 1)
    for options in ({}, {"face_weights": np.ones(len(faces))}, {"costs": lambda f, d: np.ones(len(d))}):
        options = {"epsilon": 0.1, "accept_weaker_bound": True, **options}
        free = ag.Solver(vertices, faces, **options)
        solver = ag.Solver(vertices, faces, max_slope=limit, **options)
        assert "max_slope=0.3" in repr(solver) and "max_slope" not in repr(free)
        assert solver.error_bound == np.inf
        assert free.distances(4)[-5] == pytest.approx(np.hypot(height, size - 1), rel=1e-2)
        least = height * np.hypot(1, limit) / limit
        assert least * (1 - 1e-9) < solver.distances(4)[-5] < 1.1 * least
        steps = np.diff(solver.path(4, size * size - 5), axis=0)
        run = np.hypot(steps[:, 0], steps[:, 1])
        assert np.all(np.abs(steps[:, 2]) <= limit * run * (1 + 1e-9))
        assert len(steps) > 3
        copy = pickle.loads(pickle.dumps(solver))
        np.testing.assert_array_equal(copy.distances(4), solver.distances(4))
    with pytest.raises(ValueError, match="steeper than max_slope.*accept_weaker_bound"):
        ag.Solver(vertices, faces, 0.1, max_slope=limit)
    for wrong in (-1, np.nan):
        with pytest.raises(ValueError, match="max_slope is .*; it must be a number that is not negative"):
            ag.Solver(vertices, faces, max_slope=wrong)
    for options in ({"max_slope": limit}, {"costs": ag.HikingTime()}):
        with pytest.raises(ValueError, match=f"may_change: with {list(options)[0]}, neither"):
            ag.Solver(vertices, faces, 0.1, may_change=True, accept_weaker_bound=True, **options)


def test_free_faces_are_crossed_straight_on():
    vertices, faces = grid(20)
    weights = np.ones(len(faces))
    middle = vertices[faces].mean(axis=1)[:, 1]
    weights[(middle > 6) & (middle < 13)] = 0
    ends = (3 * 20, 3 * 20 + 19)
    for free in (np.zeros(len(faces)), weights):
        solver = ag.Solver(vertices, faces, 0.3, face_weights=free)
        path, cost = solver.path(*ends, return_length=True)
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        assert cost <= 6 * 1.3
        assert length <= 1.3 * (19 if free is not weights else 25)


def test_what_costs_look_like():
    assert repr(ag.HikingTime(0.6)) == "HikingTime(0.6)"
    assert repr(ag.OneWay(np.ones((2, 3)))) == "OneWay(<ways of 2 faces>, 1, 0)"
    solver = ag.Solver(VERTICES, FACES, 0.5, costs=ag.HikingTime())
    assert repr(solver).endswith("epsilon=0.5, with hiking time>")


class Recorded:
    """A cost function that keeps what it was called with."""

    def __init__(self, function):
        self.function, self.calls = function, []

    def __call__(self, faces, directions):
        self.calls.append((faces, directions))
        return self.function(faces, directions)


def test_cost_functions_are_called_once_with_arrays():
    vertices = slope(0.3)
    function = Recorded(lambda faces, directions: np.ones(len(faces)))
    ag.Solver(vertices, FACES, 0.1, costs=function)
    ((faces, directions),) = function.calls
    assert faces.shape == (len(directions),) and faces.dtype == np.int64
    np.testing.assert_array_equal(np.unique(faces), np.arange(SIZE))
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1)
    corners = vertices[FACES]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    np.testing.assert_allclose(np.sum(directions * normals[faces], axis=1), 0, atol=1e-12)
    for side in range(3):
        way = corners[:, (side + 1) % 3] - corners[:, side]
        cosines = np.sum(directions * way[faces], axis=1) / np.linalg.norm(way, axis=1)[faces]
        assert np.all(np.isclose(cosines, 1).reshape(SIZE, -1).any(axis=1))
        assert np.all(np.isclose(cosines, -1).reshape(SIZE, -1).any(axis=1))


def test_own_costs_are_those_of_the_same_ready_ones():
    def tobler(faces, directions):
        x, y, z = directions.T
        run = np.hypot(x, y)
        return 0.6 * run * np.exp(3.5 * np.abs(z / run + 0.05))

    vertices = VERTICES.copy()
    vertices[:, 2] = 0.1 * np.sin(vertices[:, 0]) * vertices[:, 1]
    own = ag.Solver(vertices, FACES, 0.1, costs=ag.CostFunction(tobler, 64))
    ready = ag.Solver(vertices, FACES, 0.1, costs=ag.HikingTime())
    np.testing.assert_allclose(own.distances(0), ready.distances(0), rtol=0.02)
    along_edges = [ag.Solver(vertices, FACES, costs=c) for c in (tobler, ag.HikingTime())]
    np.testing.assert_allclose(*(solver.distances(0) for solver in along_edges), rtol=0.01)
    to_first = own.distances(0, direction_to_source=True)
    np.testing.assert_allclose(to_first, own.distance_matrix(range(81), [0])[:, 0], rtol=1e-6)


def test_own_costs_are_exact_along_sides():
    solver = ag.Solver(VERTICES, FACES, costs=lambda faces, ways: 3 + ways[:, 0])
    np.testing.assert_allclose(solver.distances(0)[1:9], 4 * np.arange(1, 9), rtol=1e-6)
    np.testing.assert_allclose(solver.distances(8)[:8], 2 * np.arange(8, 0, -1), rtol=1e-6)
    weights = np.arange(1.0, SIZE + 1)
    own = ag.Solver(VERTICES, FACES, 0.1, costs=lambda faces, ways: weights[faces])
    by_faces = ag.Solver(VERTICES, FACES, 0.1, face_weights=weights)
    np.testing.assert_allclose(own.distances(0), by_faces.distances(0), rtol=0.1)
    np.testing.assert_allclose(own.error_bound, 0.1)


def test_own_costs_may_forbid_directions():
    solver = ag.Solver(
        VERTICES, FACES, costs=lambda faces, ways: np.where(ways[:, 0] > -1e-9, 2, np.inf)
    )
    assert solver.distances(0)[8] == pytest.approx(16)
    assert np.isinf(solver.distances(8)[0])


@pytest.mark.parametrize("scale", [1e-160, 1, 1e150])
def test_own_costs_on_faces_without_area(scale):
    vertices = np.array([[0, 0, 0], [2, 0, 0], [1, 0, 0], [1, 3, 0], [5, 5, 5]]) * scale
    solver = ag.Solver(vertices, [(0, 2, 1), (0, 1, 3)], costs=lambda f, w: np.full(len(f), 2.0))
    assert solver.distances(0)[1] == pytest.approx(4 * scale)
    same = np.zeros((3, 3))
    assert ag.Solver(same, [(0, 1, 2)], costs=lambda f, w: np.ones(len(f))).distances(0)[1] == 0


def test_own_costs_of_an_empty_mesh():
    solver = ag.Solver(np.empty((0, 3)), np.empty((0, 3), int), costs=lambda f, w: np.ones(len(f)))
    assert solver.number_of_faces == 0


@pytest.mark.parametrize(
    "function, message",
    [
        (lambda f, w: np.where(f == 5, -1, 1), r"face 5 has the cost -1.0 in the direction \("),
        (lambda f, w: np.where(f == 5, np.nan, 1), "face 5 has the cost nan"),
        (lambda f, w: 1.0, r"costs must have the shape \(\d+,\), and have \(\)"),
        (lambda f, w: ["a"] * len(f), "costs must be real numbers"),
    ],
)
def test_own_costs_that_cannot_be_right(function, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver(VERTICES, FACES, 0.5, costs=function)


def test_cost_functions_that_cannot_be_right():
    with pytest.raises(TypeError, match="cost function is 5; it must be callable"):
        ag.CostFunction(5)
    with pytest.raises(ValueError, match="number_of_directions is 3; it must be from 4"):
        ag.CostFunction(print, 3)
    with pytest.raises(ZeroDivisionError):  # of the function itself
        ag.Solver(VERTICES, FACES, costs=lambda f, w: 1 // 0)
    wrong = np.append(FACES, [(0, 1, 999)], axis=0)
    with pytest.raises(ValueError, match="face 128 has vertex 999"):
        ag.Solver(VERTICES, wrong, costs=lambda f, w: np.ones(len(f)))
    assert "with a cost function" in repr(ag.Solver(VERTICES, FACES, costs=lambda f, w: f + 1.0))


def test_doors_and_weights_that_change():
    wall = [(4 + 9 * y, 13 + 9 * y) for y in range(8)]
    solver = ag.Solver(VERTICES, FACES, 0.1, barriers=wall, may_change=True)
    assert np.isinf(solver.distances(0)[80])
    solver.set_barriers(wall[7:], False)
    open_door = solver.distances(0)
    assert 8 * np.sqrt(2) <= open_door[80] < 8 * np.sqrt(2) * 1.1
    solver.set_weights([3, 50], [2.5, np.inf])
    weights = np.ones(SIZE)
    weights[[3, 50]] = 2.5, np.inf
    other = ag.Solver(VERTICES, FACES, 0.1, barriers=wall[:7], face_weights=weights)
    np.testing.assert_allclose(solver.distances(0), other.distances(0), rtol=0.1)
    assert solver.error_bound == pytest.approx(0.1)
    solver.set_barriers(wall, np.ones(8, bool))
    assert np.isinf(solver.distances(0)[80])
    with pytest.raises(ValueError, match="barrier"):
        solver.set_barriers([(0, 1)], False)
    for closed in ("no", 1, [0.5] * 8):
        with pytest.raises(ValueError, match="closed must be bool"):
            solver.set_barriers(wall, closed)
    with pytest.raises(ValueError, match="without face weights"):
        ag.Solver(VERTICES, FACES, 0.1).set_weights([3], [2])
