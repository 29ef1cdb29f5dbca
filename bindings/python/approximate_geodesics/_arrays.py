"""What arguments can be: arrays of the right type as they are, and what NumPy makes arrays of."""

from __future__ import annotations

import operator
import reprlib
from typing import Any, Callable, Iterable, Mapping, Optional, Tuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

_LARGEST = int(np.iinfo(np.int64).max)

#: Numbers of vertices, (k,); or pairs of the vertices of edges, (k, 2), and parameters along them,
#: (k,); or numbers of faces, (k,), and barycentric coordinates in them, (k, 3).
Points = Tuple[Integers, Optional[Floats]]


def numbers(values: Any, name: str, shape: tuple[int, ...]) -> Floats:
    """The values as `float64`, not copied if C++ can read them. `-1` in `shape` fits any size."""
    try:
        array = np.asanyarray(values)
        _check_kind(array, name, "fiubO", "real numbers")
        if array.dtype.kind == "O" and any(isinstance(x, (str, bytes)) for x in array.flat):
            raise ValueError("some are texts")
        result: Floats = _readable(array, np.dtype(np.float64))
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} cannot be read as numbers: {error}") from None
    _check_items(values, name, "real numbers")
    _check_shape(result, name, shape)
    return result


def integers(values: Any, name: str, shape: tuple[int, ...]) -> npt.NDArray[Any]:
    """The values as `int32` or `int64`, not copied if C++ can read them. An empty list fits."""
    try:
        result: npt.NDArray[Any] = np.asanyarray(values)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} cannot be read as integers: {error}") from None
    _check_items(values, name, "integers")
    if result.shape == (0,) and result.dtype.kind == "f":
        result = np.empty([max(size, 0) for size in shape], dtype=np.int64)
    if result.dtype.kind in "fO":  # what NumPy makes of lists with integers from 2**63
        _check_sizes(np.asarray(values, dtype=object), name)
    _check_kind(result, name, "iu", "integers")
    if result.dtype.kind == "u":
        _check_sizes(result, name)
    is_fitting = result.dtype in (np.dtype(np.int32), np.dtype(np.int64))
    result = _readable(result, result.dtype if is_fitting else np.dtype(np.int64))
    _check_shape(result, name, shape)
    return result


def triangles(values: Any, name: str) -> npt.NDArray[Any]:
    """Three vertices for each face. A flat array is not taken for them: it may be meant otherwise."""
    if _number_of_dimensions(values) == 1 and len(values) > 0 and len(values) % 4 == 0:
        if np.all(np.asarray(values)[::4] == 3):
            raise ValueError(
                f"{name} are a flat array in which each face starts with its size, as PyVista's are; "
                f"give {name}.reshape(-1, 4)[:, 1:]"
            )
    return integers(values, name, (-1, 3))


def points(values: Any, name: str) -> tuple[Points, bool]:
    """The points, and whether it is one, and not a sequence of them."""
    if _is_point_of_face(values):
        return _points_of_faces([values], name), True
    if _is_point_on_edge(values):
        return _points_on_edges([values], name), True
    dimensions = list(map(_number_of_dimensions, values)) if isinstance(values, tuple) else []
    if dimensions == [1, 2]:
        return _arrays_of_faces(values, name), False
    if dimensions == [2, 1]:
        return _arrays_of_edges(values, name), False
    if isinstance(values, (str, bytes, bytearray, Mapping)):  # whose elements mean something else
        raise ValueError(f"the {name} {reprlib.repr(values)} is not a point")
    if isinstance(values, Iterable) and not isinstance(values, (np.ndarray, list, tuple)):
        values = list(values)  # as that of a range
    if _has_any(values, _is_point_of_face):
        return _points_of_faces(values, name), False
    if _has_any(values, _is_point_on_edge):
        return _points_on_edges(values, name), False
    if _number_of_dimensions(values) == 0:
        return (np.array([_vertex(values, name)], dtype=np.int64), None), True
    vertices = integers(values, f"the {name} vertices", (-1,))
    return (vertices.astype(np.int64, copy=False), None), False


