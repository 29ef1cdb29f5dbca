// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_vicinities.h>

#include "meshes/test_costs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// How near to a vertex the first points are, in the regular fan of six faces, in closed form.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::Gauge_polygon;
using AG::internal::Gauge_vicinities;
using AG::internal::Index;

constexpr double UNLIMITED = std::numeric_limits<double>::infinity();
constexpr double SAMPLING = 1e-6; // how near a polygon is to a smooth gauge
constexpr double TOLERANCE = 2e-4;

// What is known near the center, where all faces have one cost function.
struct Regular_fan
{
  template <typename Cost>
  explicit Regular_fan(const Cost& cost, const double error = 0, const bool has_free_face = false)
    : mesh(to_mesh(fan(6))),
      triangulation(mesh, with_cost([&cost](Face, const Vector& d) {
                            return cost.cost(d);
                          }).epsilon(SAMPLING)),
      vicinities(triangulation),
      center(triangulation.vertex(0))
  {
    Gauge_polygon polygon;
    AG::internal::Gauge_samples samples;
    bool is_free = has_free_face;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(triangulation.is_open(h) && h == triangulation.first_of_face(h))
      {
        polygon.assign(triangulation, h, TOLERANCE, samples);
        if(is_free)
          vicinities.add_free(h);
        else
          vicinities.add(h, polygon, error);
        is_free = false;
      }
  }

  double radius(const double epsilon, const double largest = UNLIMITED) const
  {
    return unit() * vicinities.radius(center, epsilon, largest / unit());
  }

  double height() const { return unit() * vicinities.height(center); }

  double unit() const { return triangulation.unit() * triangulation.weight_unit(); } // of costs

  Mesh mesh;
  Triangulation triangulation;
  Gauge_vicinities vicinities;
  Index center;
};

// The radius if a path loses this part of it at most on its way to the vertex.
double expected_radius(const double height, const double loss, const double epsilon)
{
  return height * 0.5 * epsilon / (loss + epsilon);
}

// A regular_hexagon whose corners are in the middle of the faces: the cost of going out along a
// height is 3/4. A chord is too high by a third there, and the slope changes by 1. The parabola `x
// (1 - x) + x / 3` has its largest value, 4/9, in 2/3.
const Half_planes regular_hexagon = Half_planes::regular(6, 0);
constexpr double height_of_hexagon = 0.75, loss_of_hexagon = 4. / 9;

TEST(Gauge_vicinities, of_hexagonal_norm)
{
  const Regular_fan fan(regular_hexagon);
  EXPECT_NEAR(fan.height(), height_of_hexagon, TOLERANCE);
  for(const double epsilon : {0.01, 0.1, 1.})
    EXPECT_NEAR(fan.radius(epsilon), expected_radius(height_of_hexagon, loss_of_hexagon, epsilon),
                TOLERANCE);
}

// A chord of a sixth of the circle is too high by `2 / sqrt(3) - 1`, and the slope changes by 1:
// the largest value of the parabola is 1/3.
TEST(Gauge_vicinities, of_length)
{
  const Regular_fan fan(Wind{Vector(0, 0, 0), 1});
  const double height = std::sqrt(0.75);
  EXPECT_NEAR(fan.height(), height, TOLERANCE);
  for(const double epsilon : {0.01, 0.1, 1.})
    EXPECT_NEAR(fan.radius(epsilon), expected_radius(height, 1. / 3, epsilon), TOLERANCE);
}

TEST(Gauge_vicinities, whose_gauge_is_below_the_polygon)
{
  const double error = 0.1, height = height_of_hexagon / (1 + error);
  const Regular_fan fan(regular_hexagon, error);
  EXPECT_NEAR(fan.height(), height, TOLERANCE);
  const double chord = (1 + error) * 4 / 3, loss = chord * chord / 4;
  EXPECT_NEAR(fan.radius(0.1), expected_radius(height, loss, 0.1), TOLERANCE);
}

// Where a face costs nothing, a path loses at most the way to the vertex.
TEST(Gauge_vicinities, of_free_face)
{
  const Regular_fan fan(regular_hexagon, 0, true);
  EXPECT_NEAR(fan.radius(0.1), expected_radius(height_of_hexagon, 1, 0.1), TOLERANCE);
}

TEST(Gauge_vicinities, are_apart)
{
  const Regular_fan fan(regular_hexagon);
  EXPECT_NEAR(fan.radius(100), Gauge_vicinities::LARGEST_PART * height_of_hexagon, TOLERANCE);
}

TEST(Gauge_vicinities, are_limited_where_crossings_are_rounded)
{
  const Regular_fan fan(regular_hexagon);
  const double smallest = expected_radius(height_of_hexagon, 1, 0.1);
  const double largest = expected_radius(height_of_hexagon, loss_of_hexagon, 0.1);
  const double middle = (smallest + largest) / 2;
  EXPECT_NEAR(fan.radius(0.1, middle), middle, 1e-15);
  EXPECT_NEAR(fan.radius(0.1, 0), smallest, TOLERANCE); // which needs no limit
}

} // namespace
