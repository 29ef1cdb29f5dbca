"""Builds the module by CMake, which knows where CGAL is, with the options of the variable CMAKE_ARGS; and
source distributions, to which the headers are added, as they lie outside this folder. Version and
description are those of the library's CMakeLists.txt; license, authors and keywords those of its
CITATION.cff."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

SOURCE = pathlib.Path(__file__).resolve().parent
IN_SDIST = "library"  # where CMakeLists.txt looks for it
LIBRARY = SOURCE / IN_SDIST if (SOURCE / IN_SDIST).exists() else SOURCE.parent.parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(
            [
                "cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                f"-DPython_EXECUTABLE={sys.executable}",
                f"-DAPPROXIMATE_GEODESICS_PYTHON_MODULE_DIR={folder}",
                *shlex.split(os.environ.get("CMAKE_ARGS", "")),
            ],
            check=True,
        )
        subprocess.run(["cmake", "--build", build, "--parallel", "2"], check=True)


class SdistWithLibrary(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        base = pathlib.Path(base_dir)
        for name in ("include", "libraries", "cmake"):
            shutil.copytree(LIBRARY / name, base / IN_SDIST / name)
        for name in ("CMakeLists.txt", "CITATION.cff"):
            shutil.copy(LIBRARY / name, base / IN_SDIST)
        (base / "LICENSE").unlink()  # it may be a link
        shutil.copy(SOURCE / "LICENSE", base)


def metadata():
    project = (LIBRARY / "CMakeLists.txt").read_text(encoding="utf-8")
    citation = (LIBRARY / "CITATION.cff").read_text(encoding="utf-8")
    keywords = re.search(r"^keywords:\n((?:  - .*\n)+)", citation, re.M)[1]
    return {
        "version": re.search(r"^project\([^)]* VERSION (\S+)", project, re.M)[1],
        "description": re.search(r'^project\([^)]* DESCRIPTION "([^"]*)"', project, re.M)[1],
        "license": re.search(r"^license: (.*)", citation, re.M)[1],
        "author": ", ".join(re.findall(r"^  - name: (.*)", citation, re.M)),
        "keywords": re.findall(r"- (.*)", keywords),
    }


setup(
    **metadata(),
    ext_modules=[Extension("approximate_geodesics._native", sources=[])],
    cmdclass={"build_ext": BuildByCMake, "sdist": SdistWithLibrary},
)
