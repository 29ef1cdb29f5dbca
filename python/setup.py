"""Builds the module by CMake, which knows where CGAL is."""

import pathlib
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(
            [
                "cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                f"-DPython_EXECUTABLE={sys.executable}",
                f"-DAPPROXIMATE_GEODESICS_PYTHON_MODULE_DIR={folder}",
            ],
            check=True,
        )
        subprocess.run(["cmake", "--build", build], check=True)


setup(
    ext_modules=[Extension("approximate_geodesics._native", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
)
