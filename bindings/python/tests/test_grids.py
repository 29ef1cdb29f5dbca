"""Rasters."""

import numpy as np
import pytest

import approximate_geodesics as ag

ROWS, COLUMNS = np.mgrid[:31, :43]


def seconds_per_meter(slope):
    return 0.6 * np.exp(3.5 * np.abs(slope + 0.05))


def test_distances_are_as_the_crow_flies():
    grid = ag.Grid(np.full((31, 43), 2), cell_size=3)
    found = grid.distances((7, 20))
    expected = 6 * np.hypot(ROWS - 7, COLUMNS - 20)
    assert found.shape == grid.shape == (31, 43)
    assert np.all(found >= expected * (1 - 1e-9))
    assert np.all(found <= expected * (1 + 1e-9 + grid.error_on_equal_cells))
    assert grid.error_on_equal_cells < 0.003


def test_cells_have_a_width_and_a_height():
    found = ag.Grid(np.ones((4, 5)), cell_size=(2, 3)).distances((0, 0))
    assert found[0, 4] == 8
    assert found[3, 0] == 9


def test_hikers_on_a_slope():
    heights = (0.2 * 10 * COLUMNS).astype(np.float32)
    length = 10 * 10 * np.hypot(1, 0.2)
    for cost in ("hiking_time", ag.HikingTime(), lambda s: seconds_per_meter(s)):
        grid = ag.Grid(heights=heights, cell_size=10, cost=cost)
        there = grid.distances((5, 12))
        back = grid.distances((5, 12), direction_to_source=True)
        assert there[5, 22] == pytest.approx(length * seconds_per_meter(0.2), rel=1e-5)
        assert there[5, 2] == pytest.approx(length * seconds_per_meter(-0.2), rel=1e-5)
        assert back[5, 22] == pytest.approx(length * seconds_per_meter(-0.2), rel=1e-5)
        assert 0 <= grid.error_of_slopes < 1e-5
    slow = ag.Grid(np.full(heights.shape, 2.0), heights=heights, cell_size=10, cost="hiking_time")
    np.testing.assert_allclose(slow.distances((5, 12)), 2 * there, rtol=1e-6)
    assert ag.Grid(heights=heights, cost="naismith_time").distances((5, 12))[5, 13] > 0
    assert ag.Grid(heights=heights, cost="walking_energy").distances((5, 12))[5, 13] > 0
    plain = ag.Grid(heights=heights, cell_size=10).distances((5, 12))
    assert plain[5, 22] == pytest.approx(length, rel=1e-6)


def test_wind_takes_along():
    cost = ag.DriftTime(np.tile([1.0, 0, 0], (31 * 43, 1)), speed=3)
    found = ag.Grid(np.ones((31, 43)), cost=cost).distances((3, 20))
    assert found[3, 28] == pytest.approx(8 / 4)
    assert found[3, 12] == pytest.approx(8 / 2)


def test_slopes_are_limited():
    heights = np.zeros((40, 40))
    heights[:, 20:] = 100  # a wall that is one cell wide
    for cost in (None, "walking_energy", lambda s: np.where(np.abs(s) <= 0.6, 1, np.inf)):
        free = ag.Grid(heights=heights, cell_size=10, cost=cost)
        grid = ag.Grid(heights=heights, cell_size=10, cost=cost, max_slope=0.6)
        assert np.isfinite(free.distances((20, 0))).all()
        found = grid.distances((20, 0))
        assert np.isfinite(found[:, :20]).all() and np.isinf(found[:, 20:]).all()
        assert len(grid.path((20, 0), (20, 39))) == 0
    ramp = ag.Grid(heights=0.5 * ROWS, max_slope=0.5)
    assert ramp.distances((0, 5))[30, 5] == pytest.approx(30 * np.hypot(1, 0.5))
    for wrong in (-1, np.nan):
        with pytest.raises(ValueError, match="max_slope is"):
            ag.Grid(heights=heights, max_slope=wrong)
    with pytest.raises(ValueError, match="max_slope is given, and there are no heights"):
        ag.Grid(heights, max_slope=0.3)


def length_of(path):
    return np.linalg.norm(np.diff(path, axis=0), axis=1).sum()


