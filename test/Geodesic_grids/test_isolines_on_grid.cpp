// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_grids/isolines_on_grid.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// Lines of the grid where values of cells are equal to a given one.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Grid_point;
using AG::Grid_shape;
using Grid_polyline = std::vector<Grid_point>;

std::vector<Grid_polyline>
lines_on_grid(const Grid_shape& shape, const std::vector<double>& values, const double isovalue)
{
  std::vector<Grid_polyline> result;
  AG::isolines_on_grid(shape, values, isovalue, std::back_inserter(result));
  return result;
}

template <typename F>
std::vector<double> values_at_centers(const Grid_shape& shape, const F& f)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(f(shape.center(shape.cell(i))));
  return result;
}

bool is_loop(const Grid_polyline& line)
{
  return line.front().x == line.back().x && line.front().y == line.back().y;
}

// Twice the area to the left of a closed line.
double twice_area(const Grid_polyline& line)
{
  double result = 0;
  for(std::size_t i = 0; i + 1 < line.size(); ++i)
    result += line[i].x * line[i + 1].y - line[i + 1].x * line[i].y;
  return result;
}

TEST(Isolines_on_grid, of_a_linear_function_are_straight)
{
  const Grid_shape shape{9, 6, 2, 3, {}};
  const auto values = values_at_centers(shape, [](const Grid_point& p) { return p.x; });
  for(const double x : {2., 5., 8.25})
  {
    const auto lines = lines_on_grid(shape, values, x);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].size(), 6u);
    EXPECT_EQ(lines[0].front().y, 1.5); // with what is smaller to the left
    EXPECT_EQ(lines[0].back().y, 16.5);
    for(const Grid_point& p : lines[0])
      EXPECT_NEAR(p.x, x, 1e-12);
  }
  EXPECT_TRUE(lines_on_grid(shape, values, 0.5).empty());
  EXPECT_TRUE(lines_on_grid(shape, values, std::numeric_limits<double>::infinity()).empty());
}

TEST(Isolines_on_grid, of_distances_are_circles)
{
  const Grid_shape shape{41, 41, 1, 1, {}};
  const auto values = values_at_centers(
      shape, [](const Grid_point& p) { return std::hypot(p.x - 20.5, p.y - 20.5); });
  for(const double radius : {3., 10.5, 17.})
  {
    const auto lines = lines_on_grid(shape, values, radius);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(is_loop(lines[0]));
    EXPECT_NEAR(twice_area(lines[0]) / (2 * std::acos(-1.) * radius * radius), 1, 0.03);
  }
}

// What cells below a value are inside of lines that are closed, as values at the border are above.
TEST(Isolines_on_grid, separate_what_is_smaller)
{
  Random random(test_seed());
  for(int i = 0; i < 50; ++i)
  {
    const Grid_shape shape{3 + random.below(9), 3 + random.below(9), 1, 1.5, {}};
    const auto values = values_at_centers(shape, [&](const Grid_point& p) {
      const bool is_at_border = p.x < 1 || p.y < 1.5 || p.x > double(shape.columns) - 1 ||
                                p.y > 1.5 * (double(shape.rows) - 1);
      return is_at_border ? 9. : double(random.below(8));
    });
    const double isovalue = random.below(2) == 0 ? 4 : 3.5;
    const auto lines = lines_on_grid(shape, values, isovalue);
    double area = 0;
    for(const Grid_polyline& line : lines)
    {
      EXPECT_TRUE(is_loop(line));
      area += twice_area(line);
    }
    EXPECT_GE(area, 0);
    for(std::size_t k = 0; k < values.size(); ++k)
    {
      if(values[k] == isovalue)
        continue;
      const Grid_point p = shape.center(shape.cell(k));
      double turns = 0; // around the center
      for(const Grid_polyline& line : lines)
        for(std::size_t m = 0; m + 1 < line.size(); ++m)
        {
          const double x = line[m].x - p.x, y = line[m].y - p.y, u = line[m + 1].x - p.x,
                       v = line[m + 1].y - p.y;
          turns += std::atan2(x * v - y * u, x * u + y * v);
        }
      EXPECT_NEAR(turns / (2 * std::acos(-1.)), values[k] < isovalue ? 1 : 0, 1e-6);
    }
  }
}

TEST(Isolines_on_grid, have_points_for_the_smallest_and_the_largest_numbers)
{
  constexpr double smallest = std::numeric_limits<double>::denorm_min(),
                   largest = (std::numeric_limits<double>::max)();
  const auto x_of = [](const double a, const double isovalue, const double b) {
    return lines_on_grid({2, 2, 1, 1, {}}, {a, b, a, b}, isovalue).at(0).front().x;
  };
  EXPECT_EQ(x_of(3 * smallest, 4 * smallest, 5 * smallest), 1);
  EXPECT_EQ(x_of(-largest, 0, largest), 1);
}

TEST(Isolines_on_grid, end_where_there_are_no_values)
{
  const Grid_shape shape{7, 7, 1, 1, -1};
  auto values = values_at_centers(shape, [](const Grid_point& p) { return p.x; });
  values[shape.index({3, 3})] = -1;
  EXPECT_EQ(lines_on_grid(shape, values, 3.25).size(), 2u);
  values[shape.index({3, 3})] = std::nan("");
  EXPECT_EQ(lines_on_grid(shape, values, 3.25).size(), 2u);
  EXPECT_TRUE(lines_on_grid({1, 7, 1, 1, {}}, std::vector<double>(7, 1), 0.5).empty());
  EXPECT_TRUE(lines_on_grid({0, 0, 1, 1, {}}, {}, 0.5).empty());
}

TEST(Isolines_on_grid, reject_bad_input)
{
  expect_message<std::invalid_argument>(
      [] {
        lines_on_grid({2, 2, 1, 1, {}}, {1, 2, 3}, 1);
      },
      "3 values, and 4 cells");
  expect_message<std::invalid_argument>(
      [] {
        lines_on_grid({2, 2, 1, 1, {}}, {1, 2, 3, 4}, std::nan(""));
      },
      "isovalue");
}

} // namespace
