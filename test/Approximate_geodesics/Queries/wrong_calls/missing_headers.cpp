// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that need a header which is not included, each below the message that the compiler has to
// print for it.

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;

struct Graph_with_free_arcs : AG::Edge_graph
{
  bool has_free_arcs() const;
};

struct Graph_with_barriers : AG::Edge_graph
{
  using AG::Edge_graph::Edge_graph;

  void set_barriers(const std::vector<int>& changes);
};

void call_without_header(const Mesh& mesh,
                         const Mesh::Property_map<Vertex, double> distances,
                         const Mesh::Property_map<Mesh::Face_index, double> weights,
                         const Mesh::Property_map<Mesh::Edge_index, bool> barriers)
{
  // face_weight_map: include <CGAL/Geodesic_costs.h>
  AG::Intrinsic_triangulation(mesh, parameters::face_weight_map(weights));

  // max_slope: include <CGAL/Geodesic_costs.h>
  AG::Intrinsic_triangulation(mesh, parameters::max_slope(0.3));

  // edge_is_constrained_map: include <CGAL/Geodesic_costs.h>
  AG::Intrinsic_triangulation(mesh,
                              parameters::combine(parameters::edge_is_constrained_map(barriers)));

  // number_of_points_per_edge: include <CGAL/Geodesic_costs.h>
  CGAL::approximate_geodesic_distances(
      mesh, distances, Vertex(0), parameters::combine(parameters::number_of_points_per_edge(3)));

  const AG::Edge_graph graph;
  AG::Propagation<AG::Edge_graph> search(graph);

  // repair(): include <CGAL/Geodesic_costs.h>
  search.repair({});

  // resume(): include <CGAL/Geodesic_costs.h>
  search.resume([](const auto&) {});

  // set_face_weights(), set_weights(), set_barriers(): include <CGAL/Geodesic_costs.h>
  AG::Surface_mesh_shortest_path<Mesh, Graph_with_barriers> shortest_paths(mesh);
  shortest_paths.set_barriers(std::vector<std::pair<Mesh::Edge_index, bool>>());

  // has_free_arcs() of the graph: include <CGAL/Geodesic_costs.h>
  static_cast<void>(sizeof(AG::Propagation<Graph_with_free_arcs>));
}
