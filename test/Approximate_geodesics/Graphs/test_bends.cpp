// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Deferred_sights.h>

#include "checks/test_random.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::Bend_kind;
using AG::internal::Bends;
using AG::internal::Sight_tables;

// What is expected of a vertex, from angles that are added up one by one.
struct Vertex_angles
{
  Vertex_angles(const Triangulation& t, const AG::internal::Index v)
  {
    double sum = 0;
    for(auto h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
    {
      if(t.is_border(h))
        ++number_of_borders;
      else
        sum += angle_of(AG::internal::corner_angle(t, h));
    }
    excess = sum - (2 - number_of_borders) * AG::internal::straight_angle;
  }

  bool is_clear() const { return std::abs(excess) > 1e-5; }

  Bend_kind kind() const
  {
    if(number_of_borders > 1)
      return Bend_kind::ANY;
    if(excess < 0)
      return Bend_kind::NONE;
    return number_of_borders > 0 ? Bend_kind::BORDER : Bend_kind::SADDLE;
  }

  int number_of_borders = 0;
  double excess;
};

// Returns the number of vertices where paths may bend by any angle although their angle is known.
std::size_t expect_kinds(const Soup& soup)
{
  const Triangulation t(to_mesh(soup));
  const Bends bends = Sight_tables(t, AG::internal::Loop()).bends;
  std::size_t number = 0;
  double sum = 0;
  for(AG::internal::Index v = 0; v < t.number_of_vertices(); ++v)
  {
    const Vertex_angles angles(t, v);
    if(bends[v] == Bend_kind::ANY)
      number += angles.kind() == Bend_kind::ANY ? 0 : 1;
    else if(angles.is_clear())
    {
      EXPECT_EQ(bends[v], angles.kind()) << "vertex " << v << ", excess " << angles.excess;
    }
    if(angles.number_of_borders == 0)
      sum += (std::max)(0., angles.excess);
  }
  if(number == 0) // angles at degenerate faces are not known
  {
    EXPECT_NEAR(bends.mean_excess() * t.number_of_vertices(), sum, 1e-5);
  }
  return number;
}

TEST(Bends, are_possible_where_angles_add_up_to_more)
{
  Random random(test_seed());
  const Soup rough = terrain(20, 20, random);
  for(const double size : {1., 1e-110, 1e150})
    EXPECT_EQ(expect_kinds(scaled(rough, size)), 0u) << size;
  for(const std::size_t valence : {3u, 60u, 64u, 65u, 400u})
    for(const double height : {0., 0.1, 3.})
      EXPECT_EQ(expect_kinds(fan(valence, height)), 0u) << valence << " " << height;
  for(const double thin : {1e-2, 1e-4, 1e-7, 1e-10})
    EXPECT_EQ(expect_kinds(rough.transformed(
                  [=](const Point& p) { return Point(thin * p.x(), p.y(), p.z()); })),
              0u)
        << thin;
}

// Where angles add up to exactly two right ones at the border, and four inside.
TEST(Bends, are_possible_at_straight_borders_beside_needles_only)
{
  const std::size_t columns = 8, rows = 7;
  for(const double thin : {1., 1e-7})
  {
    const Triangulation t(to_mesh(grid(
        columns, rows, [=](const double i, const double j) { return Point(thin * i, j, 0); })));
    const Bends bends = Sight_tables(t, AG::internal::Loop()).bends;
    for(std::size_t v = 0; v < columns * rows; ++v)
    {
      const std::size_t i = v % columns, j = v / columns;
      const int borders = (i == 0 || i == columns - 1) + (j == 0 || j == rows - 1);
      const Bend_kind straight = thin < 1 ? Bend_kind::BORDER : Bend_kind::NONE_AS_FLAT;
      if(borders < 2)
      {
        EXPECT_EQ(bends[t.vertex(v)], borders == 0 ? Bend_kind::NONE_AS_FLAT : straight) << v;
      }
    }
  }
}

TEST(Bends, are_possible_by_any_angle_at_degenerate_faces)
{
  const std::uint64_t seed = test_seed();
  for(std::uint64_t i = 0; i < 300; ++i)
  {
    SCOPED_TRACE(seed + i);
    expect_kinds(random_small_soup(seed + i));
  }
  Random random(seed);
  Soup with_points = terrain(10, 10, random);
  with_points.points[34] = with_points.points[35]; // two faces without area
  EXPECT_EQ(expect_kinds(with_points), 4u);
}

// On plain meshes a few edges; among long and thin faces less, but at least an edge.
TEST(Deferred_sights, wait_nearer_among_long_and_thin_faces)
{
  Random random(test_seed());
  const auto edges_to_horizon = [&](const double stretch) {
    const Triangulation t(to_mesh(grid(20, 20, [&](const double i, const double j) {
      return Point(stretch * i, j, random.between(0, 1.5));
    })));
    const Bends bends = Sight_tables(t, AG::internal::Loop()).bends;
    const double mean = AG::summarize_arc_lengths(t.lengths()).mean;
    return AG::internal::Deferred_sights::suitable_distance(bends, mean, true) / mean;
  };
  EXPECT_DOUBLE_EQ(edges_to_horizon(1), 5);
  EXPECT_LT(edges_to_horizon(20), edges_to_horizon(1) / 2);
  EXPECT_EQ(edges_to_horizon(1e6), 1);
}

} // namespace
