// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_weights.h"
#include "paths/straightened_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace geodesics_test;

// A wall is a line of barriers, with a path along one side of it, round its end, and to the other.
TEST(Path_straightener, does_not_cross_barriers)
{
  const std::size_t columns = 9;
  const Mesh mesh = to_mesh(flat_grid(columns, columns));
  Barriers barriers(mesh.num_edges());
  for(const Edge e : mesh.edges())
  {
    const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    barriers[e.idx()] = p.x() == 4 && q.x() == 4 && p.y() <= 6 && q.y() <= 6;
  }
  const Surface surface(mesh, CGAL::parameters::edge_is_constrained_map(barrier_map(barriers)));
  const auto at = [&](const std::size_t i, const std::size_t j) { return i + j * columns; };
  const auto length = [&](const std::vector<std::size_t>& vertices) {
    const Path path = surface.shortened(vertices);
    EXPECT_LE(Local_check(surface).largest_defect(path.points), 1e-9);
    return path.length;
  };
  EXPECT_NEAR(length({at(3, 5), at(3, 6), at(4, 6), at(4, 5), at(5, 5)}), 2 * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(3, 5), at(4, 5), at(4, 6), at(5, 6), at(5, 5)}), 2 * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(4, 2), at(4, 3), at(4, 4), at(5, 4), at(5, 3)}), std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(3, 2), at(4, 3), at(4, 4), at(4, 5), at(3, 5)}), 3, 1e-12);
  EXPECT_NEAR(length({at(3, 4), at(4, 4), at(4, 5), at(4, 6), at(4, 5), at(5, 5)}),
              std::sqrt(5.) + std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(4, 0), at(4, 1), at(4, 2), at(4, 3), at(4, 4), at(4, 5), at(4, 6)}), 6,
              1e-12);
}

} // namespace
