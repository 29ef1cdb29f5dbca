// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SAMPLE_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_SAMPLE_MESHES_H

#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// At the start of tests that cannot do without the meshes. Where the build knows of a folder, they
// have to be there.
#ifdef CGAL_DATA_DIR
#define SKIP_WITHOUT_SAMPLE_MESHES() static_cast<void>(0)
#else
#define SKIP_WITHOUT_SAMPLE_MESHES() GTEST_SKIP() << "there are no sample meshes"
#endif

namespace geodesics_test {

// Reads a mesh that comes with CGAL; the mesh stays empty if it cannot be read.
Mesh sample_mesh(const std::string& name);

// The names of all files that come with CGAL and hold a mesh in a format that it reads.
std::vector<std::string> names_of_sample_files();

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SAMPLE_MESHES_H
