"""Vertices and faces of the mesh objects of other packages, which need not be installed."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from . import _arrays

Arrays = tuple[npt.NDArray[Any], npt.NDArray[Any]]


def of_trimesh(mesh: Any) -> Arrays:
    return np.asarray(_member(mesh, "vertices")), np.asarray(_member(mesh, "faces"))


def of_meshio(mesh: Any) -> Arrays:
    """The triangles of all blocks. Blocks of vertices, lines and volumes are ignored."""
    points = np.asarray(_member(mesh, "points"))
    blocks = list(_blocks_of_cells(_member(mesh, "cells")))
    others = {kind for kind, _ in blocks if kind.startswith(("quad", "polygon", "triangle"))}
    others.discard("triangle")
    triangles = [np.asarray(corners) for kind, corners in blocks if kind == "triangle"]
    if others or not triangles:
        kinds = sorted(others or {kind for kind, _ in blocks})
        raise ValueError(f"faces must be triangles; the mesh has cells of: {', '.join(kinds)}")
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.pad(points, [(0, 0), (0, 1)])
    return points, np.concatenate(triangles)


def of_vtk(mesh: Any) -> Arrays:
    """Also those of PyVista, whose class is derived from VTK's, and adds NumPy arrays."""
    if hasattr(mesh, "GetNumberOfStrips") and mesh.GetNumberOfStrips() > 0:
        raise ValueError("the mesh has triangle strips; vtkTriangleFilter makes triangles of them")
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):
        return np.asarray(mesh.points), _unpacked(np.asarray(mesh.faces))
    points = _member(mesh, "GetPoints")()
    if points is None or points.GetNumberOfPoints() == 0:
        return np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)
    coordinates = np.asarray(memoryview(points.GetData()))
    polygons = mesh.GetPolys()
    if polygons.GetNumberOfCells() == 0:
        return coordinates, np.empty((0, 3), dtype=np.int64)
    return coordinates, _unpacked(np.asarray(memoryview(polygons.GetData())).ravel())


def of_open3d(mesh: Any) -> Arrays:
    """Those of `open3d.geometry`, and of `open3d.t.geometry`, whose tensors are converted."""
    if hasattr(mesh, "vertex"):
        tensors = mesh.vertex.positions, mesh.triangle.indices
        positions, indices = (tensor.cpu().numpy() for tensor in tensors)
        return positions, indices
    return np.asarray(_member(mesh, "vertices")), np.asarray(_member(mesh, "triangles"))


def _member(mesh: Any, name: str) -> Any:
    try:
        return getattr(mesh, name)
    except AttributeError:
        kind = f"{type(mesh).__module__}.{type(mesh).__qualname__}"
        raise TypeError(f"the mesh is of type {kind}, which has no {name}") from None


def _blocks_of_cells(cells: Any) -> Iterator[tuple[str, Any]]:
    """Types and corners: of objects, or of pairs or a dictionary, as in versions before 5."""
    if isinstance(cells, dict):
        yield from cells.items()
        return
    for block in cells:
        kind, corners = (block.type, block.data) if hasattr(block, "type") else block
        yield kind, corners


def _unpacked(flat: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The triangles of a flat array in which each face starts with its size."""
    if len(flat) % 4 == 0 and np.all(flat[::4] == 3):
        return _arrays.integers(flat, "faces", (-1,)).reshape(-1, 4)[:, 1:]
    face = place = 0
    while place < len(flat) and flat[place] == 3:
        face, place = face + 1, place + 4
    size = flat[place] if place < len(flat) else "too few"
    raise ValueError(
        f"face {face} has {size} vertices; it must have 3, as a triangle filter makes them"
    )
