// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_KINDS_ON_PATH_H
#define APPROXIMATE_GEODESICS_TEST_KINDS_ON_PATH_H

#include "meshes/test_soup.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace geodesics_test {

// Remembers what a path goes through, a letter for each.
struct Kinds_on_path
{
  void operator()(const Vertex v)
  {
    kinds += 'v';
    vertices.push_back(v);
  }
  void operator()(const Halfedge, const double t)
  {
    EXPECT_GE(t, 0);
    EXPECT_LE(t, 1);
    kinds += 'e';
  }
  void operator()(const Face, const std::array<double, 3>&) { kinds += 'f'; }

  std::string kinds = {};
  std::vector<Vertex> vertices = {};
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_KINDS_ON_PATH_H
