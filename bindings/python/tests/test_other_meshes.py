"""Mesh objects of other packages: stand-ins with their attributes, and the packages that are there."""

from types import SimpleNamespace

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid, sphere

VERTICES, FACES = sphere(2)
EXPECTED = ag.Solver(VERTICES, FACES, 0.1).distances(5)
FLAT_FACES = np.insert(FACES, 0, 3, axis=1).ravel()


def expect_same(solver):
    assert solver.epsilon == 0.1
    np.testing.assert_array_equal(solver.faces, FACES)
    np.testing.assert_allclose(solver.distances(5), EXPECTED, rtol=1e-6)


class Tracked(np.ndarray):
    """As arrays of trimesh, which are of a derived class."""


def test_stand_in_for_trimesh():
    mesh = SimpleNamespace(vertices=VERTICES.view(Tracked), faces=FACES.view(Tracked))
    expect_same(ag.Solver.from_trimesh(mesh, 0.1))
    expect_same(ag.Solver.from_trimesh(mesh, epsilon=0.1, threads=1))


@pytest.mark.parametrize(
    "cells",
    [
        [SimpleNamespace(type="vertex", data=[[0]]), SimpleNamespace(type="triangle", data=FACES)],
        [SimpleNamespace(type="triangle", data=part) for part in np.split(FACES, [100])],
        [("line", [[0, 1]]), ("triangle", FACES)],
        {"triangle": FACES, "tetra": [[0, 1, 2, 3]]},
    ],
)
def test_stand_in_for_meshio(cells):
    expect_same(ag.Solver.from_meshio(SimpleNamespace(points=VERTICES, cells=cells), 0.1))


def test_flat_meshes_of_meshio_have_two_coordinates():
    vertices, faces = grid(4)
    mesh = SimpleNamespace(points=vertices[:, :2], cells=[("triangle", faces)])
    assert ag.Solver.from_meshio(mesh, 0).distances(0)[15] == pytest.approx(np.hypot(3, 3))


@pytest.mark.parametrize(
    "cells, message",
    [
        ([("triangle", FACES), ("quad", [[0, 1, 2, 3]])], "cells of: quad"),
        ([("triangle6", [[0, 1, 2, 3, 4, 5]])], "cells of: triangle6"),
        ([("tetra", [[0, 1, 2, 3]])], "faces must be triangles; the mesh has cells of: tetra"),
    ],
)
def test_cells_that_are_not_triangles(cells, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver.from_meshio(SimpleNamespace(points=VERTICES, cells=cells))


def test_stand_in_for_pyvista():
    mesh = SimpleNamespace(points=VERTICES.astype(np.float32), faces=FLAT_FACES)
    expect_same(ag.Solver.from_pyvista(mesh, 0.1))
    empty = SimpleNamespace(points=VERTICES, faces=np.empty(0, int))
    assert ag.Solver.from_pyvista(empty).number_of_faces == 0


def test_strips_of_pyvista_are_refused():
    def with_strips(number):
        strips = {"GetNumberOfStrips": lambda: number}
        return SimpleNamespace(points=VERTICES, faces=FLAT_FACES, **strips)

    expect_same(ag.Solver.from_pyvista(with_strips(0), 0.1))
    with pytest.raises(ValueError, match="triangle strips; vtkTriangleFilter"):
        ag.Solver.from_pyvista(with_strips(1))


@pytest.mark.parametrize(
    "faces, message",
    [
        ([3, 0, 1, 2, 4, 0, 1, 2, 3], "face 1 has 4 vertices; it must have 3"),
        ([2, 0, 1], "face 0 has 2 vertices"),
        ([3, 0, 1], "face 1 has too few vertices"),
    ],
)
def test_flat_faces_that_are_not_triangles(faces, message):
    with pytest.raises(ValueError, match=message):
        ag.Solver.from_pyvista(SimpleNamespace(points=VERTICES, faces=faces))


class Tensor:
    def __init__(self, values):
        self.values = values

    def cpu(self):
        return self

    def numpy(self):
        return self.values


def test_stand_ins_for_open3d():
    expect_same(ag.Solver.from_open3d(SimpleNamespace(vertices=VERTICES, triangles=FACES), 0.1))
    mesh = SimpleNamespace(
        vertex=SimpleNamespace(positions=Tensor(VERTICES.astype(np.float32))),
        triangle=SimpleNamespace(indices=Tensor(FACES.astype(np.int64))),
    )
    expect_same(ag.Solver.from_open3d(mesh, 0.1))


@pytest.mark.parametrize(
    "make, missing",
    [
        (ag.Solver.from_trimesh, "vertices"),
        (ag.Solver.from_meshio, "points"),
        (ag.Solver.from_pyvista, "GetPoints"),
        (ag.Solver.from_open3d, "vertices"),
    ],
)
def test_other_objects_are_named(make, missing):
    with pytest.raises(TypeError, match=f"of type builtins.dict, which has no {missing}"):
        make({})


def test_with_trimesh():
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")
    mesh = trimesh.Trimesh(VERTICES, FACES, process=False)
    expect_same(ag.Solver.from_trimesh(mesh, 0.1))


def test_with_meshio():
    meshio = pytest.importorskip("meshio", reason="meshio is not installed")
    expect_same(ag.Solver.from_meshio(meshio.Mesh(VERTICES, [("triangle", FACES)]), 0.1))


def vtk_mesh(vtk, faces):
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetDataTypeToDouble()
    for vertex in VERTICES:
        points.InsertNextPoint(vertex)
    for face in faces:
        cells.InsertNextCell(len(face), face)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def test_with_vtk():
    reason = "VTK is not installed"
    vtk = pytest.importorskip("vtkmodules.vtkCommonDataModel", reason=reason)
    core = pytest.importorskip("vtkmodules.vtkCommonCore", reason=reason)
    names = SimpleNamespace(**{**vars(core), **vars(vtk)})
    expect_same(ag.Solver.from_pyvista(vtk_mesh(names, FACES.tolist()), 0.1))
    with pytest.raises(ValueError, match="face 2 has 4 vertices"):
        ag.Solver.from_pyvista(vtk_mesh(names, [*FACES[:2].tolist(), [0, 1, 2, 3]]))
    assert ag.Solver.from_pyvista(names.vtkPolyData()).number_of_vertices == 0
    strips = names.vtkCellArray()
    strips.InsertNextCell(4, [0, 1, 2, 3])
    mesh = vtk_mesh(names, [])
    assert ag.Solver.from_pyvista(mesh).number_of_faces == 0
    mesh.SetStrips(strips)
    with pytest.raises(ValueError, match="triangle strips; vtkTriangleFilter"):
        ag.Solver.from_pyvista(mesh)


def test_with_pyvista():
    pyvista = pytest.importorskip("pyvista", reason="PyVista is not installed")
    expect_same(ag.Solver.from_pyvista(pyvista.PolyData(VERTICES, FLAT_FACES), 0.1))


def test_with_open3d():
    open3d = pytest.importorskip("open3d", reason="Open3D is not installed")
    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(VERTICES), open3d.utility.Vector3iVector(FACES)
    )
    expect_same(ag.Solver.from_open3d(mesh, 0.1))
