"""Meshes whose distances are known."""

import numpy as np


def sphere(level):
    """An icosahedron with each face divided into `4 ** level`, on the unit sphere."""
    t = (1 + 5**0.5) / 2
    vertices = [
        (-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
        (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1),
    ]
    faces = [
        (0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
        (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
        (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1),
    ]
    vertices, faces = np.array(vertices, dtype=float), np.array(faces)
    for _ in range(level):
        vertices, faces = divided(vertices, faces)
    return vertices / np.linalg.norm(vertices, axis=1)[:, None], faces.astype(np.int32)


def divided(vertices, faces):
    """Each face divided into four."""
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, number = np.unique(sides, axis=0, return_inverse=True)
    a, b, c = number.reshape(3, -1) + len(vertices)
    u, v, w = faces.T
    parts = [(u, a, c), (a, v, b), (c, b, w), (a, b, c)]
    return (
        np.concatenate([vertices, vertices[edges].mean(axis=1)]),
        np.concatenate([np.stack(part, axis=1) for part in parts]),
    )


def great_circles(vertices, source):
    return np.arccos(np.clip(vertices @ vertices[source], -1, 1))


def grid(size):
    """A flat square, whose vertex `size * y + x` is at (x, y, 0)."""
    y, x = np.mgrid[:size, :size]
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(size * size)], axis=1).astype(float)
    corner = (size * y[:-1, :-1] + x[:-1, :-1]).ravel()
    below = np.stack([corner, corner + 1, corner + size], axis=1)
    above = np.stack([corner + 1, corner + size + 1, corner + size], axis=1)
    return vertices, np.concatenate([below, above]).astype(np.int32)


def torus(around, across):
    """Around the z axis, of radii 3 and 1. Vertex `across * i` is on the outside of ring `i`."""
    i, j = (k.ravel() for k in np.mgrid[:around, :across])
    u, v = 2 * np.pi * i / around, 2 * np.pi * j / across
    radius = 3 + np.cos(v)
    vertices = np.stack([radius * np.cos(u), radius * np.sin(u), np.sin(v)], axis=1)
    k, m = (i + 1) % around, (j + 1) % across
    a, b, c, d = across * i + j, across * k + j, across * k + m, across * i + m
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return vertices, faces.astype(np.int32)
