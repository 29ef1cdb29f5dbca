// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GOLDEN_GRAPHS_H
#define APPROXIMATE_GEODESICS_TEST_GOLDEN_GRAPHS_H

#include "golden_names.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_test::golden {

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const double length : edge_lengths(mesh))
    sum += length;
  return sum / double(mesh.number_of_edges());
}

inline Weights weights_of(const Mesh& mesh)
{
  Random random(2);
  return random_weights(mesh, random, 0.5, 4);
}

inline Barriers barriers_of(const Mesh& mesh)
{
  Random random(3);
  return random_barriers(mesh, 0.05, random);
}

// Calls `f(name, graph)` for graphs whose nodes are the vertices. The graph is a temporary, as some
// cannot be copied.
template <typename F>
void for_each_graph_of_vertices(const Mesh& mesh, F f)
{
  const Triangulation triangulation(mesh);
  const auto epsilon = [](const double e) { return CGAL::parameters::epsilon(e); };
  f("edges", Edges(triangulation));
  f("built 0.1", Built(triangulation, epsilon(0.1)));
  f("lazy 0.1", Lazy(triangulation, epsilon(0.1)));
  if(mesh.number_of_vertices() <= 700)
    f("lazy 0.01", Lazy(triangulation, epsilon(0.01)));
  f("lazy 0.1 kept", Lazy(triangulation, epsilon(0.1), Lazy::Arcs::KEPT));
  f("exact", Exact(triangulation));
}

// Calls `f(name, graph)` unless that would take too long: for the mesh is large, or its faces are
// so thin that there are thousands of points on an edge.
template <typename Placement, typename F>
void with_points(const Mesh& mesh,
                 const std::string& name,
                 const Triangulation& triangulation,
                 const Placement& placement,
                 const std::size_t largest_number_of_vertices,
                 F f)
{
  if(mesh.number_of_vertices() > largest_number_of_vertices)
    return;
  With_points<Placement> graph(triangulation, placement);
  if(graph.number_of_nodes() <= 20000)
    f(name, std::move(graph));
}

// ... for graphs with points on edges.
template <typename F>
void for_each_graph_with_points_on_edges(const Mesh& mesh, F f)
{
  const Weights weights = weights_of(mesh);
  const Barriers barriers = barriers_of(mesh);
  const Triangulation plain(mesh), weighted(mesh, with_weights(weights)),
      divided(mesh, with_barriers(barriers));
  const Dense_points dense(0.4 * mean_edge_length(mesh));
  with_points(mesh, "spaced 3", plain, Spaced_points(3), 700, f);
  with_points(mesh, "spaced 2 weights", weighted, Spaced_points(2), 1200, f);
  with_points(mesh, "spaced 2 barriers", divided, Spaced_points(2), 1000, f);
  with_points(mesh, "dense", plain, dense, 700, f);
  with_points(mesh, "geometric 0.5", plain, lenient_points(0.5), 360, f);
  with_points(mesh, "geometric 1 weights", weighted, lenient_points(1), 360, f);
  with_points(mesh, "published 1", plain, Published_points(1), 360, f);
}

// ... for graphs whose costs depend on the direction.
template <typename F>
void for_each_graph_with_directional_costs(const Mesh& mesh, F f)
{
  if(mesh.number_of_vertices() > 700)
    return;
  Random random(7);
  const std::vector<Slant> slants = random_slants(mesh, random, 0.6);
  const auto slanted = with_cost(cost_of_faces(slants));
  const auto hiking = with_cost(AG::Hiking_time());
  const auto add = [&](const std::string& name, const auto& np, const bool is_to_sources) {
    f(name, With_costs<Spaced_points>(Triangulation(mesh, np), Spaced_points(2), is_to_sources));
  };
  add("slants", slanted, false);
  add("hiking", hiking, false);
  add("hiking to sources", hiking, true);
  if(mesh.number_of_vertices() > 300)
    return;
  const auto np =
      slanted.epsilon(1.).accept_weaker_bound(true).maximum_number_of_points_per_edge(40);
  f("slants with a bound", With_costs<Directional_points>(Triangulation(mesh, np), np));
}

template <typename F>
void for_each_golden_graph(const Mesh& mesh, F f)
{
  for_each_graph_of_vertices(mesh, f);
  for_each_graph_with_points_on_edges(mesh, f);
  for_each_graph_with_directional_costs(mesh, f);
}

} // namespace geodesics_test::golden

#endif // APPROXIMATE_GEODESICS_TEST_GOLDEN_GRAPHS_H
