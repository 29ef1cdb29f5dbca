#!/usr/bin/python3
"""Draws what the example there_and_back writes.

Usage: draw_there_and_back.py [FOLDER]

Reads there_and_back_*.ply and there_and_back_*.polylines.txt, and writes there_and_back.png, all of
them in FOLDER, or in the current folder if none is given.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [FOLDER, os.path.join(FOLDER, "geodesic_distances")]
from draw_picture import DARK, WHITE, actor_of, balls_actor, save, tubes
from draw_terrain import add_entry, read_polylines, walls_actor

SIZE = (2200, 1900)
RED, BLUE = (0.86, 0.06, 0.10), (0.08, 0.25, 0.85)
GROUNDS = [  # heights in meters
    (550, (0.42, 0.60, 0.34)),
    (900, (0.62, 0.70, 0.42)),
    (1300, (0.74, 0.68, 0.52)),
    (1700, (0.62, 0.60, 0.58)),
    (2100, (0.95, 0.95, 0.97)),
]
BOTTOM_OF_MOUNTAIN = 0.36  # in parts of the picture


def path_of(folder, name):
    return os.path.join(folder, "there_and_back_" + name)


def lines_actor(folder, name, color, radius):
    producer = vtk.vtkTrivialProducer()
    producer.SetOutput(read_polylines(path_of(folder, name + ".polylines.txt")))
    actor = actor_of(tubes(producer, radius), color)
    actor.GetProperty().SetAmbient(0.6)
    actor.GetProperty().SetDiffuse(0.5)
    return actor


def reader_of(folder, name):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path_of(folder, name + ".ply"))
    reader.Update()
    return reader


def mountain_actor(reader):
    heights = vtk.vtkElevationFilter()
    low, high = GROUNDS[0][0], GROUNDS[-1][0]
    heights.SetInputConnection(reader.GetOutputPort())
    heights.SetLowPoint(0, 0, low)
    heights.SetHighPoint(0, 0, high)
    heights.SetScalarRange(low, high)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(heights.GetOutputPort())
    normals.SplittingOff()
    colors = vtk.vtkColorTransferFunction()
    for height, color in GROUNDS:
        colors.AddRGBPoint(height, *color)
    actor = actor_of(normals)
    actor.GetMapper().SetLookupTable(colors)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    return actor


def add_balls(renderer, lines, radius):
    points = vtk.vtkPoints()
    for i in (0, lines.GetNumberOfPoints() - 1):
        points.InsertNextPoint(lines.GetPoint(i))
    renderer.AddActor(balls_actor(points, radius, DARK))


def new_renderer(bottom, top):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.93, 0.95, 0.97)
    renderer.SetViewport(0, bottom, 1, top)
    return renderer


def mountain(folder):
    renderer = new_renderer(BOTTOM_OF_MOUNTAIN, 1)
    reader = reader_of(folder, "mountain")
    renderer.AddActor(mountain_actor(reader))
    renderer.AddActor(walls_actor(reader, 350))
    renderer.AddActor(lines_actor(folder, "isochrones_there", RED, 12))
    renderer.AddActor(lines_actor(folder, "isochrones_back", BLUE, 12))
    renderer.AddActor(lines_actor(folder, "up", RED, 50))
    renderer.AddActor(lines_actor(folder, "down", BLUE, 50))
    add_balls(renderer, read_polylines(path_of(folder, "up.polylines.txt")), 130)
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(-8000, 3000, 12000)
    light.SetFocalPoint(6000, 6000, 800)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(6000, 4300, 700)
    camera.SetPosition(6000, -13500, 21500)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    for y, color, text in (
        (110, RED, "least energy up to the summit; what is reached from the village in 30, 60, ... minutes"),
        (50, BLUE, "least energy down again; from where the village is reached in that time"),
    ):
        add_entry(renderer, 60, y, 14, color, text)
    renderer.ResetCameraClippingRange()
    return renderer


def river(folder):
    renderer = new_renderer(0, BOTTOM_OF_MOUNTAIN)
    water = actor_of(reader_of(folder, "river"), (0.52, 0.72, 0.90))
    water.GetProperty().LightingOff()
    renderer.AddActor(water)
    renderer.AddActor(lines_actor(folder, "isochrones_on_river", WHITE, 0.5))
    renderer.AddActor(lines_actor(folder, "crossings", RED, 1.4))
    add_balls(renderer, read_polylines(path_of(folder, "crossings.polylines.txt")), 3.5)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(200, 93, 0)
    camera.SetPosition(200, 93, 100)
    camera.SetParallelScale(116)
    text = "across a river that flows to the right, and what is reached in 30, 60, ... seconds"
    add_entry(renderer, 60, 34, 14, RED, text)
    renderer.ResetCameraClippingRange()
    return renderer


def main(folder="."):
    top, bottom = mountain(folder), river(folder)
    save(top, SIZE, path_of(folder, "").rstrip("_") + ".png", [bottom])


if __name__ == "__main__":
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
