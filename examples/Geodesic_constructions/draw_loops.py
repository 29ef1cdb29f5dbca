#!/usr/bin/python3
"""Draws what the example loops writes.

Usage: draw_loops.py MESH [FOLDER [AZIMUTH ELEVATION UP]]

Reads MESH, the OFF file that the example has read, and loops_*.polylines.txt, and writes loops.png, both
in FOLDER, or in the current folder if none is given. The camera looks from AZIMUTH and ELEVATION, in
degrees; UP is the axis that points up: x, y or z.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
here = os.path.dirname(os.path.abspath(__file__))
sys.path += [here, os.path.join(here, "geodesic_distances")]
from draw_picture import DARK, actor_of, balls_actor, place_camera, tubes
from draw_field import IVORY, RED, BLUE, place_lights, save, surface_actor
from draw_terrain import read_polylines

SIZE = (1600, 1400)


def read_off(name):
    with open(name, encoding="ascii") as file:
        words = [w for line in file for w in line.partition("#")[0].split()]
    number_of_points, number_of_faces = int(words[1]), int(words[2])
    numbers = iter(words[4:])
    points, faces = vtk.vtkPoints(), vtk.vtkCellArray()
    for _ in range(number_of_points):
        points.InsertNextPoint([float(next(numbers)) for _ in range(3)])
    for _ in range(number_of_faces):
        corners = [int(next(numbers)) for _ in range(int(next(numbers)))]
        faces.InsertNextCell(len(corners), corners)
    result = vtk.vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(faces)
    return result


def loops_actor(name, radius, color):
    lines = vtk.vtkTrivialProducer()
    lines.SetOutput(read_polylines(name))
    return actor_of(tubes(lines, radius), color)


def first_points(name):
    lines = read_polylines(name)
    result, ends = vtk.vtkPoints(), vtk.vtkIdList()
    lines.GetLines().InitTraversal()
    while lines.GetLines().GetNextCell(ends):
        result.InsertNextPoint(lines.GetPoint(ends.GetId(0)))
    return result


def draw(file, actors, camera, zoom, size):
    """Writes a picture of actors. `camera` is an azimuth, an elevation, and the axis that points up."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    place_lights(renderer)
    azimuth, elevation, up = camera
    place_camera(renderer, float(azimuth), float(elevation), up)
    renderer.GetActiveCamera().Zoom(zoom)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    save(window, file)


def main(mesh, folder=".", azimuth="20", elevation="35", up="y"):
    start = os.path.join(folder, "loops")
    surface = read_off(mesh)
    unit = surface.GetLength()
    fixed = start + "_fixed.polylines.txt"
    actors = (
        surface_actor(surface, IVORY),
        loops_actor(fixed, 0.003 * unit, BLUE),
        balls_actor(first_points(fixed), 0.009 * unit, DARK),
        loops_actor(start + "_free.polylines.txt", 0.004 * unit, RED),
    )
    draw(start + ".png", actors, (azimuth, elevation, up), 1.05, SIZE)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 6):
        sys.exit(__doc__)
    main(*sys.argv[1:])
