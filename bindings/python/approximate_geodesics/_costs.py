"""Costs that depend on the direction."""

from __future__ import annotations

import operator
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _arrays


class DirectionalCost:
    """What a path costs per unit of length in each face and direction: the base of the classes below.

    They are what `Solver` takes as `costs`. "Distance" and "length" mean costs then, and the way
    back may cost something else.
    """

    _model: int
    _parameters: list[float]
    _of_faces: _arrays.Floats

    def _numbers(self, values: npt.ArrayLike, name: str, width: int) -> _arrays.Floats:
        self._name = name
        return _arrays.numbers(values, name, (-1, width)).copy()

    def _native(
        self, vertices: _arrays.Floats, faces: npt.NDArray[Any]
    ) -> tuple[int, list[float], _arrays.Floats]:
        return self._of_elements(len(faces), "faces", "the mesh")

    def _of_elements(
        self, number: int, elements: str, whole: str
    ) -> tuple[int, list[float], _arrays.Floats]:
        if type(self) is DirectionalCost:
            raise TypeError("a DirectionalCost is none itself; take one of the classes derived")
        if self._of_faces.ndim == 2 and len(self._of_faces) != number:
            raise ValueError(
                f"{self._name} are those of {len(self._of_faces)} {elements}, "
                f"and {whole} has {number}"
            )
        return self._model, self._parameters, self._of_faces

    def __repr__(self) -> str:
        parts = [f"{p:g}" for p in self._parameters]
        if self._of_faces.ndim == 2:
            parts.insert(0, f"<{self._name} of {len(self._of_faces)} faces>")
        return f"{type(self).__name__}({', '.join(parts)})"


class HikingTime(DirectionalCost):
    """Seconds per meter of walking on slopes, by Tobler's hiking function.

    The mesh is in meters, with the z axis upward. Steep slopes are climbed in zigzags.

    Parameters
    ----------
    factor : float
        What speeds are multiplied by: 1 on footpaths, 0.6 off paths, 1.25 on horseback.
    """

    def __init__(self, factor: float = 1.0) -> None:
        self._model, self._parameters, self._of_faces = 0, [float(factor)], np.empty(0)


class WalkingEnergy(DirectionalCost):
    """Joules per kilogram of the walker and meter of the ground, as Minetti et al. measured it.

    The mesh is in meters, with the z axis upward. Directions steeper than 45 % are forbidden; steep
    faces are climbed in zigzags, unless the solver has a `max_slope`.
    """

    def __init__(self) -> None:
        self._model, self._parameters, self._of_faces = 1, [], np.empty(0)


class NaismithTime(DirectionalCost):
    """Seconds per meter of walking on slopes, by Naismith's rule with Langmuir's corrections.

    A descent of up to 12 degrees saves 2 seconds per meter of height, a steeper one costs as much, as in
    the module `r.walk` of GRASS. The mesh is in meters, with the z axis upward.

    Parameters
    ----------
    pace : float
        Seconds per horizontal meter, at least 0.425.
    ascent : float
        Seconds per meter of ascent.
    """

    def __init__(self, pace: float = 0.72, ascent: float = 6.0) -> None:
        self._model, self._parameters = 6, [float(pace), float(ascent)]
        self._of_faces = np.empty(0)


class DriftTime(DirectionalCost):
    """The time of a boat or an airplane in a current or a wind: Zermelo's problem of navigation.

    Parameters
    ----------
    velocities : (m, 3) array of float
        The velocity of the drift in each face, in its plane: what is not in it makes ways longer.
        Project a wind, which also blows up and down, onto the faces first.
    speed : float
        The speed of the boat through the drift, in the same unit. Where the drift is faster,
        directions that the boat cannot get to are forbidden.
    """

    def __init__(self, velocities: npt.ArrayLike, speed: float) -> None:
        self._model, self._parameters = 2, [float(speed)]
        self._of_faces = self._numbers(velocities, "velocities", 3)


