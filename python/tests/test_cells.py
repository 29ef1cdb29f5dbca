import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import grid, sphere

PLANE = ag.Solver(*grid(9))
SPHERE = ag.Solver(*sphere(3))


def test_the_border_of_two_cells_is_their_bisector():
    faces, weights = PLANE.locate([[1.5, 4.5, 0], [4.5, 4.5, 0]])
    cells = PLANE.voronoi_borders((faces, weights))
    assert cells.areas == pytest.approx([24, 40])
    assert len(cells.borders) == 1 and cells.borders[0].shape[1] == 3
    np.testing.assert_allclose(cells.borders[0][:, 0], 3, atol=1e-9)
    np.testing.assert_array_equal(cells.border_sources, [[0, 1]])
    np.testing.assert_array_equal(cells.neighbors, [[0, 1]])
    assert cells.triangles.shape == (0, 3)


def test_cells_cover_a_sphere():
    sources = np.arange(12)
    cells = SPHERE.voronoi_borders(sources)
    corners = SPHERE.vertices[SPHERE.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert cells.areas.sum() == pytest.approx(np.linalg.norm(normals, axis=1).sum() / 2, rel=1e-9)
    assert len(cells.neighbors) == 30 and cells.triangles.shape == (20, 3)
    assert len(cells.borders) == len(cells.border_sources) == 30


def test_a_cut_locus_is_on_the_other_side():
    cells = SPHERE.cut_locus(0)
    assert len(cells.borders) > 0 and np.all(cells.border_sources == 0)
    farthest = min(points @ SPHERE.vertices[0] for border in cells.borders for points in border)
    assert farthest < -0.9
    assert len(PLANE.cut_locus(40).borders) == 0


def test_bad_sources_are_named():
    with pytest.raises(ValueError, match="source 1 is vertex 999"):
        PLANE.voronoi_borders([0, 999])
