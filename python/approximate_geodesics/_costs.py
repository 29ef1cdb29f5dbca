"""Costs that depend on the direction."""

from __future__ import annotations

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

    def _native(self, number_of_faces: int) -> tuple[int, list[float], _arrays.Floats]:
        if type(self) is DirectionalCost:
            raise TypeError("a DirectionalCost is none itself; take one of the classes derived")
        if self._of_faces.ndim == 2 and len(self._of_faces) != number_of_faces:
            raise ValueError(
                f"{self._name} are those of {len(self._of_faces)} faces, "
                f"and the mesh has {number_of_faces}"
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
    faces are climbed in zigzags.
    """

    def __init__(self) -> None:
        self._model, self._parameters, self._of_faces = 1, [], np.empty(0)


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


#: By the number of their models.
NAMES = ("hiking time", "walking energy", "drift time", "one-way faces", "tensors")
