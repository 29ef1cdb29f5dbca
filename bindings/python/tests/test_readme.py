"""The programs of the README."""

import pathlib
import re

import numpy as np

from meshes import grid

README = pathlib.Path(__file__).parents[1] / "README.md"


def test_programs_of_the_readme_run():
    vertices, faces = grid(10)
    names = np.arange(len(vertices))
    names[[8, 13]] = names[[13, 8]]  # so that vertices 3 and 8 are those of an edge
    given = {"vertices": vertices[names], "faces": names[faces], "np": np}
    given.update(p=(1.25, 0.5, 0.1), q=(7, 8, -1), dem=np.zeros((121, 461)))
    programs = re.findall("```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert len(programs) == 4
    for program in programs:
        exec(program, given)
    path = given["road"].path(given["source"], given["target"])
    np.testing.assert_allclose(path[[0, -1]], [(1.25, 0.5, 0), (7, 8, 0)])
