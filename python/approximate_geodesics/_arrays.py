"""What arguments can be: arrays of the right type as they are, and what NumPy makes arrays of."""

from __future__ import annotations

import operator
from typing import Any, Iterable, Optional, Tuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

#: Numbers of vertices; or numbers of faces, and barycentric coordinates in them.
Points = Tuple[Integers, Optional[Floats]]


def numbers(values: Any, name: str, shape: tuple[int, ...]) -> Floats:
    """The values as contiguous `float64`, not copied if they are. `-1` in `shape` fits any size."""
    try:
        result = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} cannot be read as numbers: {error}") from None
    _check_shape(result, name, shape)
    return result


def integers(values: Any, name: str, shape: tuple[int, ...]) -> npt.NDArray[Any]:
    """The values as contiguous `int32` or `int64`, not copied if they are."""
    result = np.asarray(values)
    if result.size == 0 and result.dtype.kind == "f":
        result = result.astype(np.int64)  # an empty list
    if result.dtype.kind not in "iu":
        raise ValueError(f"{name} must be integers, and are {result.dtype}")
    if result.dtype.kind == "u" and result.size > 0 and int(result.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"{name} contain {result.max()}, which is too large")
    is_fitting = result.dtype in (np.dtype(np.int32), np.dtype(np.int64))
    result = np.ascontiguousarray(result, dtype=result.dtype if is_fitting else np.int64)
    _check_shape(result, name, shape)
    return result


def points(values: Any, name: str) -> tuple[Points, bool]:
    """The points, and whether it is one, and not a sequence of them."""
    if _is_point_of_face(values):
        return _points_of_faces([values], name), True
    if isinstance(values, tuple) and [getattr(v, "ndim", None) for v in values] == [1, 2]:
        return _arrays_of_faces(values, name), False
    if isinstance(values, Iterable) and not isinstance(values, (np.ndarray, list, tuple)):
        values = list(values)  # as that of a range
    if _has_point_of_face(values):
        return _points_of_faces(values, name), False
    if np.ndim(values) == 0:
        return (np.array([_vertex(values, name)], dtype=np.int64), None), True
    vertices = integers(values, f"the {name} vertices", (-1,))
    return (vertices.astype(np.int64, copy=False), None), False


def one_point(values: Any, name: str) -> Points:
    result, is_one = points(values, name)
    if not is_one:
        raise ValueError(f"the {name} must be one point, and not a sequence of them")
    return result


def _check_shape(array: npt.NDArray[Any], name: str, shape: tuple[int, ...]) -> None:
    fits = array.ndim == len(shape) and all(
        wanted in (-1, size) for wanted, size in zip(shape, array.shape)
    )
    if not fits:
        wanted = ", ".join("any" if size == -1 else str(size) for size in shape)
        raise ValueError(f"{name} must have the shape ({wanted}), and have {array.shape}")


def _vertex(value: Any, name: str) -> int:
    try:
        return operator.index(value)
    except TypeError:
        raise ValueError(f"the {name} {value!r} is not a vertex, which is an integer") from None


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
    return faces, coordinates


def _has_point_of_face(values: Any) -> bool:
    """Whether there is any in a sequence. Arrays have none, and need not be looked through."""
    return isinstance(values, (tuple, list)) and any(map(_is_point_of_face, values))
