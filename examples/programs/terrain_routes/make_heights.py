#!/usr/bin/python3
"""Makes a raster of heights in meters, whose cells are in degrees, for terrain_routes.

Usage: make_heights.py OUTPUT.asc [HEIGHTS.npz]

HEIGHTS is an archive of NumPy with an array "elevation" in meters, and in degrees the sizes "dx" and "dy" of
cells, and the coordinates "xmin", "ymin" and "ymax" of borders, as matplotlib ships one of the Jacksboro fault in
Tennessee (Debian: python-matplotlib-data). Without such a file, heights are generated.
"""

import os
import sys

import numpy as np

SHIPPED = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"


def generated_heights(size=400):
    """Hills of all sizes: waves in random directions, the shorter the lower."""
    random = np.random.default_rng(1)
    y, x = np.mgrid[0:size, 0:size] / size
    result = np.zeros((size, size))
    for _ in range(200):
        frequency = 2 ** random.uniform(0, 5)
        angle, phase = random.uniform(0, 2 * np.pi, 2)
        wave = np.sin(2 * np.pi * frequency * (x * np.cos(angle) + y * np.sin(angle)) + phase)
        result += 80 * wave / frequency
    return {"elevation": result, "dx": 1 / 1200, "dy": 1 / 1200, "xmin": -84.4, "ymin": 36.4, "ymax": 36.4 + size / 1200}


def main(output, heights=SHIPPED):
    if os.path.exists(heights):
        data = np.load(heights)
    else:
        print(f"{heights} is missing: heights are generated")
        data = generated_heights()
    rows, columns = data["elevation"].shape
    bottom = min(data["ymin"], data["ymax"])  # that file has them the other way round
    with open(output, "w") as out:
        out.write(f"ncols {columns}\nnrows {rows}\nxllcorner {data['xmin']}\nyllcorner {bottom}\n")
        out.write(f"dx {data['dx']}\ndy {data['dy']}\n")
        np.savetxt(out, data["elevation"], fmt="%.6g")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
