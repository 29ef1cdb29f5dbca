"""Shortest distances and paths along triangle meshes, on NumPy arrays.

A `Solver` reads a mesh once, and answers any number of questions:

>>> import approximate_geodesics as ag
>>> solver = ag.Solver(vertices, faces, epsilon=0.1)
>>> distances = solver.distances(0)

A `Grid` does the same for rasters, which need no mesh.

Lengths are in the unit of the vertices. Input that cannot be right raises `ValueError`, with a
message that names the vertex or the face.
"""

from ._cells import Cells
from ._costs import (
    CostFunction,
    DirectionalCost,
    DriftTime,
    HikingTime,
    NaismithTime,
    OneWay,
    TensorCost,
    WalkingEnergy,
)
from ._drop_ins import compute_gdist, local_gdist_matrix
from ._files import read_mesh
from ._grid import Grid
from ._native import version as __version__
from ._solver import Solver

__all__ = [
    "Cells",
    "CostFunction",
    "DirectionalCost",
    "DriftTime",
    "Grid",
    "HikingTime",
    "NaismithTime",
    "OneWay",
    "Solver",
    "TensorCost",
    "WalkingEnergy",
    "compute_gdist",
    "local_gdist_matrix",
    "read_mesh",
]
