#!/usr/bin/python3
"""Draws what the example multidimensional_scaling writes.

Usage: draw_scaling.py [FOLDER [AZIMUTH ELEVATION UP]]

Reads multidimensional_scaling_original.ply and multidimensional_scaling.ply, and writes
multidimensional_scaling.png, all of them in FOLDER, or in the current folder if none is given. The
camera looks from AZIMUTH and ELEVATION, in degrees; UP is the axis that points up: x, y or z.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
here = os.path.dirname(os.path.abspath(__file__))
sys.path += [here, os.path.join(here, "geodesic_distances")]
from draw_field import add_title, place_lights, save, surface_actor
from draw_picture import place_camera

SIZE = (2000, 1100)
PANELS = {"original": "_original.ply", "canonical form": ".ply"}  # from left to right


def read(name):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def main(folder=".", azimuth="20", elevation="5", up="y"):
    start = os.path.join(folder, "multidimensional_scaling")
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    for i, (title, end) in enumerate(PANELS.items()):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(0.5 * i, 0, 0.5 * (i + 1), 1)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(surface_actor(read(start + end)))
        add_title(renderer, title)
        place_lights(renderer)
        place_camera(renderer, float(azimuth), float(elevation), up)
        renderer.GetActiveCamera().Zoom(0.82)  # leaves room for the title
        renderer.GetActiveCamera().SetWindowCenter(0, -0.05)
        window.AddRenderer(renderer)
    save(window, start + ".png")


if __name__ == "__main__":
    if len(sys.argv) not in (1, 2, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
