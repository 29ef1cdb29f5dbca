"""Reads a surface of a brain as GIfTI, and writes distances from a vertex as GIfTI.

Usage: gifti_distances.py [SURFACE [VERTEX [OUTPUT]]]

Without a surface, an ellipsoid of the size of one takes its place. Distances are in millimeters, as
coordinates are, and not numbers where no path leads to.
"""

import sys

import nibabel as nib
import numpy as np

import approximate_geodesics as ag


def ellipsoid(rows=60, columns=120):
    """A closed surface with poles, as large as a hemisphere of a cortex."""
    u, v = np.meshgrid(
        np.linspace(0, np.pi, rows)[1:-1], np.linspace(0, 2 * np.pi, columns, endpoint=False),
        indexing="ij",
    )
    ring = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], axis=-1)
    points = np.concatenate([ring.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]]) * [35, 80, 55]
    number = np.arange((rows - 2) * columns).reshape(rows - 2, columns)
    a, b = number[:-1], number[1:]
    right = lambda x: np.roll(x, -1, axis=1)
    north, south = (np.full(columns, len(points) - i) for i in (2, 1))
    parts = [
        (a, b, right(a)), (right(a), b, right(b)),
        (north, number[0], np.roll(number[0], -1)), (south, np.roll(number[-1], -1), number[-1]),
    ]
    faces = np.concatenate([np.stack([x.ravel() for x in part], axis=1) for part in parts])
    return points.astype(np.float32), faces.astype(np.int32)


def write_surface(file, points, faces):
    meta = nib.gifti.GiftiMetaData(AnatomicalStructurePrimary="CortexLeft")
    arrays = [
        nib.gifti.GiftiDataArray(points, intent="NIFTI_INTENT_POINTSET", meta=meta),
        nib.gifti.GiftiDataArray(faces, intent="NIFTI_INTENT_TRIANGLE"),
    ]
    nib.save(nib.gifti.GiftiImage(darrays=arrays), file)


def write_distances(file, distances, surface):
    """Writes them with what the surface says of itself, such as its hemisphere."""
    of_points = surface.get_arrays_from_intent("NIFTI_INTENT_POINTSET")[0].meta
    array = nib.gifti.GiftiDataArray(distances, intent="NIFTI_INTENT_SHAPE", meta=of_points)
    nib.save(nib.gifti.GiftiImage(darrays=[array], meta=surface.meta), file)


def main(surface=None, vertex="0", output="distances.shape.gii"):
    if surface is None:
        surface = "ellipsoid.surf.gii"
        write_surface(surface, *ellipsoid())
    image = nib.load(surface)
    solver = ag.Solver(*image.agg_data(("pointset", "triangle")), epsilon=0.1)
    distances = solver.distances(int(vertex)).astype(np.float32)
    distances[np.isinf(distances)] = np.nan
    write_distances(output, distances, image)
    print(f"{solver}: up to {np.nanmax(distances):.1f} mm from vertex {vertex}; see {output}")


main(*sys.argv[1:])
