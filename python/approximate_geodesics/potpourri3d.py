"""Classes and functions with potpourri3d's names, for what both packages have.

>>> import approximate_geodesics.potpourri3d as pp3d
>>> solver = pp3d.MeshHeatMethodDistanceSolver(V, F)
>>> distances = solver.compute_distance(7)

There is no heat method behind them: distances are the lengths of paths on the surface, and have a
bound. What only the heat method needs is accepted, and ignored.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._solver import Solver

__all__ = [
    "EdgeFlipGeodesicSolver",
    "MeshHeatMethodDistanceSolver",
    "compute_distance",
    "compute_distance_multisource",
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

    def compute_distance_multisource(self, v_ind_list: npt.ArrayLike) -> _arrays.Floats:
        """Distances of all vertices from the nearest of several, (n,) float64."""
        result: _arrays.Floats = self._solver.distances(np.asarray(v_ind_list))
        return result


def compute_distance(V: npt.ArrayLike, F: npt.ArrayLike, v_ind: int) -> _arrays.Floats:
    """Distances of all vertices from one, for a mesh that is seen once, (n,) float64."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(
    V: npt.ArrayLike, F: npt.ArrayLike, v_ind_list: npt.ArrayLike
) -> _arrays.Floats:
    """Distances of all vertices from the nearest of several, (n,) float64."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_ind_list)


class EdgeFlipGeodesicSolver:
    """Locally shortest paths on one mesh.

    They are straightened from paths within the bound, so that most are the shortest of all.

    Parameters
    ----------
    V : (n, 3) array of float
    F : (m, 3) array of int
    epsilon : float, optional
        The bound, as for `Solver`.
    """

    def __init__(
        self, V: npt.ArrayLike, F: npt.ArrayLike, *, epsilon: Optional[float] = 0.1
    ) -> None:
        self._solver = Solver(V, F, epsilon)

    def find_geodesic_path(
        self,
        v_start: int,
        v_end: int,
        max_iterations: Any = None,
        max_relative_length_decrease: Any = None,
    ) -> _arrays.Floats:
        """The points of a path from one vertex to another, (k, 3) float64.

        `max_iterations` and `max_relative_length_decrease` must be `None`: paths are straightened
        to the end.
        """
        if max_iterations is not None or max_relative_length_decrease is not None:
            raise ValueError("paths are straightened to the end: no limit can be given")
        result: _arrays.Floats = self._solver.path(v_start, v_end, straighten=True)
        return result
