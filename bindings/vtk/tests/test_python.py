"""The filters in Python: the sequences of calls of programs and of PyVista, with the class exchanged."""

import math

import pytest
import vtk_approximate_geodesics as ag
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath
from vtkmodules.vtkFiltersSources import vtkSphereSource


def sphere(center=(0, 0, 0)):
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetThetaResolution(30)
    source.SetPhiResolution(30)
    source.Update()
    return source.GetOutput()


def joined(*surfaces):
    append = vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


def geodesic(surface, start, end, make_filter, use_scalar_weights=False):
    """What a `geodesic` method of meshes does: the points from the start to the end, and their ids."""
    path = make_filter()
    path.SetInputData(surface)
    path.SetStartVertex(start)
    path.SetEndVertex(end)
    path.SetUseScalarWeights(use_scalar_weights)
    path.Update()
    ids = [path.GetIdList().GetId(i) for i in range(path.GetIdList().GetNumberOfIds())]
    output = path.GetOutput()
    if output.GetNumberOfPoints() == 0:
        raise ValueError(f"there is no path between {start} and {end}")
    points = vtk_to_numpy(output.GetPoints().GetData())
    assert len(ids) == len(points)
    assert output.GetNumberOfCells() == 1
    if ids[0] == end:
        ids, points = ids[::-1], points[::-1]
    return points, ids


def length(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


@pytest.mark.parametrize("scalars", [False, True])
def test_a_geodesic_has_the_points_with_its_ids(scalars):
    surface = sphere()
    end = surface.GetNumberOfPoints() - 1
    points, ids = geodesic(surface, 0, end, ag.vtkApproximateGeodesicPath, scalars)
    assert ids[0] == 0 and ids[-1] == end
    assert (points == vtk_to_numpy(surface.GetPoints().GetData())[ids]).all()


def test_a_geodesic_is_as_long_as_that_of_vtk():
    surface = sphere()
    for end in range(1, surface.GetNumberOfPoints(), 97):
        found = [geodesic(surface, 0, end, make)[0]
                 for make in (ag.vtkApproximateGeodesicPath, vtkDijkstraGraphGeodesicPath)]
        assert length(found[0]) == pytest.approx(length(found[1]), rel=1e-6)


def test_there_is_no_geodesic_between_components():
    surfaces = joined(sphere(), sphere((10, 0, 0)))
    with pytest.raises(ValueError, match="there is no path"):
        geodesic(surfaces, 0, surfaces.GetNumberOfPoints() - 1, ag.vtkApproximateGeodesicPath)


def test_distances_of_a_pipeline():
    source = vtkSphereSource()
    source.SetThetaResolution(60)
    source.SetPhiResolution(60)
    distance = ag.vtkApproximateGeodesicDistance()
    distance.SetInputConnection(source.GetOutputPort())
    distance.AddSource(0)
    distance.SetEpsilon(0)
    distance.Update()
    values = vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("GeodesicDistance"))
    assert values[0] == 0
    assert values[1] == pytest.approx(math.pi / 2, rel=2e-3)  # the other pole
    source.SetRadius(2)
    distance.Update()
    values = vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("GeodesicDistance"))
    assert values[1] == pytest.approx(2 * math.pi, rel=2e-3)


def test_errors_are_events_and_not_exceptions():
    distance = ag.vtkApproximateGeodesicDistance()
    distance.SetInputData(sphere())
    messages = []

    def collect(caller, event, message):
        messages.append(message)

    collect.CallDataType = "string0"
    distance.AddObserver("ErrorEvent", collect)
    distance.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    distance.AddSource(10**6)
    distance.Update()
    assert "source 0 is vertex 1000000" in messages[0]