class OneWay(DirectionalCost):
    """Faces that can be crossed in some directions only.

    There is no bound `epsilon` then: `Solver` needs `accept_weaker_bound=True`, or no `epsilon`.

    Parameters
    ----------
    ways : (m, 3) array of float
        The direction of each face, in its plane, of any length; zero allows all. The angle with
        what is not in the plane is larger.
    cost : float
        What a path costs per unit of length where it is allowed.
    smallest_cosine : float
        Directions at an angle to that of the face with at least this cosine are allowed; 0 stands
        for half of them.
    """

    def __init__(
        self, ways: npt.ArrayLike, cost: float = 1.0, smallest_cosine: float = 0.0
    ) -> None:
        self._model, self._parameters = 3, [float(cost), float(smallest_cosine)]
        self._of_faces = self._numbers(ways, "ways", 3)


class TensorCost(DirectionalCost):
    """A metric tensor per face: in the direction d, a unit of length costs sqrt(d A d).

    Parameters
    ----------
    tensors : (m, 3, 3) or (m, 6) array of float
        Symmetric matrices, up to rounding, that are positive semidefinite in the planes of their
        faces; or their entries xx, xy, xz, yy, yz and zz.
    """

    def __init__(self, tensors: npt.ArrayLike) -> None:
        self._model, self._parameters = 4, []
        if np.ndim(tensors) == 3:
            tensors = _upper_triangles(_arrays.numbers(tensors, "tensors", (-1, 3, 3)))
        self._of_faces = self._numbers(tensors, "tensors", 6)


def _upper_triangles(matrices: _arrays.Floats) -> _arrays.Floats:
    transposed = matrices.transpose(0, 2, 1)
    largest = np.abs(matrices).max(axis=(1, 2), initial=0)
    with np.errstate(invalid="ignore"):  # C++ tells of what is not finite
        differences = np.abs(matrices - transposed).max(axis=(1, 2), initial=0)
    wrong = np.flatnonzero(differences > 1e-6 * largest)  # rounding errors of `float32`
    if len(wrong) > 0:
        raise ValueError(f"the tensor of face {wrong[0]} is not symmetric")
    rows, columns = np.triu_indices(3)
    result: _arrays.Floats = (matrices / 2 + transposed / 2)[:, rows, columns]
    return result


class CostFunction(DirectionalCost):
    """Costs of your own: a function of faces and directions.

    It is called once, when a solver is made, with arrays of all faces and directions. Between two
    neighboring directions of a face, costs are interpolated by the largest convex gauge, so that
    convex costs become higher: with the default number of directions and the same cost in all
    directions, by up to 0.5 %; along the edges, not at all. The bound `epsilon` of paths is for the
    costs that were sampled. Solvers keep these, and can be saved.

    Parameters
    ----------
    function : callable
        Takes the numbers of faces, (k,) int64, and unit vectors in their planes, (k, 3) float64, and
        returns the costs of a unit of length, (k,): not negative. Infinity forbids only to walk
        straight on in a direction; zigzags may still follow it, at the cost of others. For a limit
        of slopes, give `max_slope` to the solver.
    number_of_directions : int
        How many directions there are in each face, besides those of its sides. They take 16 bytes
        each; the error falls with their square.
    """

    def __init__(
        self,
        function: Callable[[_arrays.Integers, _arrays.Floats], npt.ArrayLike],
        number_of_directions: int = 32,
    ) -> None:
        if not callable(function):
            raise TypeError(f"the cost function is {function!r}; it must be callable")
        self._function = function
        self._number = operator.index(number_of_directions)
        if not 4 <= self._number <= 10000:
            raise ValueError(f"number_of_directions is {self._number}; it must be from 4 to 10000")

    def _of_elements(
        self, number: int, elements: str, whole: str
    ) -> tuple[int, list[float], _arrays.Floats]:
        raise TypeError(f"a CostFunction is of faces, and {whole} has none; give a function of slopes")

    def _native(
        self, vertices: _arrays.Floats, faces: npt.NDArray[Any]
    ) -> tuple[int, list[float], _arrays.Floats]:
        corners = np.clip(faces, 0, max(len(vertices) - 1, 0))  # C++ tells of wrong vertices
        sides = _unit_sides(vertices, corners)
        x, y = _axes(sides)
        angles = _angles(sides, x, y, self._number)
        directions = np.cos(angles)[..., None] * x[:, None] + np.sin(angles)[..., None] * y[:, None]
        number = angles.shape[1]
        numbers_of_faces = np.repeat(np.arange(len(faces)), number)
        costs = _arrays.numbers(
            self._function(numbers_of_faces, directions.reshape(-1, 3)), "costs", (angles.size,)
        )
        wrong = np.flatnonzero(~(costs >= 0))  # also what is no number
        if len(wrong) > 0:
            text = ", ".join(f"{z:g}" for z in directions.reshape(-1, 3)[wrong[0]])
            raise ValueError(
                f"face {numbers_of_faces[wrong[0]]} has the cost {costs[wrong[0]]} in the direction "
                f"({text}); it must be a number that is not negative, or infinity"
            )
        samples = np.stack([angles, costs.reshape(angles.shape)], axis=-1)
        numbers = np.concatenate([x, y, samples.reshape(len(faces), 2 * number)], axis=1)
        return 5, [float(number)], numbers

    def __repr__(self) -> str:
        return f"CostFunction({self._function!r}, {self._number})"