def test_free_cells_are_crossed_straight_on():
    for shape in ((60, 60), (101, 101)):
        path, cost = ag.Grid(np.zeros(shape)).path((30, 30), (45, shape[1] - 1), return_length=True)
        assert cost == 0
        assert length_of(path) <= 1.003 * np.hypot(15, shape[1] - 31)
    channel = np.full((60, 60), 100.0)
    channel[25:36, 5:55] = 0
    assert length_of(ag.Grid(channel).path((30, 6), (28, 53))) <= 1.003 * np.hypot(2, 47)
    grid = ag.Grid(np.zeros((31, 43)))
    costs, nearest, predecessors = grid.distances(
        [(3, 3), (25, 40)], return_nearest=True, return_predecessors=True
    )
    assert np.all(costs == 0)
    assert nearest[4, 9] == 0 and nearest[30, 30] == 1
    assert predecessors[3, 4] == 3 * 43 + 3


def test_paths_sources_and_predecessors():
    friction = np.ones((31, 43))
    friction[:25, 20] = np.inf
    friction[:25, 21] = np.nan
    grid = ag.Grid(friction)
    sources = [(2, 3), (2, 40)]
    costs, nearest, predecessors = grid.distances(
        sources, return_nearest=True, return_predecessors=True
    )
    assert nearest[0, 0] == 0 and nearest[0, 42] == 1 and nearest[3, 20] == -1
    assert predecessors[2, 3] == 2 * 43 + 3
    assert predecessors[3, 21] == -1
    path, length = grid.path(sources[0], sources[1], return_length=True)
    assert tuple(path[0]) == sources[0] and tuple(path[-1]) == sources[1]
    assert path[:, 0].max() >= 24.5
    assert length == pytest.approx(grid.distances(sources[0])[sources[1]])
    near = grid.distances(np.array(sources), max_distance=5)
    np.testing.assert_array_equal(near, np.where(costs <= 5, costs, np.inf))
    assert grid.path((2, 3), (3, 20)).shape == (0, 2)
    assert np.all(np.isinf(grid.distances([])))


def test_bound_with_friction():
    friction = np.where((ROWS // 3 + COLUMNS // 4) % 2 == 0, 1.0, 4.0)
    bounded = ag.Grid(friction, epsilon=0.1).distances((0, 0))
    lines = ag.Grid(friction).distances((0, 0))
    assert np.all(bounded <= lines * 1.1 + 1e-9)
    assert np.mean(bounded[1:, 1:] / lines[1:, 1:]) < 1


def test_degrees():
    grid = ag.Grid(np.ones((31, 43)), cell_size=0.01, first_latitude=60.005)
    found = grid.distances((0, 0))
    assert found[30, 0] == pytest.approx(0.3 * 111412, rel=1e-3)
    assert found[0, 1] == pytest.approx(0.01 * 55800, rel=1e-3)


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64])
def test_no_data_is_that_of_the_type(dtype):
    for no_data in (-9999.9, 1e20, -3.4028235e38):
        with np.errstate(over="ignore"):
            values = np.array([[1, 1, no_data], [1, 1, 1]]).astype(dtype)
        reached = [[True, True, False], [True, True, True]]
        for name in ("friction", "heights"):
            if name == "heights" and np.isinf(values).any():
                continue
            grid = ag.Grid(**{name: values}, no_data=no_data)
            np.testing.assert_array_equal(np.isfinite(grid.distances((0, 0))), reached)
            assert grid.isolines(values, 0.5, no_data=no_data) == []


@pytest.mark.parametrize("no_data", [None, float("nan"), -1])
@pytest.mark.parametrize("dtype", [np.int16, np.float32, np.float64])
def test_masks_hide_cells(dtype, no_data):
    mask = np.zeros((9, 9), dtype=bool)
    mask[:, 4] = True
    values = np.ma.masked_array(np.ones((9, 9), dtype=dtype), mask)
    for name in ("friction", "heights"):
        costs = ag.Grid(**{name: values}, no_data=no_data).distances((4, 0))
        assert np.isinf(costs[:, 4:]).all() and np.isfinite(costs[:, :4]).all()
    assert values.data[0, 4] == 1
    grid = ag.Grid(np.ones((9, 9)))
    assert grid.isolines(np.ma.masked_array(grid.distances((4, 0)), mask | True), 3) == []
    unhidden = np.ma.masked_array(np.ones((9, 9), dtype=dtype), False)
    assert ag.Grid(unhidden).distances((0, 0))[0, 8] == 8
    with pytest.raises(ValueError, match=r"height of cell \(0, 1\) is inf"):
        ag.Grid(heights=np.ma.masked_array([[0, np.inf, 1]], [[1, 0, 0]]), no_data=None)


