"""Meshes from files, and files that are replaced when they are complete."""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
import shutil
from typing import Callable, Union

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


def replace(name: str, write: Callable[[str], None]) -> None:
    """Call `write` with the name of a new file beside one, which it replaces when it is complete.

    Until then, the present file stays as it is. A device or a pipe is written to at once.
    """
    target = os.path.realpath(name)
    try:
        if os.path.exists(name) and not os.path.isfile(name):
            write(name)  # the target of a link like /dev/stdout may be no path
            return
        place = _new_file(target)
        try:
            write(place)
            if os.path.exists(target):
                shutil.copymode(target, place)
            os.replace(place, target)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(place)
            raise
    except OSError as error:
        raise OSError(error.errno, error.strerror, name) from error


def _new_file(target: str) -> str:
    for number in itertools.count():
        place = f"{target}.new{number}"
        try:
            os.close(os.open(place, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
            return place
        except FileExistsError:
            continue
        except OSError as error:
            reason = f"{error.strerror}; no file can be created in {os.path.dirname(target)}"
            raise OSError(error.errno, reason) from error
    raise AssertionError("there are more files than numbers")
