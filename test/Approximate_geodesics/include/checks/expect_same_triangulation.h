// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_SAME_TRIANGULATION_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_SAME_TRIANGULATION_H

#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>

#include <gtest/gtest.h>

// A mesh that is right in every respect is read from its links, in the order of its memory. Where
// elements were removed it is read step by step. Both have to come to the same.

namespace geodesics_test {

// The same mesh, with a vertex that was removed; no other one has another index.
inline Mesh with_removed_vertex(const Mesh& mesh)
{
  Mesh result = mesh;
  result.remove_vertex(result.add_vertex(Point(0, 0, 0)));
  return result;
}

inline void expect_same_triangulation(const Triangulation& a, const Triangulation& b)
{
  EXPECT_TRUE(a.is_valid());
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.targets(), b.targets());
  EXPECT_EQ(a.lengths(), b.lengths());
  EXPECT_EQ(a.unit(), b.unit());
  EXPECT_EQ(a.number_of_faces(), b.number_of_faces());
  EXPECT_EQ(a.thin_faces().number_of_faces(), b.thin_faces().number_of_faces());
  for(Triangulation::Index v = 0; v < a.number_of_vertices(); ++v)
  {
    ASSERT_EQ(a.first_halfedge(v), b.first_halfedge(v));
    ASSERT_EQ(a.index(v), b.index(v));
  }
  for(Triangulation::Index h = 0; h < a.number_of_halfedges(); ++h)
  {
    ASSERT_EQ(a.opposite(h), b.opposite(h));
    ASSERT_EQ(a.is_border(h), b.is_border(h));
    ASSERT_EQ(a.weight(h), b.weight(h));
    ASSERT_EQ(a.is_barrier(h), b.is_barrier(h));
  }
}

template <typename NamedParameters>
void expect_same_triangulation(const Mesh& mesh, const NamedParameters& np)
{
  expect_same_triangulation(Triangulation(mesh, np), Triangulation(with_removed_vertex(mesh), np));
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_SAME_TRIANGULATION_H