def test_grids_that_go_round():
    grid = ag.Grid(np.ones((180, 360)), cell_size=1, first_latitude=90, periodic=True)
    costs = grid.distances((89, 359))
    assert costs[89, 0] == pytest.approx(111319.5, rel=1e-3)
    path = grid.path((89, 359), (89, 2))
    np.testing.assert_allclose(path[:, 1], np.arange(359, 359 + len(path)), atol=1e-9)
    (line,) = grid.isolines(costs, 1e6)
    assert np.abs(np.diff(line[:, 1])).max() <= 1
    mask = np.ones((180, 360), dtype=bool)
    mask[89, [3, 350]] = False
    islands = ag.Grid(np.ma.masked_array(np.ones(mask.shape), mask), cell_size=1, periodic=True)
    assert islands.snap((89, 359)).tolist() == [89, 3]
    for options, message in (
        ({"friction": np.ones((3, 30))}, "30 columns"),
        ({"friction": np.ones((3, 40)), "epsilon": 0.1}, "periodic"),
        ({"friction": np.ones((3, 40)), "first_latitude": 50}, "40 degrees"),
    ):
        with pytest.raises(ValueError, match=message):
            ag.Grid(periodic=True, **options)


def test_ellipsoids_of_other_bodies():
    moon = ag.Grid(np.ones((9, 9)), cell_size=0.1, first_latitude=0.45, ellipsoid=(1737400, 0))
    assert moon.distances((4, 0))[4, 8] == pytest.approx(np.radians(0.8) * 1737400)
    with pytest.raises(ValueError, match="flattening is 2"):
        ag.Grid(np.ones((9, 9)), first_latitude=0, ellipsoid=(1, 2))


def test_cells_that_cannot_be_entered_have_near_ones_that_can():
    friction = np.full((5, 9), np.inf)
    friction[3, [1, 8]] = 1
    grid = ag.Grid(friction, cell_size=(1, 10))
    assert grid.snap((0, 3)).tolist() == [3, 1]
    assert grid.snap([(3, 8), (3, 6)]).tolist() == [[3, 8], [3, 8]]
    with pytest.raises(ValueError, match=r"\(5, 0\) does not exist"):
        grid.snap((5, 0))
    with pytest.raises(ValueError, match="no cell"):
        ag.Grid(np.full((2, 2), np.inf)).snap((0, 0))


def test_messages_name_rows_first():
    friction = np.ones((4, 7))
    friction[2, 5] = -1
    with pytest.raises(ValueError, match=r"cell \(2, 5\) is -1"):
        ag.Grid(friction)
    with pytest.raises(ValueError, match=r"cell \(9, 3\) does not exist: there are 7 columns and 4 rows"):
        ag.Grid(np.ones((4, 7))).distances((9, 3))


def test_costs_of_sources_are_values_whatever_friction_has_for_no_data():
    friction = np.ones((9, 9))
    friction[0, 0] = 0
    grid = ag.Grid(friction, no_data=0)
    costs = grid.distances((4, 4))
    assert np.isinf(costs[0, 0])
    (line,) = grid.isolines(costs, 0.5)
    np.testing.assert_allclose(np.hypot(line[:, 0] - 4, line[:, 1] - 4), 0.5, atol=0.2)
    assert grid.isolines(costs, 0.5, no_data=0) == []


def test_no_path_leads_from_a_source_that_cannot_be_entered():
    friction = np.ones((3, 3))
    friction[1, 1] = np.inf
    for grid in (ag.Grid(friction), ag.Grid(friction, epsilon=0.5)):
        np.testing.assert_array_equal(
            grid.distances((1, 1)), np.where(np.isinf(friction), 0, np.inf)
        )
        assert grid.path((1, 1), (0, 0)).shape == (0, 2)


