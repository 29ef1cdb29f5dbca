import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir

required_conan_version = ">=2.0"


class ApproximateGeodesicsConan(ConanFile):
    name = "approximate-geodesics"
    version = "@VERSION@"
    description = "@DESCRIPTION@"
    license = "@LICENSE@"
    homepage = "@HOMEPAGE@"
    url = "@HOMEPAGE@"
    topics = ("cgal", "geodesic", "geometry", "mesh", "shortest-path")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"

    def layout(self):
        cmake_layout(self, src_folder="src")

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)

    def validate(self):
        if self.settings.compiler.get_safe("cppstd"):
            check_min_cppstd(self, 17)

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["APPROXIMATE_GEODESICS_EXAMPLES"] = False
        toolchain.cache_variables["APPROXIMATE_GEODESICS_TESTS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        licenses = os.path.join(self.package_folder, "licenses")
        copy(self, "LICENSE", self.source_folder, licenses)
        CMake(self).install()
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))  # Conan writes its own
        rmdir(self, os.path.join(self.package_folder, "share"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "Approximate_geodesics")
        for name in ("Approximate_geodesics", "compiled", "Matrix_files", "Solver"):
            component = self.cpp_info.components[name.lower()]
            component.bindirs = []
            component.requires = ["cgal::cgal"]
            component.set_property("cmake_target_name", f"Approximate_geodesics::{name}")
        for name in ("compiled", "matrix_files", "grid_files"):
            self.cpp_info.components[name].libs = [f"Approximate_geodesics_{name}"]
        self.cpp_info.components["compiled"].defines = ["CGAL_APPROXIMATE_GEODESICS_COMPILED"]
