// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_random.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <vector>

// Weights that differ by hundreds of orders of magnitude: beside a cost, others vanish.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Lenient_graph = AG::Steiner_graph<>;
using Node = Lenient_graph::Node;

constexpr double infinity = std::numeric_limits<double>::infinity();

AG::Intrinsic_triangulation triangulation(const Mesh& mesh, const std::function<double()>& weight)
{
  std::map<Face, double> weights;
  for(const Face f : mesh.faces())
    weights[f] = weight();
  return AG::Intrinsic_triangulation(
      mesh, CGAL::parameters::face_weight_map(boost::make_assoc_property_map(weights)));
}

std::vector<std::function<double()>> kinds_of_extreme_weights(Random& random)
{
  return {[&] { return std::pow(10, random.between(0, 300)); },
          [&] { return std::pow(10, random.between(-300, 300)); },
          [&] { return std::pow(10, random.between(0, 20)); },
          [&] { return random.below(2) == 0 ? 1. : 1e200; },
          [&] { return random.below(10) == 0 ? 1e-200 : 1.; },
          [&] { return random.below(3) == 0 ? 0. : std::pow(10, random.between(0, 40)); }};
}

// As if nothing but one node were reached, so that all of its arcs are looked at.
struct Lone_label
{
  double distance(const Node n) const { return n == node ? 0 : infinity; }
  Node predecessor(Node) const { return AG::Propagation<Lenient_graph>::null_node; }

  Node node;
};

// Costs are those of all arcs, though most of these are not looked at.
TEST(Extreme_weights, leave_no_arc_out_that_matters)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  for(const auto& weight : kinds_of_extreme_weights(random))
  {
    const Lenient_graph graph(triangulation(mesh, weight), lenient_points(0.5));
    AG::Propagation<Lenient_graph> search(graph);
    search.run_from(Node(random.below(9)));
    const auto cost = [&](const Node n) { return search.distance(n) / graph.unit(); };
    for(Node n = 0; n < graph.number_of_nodes(); ++n)
    {
      double smallest_slack = infinity;
      graph.for_each_arc(n, Lone_label{n}, [&](const Node target, const double length) {
        smallest_slack =
            (std::min)(smallest_slack, (cost(n) + length) * (1 + 1e-12) - cost(target));
      });
      EXPECT_GE(smallest_slack, 0) << "node " << n;
    }
  }
}

// Rows of thousands of points; if ties were not broken, each point would look at a good part of
// several of them.
TEST(Extreme_weights, keep_the_number_of_arcs_small)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(5, 5));
  for(const auto& weight : kinds_of_extreme_weights(random))
  {
    const Lenient_graph graph(triangulation(mesh, weight), lenient_points(0.05));
    AG::Propagation<Lenient_graph> search(graph);
    search.collect_statistics(true);
    search.run_from(12);
    EXPECT_LT(double(search.statistics().relaxations),
              double(graph.number_of_nodes()) * double(graph.maximum_degree()) / 8);
  }
}

} // namespace
