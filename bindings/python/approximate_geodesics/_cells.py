"""What `Solver.voronoi_borders` and `Solver.cut_locus` return."""

from __future__ import annotations

from typing import NamedTuple

from . import _arrays


class Cells(NamedTuple):
    """The exact cells of sources. Sources are named by their positions among the sources."""

    areas: _arrays.Floats
    """The area of the cell of each source, (k,) float64."""

    borders: list[_arrays.Floats]
    """Polylines, (n, 3) float64 each; the last point of a closed one equals its first one."""

    border_sources: _arrays.Integers
    """The two sources of each border, (b, 2) int64; the cell of the first is on the left."""

    neighbors: _arrays.Integers
    """The pairs of sources whose cells have a border in common, (p, 2) int64, sorted."""

    triangles: _arrays.Integers
    """The dual triangulation: three sources where their cells meet, (t, 3) int64."""
