"""The plug-in in ParaView: distances, isolines and paths, which are checked and drawn. Run by pvpython.

Usage: test_plugin.py PLUGIN.so PICTURE.png
"""

import math
import sys

from paraview import simple

plugin, picture = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=globals())
sphere = simple.Sphere(ThetaResolution=120, PhiResolution=120)  # of radius 0.5; its points 0 and 1 are poles


def largest(proxy, array="GeodesicDistance", port=0):
    proxy.UpdatePipeline()
    arrays = proxy.GetDataInformation(port).GetPointDataInformation()
    return arrays.GetArrayInformation(array).GetComponentRange(0)[1]


def check(value, expected, tolerance=1e-3):
    assert abs(value - expected) < tolerance, f"{value}, and not {expected}"


# sources of all three kinds
distance = ApproximateGeodesicDistance(Input=sphere, SourceIds=[0], Epsilon=0)  # noqa: F821
check(largest(distance), math.pi / 2)
check(largest(distance, port=1), math.pi / 2 * 10 / 11)
distance.Epsilon = 0.1
assert math.pi / 2 - 1e-3 < largest(distance) < 1.1 * math.pi / 2
distance.Epsilon = 0
distance.SourcePoints = simple.PointSource(Center=[0, 0, -2], NumberOfPoints=1, Radius=0)
check(largest(distance), math.pi / 4, 0.01)
distance.Selection = simple.IDSelectionSource(FieldType="POINT", IDs=[-1, 5000])
distance.NearestSources = 1
check(largest(distance, "NearestSource"), 2)

# a path whose length is known
path = ApproximateGeodesicPath(Input=sphere, StartVertex=0, EndVertex=5000, Epsilon=0)  # noqa: F821
length = simple.AppendArcLength(Input=path)
end = simple.servermanager.Fetch(sphere).GetPoint(5000)
check(largest(length, "arc_length"), 0.5 * math.acos(end[2] / 0.5), 1e-3)

view = simple.CreateView("RenderView", ViewSize=[900, 700], Background=[1, 1, 1], UseColorPaletteForBackground=0)
view.OrientationAxesVisibility = 0
surface = simple.Show(distance, view)
simple.ColorBy(surface, ("POINTS", "GeodesicDistance"))
surface.RescaleTransferFunctionToDataRange(False, True)
for lines, color, radius in [
    (simple.OutputPort(distance, 1), [1, 1, 1], 0.0015),
    (simple.OutputPort(path, 0), [0.9, 0.1, 0.1], 0.006),
]:
    shown = simple.Show(simple.Tube(Input=lines, Radius=radius), view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = color
simple.ResetCamera(view)
view.CameraPosition = [1.2, -1.6, 1]
simple.ResetCamera(view)
simple.SaveScreenshot(picture, view)
print(f"The picture is {picture}")
