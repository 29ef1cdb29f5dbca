"""Distances from a vertex of the Stanford bunny, isolines, and paths, as a picture.

Usage: first_picture.py [MESH [PICTURE]]
"""

import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from _sample_meshes import sample_mesh

import approximate_geodesics as ag


class Front:
    """What is seen of a mesh from the front, where z is largest."""

    SIZE = 250  # of a raster with the depth of what is in front

    def __init__(self, vertices, faces):
        self.low, self.high = vertices.min(axis=0), vertices.max(axis=0)
        corners = vertices[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self.normals = normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        front = np.flatnonzero(self.normals[:, 2] > 0)
        self.faces = front[np.argsort(corners[front].mean(axis=1)[:, 2])]  # the last ones cover
        self.depth = np.full((self.SIZE, self.SIZE), -np.inf)
        for weights in np.random.default_rng(1).dirichlet([1, 1, 1], 40):
            samples = weights @ corners[front]
            np.maximum.at(self.depth, self.cell(samples), samples[:, 2])

    def cell(self, points):
        size = np.maximum(self.high - self.low, 1e-300)
        return tuple(((points - self.low) / size * (self.SIZE - 1)).round().astype(int).T[:2])

    def is_seen(self, points):
        return points[:, 2] > self.depth[self.cell(points)] - 0.03 * (self.high - self.low)[2]

    def draw_surface(self, axes, vertices, faces, values):
        colors = plt.get_cmap("viridis")(values[faces[self.faces]].mean(axis=1))
        light = 0.35 + 0.65 * self.normals[self.faces] @ np.array([0.3, 0.5, 0.81])
        colors[:, :3] *= np.clip(light, 0, 1)[:, None]
        polygons = vertices[faces[self.faces]][:, :, :2]
        axes.add_collection(PolyCollection(polygons, facecolors=colors, edgecolors=colors, lw=0.3))

    def draw_line(self, axes, points, **style):
        shown = np.where(self.is_seen(points)[:, None], points, np.nan)
        axes.plot(shown[:, 0], shown[:, 1], **style)


mesh = sys.argv[1] if len(sys.argv) > 1 else sample_mesh("bunny00.off")
picture = sys.argv[2] if len(sys.argv) > 2 else "first_picture.png"

# three lines to an answer
vertices, faces = ag.read_mesh(mesh)
solver = ag.Solver(vertices, faces, epsilon=0.1)
points = solver.farthest_points(60)

front = Front(vertices, faces)
points = points[front.is_seen(vertices[points])]
source = points[np.argmin(vertices[points, 1])]
distances = solver.distances(source)
longest = distances[np.isfinite(distances)].max()
print(f"{solver}: up to {longest:.4g} from vertex {source}")

figure, axes = plt.subplots(figsize=(7, 7))
front.draw_surface(axes, vertices, faces, np.minimum(distances / longest, 1))
for lines in solver.isolines(distances, np.linspace(0, longest, 24)[1:-1]):
    for line in lines:
        front.draw_line(axes, line, color="white", lw=0.6)
for target in points:
    front.draw_line(axes, solver.path(source, target, straighten=True), color="red", lw=1.5)
(left, bottom), (right, top) = front.low[:2], front.high[:2]
axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
axes.axis("off")
figure.savefig(picture, dpi=120, bbox_inches="tight")
print(f"The picture is {picture}")
