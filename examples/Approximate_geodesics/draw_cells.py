#!/usr/bin/python3
"""Draws what the example exact_cells writes.

Usage: draw_cells.py MESH [FOLDER [AZIMUTH ELEVATION UP]]

Reads MESH, the OFF file that the example has read, and exact_cells.polylines.txt, and writes
exact_cells.png, both in FOLDER, or in the current folder if none is given. The camera looks from AZIMUTH
and ELEVATION, in degrees; UP is the axis that points up: x, y or z.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
here = os.path.dirname(os.path.abspath(__file__))
sys.path += [here, os.path.join(here, "geodesic_distances")]
from draw_picture import place_camera
from draw_field import IVORY, RED, place_lights, save, surface_actor
from draw_loops import loops_actor, read_off

SIZE = (1400, 1400)


def main(mesh, folder=".", azimuth="0", elevation="10", up="y"):
    start = os.path.join(folder, "exact_cells")
    surface = read_off(mesh)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(surface_actor(surface, IVORY))
    borders = start + ".polylines.txt"
    renderer.AddActor(loops_actor(borders, 0.0015 * surface.GetLength(), RED))
    place_lights(renderer)
    place_camera(renderer, float(azimuth), float(elevation), up)
    renderer.GetActiveCamera().Zoom(0.98)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    save(window, start + ".png")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 6):
        sys.exit(__doc__)
    main(*sys.argv[1:])
