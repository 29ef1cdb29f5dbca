"""Meshes from files."""

from __future__ import annotations

import errno
import os
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _native


def read_mesh(
    file: Union[str, "os.PathLike[str]"]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
    """Read a triangle mesh from a file: OFF, OBJ, PLY, STL, or another format of CGAL.

    Returns the vertices, (n, 3) `float64`, and the faces, (m, 3) `int32`.

    Raises `OSError` if there is no such file, and `ValueError` if it holds no mesh or a face that is
    not a triangle.
    """
    return _native.read_mesh(name_of(file))


def name_of(file: Union[str, "os.PathLike[str]"]) -> str:
    result = os.fspath(file)
    if not isinstance(result, str):
        raise TypeError(f"the name of a file is of type {type(result).__name__}; it must be str")
    if "\0" in result:
        raise ValueError("the name of a file has a null character")
    try:
        result.encode()
    except UnicodeEncodeError:
        raise ValueError(f"the name of the file {result!r} is not UTF-8") from None
    if os.path.isdir(result):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), result)
    return result
