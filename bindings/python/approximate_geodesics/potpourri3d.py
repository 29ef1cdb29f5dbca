"""Classes and functions with potpourri3d's names, for what both packages have.

>>> import approximate_geodesics.potpourri3d as pp3d
>>> solver = pp3d.MeshHeatMethodDistanceSolver(V, F)
>>> distances = solver.compute_distance(7)

There is no heat method behind them: distances are the lengths of paths on the surface, and have a
bound. What only the heat method needs is accepted, and ignored. What `MeshVectorHeatSolver` extends
comes from the nearest source along an exact shortest path, and is not smoothed. What is not here,
such as signed distances, `Solver` has in another form, or it has nothing to do with paths: see the
README.
"""

from __future__ import annotations

import functools
from typing import Optional, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._files import read_mesh
from ._solver import Solver

__all__ = [
    "EdgeFlipGeodesicSolver",
    "GeodesicTracer",
    "MeshHeatMethodDistanceSolver",
    "MeshVectorHeatSolver",
    "compute_distance",
    "compute_distance_multisource",
    "read_mesh",
]


class MeshHeatMethodDistanceSolver:
    """Distances from vertices of one mesh.

    Parameters
    ----------
    V : (n, 3) array of float
    F : (m, 3) array of int
    t_coef, use_robust
        Ignored.
    epsilon : float, optional
        The bound, as for `Solver`.
    """

    def __init__(
        self,
        V: npt.ArrayLike,
        F: npt.ArrayLike,
        t_coef: float = 1.0,
        use_robust: bool = True,
        *,
        epsilon: Optional[float] = 0.1,
    ) -> None:
        self._solver = Solver(V, F, epsilon)

    def compute_distance(self, v_ind: int) -> _arrays.Floats:
        """Distances of all vertices from one, (n,) float64; infinity where there is no path."""
        return self.compute_distance_multisource([v_ind])

    def compute_distance_multisource(self, v_inds: npt.ArrayLike) -> _arrays.Floats:
        """Distances of all vertices from the nearest of several, (n,) float64."""
        vertices = _arrays.integers(v_inds, "v_inds", (-1,))
        return self._solver.distances(vertices)