def one_point(values: Any, name: str) -> Points:
    result, is_one = points(values, name)
    if not is_one:
        raise ValueError(f"the {name} must be one point, and not a sequence of them")
    return result


def pairs(sources: Any, targets: Any) -> tuple[Points, Points]:
    """Sources, and as many targets; without targets, sources are pairs of vertices."""
    if targets is None:
        vertices = integers(sources, "pairs", (-1, 2)).astype(np.int64, copy=False)
        return (np.ascontiguousarray(vertices[:, 0]), None), (
            np.ascontiguousarray(vertices[:, 1]),
            None,
        )
    result = points(sources, "source")[0], points(targets, "target")[0]
    if len(result[0][0]) != len(result[1][0]):
        raise ValueError(
            f"there are {len(result[0][0])} sources and {len(result[1][0])} targets; pairs need as "
            "many of both"
        )
    return result


def _readable(values: Any, dtype: np.dtype[Any]) -> npt.NDArray[Any]:
    """An array that C++ can read: the given one if it is."""
    return np.require(values, dtype, ["C_CONTIGUOUS", "ALIGNED", "ENSUREARRAY"])


def _check_kind(array: npt.NDArray[Any], name: str, kinds: str, wanted: str) -> None:
    """Refuses what NumPy would convert, but means something else."""
    if array.dtype.kind not in kinds:
        raise ValueError(f"{name} must be {wanted}, and are {array.dtype}")


def _check_items(values: Any, name: str, wanted: str) -> None:
    """Refuses what NumPy makes numbers of in a list: masked elements, and truth values."""
    if not isinstance(values, (tuple, list)):
        _check_mask(values, name)
        return
    for value in values:
        if _is_bool(value):
            raise ValueError(f"{name} must be {wanted}, and some are bool")
        if not isinstance(value, (int, float)):
            _check_items(value, name, wanted)


def _check_mask(array: Any, name: str) -> None:
    """Refuses masked elements, which are no numbers."""
    if isinstance(array, np.ma.MaskedArray) and np.any(array.mask):
        place = ", ".join(map(str, np.argwhere(array.mask)[0]))
        raise ValueError(f"{name} are masked at [{place}]")


def _check_shape(array: npt.NDArray[Any], name: str, shape: tuple[int, ...]) -> None:
    fits = array.ndim == len(shape) and all(
        wanted in (-1, size) for wanted, size in zip(shape, array.shape)
    )
    if not fits:
        wanted = str(shape).replace("-1", "any")
        raise ValueError(f"{name} must have the shape {wanted}, and have {array.shape}")


def _check_sizes(values: npt.NDArray[Any], name: str) -> None:
    """Refuses integers that are too large for NumPy."""
    suspects = values if values.dtype.kind == "O" else np.max(values, initial=0, keepdims=True)
    for value in suspects.flat:
        if isinstance(value, (int, np.integer)) and abs(int(value)) > _LARGEST:
            raise ValueError(f"{name} contain {value}, which is too large")


def _vertex(value: Any, name: str) -> int:
    _check_mask(value, f"the {name} vertices")
    try:
        result = index(value)
    except TypeError:
        raise ValueError(f"the {name} {value!r} is not a vertex, which is an integer") from None
    if abs(result) > _LARGEST:
        raise ValueError(f"the {name} is vertex {result}, which is too large")
    return result


def index(value: Any) -> int:
    """The integer that it is; a truth value is none."""
    if _is_bool(value):
        raise TypeError(f"{value} is a truth value")
    return operator.index(value)


def _is_bool(value: Any) -> bool:
    return isinstance(value, (bool, np.bool_))


def _number_of_dimensions(values: Any) -> int:
    """That of an array or of what NumPy makes one of, or else -1."""
    try:
        return np.ndim(values)
    except ValueError:
        return -1


