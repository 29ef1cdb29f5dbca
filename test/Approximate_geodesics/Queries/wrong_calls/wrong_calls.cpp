// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_pair_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <iterator>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Edge = Mesh::Edge_index;

struct Graph_that_attaches_nothing : AG::Edge_graph
{
  void attach() const;
};

struct Graph_without_triangulation : AG::Edge_graph
{
  void triangulation() const;
};

void call_wrongly(const Mesh& mesh,
                  const Mesh::Property_map<Vertex, double> distances,
                  const Mesh::Property_map<Face, int> cells,
                  const Mesh::Property_map<Face, Vector> gradients,
                  const Mesh::Property_map<Face, double> weights,
                  const Mesh::Property_map<Edge, bool> barriers)
{
  const std::vector<double> isovalues;
  const std::vector<Vertex> vertices;
  std::vector<std::vector<Point>> lines;
  std::vector<Vertex> samples;
  std::vector<Point> points;

  // approximate_geodesic_distances() does not read one of these named parameters
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0), parameters::straighten(true));

  // one of a std::vector is boost::make_iterator_property_map(
  CGAL::approximate_geodesic_distances(mesh, std::vector<double>(), Vertex(0));

  // distances are written to a property map with vertex descriptors as keys
  AG::Surface_mesh_shortest_path<Mesh>(mesh).shortest_distances_to_source_points(isovalues);

  // a source is a vertex descriptor, a Face_location or a Surface_point
  CGAL::approximate_geodesic_distances(mesh, distances, 0);

  // source, target: a vertex descriptor, Face_location, or Surface_point
  CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), 0, Vertex(1));

  // approximate_geodesic_path() does not read one of these named parameters
  CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                                  parameters::targets(vertices));

  // maximum_number_of_points_per_edge, accept_weaker_bound: they are for epsilon with
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::epsilon(0.1).accept_weaker_bound(true));

  // isolines() reads vertex_point_map and geom_traits only
  AG::isolines(mesh, distances, isovalues, std::back_inserter(lines), parameters::epsilon(0.1));

  // gradient() reads vertex_point_map and geom_traits only
  AG::gradient(mesh, distances, gradients, parameters::maximum_distance(3));

  // farthest_point_sampling() reads epsilon
  AG::farthest_point_sampling(mesh, std::back_inserter(samples), 3, parameters::targets(vertices));

  // farthest_point_sampling() takes a vertex or a range of vertices as sources
  AG::farthest_point_sampling(mesh, std::back_inserter(samples), 3, AG::Face_location<Mesh>());

  // approximate_geodesic_distances() does not read one of these named parameters
  AG::voronoi_partition(mesh, cells, vertices, parameters::straighten(true));

  // voronoi_borders() and cut_locus() are exact, and read edge_length_map
  AG::voronoi_borders(mesh, vertices, parameters::epsilon(0.1));

  // offset_curves() is exact
  std::vector<AG::Offset_curve<Point>> curves;
  AG::offset_curves(mesh, Vertex(0), 0.1, std::back_inserter(curves), parameters::epsilon(0.1));

  // epsilon: selective refinement gives no bound
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::epsilon(0.1));

  // refined_path() reads relative_tolerance
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::relative_tolerance(0.1).straighten(true));

  // directional_cost: selective refinement does not support directional costs
  AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                   parameters::face_weight_map(AG::directional_cost(AG::Hiking_time())));

  // direction_to_source: distances there and back are the same in this graph
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::direction_to_source(true));

  // epsilon and number_of_points_per_edge: only one of them can be given
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::epsilon(0.1).number_of_points_per_edge(3));

  // epsilon: the edge graph has no error bound
  AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>(mesh, parameters::epsilon(0.1));

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

  // build_sequence_tree() reads maximum_distance, targets and visitor
  AG::Surface_mesh_shortest_path<Mesh> shortest_paths(mesh);
  shortest_paths.build_sequence_tree(parameters::epsilon(0.1));

  // the constructor does not run
  AG::Surface_mesh_shortest_path<Mesh>(mesh, parameters::maximum_distance(3));

  // paths to sources read straighten
  shortest_paths.shortest_path_points_to_source_points(Vertex(0), std::back_inserter(points),
                                                       parameters::maximum_distance(3));

  // single pairs read straighten, maximum_distance and visitor
  shortest_paths.shortest_distance(Vertex(0), Vertex(1), parameters::targets(vertices));

  // Geometric_points and Directional_points read epsilon, which determines the number of points
  AG::Geometric_points(parameters::number_of_points_per_edge(3));

  // Fixed_number_of_points reads number_of_points_per_edge, and gives no bound
  AG::Fixed_number_of_points{parameters::epsilon(0.1)};

  // A model of SurfaceGraph must have `attach(
  static_cast<void>(sizeof(AG::Surface_search<Graph_that_attaches_nothing>));

  // A model of SurfaceGraph must have `const Intrinsic_triangulation& triangulation()
  static_cast<void>(sizeof(AG::Surface_search<Graph_without_triangulation>));
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

  // epsilon: there is no bound on heights, or with costs that depend on the direction
  AG::Grid_graph(AG::Grid_shape(), 1, parameters::heights(std::vector<double>()).epsilon(0.1));

  // a cost function of the slope needs the named parameter heights
  AG::Grid_graph(AG::Grid_shape(), 1,
                 parameters::face_weight_map(AG::directional_cost(AG::Hiking_time())));

  // max_slope needs the named parameter heights
  AG::Grid_graph(AG::Grid_shape(), 1, parameters::max_slope(0.3));

  // max_slope: this graph does not support it
  AG::Edge_graph(AG::Intrinsic_triangulation(), parameters::max_slope(0.3));

  // max_slope: costs depend on the direction then
  AG::Steiner_graph<>(AG::Intrinsic_triangulation(), parameters::max_slope(0.3));
}
