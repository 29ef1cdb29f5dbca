"""The class `Grid`."""

from __future__ import annotations

from typing import Any, Callable, Literal, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._costs import DirectionalCost, HikingTime, NaismithTime, WalkingEnergy
from ._solver import Progress, _bound, _checked, _distance, _max_slope, _number

SlopeFunction = Callable[[_arrays.Floats], npt.ArrayLike]

_BY_NAME: dict[str, Callable[[], DirectionalCost]] = {
    "hiking_time": HikingTime,
    "naismith_time": NaismithTime,
    "walking_energy": WalkingEnergy,
}
_STEEPEST, _SLOPES_PER_UNIT = 4, 8000
_WGS_84 = (6378137.0, 1 / 298.257223563)
_NO_VALUE = float(np.finfo(np.float64).max)  # stands for what a mask hides: no friction or height is so large


class Grid:
    """Costs and paths on a raster: a regular grid of cells with friction, heights, or both.

    No mesh is built. Lines join the centers of cells up to 15 rows and columns apart, in all
    directions. "Distance" and "length" mean costs.

    Parameters
    ----------
    friction : (rows, columns) array of float, optional
        What a unit of length costs in each cell: not negative; infinity forbids a cell. By default,
        1 everywhere. Where cells cost nothing, paths are the shortest of those that cost the same.
    heights : (rows, columns) array of float, optional
        The heights of the centers, in the unit of lengths. Lines are on the surface then. Cells that
        the mask of a masked array hides cannot be entered, nor those of friction.
    cell_size : float, or two
        The size of a cell; or its width, along a row, and its height.
    cost : str, DirectionalCost or callable, optional
        What a unit of length costs, which friction multiplies: `"hiking_time"`, `"naismith_time"`,
        `"walking_energy"`, an object of such a class, or a function of slopes, (k,) float64, that
        returns (k,) costs; these need heights. Or a `DriftTime`, `OneWay` or `TensorCost`, with one
        row of numbers for each cell, in the order of `friction.ravel()`: x is along rows, y goes
        from row to row, and z upward. Infinity for a slope forbids only straight lines of it:
        zigzags climb it at the cost of other slopes. A limit is `max_slope`.
    max_slope : float, optional
        The steepest slope of lines, uphill and downhill: height per horizontal length. It needs
        heights. A line keeps it in all cells that it crosses, and there are no zigzags in its
        place, so that a wall one cell wide is a wall. Paths turn at centers; so they can still
        cross a slope up to 10 times as steep (for square cells), on lines along it, which can make
        them 23 % too long. Give cells infinite friction that are too steep in any direction.
    epsilon : float, optional
        Paths cost at most `1 + epsilon` times as much as the cheapest ones in the plane, for
        friction alone. Without it, there is no bound where friction changes; where it does not,
        distances are at most `error_on_equal_cells` too large, 0.3 % for most cells.
    no_data : float, optional
        The friction or height of cells that cannot be entered, rounded to the type of the array; NaN by
        default.
    first_latitude : float, optional
        The latitude, in degrees, of the side where the first row begins. Then `cell_size` is in
        degrees, rows run south, and lengths are in meters.
    periodic : bool
        Whether columns go round: the first one follows the last one, as on a raster of the whole
        Earth. It has at least 31 columns, and no `epsilon`; in degrees, these are 360.
    ellipsoid : (float, float), optional
        What latitudes are of: the radius of the equator, and the flattening, 0 for a sphere. By
        default, WGS 84 in meters.
    progress : callable, optional
        Called while the graph is built.

    Raises
    ------
    ValueError
        If the input cannot be right. The message names the cell, by its row and its column.

    A cell is a pair of a row and a column, as NumPy has it; cells are a sequence of pairs, or a (k, 2)
    array. Points of paths and isolines are rows and columns, too, in which centers are integers. If
    columns go round, a path or an isoline goes on beyond the first or the last one.

    Several threads can call all methods at the same time. Ctrl-C ends searches.

    >>> grid = ag.Grid(heights=dem, cell_size=30, cost="hiking_time")
    >>> seconds = grid.distances((120, 80))
    >>> path = grid.path((120, 80), (7, 460))
    """

    def __init__(
        self,
        friction: Optional[npt.ArrayLike] = None,
        *,
        heights: Optional[npt.ArrayLike] = None,
        cell_size: Union[float, tuple[float, float]] = 1.0,
        cost: Union[str, DirectionalCost, SlopeFunction, None] = None,
        max_slope: Optional[float] = None,
        epsilon: Optional[float] = None,
        no_data: Optional[float] = float("nan"),
        first_latitude: Optional[float] = None,
        periodic: bool = False,
        ellipsoid: tuple[float, float] = _WGS_84,
        progress: Optional[Progress] = None,
    ) -> None:
        if friction is None and heights is None:
            raise TypeError("a Grid has friction, or heights, or both; there are none")
        if no_data is not None:
            no_data = _number(no_data, "no_data")
        hidden = no_data
        if no_data is None and (_is_masked(friction) or _is_masked(heights)):
            hidden = _NO_VALUE
        values, surface = None, None
        if friction is not None:
            values = _values(friction, "friction", (-1, -1), no_data, hidden)
        if heights is not None:
            wanted = (-1, -1) if values is None else values.shape
            surface = _values(heights, "heights", wanted, no_data, hidden)
        first = surface if values is None else values
        assert first is not None
        self._shape = (first.shape[0], first.shape[1])
        self._cell_size = _two_numbers(cell_size, "cell_size")
        self._first_latitude, self._periodic = first_latitude, bool(periodic)
        model, slope_costs = _native_cost(cost, first.size)
        self._grid = _native.Grid(
            self._shape,
            self._cell_size,
            hidden,
            None if first_latitude is None else _number(first_latitude, "first_latitude"),
            _two_numbers(ellipsoid, "ellipsoid"),
            bool(periodic),
            values,
            surface,
            _bound(epsilon),
            model,
            slope_costs,
            _max_slope(max_slope),
            _checked(progress),
        )

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[False] = False,
        return_predecessors: Literal[False] = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> _arrays.Floats: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[True],
        return_predecessors: Literal[False] = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers]: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[False] = False,
        return_predecessors: Literal[True],
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers]: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[True],
        return_predecessors: Literal[True],
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers, _arrays.Integers]: ...

    def distances(
        self,
        sources: Any,
        *,
        return_nearest: bool = False,
        return_predecessors: bool = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Costs of all cells from the nearest source.

        Parameters
        ----------
        sources : cell or cells
            One that cannot be entered has the cost 0, and no other cell is reached from it: see
            `snap()`.
        return_nearest : bool
            Whether the nearest sources are returned, too.
        return_predecessors : bool
            Whether the cells before each one on its path are returned, too.
        max_distance : float, optional
            Cells that cost more are not reached; the run ends there.
        direction_to_source : bool
            Whether the costs are those to the sources. The first time, the graph is copied for that.
        progress : callable, optional

        Returns
        -------
        (rows, columns) array of float64
            Infinity for cells that no source reaches.
        (rows, columns) array of int64
            The position of the nearest source among the sources, or -1; if wanted.
        (rows, columns) array of int64
            The last cell before each one whose center is on the path, as a flat index for
            `numpy.unravel_index`; the cell itself if there is none, or -1 if it is not reached; if
            wanted.
        """
        result, nearest, predecessors = self._grid.distances(
            _cells(sources, "sources"),
            _distance(max_distance),
            direction_to_source,
            return_nearest,
            return_predecessors,
            _checked(progress),
        )
        more = ([nearest] if return_nearest else []) + ([predecessors] if return_predecessors else [])
        return (result, *more) if more else result

    @overload
    def path(
        self, source: Any, target: Any, *, return_length: Literal[False] = False
    ) -> _arrays.Floats: ...

    @overload
    def path(
        self, source: Any, target: Any, *, return_length: Literal[True]
    ) -> tuple[_arrays.Floats, float]: ...

    def path(self, source: Any, target: Any, *, return_length: bool = False) -> Any:
        """A cheapest path from one cell to another.

        Returns
        -------
        (k, 2) array of float64
            Rows and columns of its points; (0, 2) if there is none.
        float
            What it costs, or infinity; if wanted.
        """
        ends = np.concatenate([_cells(source, "source", (2,)), _cells(target, "target", (2,))])
        points, length = self._grid.path(ends)
        return (points, length) if return_length else points

    @overload
    def isolines(
        self, values: npt.ArrayLike, levels: float, *, no_data: Optional[float] = None
    ) -> list[_arrays.Floats]: ...

    @overload
    def isolines(
        self,
        values: npt.ArrayLike,
        levels: Union[Sequence[float], npt.NDArray[Any]],
        *,
        no_data: Optional[float] = None,
    ) -> list[list[_arrays.Floats]]: ...

    def isolines(
        self, values: npt.ArrayLike, levels: npt.ArrayLike, *, no_data: Optional[float] = None
    ) -> Any:
        """Lines where values of cells, such as costs, reach a level; or for each of several levels.

        Parameters
        ----------
        values : (rows, columns) array of float
            No lines are next to cells whose values are infinite, NaN, masked, or `no_data`.
        levels : float, or (k,) array of float
        no_data : float, optional
            By default, none: that of friction can be 0, which is what sources cost.

        Returns
        -------
        list of (k, 2) arrays of float64
            Rows and columns; the last point of a closed line is its first. Of several levels, a list
            of such lists.
        """
        if no_data is not None:
            no_data = _number(no_data, "no_data")
        numbers = _values(values, "values", self._shape, no_data, float("nan"))
        if no_data is not None:
            numbers = np.where(numbers == no_data, np.nan, numbers)
        if np.ndim(levels) == 0:
            return self._grid.isolines(numbers, _number(levels, "levels"))
        return [
            self._grid.isolines(numbers, float(level))
            for level in _arrays.numbers(levels, "levels", (-1,))
        ]

    def snap(self, cells: Any) -> _arrays.Integers:
        """The nearest cells that can be entered, such as for sources in the sea.

        Parameters
        ----------
        cells : cell or cells

        Returns
        -------
        (2,) or (k, 2) array of int64
            Those that can be entered themselves stay.

        Raises
        ------
        ValueError
            If no cell can be entered, or a cell does not exist.
        """
        wanted = _cells(cells, "cells")
        rows, columns = np.nonzero(self._grid.can_enter())
        if len(rows) == 0:
            raise ValueError("no cell of the grid can be entered")
        result = wanted.copy()
        for i, (row, column) in enumerate(wanted.tolist()):
            if row >= self._shape[0] or column >= self._shape[1]:
                raise ValueError(f"the cell {(row, column)} does not exist: the shape is {self._shape}")
            nearest = int(np.argmin(self._distances_of_centers(row, column, rows, columns)))
            result[i] = rows[nearest], columns[nearest]
        one: _arrays.Integers = result[0]
        return one if np.ndim(cells) == 1 and len(wanted) == 1 else result

    def _distances_of_centers(
        self, row: int, column: int, rows: _arrays.Integers, columns: _arrays.Integers
    ) -> _arrays.Floats:
        """Straight ones, in units of `cell_size` along columns."""
        width, height = self._cell_size
        x: _arrays.Floats = np.abs(columns - column).astype(np.float64)
        if self._periodic:
            x = np.minimum(x, self._shape[1] - x)
        if self._first_latitude is not None:
            x *= np.cos(np.radians(self._first_latitude - (rows + row + 1) / 2 * height))
        result: _arrays.Floats = np.hypot(x * width, (rows - row) * height)
        return result

    @property
    def shape(self) -> tuple[int, int]:
        """The numbers of rows and columns."""
        return self._shape

    @property
    def error_on_equal_cells(self) -> float:
        """How much too large distances are at most, relatively, where all cells are alike."""
        return self._grid.error_on_equal_cells

    @property
    def error_of_slopes(self) -> float:
        """How much too large costs of slopes are at most, relatively, due to interpolation."""
        return self._grid.error_of_slopes

    @property
    def memory(self) -> int:
        """The size of the graph and of unused workspaces, in bytes."""
        return self._grid.memory

    def __repr__(self) -> str:
        return f"<Grid of {self._shape[0]} x {self._shape[1]} cells>"


def _is_masked(values: Any) -> bool:
    return isinstance(values, np.ma.MaskedArray) and bool(np.any(values.mask))


def _values(
    values: Any,
    name: str,
    shape: tuple[int, ...],
    no_data: Optional[float],
    hidden: Optional[float],
) -> _arrays.Floats:
    """Values of cells, in which `no_data` is that of their own type: 1e20 is no `float32`. What a mask
    hides becomes `hidden`."""
    if _is_masked(values):
        mask, values = values.mask, np.asarray(values)
        result = _arrays.numbers(values, name, shape).copy()
        result[mask] = hidden
    else:
        result = _arrays.numbers(values, name, shape)
    dtype = np.asarray(values).dtype if hasattr(values, "dtype") else result.dtype
    if no_data is not None and dtype.kind == "f" and dtype.itemsize < 8:
        with np.errstate(over="ignore"):
            rounded = float(np.float64(no_data).astype(dtype))
        result[result == rounded] = no_data
    return result


def _cells(values: Any, name: str, shape: tuple[int, ...] = ()) -> _arrays.Integers:
    """Rows and columns, (k, 2)."""
    wanted = shape or ((2,) if np.ndim(values) == 1 and len(values) > 0 else (-1, 2))
    result = _arrays.integers(values, name, wanted).astype(np.int64, copy=False)
    cells: _arrays.Integers = np.ascontiguousarray(result.reshape(-1, 2))
    wrong = np.flatnonzero(cells.min(axis=1, initial=0) < 0)
    if len(wrong) > 0:
        raise ValueError(f"{name} has the cell {tuple(cells[wrong[0]].tolist())}, which is below 0")
    return cells


def _two_numbers(values: Any, name: str) -> tuple[float, float]:
    if np.ndim(values) == 0:
        number = _number(values, name)
        return number, number
    numbers = _arrays.numbers(values, name, (2,))
    return float(numbers[0]), float(numbers[1])


def _native_cost(
    cost: Union[str, DirectionalCost, SlopeFunction, None], number_of_cells: int
) -> tuple[Optional[tuple[int, list[float], _arrays.Floats]], Optional[_arrays.Floats]]:
    if cost is None:
        return None, None
    if isinstance(cost, str):
        if cost not in _BY_NAME:
            raise ValueError(f"the cost is {cost!r}; it must be one of {', '.join(_BY_NAME)}")
        cost = _BY_NAME[cost]()
    if isinstance(cost, DirectionalCost):
        return cost._of_elements(number_of_cells, "cells", "the grid"), None
    if not callable(cost):
        raise TypeError(
            f"the cost is of type {type(cost).__name__}; it must be a name, a DirectionalCost, or a "
            "function of slopes"
        )
    number = _STEEPEST * _SLOPES_PER_UNIT
    slopes = np.arange(-number, number + 1) / _SLOPES_PER_UNIT
    return None, _arrays.numbers(cost(slopes), "costs", slopes.shape)
