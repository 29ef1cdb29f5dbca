#!/usr/bin/python3
"""Draws a path along edges beside one across faces, with the isolines of both kinds of distances.

Usage: draw_edge_and_epsilon_path.py FOLDER AZIMUTH ELEVATION UP

Reads edges.vtp, edges_paths.vtp, epsilon.vtp and epsilon_paths.vtp, as geodesic_distances writes them,
and writes edge_and_epsilon_path.png, all of them in FOLDER. The camera looks from AZIMUTH and
ELEVATION, in degrees; UP is the axis that points up: x, y or z.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), *3 * [".."], "examples")
sys.path.append(os.path.join(EXAMPLES, "Approximate_geodesics", "geodesic_distances"))
from draw_picture import DARK, actor_of, balls_actor, color_map, place_camera, save, tubes

SIZE = (2000, 1060)
NUMBER_OF_ISOLINES = 40
ZOOM = 1.7
STRIP = 0.09  # of the picture's height
RED = (0.80, 0.05, 0.10)
PANELS = {"edges": "along edges", "epsilon": "across faces, epsilon 0.05"}


def read(name):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def length(path):
    points = [path.GetPoint(i) for i in range(path.GetNumberOfPoints())]
    squared = vtk.vtkMath.Distance2BetweenPoints
    return sum(squared(p, q) ** 0.5 for p, q in zip(points, points[1:]))


def surface_actor(surface, farthest):
    """The mesh in pale colors of its distances, with its edges."""
    surface.GetPointData().SetActiveScalars("distance")
    actor = actor_of(surface)
    actor.GetMapper().SetLookupTable(color_map(farthest))
    actor.GetMapper().SetUseLookupTableScalarRange(True)
    actor.GetMapper().SetInterpolateScalarsBeforeMapping(True)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.45)
    look.SetDiffuse(0.65)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(1, 1, 1)
    look.SetLineWidth(1)
    return actor


def isolines_actor(surface, farthest, radius):
    contours = vtk.vtkContourFilter()
    contours.SetInputData(surface)
    for i in range(1, NUMBER_OF_ISOLINES):
        contours.SetValue(i - 1, farthest * i / NUMBER_OF_ISOLINES)
    return actor_of(tubes(contours, radius), DARK)


def path_points(scene):
    """The points of the only path, in their order."""
    ids, points = vtk.vtkIdList(), vtk.vtkPoints()
    scene.GetLines().InitTraversal()
    scene.GetLines().GetNextCell(ids)
    for i in range(ids.GetNumberOfIds()):
        points.InsertNextPoint(scene.GetPoint(ids.GetId(i)))
    return points


def path_actor(points, radius):
    line = vtk.vtkPolyLineSource()
    line.SetNumberOfPoints(points.GetNumberOfPoints())
    line.SetPoints(points)
    actor = actor_of(tubes(line, radius), RED)
    actor.GetProperty().SetAmbient(0.5)
    return actor


def titles(texts):
    """What is behind the panels: a strip below them has the texts."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for i, text in enumerate(texts):
        title = vtk.vtkTextActor()
        title.SetInput(text)
        style = title.GetTextProperty()
        style.SetFontFamilyToArial()
        style.SetFontSize(44)
        style.SetColor(*DARK)
        style.SetJustificationToCentered()
        title.SetPosition(SIZE[0] * (2 * i + 1) / 4, 24)
        renderer.AddActor2D(title)
    return renderer


def look_between(camera, one, other):
    """From where the camera is, at a path between two points."""
    for i in range(3):
        shift = (one[i] + other[i]) / 2 - camera.GetFocalPoint()[i]
        for get, put in (
            (camera.GetPosition, camera.SetPosition),
            (camera.GetFocalPoint, camera.SetFocalPoint),
        ):
            place = list(get())
            place[i] += shift
            put(*place)
    camera.Zoom(ZOOM)
    camera.SetWindowCenter(0, 0)


def panel(surface, path, left, farthest, view):
    unit = surface.GetLength()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(left, STRIP, left + 0.49, 1)
    renderer.AddActor(surface_actor(surface, farthest))
    renderer.AddActor(isolines_actor(surface, farthest, 0.0009 * unit))
    renderer.AddActor(path_actor(path, 0.0035 * unit))
    ends = vtk.vtkPoints()
    ends.InsertNextPoint(path.GetPoint(0))
    ends.InsertNextPoint(path.GetPoint(path.GetNumberOfPoints() - 1))
    renderer.AddActor(balls_actor(ends, 0.008 * unit, RED))
    place_camera(renderer, float(view[0]), float(view[1]), view[2])
    look_between(renderer.GetActiveCamera(), ends.GetPoint(0), ends.GetPoint(1))
    renderer.ResetCameraClippingRange()
    return renderer


def main(folder, *view):
    surfaces = [read(os.path.join(folder, name + ".vtp")) for name in PANELS]
    paths = [path_points(read(os.path.join(folder, name + "_paths.vtp"))) for name in PANELS]
    farthest = max(s.GetPointData().GetArray("distance").GetRange()[1] for s in surfaces)
    panels = [panel(surfaces[i], paths[i], 0.51 * i, farthest, view) for i in range(2)]
    texts = [f"{text}: length {length(path):.3f}" for text, path in zip(PANELS.values(), paths)]
    save(titles(texts), SIZE, os.path.join(folder, "edge_and_epsilon_path.png"), panels)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
