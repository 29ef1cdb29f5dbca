// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

// Pairs of points that are as close to each other as numbers can tell, next to what a search from
// one of them to everywhere says of the other one.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

template <typename Graph>
class Near_pairs : public testing::Test
{
protected:
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Graph>;
  using Location = typename Paths::Face_location;
  using Weights = std::array<double, 3>;

  // Of a face: a point anywhere, and one that is a part of the face away from it.
  static std::array<Weights, 2> inside(Random& random, const double part)
  {
    const double x = random.between(0.1, 0.4), y = random.between(0.1, 0.4);
    const double u = random.between(-part, part), v = random.between(-part, part);
    return {Weights{1 - x - y, x, y}, Weights{1 - (x + u) - (y + v), x + u, y + v}};
  }

  // Two points next to a corner, on a side at times. The first can be the corner.
  static std::array<Weights, 2> at_corner(Random& random, const double part)
  {
    const std::size_t corner = random.below(3);
    std::array<Weights, 2> result;
    for(Weights& weights : result)
    {
      const double u = double(random.below(3)) * random.between(0, part / 3);
      const double v = double(random.below(3)) * random.between(0, part / 3);
      weights[corner] = 1 - (u + v);
      weights[(corner + 1) % 3] = u;
      weights[(corner + 2) % 3] = v;
    }
    return result;
  }

  template <typename NamedParameters>
  static void compare(const Mesh& mesh, const NamedParameters& np)
  {
    Random random(test_seed());
    Paths pairs(mesh, np), field(mesh, np);
    for(int exponent = -14; exponent <= -3; ++exponent)
      for(std::size_t i = 0; i < 20; ++i)
      {
        SCOPED_TRACE("1e" + std::to_string(exponent) + ", pair " + std::to_string(i));
        const double part = std::pow(10., exponent);
        const Face f(static_cast<Face::size_type>(random.below(mesh.number_of_faces())));
        const auto points = i % 2 == 0 ? inside(random, part) : at_corner(random, part);
        compare(pairs, field, Location(f, points[0]), Location(f, points[1]));
      }
  }

  static void compare(Paths& pairs, Paths& field, const Location& p, const Location& q)
  {
    field.remove_all_source_points();
    field.add_source_point(p);
    field.build_sequence_tree();
    const double expected = field.shortest_distance_to_source_points(q.first, q.second).first;
    EXPECT_NEAR(expected, pairs.shortest_distance(p, q), 1e-9 * expected);
    EXPECT_NEAR(expected, pairs.shortest_distance(q, p), 1e-9 * expected + rounding_of_positions);
  }

  // The way back, where lines are laid out from the other end across several faces.
  static constexpr double rounding_of_positions =
      AG::internal::has_crossing_arcs<Graph> ? 1e-15 : 0;
};

using Graphs_of_pairs = testing::Types<AG::Edge_graph,
                                       Steiner_graph<Fixed_number_of_points>,
                                       Steiner_graph<Geometric_points>,
                                       AG::Discrete_geodesic_graph,
                                       AG::Lazy_discrete_geodesic_graph,
                                       AG::Saddle_vertex_graph>;
TYPED_TEST_SUITE(Near_pairs, Graphs_of_pairs, );

TYPED_TEST(Near_pairs, have_the_distance_of_the_field)
{
  Random random(test_seed());
  this->compare(to_mesh(terrain(6, 5, random)), CGAL::parameters::default_values());
}

} // namespace