def _unit_sides(vertices: _arrays.Floats, faces: npt.NDArray[Any]) -> _arrays.Floats:
    """The directions of the sides of faces, (m, 3, 3): zeros where a side has no length."""
    corners = vertices[faces] if len(vertices) > 0 else np.zeros((len(faces), 3, 3))
    with np.errstate(all="ignore"):  # C++ tells of what is not finite
        size = np.abs(corners).max(axis=(1, 2), keepdims=True, initial=0)
        scaled = np.where(size > 0, corners / size, 0)  # differences and squares do not overflow
        sides = np.roll(scaled, -1, axis=1) - scaled
        sides /= np.abs(sides).max(axis=2, keepdims=True)  # whose squares would underflow
        result: _arrays.Floats = sides / np.linalg.norm(sides, axis=2, keepdims=True)
    return np.nan_to_num(result)


def _axes(sides: _arrays.Floats) -> tuple[_arrays.Floats, _arrays.Floats]:
    """Two orthogonal unit vectors in the plane of each face; the first one is along a side."""
    x, across = sides[:, 0].copy(), -sides[:, 2]
    is_point = ~np.any(x, axis=1)
    x[is_point] = across[is_point]
    x[~np.any(x, axis=1)] = (1, 0, 0)
    for other in (sides[:, 1], np.eye(3)[np.abs(x).argmin(axis=1)]):  # where faces have no area
        rest = across - np.sum(across * x, axis=1, keepdims=True) * x
        is_thin = np.linalg.norm(rest, axis=1) < 1e-12
        across = np.where(is_thin[:, None], other, across)
    y = across - np.sum(across * x, axis=1, keepdims=True) * x
    y /= np.linalg.norm(y, axis=1, keepdims=True)
    return x, y - np.sum(y * x, axis=1, keepdims=True) * x


def _angles(
    sides: _arrays.Floats, x: _arrays.Floats, y: _arrays.Floats, number: int
) -> _arrays.Floats:
    """Angles of directions of each face, in their order: both of each side, and equal parts."""
    both = np.concatenate([sides, -sides], axis=1)
    along_x, along_y = (np.einsum("mij,mj->mi", both, axis) for axis in (x, y))
    of_sides = np.arctan2(along_y, along_x)
    parts = np.broadcast_to(np.linspace(-np.pi, np.pi, number, endpoint=False), (len(x), number))
    result: _arrays.Floats = np.sort(np.concatenate([of_sides, parts], axis=1), axis=1)
    return result


#: By the number of their models.
NAMES = (
    "hiking time", "walking energy", "drift time", "one-way faces", "tensors", "a cost function",
    "Naismith's time",
)
