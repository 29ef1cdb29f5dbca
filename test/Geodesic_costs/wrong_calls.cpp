// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

void call_wrongly(const Mesh& mesh,
                  const Mesh::Property_map<Vertex, double> distances,
                  const Mesh::Property_map<Mesh::Face_index, double> weights,
                  const Mesh::Property_map<Mesh::Edge_index, bool> barriers)
{
  // maximum_number_of_points_per_edge, accept_weaker_bound: they are for epsilon with
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::epsilon(0.1).accept_weaker_bound(true));

  // epsilon and number_of_points_per_edge: only one of them can be given
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::epsilon(0.1).number_of_points_per_edge(3));

  // face_weight_map: this graph does not support weights
  AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>(
      mesh, parameters::face_weight_map(weights));

  // edge_is_constrained_map: this graph does not support barriers
  AG::Surface_mesh_shortest_path<Mesh>(mesh, parameters::edge_is_constrained_map(barriers));

  // maximum_number_of_points_per_edge, accept_weaker_bound: the bound of this graph
  AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>(
      mesh, parameters::accept_weaker_bound(true));

  // this graph has no points on edges
  AG::Surface_mesh_shortest_path<Mesh>(mesh, parameters::number_of_points_per_edge(3));

  // Geometric_points and Directional_points read epsilon, which determines the number of points
  AG::Geometric_points(parameters::number_of_points_per_edge(3));

  // Fixed_number_of_points reads number_of_points_per_edge, and gives no bound
  AG::Fixed_number_of_points{parameters::epsilon(0.1)};

  // max_slope: this graph does not support it
  AG::Edge_graph(AG::Intrinsic_triangulation(), parameters::max_slope(0.3));

  // max_slope: costs depend on the direction then
  AG::Steiner_graph<>(AG::Intrinsic_triangulation(), parameters::max_slope(0.3));
}