def test_rasters_of_one_cell_and_of_none_that_can_be_entered():
    grid = ag.Grid([[2]], epsilon=0.1)
    assert grid.distances((0, 0)) == [[0]]
    assert grid.path((0, 0), (0, 0)).tolist() == [[0, 0]]
    assert grid.isolines([[1]], 1) == []
    nowhere = ag.Grid(heights=np.full((2, 3), np.nan), cost="hiking_time")
    np.testing.assert_array_equal(
        nowhere.distances((1, 1)), [[np.inf, np.inf, np.inf], [np.inf, 0, np.inf]]
    )


def test_isolines_are_circles():
    grid = ag.Grid(np.ones((31, 43)), cell_size=2)
    costs = grid.distances((15, 20))
    (line,) = grid.isolines(costs, 20)
    np.testing.assert_array_equal(line[0], line[-1])
    np.testing.assert_allclose(np.hypot(line[:, 0] - 15, line[:, 1] - 20), 10, atol=0.1)
    assert [len(lines) for lines in grid.isolines(costs, [10, 20, 1e6])] == [1, 1, 0]


def test_progress_and_memory():
    calls = []
    grid = ag.Grid(np.ones((700, 700)), progress=lambda done, number: calls.append((done, number)))
    assert calls[-1] == (490000, 490000)
    calls.clear()
    grid.distances((0, 0), progress=lambda done, number: calls.append((done, number)))
    assert calls[-1] == (490000, 490000)
    assert grid.memory > 490000 * 16
    assert repr(grid) == "<Grid of 700 x 700 cells>"


@pytest.mark.parametrize(
    "options, message",
    [
        ({"friction": np.ones(5)}, "friction"),
        ({"friction": -np.ones((3, 4))}, r"cell \(0, 0\) is -1"),
        ({"friction": np.ones((3, 4)), "heights": np.ones((4, 3))}, "heights"),
        ({"friction": np.ones((0, 4))}, "no cells"),
        ({"friction": np.full((3, 4), np.nan), "no_data": None}, "nan"),
        ({"heights": np.full((3, 4), np.inf)}, "height of cell"),
        ({"friction": np.ones((3, 4)), "cell_size": 0}, "width of a cell"),
        ({"friction": np.ones((3, 4)), "cell_size": (1, 2, 3)}, "cell_size"),
        ({"friction": np.ones((3, 4)), "cost": "hiking_time"}, "no heights"),
        ({"friction": np.ones((3, 4)), "cost": "flying"}, "walking_energy"),
        ({"friction": np.ones((3, 4)), "epsilon": 0}, "epsilon is 0"),
        ({"heights": np.ones((3, 4)), "epsilon": 0.1}, "no bound"),
        ({"heights": np.ones((3, 4)), "cost": lambda s: s}, "slope -"),
        ({"heights": np.ones((3, 4)), "cost": lambda s: s[1:]}, "costs"),
        ({"friction": np.ones((3, 4)), "cost": ag.DriftTime([[1, 0, 0]], 2)}, "1 cells.*has 12"),
        ({"friction": np.ones((3, 4)), "first_latitude": 100}, "latitude 100"),
    ],
)
def test_bad_input(options, message):
    with pytest.raises(ValueError, match=message):
        ag.Grid(**options)


def test_bad_types_and_cells():
    grid = ag.Grid(np.ones((3, 4)))
    for call in (
        lambda: ag.Grid(),
        lambda: ag.Grid(np.ones((3, 4)), cost=3),
        lambda: ag.Grid(np.ones((3, 4)), cost=ag.CostFunction(lambda f, d: f)),
        lambda: ag.Grid(np.ones((3, 4)), cell_size="1"),
    ):
        with pytest.raises(TypeError):
            call()
    for cells, message in (
        ((3, 0), r"\(3, 0\) does not exist"),
        ([(0, 0), (0, 4)], "source 1"),
        ((-1, 0), "below 0"),
        ((0.5, 1), "integers"),
        ((0, 1, 2), "shape"),
    ):
        with pytest.raises(ValueError, match=message):
            grid.distances(cells)
    with pytest.raises(ValueError, match="target"):
        grid.path((0, 0), (9, 9))
    with pytest.raises(ValueError, match="max_distance"):
        grid.distances((0, 0), max_distance=-1)
    with pytest.raises(ValueError, match="values"):
        grid.isolines(np.ones((4, 3)), 1)
