"""Distances on a surface from one of its points, isolines, and paths to some others, as a picture.

Usage: distance_and_path.py [SURFACE.ply [PICTURE.png]]
"""

import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, which draws
from vtk_approximate_geodesics import vtkApproximateGeodesicDistance, vtkApproximateGeodesicPath
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkSuperquadric
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFlyingEdges3D, vtkTubeFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

picture = sys.argv[2] if len(sys.argv) > 2 else "distance_and_path.png"
if len(sys.argv) > 1:
    surface = vtkPLYReader()
    surface.SetFileName(sys.argv[1])
else:
    ring = vtkSuperquadric()
    ring.ToroidalOn()
    ring.SetThickness(0.4)
    ring.SetThetaRoundness(0.6)
    samples = vtkSampleFunction()
    samples.SetImplicitFunction(ring)
    samples.SetSampleDimensions(90, 60, 90)
    samples.SetModelBounds(-1, 1, -0.6, 0.6, -1, 1)
    samples.ComputeNormalsOff()
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(samples.GetOutputPort())
    surface.SetValue(0, 0)

distance = vtkApproximateGeodesicDistance()
distance.SetInputConnection(surface.GetOutputPort())
distance.AddSource(0)
distance.SetEpsilon(0.1)
distance.SetNumberOfIsolines(25)
distance.Update()
low, high = distance.GetOutput().GetPointData().GetScalars().GetFiniteRange()
size = distance.GetOutput().GetLength()
print(f"{distance.GetOutput().GetNumberOfPoints()} points, up to {high:.4g} from point 0")

renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)


def show(lines_or_surface, color=None, radius=0):
    """Adds the output of an algorithm to the picture, as tubes if they have a radius."""
    if radius > 0:
        tubes = vtkTubeFilter()
        tubes.SetInputConnection(lines_or_surface)
        tubes.SetRadius(radius)
        lines_or_surface = tubes.GetOutputPort()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(lines_or_surface)
    mapper.SetScalarRange(low, high)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)


show(distance.GetOutputPort(0))
show(distance.GetOutputPort(1), (1, 1, 1), 0.0015 * size)
path = vtkApproximateGeodesicPath()
path.SetInputConnection(surface.GetOutputPort())
path.SetEpsilon(0)
paths = vtkAppendPolyData()
number = distance.GetOutput().GetNumberOfPoints()
for i in range(1, 8):
    path.SetEndVertex(i * number // 8)
    path.Update()
    print(f"to point {path.GetEndVertex()}: {path.GetLength():.4g}")
    copy = vtkPolyData()
    copy.DeepCopy(path.GetOutput())
    paths.AddInputData(copy)
show(paths.GetOutputPort(), (0.1, 0.1, 0.1), 0.003 * size)

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(900, 700)
window.AddRenderer(renderer)
renderer.ResetCamera()
renderer.GetActiveCamera().Azimuth(180)
renderer.GetActiveCamera().Elevation(40)
renderer.GetActiveCamera().Zoom(1.2)
renderer.ResetCameraClippingRange()
image = vtkWindowToImageFilter()
image.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(picture)
writer.Write()
print(f"The picture is {picture}")
