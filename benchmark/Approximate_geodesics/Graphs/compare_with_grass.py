#!/usr/bin/python3
# Copyright (c) 2026  The Approximate Geodesics authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares terrain_routes with r.cost of GRASS on the same rasters: times and errors of both, in one run.

Usage: compare_with_grass.py --program TERRAIN_ROUTES [--side N] [--side-of-errors N]

r.cost goes to 8 neighbors of a cell, and with -k to those of a knight's move, too. Rasters are flat, where
distances are known; and with friction that varies by a factor of 30, where the reference is terrain_routes
with epsilon 0.03. Times are processor times of both programs with everything they read and write.

Needs GRASS (Debian: grass-core) and NumPy.
"""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy as np


def seconds_of(command, **arguments):
    """The processor time of a program in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, **arguments)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def run_in_grass(folder, side, *flags):
    """To be called within GRASS: reads `friction.bin`, writes `costs.bin`, and prints the time."""
    middle = side // 2 + 0.5
    place = [f"north={side}", "south=0", f"east={side}", "west=0", f"rows={side}", f"cols={side}"]
    quiet = ["--quiet", "--overwrite"]
    subprocess.run(
        ["r.in.bin", "-d", f"input={folder}/friction.bin", "output=friction", *place, *quiet], check=True
    )
    subprocess.run(["g.region", "raster=friction"], check=True)
    start = f"start_coordinates={middle},{side - middle}"
    print(seconds_of(["r.cost", *flags, "input=friction", "output=costs", start, *quiet]))
    subprocess.run(
        ["r.out.bin", "-f", "input=costs", f"output={folder}/costs.bin", "bytes=8", *quiet], check=True
    )


def costs_of_grass(folder, friction, *flags):
    """Costs and the time in seconds."""
    side = len(friction)
    friction.tofile(folder / "friction.bin")
    grass = ["grass", "--tmp-location", "XY", "--exec"]
    inner = [sys.executable, __file__, "--in-grass", str(folder), str(side), *flags]
    output = subprocess.run(grass + inner, check=True, capture_output=True, text=True).stdout
    seconds = float(output.strip().splitlines()[-1])
    return np.fromfile(folder / "costs.bin").reshape(side, side), seconds


def costs_of_program(program, folder, friction, *options):
    side = len(friction)
    np.save(folder / "friction.npy", friction)
    middle = f"cell:{side // 2},{side // 2}"
    seconds = seconds_of(
        [program, folder / "friction.npy", "-s", middle, "-o", folder / "ours", "--force", *options]
    )
    return np.load(folder / "ours_cost.npy"), seconds


def varied_friction(side):
    y, x = np.mgrid[0:side, 0:side] / side
    noise = np.random.default_rng(1).random((side, side))
    return np.exp(1.5 * np.sin(20 * x + 3 * np.sin(14 * y)) + 0.5 * noise)


def distances_in_plane(side):
    y, x = np.mgrid[0:side, 0:side] - side // 2
    return np.hypot(x, y)


def compare(title, program, folder, friction, reference):
    print(f"\n{title}, {len(friction)} x {len(friction)} cells:\n")
    print(f"{'':30}{'mean %':>10}{'largest %':>11}{'seconds':>9}{'ratio':>7}")
    first = None
    for name, find in {
        "r.cost": lambda: costs_of_grass(folder, friction),
        "r.cost -k": lambda: costs_of_grass(folder, friction, "-k"),
        "terrain_routes": lambda: costs_of_program(program, folder, friction),
        "terrain_routes --epsilon 0.3": lambda: costs_of_program(program, folder, friction, "-e0.3"),
    }.items():
        costs, seconds = find()
        first = first or seconds
        errors = 100 * (costs / np.where(reference > 0, reference, np.inf) - 1)[reference > 0]
        print(f"{name:30}{errors.mean():10.3f}{errors.max():11.3f}{seconds:9.2f}{seconds / first:7.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, type=pathlib.Path)
    parser.add_argument("--side", type=int, default=1001, help="of the flat raster")
    parser.add_argument("--side-of-errors", type=int, default=201, help="of the other one")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        flat = np.ones((options.side, options.side))
        compare("Equal friction", options.program, folder, flat, distances_in_plane(options.side))
        varied = varied_friction(options.side_of_errors)
        reference, _ = costs_of_program(options.program, folder, varied, "-e0.03")
        compare("Friction that varies", options.program, folder, varied, reference)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--in-grass"]:
        run_in_grass(sys.argv[2], int(sys.argv[3]), *sys.argv[4:])
    else:
        main()
