// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "grids/cells.h"

#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

// Grids in degrees, against lengths of meridians, parallels and great circles.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::directional_cost;
using AG::Grid_vector;
using AG::Hiking_time;
using CGAL::parameters::epsilon;
using CGAL::parameters::heights;

// The length of a meridian from the equator, by Helmert's series.
double meridian(const double degrees)
{
  const double n = 1 / (2 * 298.257223563 - 1), p = degrees * std::acos(-1.) / 180;
  const double a = 6378137 / (1 + n);
  return a *
         ((1 + n * n / 4 + n * n * n * n / 64) * p - 1.5 * (n - n * n * n / 8) * std::sin(2 * p) +
          15. / 16 * (n * n - n * n * n * n / 4) * std::sin(4 * p) -
          35. / 48 * n * n * n * std::sin(6 * p));
}

// On a sphere.
double great_circle(const double first, const double second, const double longitudes)
{
  const double degree = std::acos(-1.) / 180;
  const double u = std::sin((first - second) * degree / 2), v = std::sin(longitudes * degree / 2);
  return 2 * 6371008.8 *
         std::asin(std::sqrt(u * u + std::cos(first * degree) * std::cos(second * degree) * v * v));
}

TEST(Geographic_grid, has_the_lengths_of_meridians_and_parallels)
{
  for(const double first : {89., 51.25, 2.})
  {
    const Grid_shape shape{30, 40, 0.05, 0.1, {}, first};
    const Cell_values found = costs_of_cells(shape, 1, Grid_cell{3, 0});
    EXPECT_NEAR(found[shape.index({3, 39})], meridian(first - 0.05) - meridian(first - 3.95), 0.5);
    const double degree = std::acos(-1.) / 180, latitude = (first - 0.05) * degree;
    const double of_degree = 6378137 * degree * std::cos(latitude) /
                             std::sqrt(1 - 0.00669437999014 * std::pow(std::sin(latitude), 2));
    EXPECT_NEAR(found[shape.index({4, 0})], 0.05 * of_degree, 1e-3);
  }
}

TEST(Geographic_grid, has_distances_of_great_circles)
{
  for(const double first : {75., 48., 3., -30.})
  {
    const Grid_shape shape{70, 60, 0.1, 0.08, {}, first};
    const Grid_cell source{10, 12};
    const Grid_graph graph(shape, 1);
    EXPECT_LE(graph.error_on_equal_cells(), first > 70 ? 0.01 : 0.0031);
    const Cell_values found = costs_of_cells(shape, 1, source);
    const auto latitude = [&](const Grid_cell& c) { return first - shape.center(c).y; };
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Grid_cell c = shape.cell(i);
      const double expected =
          great_circle(latitude(source), latitude(c), shape.center(c).x - shape.center(source).x);
      // the sphere is not the ellipsoid
      EXPECT_GE(found[i], expected * 0.993);
      EXPECT_LE(found[i], expected * (1.006 + graph.error_on_equal_cells()));
      EXPECT_LE(graph.lower_bound(graph.node(source), static_cast<Grid_graph::Node>(i)),
                found[i] * (1 + slack_of_costs));
    }
    const Cell_values back = costs_of_cells(shape, 1, {60, 50});
    EXPECT_NEAR(back[shape.index(source)], found[shape.index({60, 50})], 1e-3);
  }
}

TEST(Geographic_grid, has_heights_in_meters)
{
  const Grid_shape shape{30, 30, 1 / 1200., 1 / 1200., {}, 46.5};
  const Cell_values friction(shape.number_of_cells(), 1);
  const double width = costs_of_cells(shape, 1, Grid_cell{})[1];
  EXPECT_NEAR(width, 63.9, 0.1);
  const Cell_values h =
      values_of_cells(shape, [&](double x, double) { return 0.2 * 1200 * width * x; });
  const auto cost = directional_cost(Hiking_time());
  const Cell_values found = costs_of_cells(shape, 1, Grid_cell{}, heights(h).face_weight_map(cost));
  const double expected = 29 * width * std::sqrt(1.04) * Hiking_time()(0.2);
  EXPECT_NEAR(found[29] / expected, 1, 1e-4);
  const auto up = [](const Grid_cell&, const Grid_vector& d) { return 1 + d.z(); };
  const Cell_values by_cells =
      costs_of_cells(shape, 1, Grid_cell{}, heights(h).face_weight_map(directional_cost(up)));
  EXPECT_NEAR(by_cells[29] / (29 * width * (std::sqrt(1.04) + 0.2)), 1, 1e-4);
}

TEST(Geographic_grid, rejects_bad_latitudes)
{
  const auto rejects = [](const Grid_shape& shape, const char* const text) {
    expect_message<std::invalid_argument>([&] { Grid_graph(shape, 1); }, text);
  };
  rejects({4, 3, 1, 1, {}, 91}, "from latitude 91 to 88");
  rejects({4, 3, 1, 1, {}, -88}, "to -91");
  rejects({4, 3, 1, 1, {}, std::nan("")}, "latitude");
  rejects({361, 3, 1, 1, {}, 10}, "361 degrees");
  expect_message<std::invalid_argument>(
      [] {
        Grid_graph({4, 3, 1, 1, {}, 50}, 1, epsilon(0.1));
      },
      "degrees");
}

} // namespace
