"""The class and the function of the module `pygeodesic.geodesic`, with its names.

>>> import approximate_geodesics.pygeodesic as geodesic
>>> algorithm = geodesic.PyGeodesicAlgorithmExact(points, faces)
>>> distances, best_source = algorithm.geodesicDistances([0, 7])

Distances are exact, as there. What cannot be right raises `ValueError`, where pygeodesic prints a
message and returns `None`. Vertices without faces are accepted, and so are faces whose orientations
differ, as there.
"""

from __future__ import annotations

import os
from typing import Optional, Union

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._drop_ins import oriented, vertices_of_mesh
from ._solver import Solver

__all__ = ["PyGeodesicAlgorithmExact", "read_mesh_from_file"]

_INFINITY = float("inf")


class PyGeodesicAlgorithmExact:
    """Exact distances and paths between vertices of one mesh.

    Parameters
    ----------
    points : (n, 3) array of float
    faces : (m, 3) array of int
    epsilon : float, optional
        As for `Solver`: exact by default.
    """

    def __init__(
        self, points: npt.ArrayLike, faces: npt.ArrayLike, *, epsilon: Optional[float] = 0
    ) -> None:
        self._solver = Solver(points, oriented(_arrays.integers(faces, "faces", (-1, 3))), epsilon)

    def geodesicDistance(
        self, sourceIndex: int, targetIndex: int
    ) -> tuple[float, npt.NDArray[np.float64]]:
        """The distance of two vertices, and the points of the path, from the target to the source.

        Points that differ by rounding, as where a path goes through a vertex, are one.

        Returns a float, and a (k, 3) array of float64. Without a path, these are infinity and a
        (0, 3) array.
        """
        points, length = self._solver.path(sourceIndex, targetIndex, return_length=True)
        return length, _distinct(points[::-1], 1e-12 * length)

    def geodesicDistances(
        self,
        source_indices: Optional[npt.ArrayLike] = None,
        target_indices: Optional[npt.ArrayLike] = None,
        max_distance: float = _INFINITY,
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
        """Distances of vertices from the nearest of several, and which of them that is.

        Parameters
        ----------
        source_indices : (k,) array of int, optional
            Vertices; by default, the first one.
        target_indices : (l,) array of int, optional
            Vertices; by default, all.
        max_distance : float
            Targets that are farther get infinity.

        Returns
        -------
        (l,) array of float64
        (l,) array of int32
            Positions among the sources, or -1 for targets that are not reached.
        """
        sources = [0] if source_indices is None else source_indices
        distances, nearest = self._solver.distances(
            _arrays.integers(sources, "source_indices", (-1,)),
            return_nearest=True,
            max_distance=max_distance,
        )
        if target_indices is not None:
            targets = vertices_of_mesh(target_indices, len(distances))
            distances, nearest = distances[targets], nearest[targets]
        return distances, nearest.astype(np.int32)


def _distinct(points: npt.NDArray[np.float64], tolerance: float) -> npt.NDArray[np.float64]:
    """The points that are farther from the one before. Both ends are kept."""
    is_kept = np.ones(len(points), dtype=bool)
    is_kept[1:] = np.linalg.norm(np.diff(points, axis=0), axis=1) > tolerance
    if len(points) > 1 and not is_kept[-1]:
        is_kept[1:-1][np.flatnonzero(is_kept[1:-1])[-1:]] = False  # in place of the end
        is_kept[-1] = True
    result: npt.NDArray[np.float64] = points[is_kept]
    return result


def read_mesh_from_file(
    filename: Union[str, "os.PathLike[str]"]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Read points and faces from a file in the format of the examples of pygeodesic.

    It has two numbers, of the points and of the faces, then the coordinates, then the vertices of
    the faces. Raises `OSError` if there is no such file, and `ValueError` if it has something else.
    """
    with open(filename, encoding="utf-8") as file:
        words = file.read().split()
    try:
        number_of_points, number_of_faces = map(int, words[:2])
        beyond = 2 + 3 * number_of_points
        size = beyond + 3 * number_of_faces
        if min(number_of_points, number_of_faces) < 0 or len(words) != size:
            raise ValueError(
                f"it has {len(words)} numbers; {number_of_points} points and {number_of_faces} faces "
                f"take {size}"
            )
        points = np.array(words[2:beyond], dtype=float)
        faces = _arrays.integers([int(word) for word in words[beyond:]], "faces", (-1,))
    except ValueError as error:
        raise ValueError(f"{os.fspath(filename)} has no mesh: {error}") from None
    return points.reshape(-1, 3), faces.reshape(-1, 3)
