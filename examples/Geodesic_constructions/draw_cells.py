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

sys.dont_write_bytecode = True  # beside the sources
here = os.path.dirname(os.path.abspath(__file__))
sys.path += [here, os.path.join(here, "geodesic_distances")]
from draw_field import IVORY, RED, surface_actor
from draw_loops import draw, loops_actor, read_off

SIZE = (1400, 1400)


def main(mesh, folder=".", azimuth="0", elevation="10", up="y"):
    start = os.path.join(folder, "exact_cells")
    surface = read_off(mesh)
    borders = loops_actor(start + ".polylines.txt", 0.0015 * surface.GetLength(), RED)
    draw(start + ".png", (surface_actor(surface, IVORY), borders), (azimuth, elevation, up), 0.98, SIZE)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 6):
        sys.exit(__doc__)
    main(*sys.argv[1:])
