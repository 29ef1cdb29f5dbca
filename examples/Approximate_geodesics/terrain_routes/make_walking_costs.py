#!/usr/bin/python3
"""Makes a raster of costs from heights: the seconds that a meter takes on foot, for terrain_routes.

Usage: make_walking_costs.py OUTPUT.asc [HEIGHTS.npz]

HEIGHTS is an archive of NumPy with an array "elevation" in meters, and the sizes "dx" and "dy" of cells and
latitudes "ymin" and "ymax" in degrees, as matplotlib ships one of the Jacksboro fault in Tennessee
(Debian: python-matplotlib-data). Without such a file, heights are generated.

The speed falls with the slope as in Tobler's hiking function, in all directions alike:
6 km/h times exp(-3.5 slope), the slope being the steepest one of the cell.
"""

import os
import sys

import numpy as np

SHIPPED = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"
METERS_PER_DEGREE = 111_200


def read_heights(name):
    """Heights, and the width and the height of a cell in meters."""
    data = np.load(name)
    middle = np.radians((data["ymin"] + data["ymax"]) / 2)
    width = float(data["dx"]) * METERS_PER_DEGREE * np.cos(middle)
    return data["elevation"].astype(float), width, float(data["dy"]) * METERS_PER_DEGREE


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
    return result, 90, 90


def write_ascii_grid(name, values, width, height):
    with open(name, "w") as out:
        rows, columns = values.shape
        out.write(f"ncols {columns}\nnrows {rows}\nxllcorner 0\nyllcorner 0\ndx {width}\ndy {height}\n")
        np.savetxt(out, values, fmt="%.6g")


def main(output, heights=SHIPPED):
    if os.path.exists(heights):
        values, width, height = read_heights(heights)
    else:
        print(f"{heights} is missing: heights are generated")
        values, width, height = generated_heights()
    slope = np.hypot(*np.gradient(values, height, width))
    write_ascii_grid(output, 3.6 / (6 * np.exp(-3.5 * slope)), width, height)


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
