#!/usr/bin/python3
"""Draws what the example paths_on_weighted_terrain writes.

Usage: draw_terrain.py [FOLDER]

Reads weighted_terrain.ply and weighted_terrain_*.polylines.txt, and writes weighted_terrain.png,
all of them in FOLDER, or in the current folder if none is given.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "geodesic_distances"))
from draw_picture import DARK, WHITE, actor_of, balls_actor, save, tubes

SIZE = (2200, 1400)
RED, ORANGE, BROWN = (0.86, 0.06, 0.10), (1.0, 0.58, 0.05), (0.36, 0.20, 0.11)
LINES = {  # the file of each, its color and radius, and what the legend says
    "shortest": (WHITE, 0.020, "shortest path, costs ignored"),
    "road_closed": (ORANGE, 0.024, "the same, road closed"),
    "cheapest": (RED, 0.024, "cheapest path"),
    "fence": (BROWN, 0.022, "fence"),
}
GROUNDS = [  # as in the example; the number is what a kilometer costs
    ((246, 232, 190), "road 0.3 per km"),
    ((150, 198, 104), "level 1"),
    ((102, 160, 76), "slope 2"),
    ((62, 112, 60), "steep 5"),
    ((150, 144, 138), "cliff: forbidden"),
    ((82, 146, 214), "lake: forbidden"),
]


def read_polylines(name):
    """A line of the file is the number of points, and their coordinates."""
    points, lines = vtk.vtkPoints(), vtk.vtkCellArray()
    with open(name, encoding="ascii") as file:
        for text in file:
            numbers = [float(word) for word in text.split()[1:]]
            lines.InsertNextCell(len(numbers) // 3)
            for i in range(0, len(numbers), 3):
                lines.InsertCellPoint(points.InsertNextPoint(numbers[i : i + 3]))
    result = vtk.vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    return result


def surface_actor(reader):
    """One color per face, and shades as those of a smooth surface."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SplittingOff()
    actor = actor_of(normals)
    actor.GetMapper().SetScalarModeToUseCellFieldData()
    actor.GetMapper().SelectColorArray("RGBA")
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def walls_actor(reader, height=0.13):
    """What makes a block of the surface: walls down from its border."""
    border = vtk.vtkFeatureEdges()
    border.SetInputConnection(reader.GetOutputPort())
    border.FeatureEdgesOff()
    border.NonManifoldEdgesOff()
    border.ColoringOff()
    walls = vtk.vtkLinearExtrusionFilter()
    walls.SetInputConnection(border.GetOutputPort())
    walls.SetExtrusionTypeToVectorExtrusion()
    walls.SetVector(0, 0, -height)
    actor = actor_of(walls, (0.55, 0.45, 0.36))
    actor.GetProperty().LightingOff()
    return actor


def lines_actor(lines, color, radius):
    producer = vtk.vtkTrivialProducer()
    producer.SetOutput(lines)
    actor = actor_of(tubes(producer, radius), color)
    actor.GetProperty().SetAmbient(0.5)
    actor.GetProperty().SetDiffuse(0.6)
    return actor


def style(text, size):
    text.SetFontFamilyToArial()
    text.SetFontSize(size)
    text.SetColor(*DARK)
    text.SetVerticalJustificationToCentered()


def add_place(renderer, point, name):
    points = vtk.vtkPoints()
    points.InsertNextPoint(point)
    renderer.AddActor(balls_actor(points, 0.06, DARK))
    label = vtk.vtkBillboardTextActor3D()
    label.SetInput(name)
    label.SetPosition(point[0], point[1] - 0.4, point[2] + 0.35)  # in front of the ground
    label.SetDisplayOffset(0, -46)
    style(label.GetTextProperty(), 44)
    label.GetTextProperty().SetJustificationToCentered()
    renderer.AddActor(label)


def add_entry(renderer, x, y, height, color, text):
    """A bar of the given color and height at (`x`, `y`), in pixels, and the text beside it."""
    bar = vtk.vtkPlaneSource()
    bar.SetOrigin(x, y - height / 2, 0)
    bar.SetPoint1(x + 70, y - height / 2, 0)
    bar.SetPoint2(x, y + height / 2, 0)
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputConnection(bar.GetOutputPort())
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    renderer.AddActor2D(actor)
    label = vtk.vtkTextActor()
    label.SetInput(text)
    label.SetPosition(x + 88, y)
    style(label.GetTextProperty(), 36)
    renderer.AddActor2D(label)


def add_legend(renderer):
    for x, (color, text) in zip((60, 475, 755, 1045, 1330, 1755), GROUNDS):
        add_entry(renderer, x, 120, 46, [c / 255 for c in color], text)
    for x, name in zip((1045, 475, 60, 1755), LINES):
        color, _, text = LINES[name]
        add_entry(renderer, x, 46, 14, color, text)


def place_light_and_camera(renderer):
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(-4, -1, 6)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(2.5, 2.22, 0)
    camera.SetPosition(2.5, -7.4, 8.2)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(19.5)
    camera.SetWindowCenter(0, -0.08)  # leaves room for the legend
    renderer.ResetCameraClippingRange()


def main(folder="."):
    start = os.path.join(folder, "weighted_terrain")
    reader = vtk.vtkPLYReader()
    reader.SetFileName(start + ".ply")
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.93, 0.95, 0.97)
    renderer.AddActor(surface_actor(reader))
    renderer.AddActor(walls_actor(reader))
    for name, (color, radius, _) in LINES.items():
        lines = read_polylines(f"{start}_{name}.polylines.txt")
        renderer.AddActor(lines_actor(lines, color, radius))
        if name == "cheapest":
            add_place(renderer, lines.GetPoint(0), "start")
            add_place(renderer, lines.GetPoint(lines.GetNumberOfPoints() - 1), "target")
    add_legend(renderer)
    place_light_and_camera(renderer)
    save(renderer, SIZE, start + ".png")


if __name__ == "__main__":
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
