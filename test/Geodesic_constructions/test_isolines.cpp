// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_fields.h"
#include "checks/expect_message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <vector>

// Lines where a function has given values.

namespace {

using namespace geodesics_test;

// Between vertices and through them: from border to border, with what is smaller to the left.
TEST(Isolines, of_a_linear_function_are_straight)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  const std::vector<double> values = {0.5, 3, 6.25, 8};
  const std::vector<Polyline> lines = isolines(mesh, x, values);
  ASSERT_EQ(lines.size(), values.size());
  EXPECT_TRUE(are_clean(lines));
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    EXPECT_EQ(lines[i].front(), Point(values[i], 0, 0));
    EXPECT_EQ(lines[i].back(), Point(values[i], 5, 0));
    EXPECT_EQ(lines[i].size(), std::floor(values[i]) == values[i] ? 6u : 11u);
    for(std::size_t j = 0; j < lines[i].size(); ++j)
    {
      EXPECT_EQ(lines[i][j].x(), values[i]);
      EXPECT_TRUE(j == 0 || lines[i][j - 1].y() < lines[i][j].y());
    }
  }
}

TEST(Isolines, of_one_value_need_no_range)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  for(const double value : {0.5, 3.})
  {
    std::vector<Polyline> lines, lines_of_integer;
    AG::isolines(mesh, x, value, std::back_inserter(lines));
    EXPECT_EQ(lines, isolines(mesh, x, {value}));
    AG::isolines(mesh, x, int(value), std::back_inserter(lines_of_integer));
    EXPECT_EQ(lines_of_integer, isolines(mesh, x, {std::floor(value)}));
  }
  std::vector<Polyline> none;
  expect_message<std::invalid_argument>(
      [&] { AG::isolines(mesh, x, std::nan(""), std::back_inserter(none)); },
      "isovalue 0, counted from 0, is not a number");
}

TEST(Isolines, of_values_whose_difference_overflows_are_straight)
{
  const Mesh mesh = to_mesh(flat_grid(2, 2));
  const auto field =
      at_points(mesh, [](const Point& p) { return p.x() == 0 ? -1.6e308 : 1.6e308; });
  const std::vector<Polyline> lines = isolines(mesh, field, {-0.8e308});
  ASSERT_EQ(lines.size(), 1u);
  for(const Point& p : lines.front())
    EXPECT_EQ(p.x(), 0.25);
}

TEST(Isolines, go_counterclockwise_around_a_source)
{
  const Mesh cone = to_mesh(fan(50, 3));
  std::vector<double> distances(cone.num_vertices());
  const auto map = boost::make_iterator_property_map(distances.begin(), //
                                                     get(boost::vertex_index, cone));
  CGAL::approximate_geodesic_distances(cone, map, Vertex(0));
  const std::vector<Polyline> lines = isolines(cone, map, {std::sqrt(10.) / 3});
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].size(), 51u);
  EXPECT_TRUE(is_closed(lines[0]));
  for(std::size_t i = 0; i + 1 < lines[0].size(); ++i)
  {
    const Point &p = lines[0][i], &q = lines[0][i + 1];
    EXPECT_NEAR(p.z(), 2, 1e-14);
    EXPECT_GT(p.x() * q.y() - p.y() * q.x(), 0);
  }
}

TEST(Isolines, have_a_segment_in_every_face_that_they_cross)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    std::vector<double> values(mesh.num_vertices());
    for(const bool is_degenerate : {false, true})
    {
      for(double& value : values)
        value = is_degenerate ? double(random.below(5)) : random.between(0, 4);
      for(double& value : values)
        if(random.below(20) == 0)
          value = infinity;
      const std::vector<Polyline> lines = isolines(mesh, from_vector(values), {2});
      const double expected = length_in_faces(mesh, values, 2);
      EXPECT_NEAR(length(lines), expected, 1e-12 * expected);
      EXPECT_TRUE(are_clean(lines));
    }
  }
}

// On a surface without border, lines have no ends, even if they go through many vertices.
TEST(Isolines, are_closed_on_a_closed_surface)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(sphere(24, 15));
  for(int run = 0; run < 20; ++run)
  {
    std::vector<double> values(mesh.num_vertices());
    for(double& value : values)
      value = double(random.below(4));
    const std::vector<Polyline> lines = isolines(mesh, from_vector(values), {1, 1.5, 2});
    EXPECT_FALSE(lines.empty());
    EXPECT_TRUE(are_clean(lines));
    EXPECT_TRUE(std::all_of(lines.begin(), lines.end(), is_closed));
  }
}

TEST(Isolines, do_not_consist_of_a_single_point)
{
  const Mesh mesh = to_mesh(fan(7));
  const auto one_at = [&](const Vertex top) {
    return at_vertices([top](const Vertex v) { return v == top ? 1. : 0.; });
  };
  EXPECT_EQ(isolines(mesh, one_at(Vertex(0)), {-1, 0, 1, 2, infinity}).size(), 0u);
  EXPECT_EQ(isolines(mesh, one_at(Vertex(3)), {-1, 0, 1, 2, infinity}).size(), 0u);
  EXPECT_EQ(isolines(mesh, one_at(Vertex(0)), {0.5}).size(), 1u);
}

TEST(Isolines, end_where_vertices_were_not_reached)
{
  const Mesh mesh = to_mesh(flat_grid(5, 9));
  const auto x_below = at_points(mesh, [](const Point& p) { return p.y() > 6 ? infinity : p.x(); });
  const std::vector<Polyline> lines = isolines(mesh, x_below, {1.5, infinity});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), Point(1.5, 0, 0));
  EXPECT_EQ(lines[0].back(), Point(1.5, 6, 0));
  const auto none = at_vertices([](Vertex) { return std::nan(""); });
  EXPECT_TRUE(isolines(mesh, none, {0, 1}).empty());
}

TEST(Isolines, need_values_that_are_numbers)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  std::vector<Polyline> lines;
  for(const double nan : {std::nan(""), -std::nan("")})
    expect_message<std::invalid_argument>(
        [&] {
          AG::isolines(mesh, x, std::vector<double>{0.5, infinity, nan, nan},
                       std::back_inserter(lines));
        },
        "isovalue 2", "not a number");
  EXPECT_TRUE(lines.empty());
}

TEST(Isolines, return_the_iterator)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  std::array<Polyline, 3> lines;
  const auto last = AG::isolines(mesh, x, std::array<double, 2>{0.5, 1.5}, lines.begin());
  EXPECT_EQ(last - lines.begin(), 2);
  EXPECT_EQ(AG::isolines(mesh, x, std::array<double, 0>(), last) - lines.begin(), 2);
}

} // namespace
