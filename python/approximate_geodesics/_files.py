"""Meshes from files."""

from __future__ import annotations

import os
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _native


def read_mesh(
    file: Union[str, "os.PathLike[str]"]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
    """Read a triangle mesh from a file: OFF, OBJ, PLY, STL, VTP, or another format of CGAL.

    Returns the vertices, (n, 3) `float64`, and the faces, (m, 3) `int32`.

    Raises `OSError` if there is no such file, and `ValueError` if it holds no mesh or a face that is
    not a triangle.
    """
    return _native.read_mesh(os.fspath(file))
