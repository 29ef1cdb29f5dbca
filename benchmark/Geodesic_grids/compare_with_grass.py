#!/usr/bin/env python3
# Copyright (c) 2026  The Approximate Geodesics authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Costs of all cells of a raster, by terrain_routes and by r.cost and r.walk of GRASS, which take
turns: errors, and processor times with everything that is read and written. Both have one thread.

GRASS steps to 8 neighbors of a cell, and with -k to those of a knight's move, too. Where friction is
equal, distances are known; where it varies, the reference is terrain_routes with epsilon 0.03. On
heights, costs are times by Naismith's rule with Langmuir's corrections, and the reference is
terrain_routes on a raster that is four times finer, whose heights are interpolated."""
import argparse
import csv
import os
import pathlib
import statistics
import subprocess
import tempfile

import numpy as np

DEGREES = [f"{i}-{i + 5}" for i in range(0, 45, 5)]  # of directions; the others are symmetric
SIZE_OF_CELL = 30  # on heights


def run(command, **arguments):
    """The processor time in seconds."""
    with subprocess.Popen([str(word) for word in command], text=True, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, **arguments) as process:
        messages = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{command[0]}: {messages}")
    return usage.ru_utime + usage.ru_stime


class Grass:
    """Calls commands of GRASS, in a location of its own without a projection."""

    def __init__(self, folder):
        self.folder = folder
        base = subprocess.run(["grass", "--config", "path"], check=True, text=True,
                              capture_output=True).stdout.strip()
        self.environment = os.environ | {"HOME": str(folder)}
        run(["grass", "-c", "XY", folder / "location", "-e"], env=self.environment)
        settings = folder / "gisrc"
        settings.write_text(f"GISDBASE: {folder}\nLOCATION_NAME: location\nMAPSET: PERMANENT\n")
        self.environment |= {"GISRC": str(settings), "GISBASE": base,
                             "LD_LIBRARY_PATH": f"{base}/lib",
                             "PATH": f"{base}/bin:{os.environ['PATH']}"}

    def call(self, name, *flags, **options):
        words = [f"{key}={value}" for key, value in options.items()]
        return run([name, *flags, *words, "--quiet", "--overwrite"], env=self.environment)

    def read(self, name, values, size_of_cell):
        rows, columns = values.shape
        values.tofile(self.folder / "in.bin")
        self.call("r.in.bin", "-d", input=self.folder / "in.bin", output=name, rows=rows,
                  cols=columns, west=0, south=0, east=columns * size_of_cell,
                  north=rows * size_of_cell)
        self.call("g.region", raster=name)

    def find(self, name, shape, size_of_cell, *flags, **options):
        """Costs from the cell in the middle, and the time."""
        row, column = middle(shape)
        place = (column + 0.5) * size_of_cell, (shape[0] - row - 0.5) * size_of_cell
        seconds = self.call(name, *flags, output="costs", start_coordinates=f"{place[0]},{place[1]}",
                            **options)
        self.call("r.out.bin", "-f", input="costs", output=self.folder / "out.bin", bytes=8)
        return np.fromfile(self.folder / "out.bin").reshape(shape), seconds

    def by_friction(self, friction, *flags):
        self.read("friction", friction, 1)
        return self.find("r.cost", friction.shape, 1, *flags, input="friction")

    def by_heights(self, heights, *flags):
        self.read("heights", heights, SIZE_OF_CELL)
        self.call("r.mapcalc", expression="no_friction = 0")  # r.walk adds it
        return self.find("r.walk", heights.shape, SIZE_OF_CELL, *flags, elevation="heights",
                         friction="no_friction", walk_coeff="0.72,6,2,-2", slope_factor=-0.2125)


class Terrain_routes:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def find(self, values, source, *options):
        """Costs from a cell, and the time."""
        np.save(self.folder / "in.npy", values)
        seconds = run([self.program, *options, self.folder / "in.npy", "--output",
                       self.folder / "out", "--force", "--sources", f"cell:{source[1]},{source[0]}"])
        return np.load(self.folder / "out_cost.npy"), seconds

    def by_friction(self, friction, *options):
        return self.find(friction, middle(friction.shape), *options)

    def by_heights(self, heights, factor=1):
        """If the raster is so many times finer, the costs are those of the original cells."""
        finer = interpolated(interpolated(heights, factor).T, factor).T.copy()
        source = [factor * i for i in middle(heights.shape)]
        costs, seconds = self.find(finer, source, "--cost", "naismith_time", "--cell-size",
                                   SIZE_OF_CELL / factor, "--heights")
        return costs[::factor, ::factor], seconds


def middle(shape):
    return shape[0] // 2, shape[1] // 2


def interpolated(values, factor):
    """Has further rows between those of the values."""
    at = np.arange(factor * (len(values) - 1) + 1) / factor
    first = np.minimum(at.astype(int), len(values) - 2)
    share = (at - first)[:, np.newaxis]
    return (1 - share) * values[first] + share * values[first + 1]


def varied_friction(side):
    """Smooth bands, and noise from cell to cell: the largest is some 30 times the smallest."""
    y, x = np.mgrid[0:side, 0:side] / side
    noise = np.random.default_rng(1).random((side, side))
    return np.exp(1.5 * np.sin(20 * x + 3 * np.sin(14 * y)) + 0.5 * noise)


def vectors_from_middle(side):
    y, x = np.abs(np.mgrid[0:side, 0:side] - side // 2)
    return np.maximum(x, y), np.minimum(x, y)


def errors(costs, reference):
    """In percent; 0 where the reference is."""
    return 100 * np.divide(costs - reference, reference, out=np.zeros_like(costs),
                           where=reference > 0)


def mean_and_largest(costs, reference):
    found = errors(costs, reference)
    return [f"{found.sum() / np.count_nonzero(reference):.2f}", f"{found.max():.2f}"]


def largest_by_direction(costs, reference):
    x, y = vectors_from_middle(len(costs))
    part = np.minimum(np.degrees(np.arctan2(y, x)) // 5, len(DEGREES) - 1)
    found = errors(costs, reference)
    return [f"{found[part == i].max():.3f}" for i in range(len(DEGREES))]


class Comparison:
    """Prints tables, and writes them."""

    def __init__(self, options):
        self.options = options

    def print(self, name, title, table):
        print(f"{title}:\n")
        widths = [max(map(len, column)) for column in zip(*table)]
        for first, *others in table:
            print(first.ljust(widths[0]), *(t.rjust(w) for t, w in zip(others, widths[1:])),
                  sep="  ")
        print(flush=True)
        if self.options.csv:
            with open(self.options.csv + name + ".csv", "w", newline="", encoding="utf-8") as file:
                csv.writer(file, lineterminator="\n").writerows(table)

    def measure(self, name, title, columns, contestants, describe):
        """A row for each contestant: what `describe(costs)` tells, and the time."""
        seconds = {label: [] for label in contestants}
        costs = {}
        for _ in range(self.options.rounds):
            for label, find in contestants.items():
                costs[label], time = find()
                seconds[label].append(time)
        peer = list(contestants)[1]
        table = [["", *columns, "s", f"s : {peer}"]]
        for label, found in costs.items():
            time, of_peer = (statistics.median(seconds[i]) for i in (label, peer))
            table.append([label, *describe(found), f"{time:.2f}", f"{time / of_peer:.2f}"])
        self.print(name, f"{title} (medians of {self.options.rounds})", table)

    def compare_equal_friction(self, grass, routes):
        side = self.options.side
        friction, distances = np.ones((side, side)), np.hypot(*vectors_from_middle(side))
        self.measure("grass_directions", f"Equal friction, {side} x {side} cells, largest errors in "
                     "percent by direction in degrees", [*DEGREES, "mean %", "largest %"], {
                         "r.cost": lambda: grass.by_friction(friction),
                         "r.cost -k": lambda: grass.by_friction(friction, "-k"),
                         "terrain_routes": lambda: routes.by_friction(friction),
                     }, lambda costs: largest_by_direction(costs, distances)
                     + mean_and_largest(costs, distances))

    def compare_friction(self, grass, routes):
        side = self.options.side // 5
        friction = varied_friction(side)
        reference = routes.by_friction(friction, "--epsilon", 0.03)[0]
        self.measure("grass_friction", f"Friction that varies, {side} x {side} cells",
                     ["mean %", "largest %"], {
                         "r.cost": lambda: grass.by_friction(friction),
                         "r.cost -k": lambda: grass.by_friction(friction, "-k"),
                         "terrain_routes": lambda: routes.by_friction(friction),
                         "terrain_routes --epsilon 0.5":
                             lambda: routes.by_friction(friction, "--epsilon", 0.5),
                     }, lambda costs: mean_and_largest(costs, reference))

    def compare_heights(self, grass, routes, name, heights):
        side = len(heights)
        reference = routes.by_heights(heights, 4)[0]
        self.measure(f"grass_{name}", f"Times on heights, {name.replace('_', ' ')}, {side} x {side} "
                     "cells", ["mean %", "largest %"], {
                         "r.walk": lambda: grass.by_heights(heights),
                         "r.walk -k": lambda: grass.by_heights(heights, "-k"),
                         "terrain_routes": lambda: routes.by_heights(heights),
                     }, lambda costs: mean_and_largest(costs, reference))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="terrain_routes")
    parser.add_argument("--bench-grid", required=True, help="bench_grid, which makes the heights")
    parser.add_argument("--side", type=int, default=1000, help="the number of columns and rows")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="only see whether it runs")
    parser.add_argument("--csv", default="", help="write tables, too, to files that start so")
    options = parser.parse_args()
    if options.quick:
        options.side, options.rounds = 100, 1
    comparison = Comparison(options)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        grass, routes = Grass(folder), Terrain_routes(options.program, folder)
        comparison.compare_equal_friction(grass, routes)
        comparison.compare_friction(grass, routes)
        run([options.bench_grid, "--side", options.side, "--write-heights", folder / "heights_"])
        for file in sorted(folder.glob("heights_*")):
            heights = np.fromfile(file).reshape(options.side, options.side)
            comparison.compare_heights(grass, routes, file.name.removeprefix("heights_"), heights)


main()