def _is_point_of_face(value: Any) -> bool:
    """Whether it is a face, and three coordinates."""
    return (
        isinstance(value, (tuple, list))
        and len(value) == 2
        and _is_scalar(value[0])
        and not _is_scalar(value[1])
        and len(value[1]) == 3
        and all(map(_is_scalar, value[1]))
    )


def _is_scalar(value: Any) -> bool:
    return not isinstance(value, (tuple, list)) and np.ndim(value) == 0


def _points_of_faces(values: Any, name: str) -> Points:
    for number, value in enumerate(values):
        if not _is_point_of_face(value):
            raise ValueError(
                f"{name} {number} is not a face and three barycentric coordinates, as others are"
            )
    return _arrays_of_faces(([v[0] for v in values], [v[1] for v in values]), name)


def _arrays_of_faces(values: Any, name: str) -> Points:
    faces = integers(values[0], f"the {name} faces", (-1,)).astype(np.int64, copy=False)
    coordinates = numbers(values[1], f"the {name} coordinates", (-1, 3))
    if len(faces) != len(coordinates):
        raise ValueError(
            f"there are {len(faces)} {name} faces, and coordinates of {len(coordinates)} points"
        )
    return faces, _barycentric(coordinates, name)


def _barycentric(coordinates: Floats, name: str) -> Floats:
    """Coordinates whose sum is 1, without what can only be rounding errors of `float32`."""
    tolerance = 1e-6
    sums = coordinates.sum(axis=1)
    is_right = (np.abs(sums - 1) <= tolerance) & (coordinates.min(axis=1, initial=0) >= -tolerance)
    wrong = np.flatnonzero(~is_right)  # also those that are not numbers
    if len(wrong) > 0:
        text = ", ".join(f"{x:g}" for x in coordinates[wrong[0]])
        raise ValueError(
            f"{name} {wrong[0]} has the barycentric coordinates {text}; "
            "they must not be negative, and their sum must be 1"
        )
    if np.all(np.abs(sums - 1) <= 1e-15) and np.all(coordinates >= 0):
        return coordinates
    positive = np.maximum(coordinates, 0)
    result: Floats = positive / positive.sum(axis=1, keepdims=True)
    return result


def _is_point_on_edge(value: Any) -> bool:
    """Whether it is a pair of vertices, and a parameter."""
    return (
        isinstance(value, (tuple, list))
        and len(value) == 2
        and _is_scalar(value[1])
        and not _is_scalar(value[0])
        and len(value[0]) == 2
        and all(map(_is_scalar, value[0]))
    )


def _points_on_edges(values: Any, name: str) -> Points:
    for number, value in enumerate(values):
        if not _is_point_on_edge(value):
            raise ValueError(f"{name} {number} is not two vertices and a parameter, as others are")
    return _arrays_of_edges(([v[0] for v in values], [v[1] for v in values]), name)


def _arrays_of_edges(values: Any, name: str) -> Points:
    ends = integers(values[0], f"the {name} edges", (-1, 2)).astype(np.int64, copy=False)
    parameters = numbers(values[1], f"the {name} parameters", (-1,))
    if len(ends) != len(parameters):
        raise ValueError(
            f"there are {len(ends)} {name} edges, and parameters of {len(parameters)} points"
        )
    wrong = np.flatnonzero(~((parameters >= 0) & (parameters <= 1)))  # also what is no number
    if len(wrong) > 0:
        raise ValueError(
            f"{name} {wrong[0]} has the parameter {parameters[wrong[0]]}; it must be from 0, at the "
            "first vertex of the edge, to 1, at the second one"
        )
    return ends, parameters


def _has_any(values: Any, is_one: Callable[[Any], bool]) -> bool:
    """Whether any in a sequence is one. Arrays have none, and need not be looked through."""
    return isinstance(values, (tuple, list)) and any(map(is_one, values))
