// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_pair_distances.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

void refine_wrongly(const Mesh& mesh)
{
  std::vector<Point> points;

  // epsilon: selective refinement gives no bound
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::epsilon(0.1));

  // refined_path() reads relative_tolerance
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::relative_tolerance(0.1).straighten(true));

  // directional_cost: selective refinement does not support directional costs
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::face_weight_map(AG::directional_cost(AG::Hiking_time())));
}

void compute_matrices_wrongly(const Mesh& mesh, const AG::Edge_graph& graph)
{
  const std::vector<double> initial_distances;
  const std::vector<Vertex> vertices;
  const auto function = [](std::size_t, const AG::Distance_row&) {};
  AG::Dense_rows<> rows;
  AG::Nearest_rows<> nearest(3);

  // approximate_geodesic_distance_matrix() does not read one of these named parameters
  CGAL::approximate_geodesic_distance_matrix(mesh, rows, vertices,
                                             parameters::initial_distances(initial_distances));

  // approximate_geodesic_distance_matrix() with a graph reads targets, maximum_distance
  CGAL::approximate_geodesic_distance_matrix(graph, rows, std::vector<int>(),
                                             parameters::epsilon(0.1));

  const std::vector<std::pair<Vertex, Vertex>> pairs;
  const AG::Surface_mesh_shortest_path<Mesh> shortest_paths(mesh);
  std::vector<double> numbers;

  // approximate_geodesic_pair_distances() does not read one of these named parameters
  CGAL::approximate_geodesic_pair_distances(mesh, pairs, std::back_inserter(numbers),
                                            parameters::targets(vertices));

  // approximate_geodesic_pair_distances() with a graph reads maximum_distance
  CGAL::approximate_geodesic_pair_distances(graph, std::vector<AG::Point_pair>(),
                                            std::back_inserter(numbers), parameters::epsilon(0.1));

  // pairs: a range of std::pair
  CGAL::approximate_geodesic_pair_distances(mesh, vertices, std::back_inserter(numbers));

  // lists of pairs read maximum_distance, concurrency_tag and visitor
  AG::Pair_queries(shortest_paths).distances(pairs, parameters::straighten(true));

  // symmetric: only supported by sinks that keep all rows and columns
  CGAL::approximate_geodesic_distance_matrix(graph, function, std::vector<int>(),
                                             parameters::symmetric(true));

  // Dense_rows, Radius_rows, Npy_file
  CGAL::approximate_geodesic_distance_matrix(graph, nearest, std::vector<int>(),
                                             parameters::symmetric(true));

  // a row sink must not be const
  const AG::Dense_rows<> const_rows;
  CGAL::approximate_geodesic_distance_matrix(graph, const_rows, std::vector<int>());

  // rows must be a row sink, such as Dense_rows, or callable
  CGAL::approximate_geodesic_distance_matrix(graph, 3, std::vector<int>());
}
