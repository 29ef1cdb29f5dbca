import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, get
from conan.tools.layout import basic_layout

required_conan_version = ">=2.0"


class ApproximateGeodesicsConan(ConanFile):
    name = "approximate-geodesics"
    version = "@VERSION@"
    description = "Geodesic distances and paths on triangle meshes, within an error bound, with CGAL"
    license = "GPL-3.0-or-later"
    homepage = "@HOMEPAGE@"
    url = "@HOMEPAGE@"
    topics = ("cgal", "geodesic", "geometry", "mesh", "shortest-path", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def layout(self):
        basic_layout(self, src_folder="src")

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)

    def package_id(self):
        self.info.clear()

    def validate(self):
        if self.settings.compiler.get_safe("cppstd"):
            check_min_cppstd(self, 17)

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def package(self):
        licenses = os.path.join(self.package_folder, "licenses")
        copy(self, "LICENSE", self.source_folder, licenses)
        for folder in ("", "matrix_files", "solver"):
            headers = os.path.join(self.source_folder, folder, "include")
            copy(self, "*.h", headers, os.path.join(self.package_folder, "include"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "Approximate_geodesics")
        for name in ("Approximate_geodesics", "Matrix_files", "Solver"):
            component = self.cpp_info.components[name.lower()]
            component.bindirs = []
            component.libdirs = []
            component.requires = ["cgal::cgal"]
            component.set_property("cmake_target_name", f"Approximate_geodesics::{name}")
