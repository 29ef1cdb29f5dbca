#!/usr/bin/env python3
"""NumPy and SciPy read files of distances, which have the same distances, and right ones.

Usage: read_matrix_files.py COMPUTE_MATRIX_FILE"""
import pathlib
import subprocess
import sys
import tempfile

import numpy
import scipy.sparse

RADIUS = 4


def computed(folder, name, kind, **arguments):
    file = pathlib.Path(folder) / name
    words = [f"{key}={value}" for key, value in arguments.items()]
    subprocess.run([sys.argv[1], f"file={file}", f"kind={kind}", "side=12", *words], check=True)
    return file


def loaded(folder):
    """The sparse matrix of a folder, mapped into memory, as the manual says."""
    data, indices, indptr, shape = (
        numpy.load(folder / f"{name}.npy", mmap_mode="r") for name in ("data", "indices", "indptr", "shape"))
    matrix = scipy.sparse.csr_matrix((data, indices, indptr), shape=shape)
    assert numpy.shares_memory(matrix.data, data) and numpy.shares_memory(matrix.indices, indices)
    return matrix


def check_sparse(sparse, dense, is_kept):
    """`is_kept(row)` tells which entries of a row of distances are in the file."""
    assert sparse.format == "csr" and sparse.dtype == numpy.float32
    assert sparse.shape == dense.shape
    for i, row in enumerate(dense):
        part = slice(sparse.indptr[i], sparse.indptr[i + 1])
        columns = sparse.indices[part]
        assert numpy.array_equal(numpy.sort(columns), numpy.flatnonzero(is_kept(row)))
        assert numpy.array_equal(sparse.data[part], row[columns])
    assert sparse.nnz < dense.size


with tempfile.TemporaryDirectory() as folder:
    dense = numpy.load(computed(folder, "a.npy", "npy"), mmap_mode="r")
    symmetric = numpy.load(computed(folder, "b.npy", "symmetric"), mmap_mode="r")
    within = loaded(computed(folder, "c.csr", "csr", radius=RADIUS))
    nearest = loaded(computed(folder, "d.csr", "nearest"))

    for matrix in (dense, symmetric):
        assert isinstance(matrix, numpy.memmap)
        assert matrix.dtype == numpy.float32 and matrix.shape == (144, 144)
        assert matrix.flags.c_contiguous
        assert (numpy.diag(matrix) == 0).all() and (matrix > 0).sum() == 144 * 143
    assert numpy.array_equal(symmetric, numpy.minimum(dense, dense.T))
    check_sparse(within, dense, lambda row: row <= RADIUS)
    check_sparse(nearest, dense, lambda row: row <= numpy.sort(row)[19])
    assert (numpy.diff(nearest.indptr) == 20).all()

    another = pathlib.Path(folder) / "by SciPy.npz"  # one file, for those who want one
    scipy.sparse.save_npz(another, within)
    assert (scipy.sparse.load_npz(another) != within).nnz == 0
