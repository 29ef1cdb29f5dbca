"""The functions of gdist, with its arguments."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._solver import Solver

_INFINITY = float("inf")


def compute_gdist(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    source_indices: Optional[npt.ArrayLike] = None,
    target_indices: Optional[npt.ArrayLike] = None,
    max_distance: float = _INFINITY,
    is_one_indexed: bool = False,
    *,
    epsilon: Optional[float] = 0,
) -> _arrays.Floats:
    """Distances from the nearest source to targets: the arguments of gdist's function, and a bound.

    Parameters
    ----------
    vertices : (n, 3) array of float
    triangles : (m, 3) array of int
    source_indices : (k,) array of int, optional
        Vertices; by default, the first one.
    target_indices : (l,) array of int, optional
        Vertices; by default, all.
    max_distance : float
        Targets that are farther get infinity.
    is_one_indexed : bool
        Whether the vertices of triangles are numbered from 1. Sources and targets never are.
    epsilon : float, optional
        As for `Solver`: exact by default, as in gdist.

    Returns
    -------
    (l,) array of float64
    """
    vertices = _arrays.numbers(vertices, "vertices", (-1, 3))
    solver = Solver(vertices, _from_zero(triangles, is_one_indexed, len(vertices)), epsilon)
    sources = [0] if source_indices is None else source_indices
    distances = solver.distances(sources, max_distance=max_distance)
    if target_indices is None:
        return distances
    result: _arrays.Floats = distances[vertices_of_mesh(target_indices, len(distances))]
    return result


def oriented(faces: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The faces, turned where neighbors traverse their edge in the same direction.

    gdist and pygeodesic accept such meshes, which `Solver` refuses. Meshes with a one-sided
    surface stay as they are, and are refused then.
    """
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    low, high = sides.min(axis=1), sides.max(axis=1)
    order = np.lexsort([high, low])
    is_pair = (np.diff(low[order]) == 0) & (np.diff(high[order]) == 0)
    first, second = order[:-1][is_pair], order[1:][is_pair]
    turns = sides[first, 0] == sides[second, 0]
    if not np.any(turns):
        return faces
    first, second = first % len(faces), second % len(faces)
    neighbors: list[list[tuple[int, bool]]] = [[] for _ in faces]
    for a, b, turn in zip(first, second, turns):
        neighbors[a].append((b, turn))
        neighbors[b].append((a, turn))
    is_turned: list[Optional[bool]] = [None] * len(faces)
    for start in range(len(faces)):
        if is_turned[start] is None:
            is_turned[start], front = False, [start]
            while front:
                face = front.pop()
                for other, turn in neighbors[face]:
                    if is_turned[other] is None:
                        is_turned[other] = bool(is_turned[face]) != bool(turn)
                        front.append(other)
    is_reversed = np.array(is_turned, dtype=bool)
    if np.any((is_reversed[first] != is_reversed[second]) != turns):
        return faces
    return np.where(is_reversed[:, None], faces[:, ::-1], faces)


def vertices_of_mesh(targets: npt.ArrayLike, number_of_vertices: int) -> npt.NDArray[Any]:
    """Targets that are vertices of a mesh."""
    result = _arrays.integers(targets, "target_indices", (-1,))
    wrong = np.flatnonzero((result < 0) | (result >= number_of_vertices))
    if len(wrong) > 0:
        raise ValueError(
            f"target {wrong[0]} is vertex {result[wrong[0]]}; they are numbered from 0, "
            f"and there are {number_of_vertices}"
        )
    return result


def local_gdist_matrix(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    max_distance: float = _INFINITY,
    is_one_indexed: bool = False,
    *,
    epsilon: Optional[float] = 0.05,
    threads: Optional[int] = None,
    progress: Any = None,
) -> Any:
    """Distances from every vertex to all within a distance: the arguments of gdist's function.

    Parameters
    ----------
    vertices : (n, 3) array of float
    triangles : (m, 3) array of int
    max_distance : float
    is_one_indexed : bool
        Whether the vertices of triangles are numbered from 1.
    epsilon : float, optional
        As for `Solver`. `0` gives the exact distances of gdist; the default is at most 5 % too
        long, less than 0.1 % on average on smooth surfaces, and faster where hundreds of vertices
        are within the distance.
    threads : int, optional
        One per core by default. gdist has one.
    progress : callable, optional
        Called with the number of rows that are done, and of all.

    Returns
    -------
    scipy.sparse.csc_matrix of shape (n, n) and type float64
        It is symmetric. Zeros are not stored, as in gdist; so nothing is on the diagonal.
    """
    import scipy.sparse

    vertices = _arrays.numbers(vertices, "vertices", (-1, 3))
    corners = _from_zero(triangles, is_one_indexed, len(vertices))
    solver = Solver(vertices, corners, epsilon, threads=threads)
    everything = np.arange(solver.number_of_vertices)
    rows = solver.distance_matrix(
        everything,
        everything,
        max_distance=max_distance,
        symmetric=True,  # searches from either end can find different paths, or round differently
        progress=progress,
    )
    arrays = rows.data, rows.indices, rows.indptr  # as columns are the same as rows
    result = scipy.sparse.csc_matrix(arrays, shape=rows.shape, copy=False)
    result.eliminate_zeros()
    return result


def _from_zero(
    triangles: npt.ArrayLike, is_one_indexed: bool, number_of_vertices: int
) -> npt.NDArray[Any]:
    result = _arrays.integers(triangles, "triangles", (-1, 3))
    if not is_one_indexed:
        return oriented(result)
    wrong = np.flatnonzero(np.any((result < 1) | (result > number_of_vertices), axis=1))
    if len(wrong) > 0:
        vertices = [v for v in result[wrong[0]].tolist() if not 1 <= v <= number_of_vertices]
        raise ValueError(
            f"face {wrong[0]} has vertex {vertices[0]}; the vertices are numbered from 1, and there "
            f"are {number_of_vertices}"
        )
    return oriented(result - 1)
