"""A distance matrix in a file of NumPy, block by block, with a progress bar by tqdm."""

import numpy as np
from _sample_meshes import sample_mesh
from tqdm import tqdm

import approximate_geodesics as ag

solver = ag.Solver.from_file(sample_mesh("elephant.off"), epsilon=0.1)
points = solver.farthest_points(500)

# one call, whose progress is told
with tqdm(total=len(points), unit=" rows") as bar:
    matrix = solver.distance_matrix(
        points, points, progress=lambda done, _: bar.update(done - bar.n)
    )
print(f"The largest distance between {len(points)} points is {matrix.max():.4g}")

# or block by block, if memory is too small for the whole
file = np.lib.format.open_memmap(
    "matrix.npy", mode="w+", dtype=np.float32, shape=(len(points), solver.number_of_vertices)
)
for rows, block in tqdm(solver.iter_blocks(points, block_size=100), total=5):
    file[rows] = block
file.flush()
print(f"matrix.npy has the shape {file.shape}")