def compute_distance(V: npt.ArrayLike, F: npt.ArrayLike, v_ind: int) -> _arrays.Floats:
    """Distances of all vertices from one, for a mesh that is seen once, (n,) float64."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(
    V: npt.ArrayLike, F: npt.ArrayLike, v_inds: npt.ArrayLike
) -> _arrays.Floats:
    """Distances of all vertices from the nearest of several, (n,) float64."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class EdgeFlipGeodesicSolver:
    """Locally shortest paths on one mesh.

    They are straightened from paths within the bound, so that most are the shortest of all.

    Parameters
    ----------
    V : (n, 3) array of float
    F : (m, 3) array of int
    t_coef
        Ignored.
    epsilon : float, optional
        The bound, as for `Solver`.
    """

    def __init__(
        self,
        V: npt.ArrayLike,
        F: npt.ArrayLike,
        t_coef: float = 1.0,
        *,
        epsilon: Optional[float] = 0.1,
    ) -> None:
        self._solver = Solver(V, F, epsilon)

    def find_geodesic_path(
        self,
        v_start: int,
        v_end: int,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> _arrays.Floats:
        """The points of a path from one vertex to another, (k, 3) float64; (0, 3) if there is none.

        `max_iterations` and `max_relative_length_decrease` are ignored: paths are straightened to
        the end, which is as short as more iterations would make them.
        """
        start, end = _integer(v_start, "vertices"), _integer(v_end, "vertices")
        return self._solver.path(start, end, straighten=True)

    def find_geodesic_path_poly(
        self,
        v_list: Sequence[int],
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> _arrays.Floats:
        """The points of a locally shortest path from the first vertex to the last, (k, 3) float64.

        It is shortened from the curve of shortest paths between each vertex and the next, and
        passes none of those between the ends in general.
        """
        return self._solver.shorten_curve(_several(v_list, "path"))

    def find_geodesic_loop(
        self,
        v_list: Sequence[int],
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> _arrays.Floats:
        """The points of a closed geodesic, (k, 3) float64, whose last one is the first one.

        It is shortened from the closed curve of shortest paths between each vertex and the next,
        and the last and the first. It passes none of the vertices in general. If the curve
        contracts, it is a single point.
        """
        return self._solver.shorten_loop(_several(v_list, "loop"))


class GeodesicTracer:
    """Walks straight ahead on one mesh.

    Parameters
    ----------
    V : (n, 3) array of float
    F : (m, 3) array of int
    t_coef
        Ignored.
    """

    def __init__(self, V: npt.ArrayLike, F: npt.ArrayLike, t_coef: float = 1.0) -> None:
        self._solver = Solver(V, F)
        self._vertices, self._faces = self._solver.vertices, self._solver.faces

    def trace_geodesic_from_vertex(
        self, start_vert: int, direction_xyz: npt.ArrayLike, max_iterations: Optional[int] = None
    ) -> _arrays.Floats:
        """The points of a walk from a vertex, (k, 3) float64.

        Its direction and its length are those of a vector in space, after projection to the plane
        that is orthogonal to the normal of the vertex. `max_iterations` is ignored.
        """
        vertex = _integer(start_vert, "vertices")
        direction = _in_space(direction_xyz)
        if 0 <= vertex < len(self._normals):  # if not, `trace` says so
            direction = _projected(direction, self._normals[vertex])
        return self._solver.trace(vertex, direction)

    def trace_geodesic_from_face(
        self,
        start_face: int,
        bary_coords: npt.ArrayLike,
        direction_xyz: npt.ArrayLike,
        max_iterations: Optional[int] = None,
    ) -> _arrays.Floats:
        """The points of a walk from barycentric coordinates in a face, (k, 3) float64.

        The vector is projected to the plane of the face.
        """
        face = _integer(start_face, "faces")
        coordinates = _arrays.numbers(bary_coords, "bary_coords", (3,))
        direction = _in_space(direction_xyz)
        if 0 <= face < len(self._faces):
            a, b, c = self._vertices[self._faces[face]]
            direction = _projected(direction, np.cross(b - a, c - a))
        return self._solver.trace((face, coordinates), direction)

    @functools.cached_property
    def _normals(self) -> _arrays.Floats:
        return self._solver.tangent_frames()[2]


def _projected(direction: _arrays.Floats, normal: _arrays.Floats) -> _arrays.Floats:
    size = np.abs(normal).max()
    if not size > 0:
        return direction
    normal = normal / size
    return direction - (direction @ normal) / (normal @ normal) * normal


def _in_space(direction: npt.ArrayLike) -> _arrays.Floats:
    return _arrays.numbers(direction, "direction_xyz", (3,))


class MeshVectorHeatSolver:
    """Values and vectors that are extended from vertices, and the logarithmic map, on one mesh.

    Parameters
    ----------
    V : (n, 3) array of float
    F : (m, 3) array of int
    t_coef, use_intrinsic_delaunay
        Ignored.
    """

    def __init__(
        self,
        V: npt.ArrayLike,
        F: npt.ArrayLike,
        t_coef: float = 1.0,
        use_intrinsic_delaunay: bool = True,
    ) -> None:
        self._solver = Solver(V, F, 0)

    def extend_scalar(self, v_inds: npt.ArrayLike, values: npt.ArrayLike) -> _arrays.Floats:
        """The value of the nearest of several vertices, for each vertex, (n,) float64.

        It is zero at vertices that are not reached.
        """
        vertices = _arrays.integers(v_inds, "v_inds", (-1,))
        of_sources = _arrays.numbers(values, "values", (len(vertices),))
        nearest = self._solver.distances(vertices, return_nearest=True)[1]
        return np.append(of_sources, 0.0)[nearest]  # -1: none

    def transport_tangent_vector(self, v_ind: int, vector: npt.ArrayLike) -> _arrays.Floats:
        """A tangent vector, (2,), of a vertex, carried to each vertex, (n, 2) float64."""
        return self.transport_tangent_vectors(
            [v_ind], _arrays.numbers(vector, "vector", (2,))[np.newaxis]
        )

    def transport_tangent_vectors(
        self, v_inds: npt.ArrayLike, vectors: npt.ArrayLike
    ) -> _arrays.Floats:
        """The tangent vector of the nearest of several vertices, carried to each vertex.

        Both `vectors` and the result, (n, 2) float64, are in the frames that `get_tangent_frames`
        returns.
        """
        vertices = _arrays.integers(v_inds, "v_inds", (-1,))
        return self._solver.extend_vectors(vertices, vectors)

    def get_tangent_frames(self) -> tuple[_arrays.Floats, _arrays.Floats, _arrays.Floats]:
        """The x axes, y axes and normals of the vertices, (n, 3) float64 each."""
        return self._solver.tangent_frames()

    def compute_log_map(self, v_ind: int, strategy: Optional[str] = None) -> _arrays.Floats:
        """The logarithmic map of a vertex in its frame, (n, 2) float64.

        It is exact, whatever the `strategy`.
        """
        return self._solver.logarithmic_map(_integer(v_ind, "vertices"))


def _integer(value: int, name: str) -> int:
    return int(_arrays.integers([value], name, (1,))[0])


def _several(v_list: Sequence[int], what: str) -> _arrays.Integers:
    vertices = _arrays.integers(v_list, "v_list", (-1,))
    if len(vertices) < 2:
        raise ValueError(f"there are {len(vertices)} vertices; a {what} has at least 2")
    return vertices
