// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <iterator>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

struct Graph_that_attaches_nothing : AG::Edge_graph
{
  void attach() const;
};

struct Graph_without_triangulation : AG::Edge_graph
{
  void triangulation() const;
};

void call_wrongly(const Mesh& mesh, const Mesh::Property_map<Vertex, double> distances)
{
  const std::vector<double> numbers;
  const std::vector<Vertex> vertices;
  std::vector<Point> points;

  // approximate_geodesic_distances() does not read one of these named parameters
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0), parameters::straighten(true));

  // one of a std::vector is boost::make_iterator_property_map(
  CGAL::approximate_geodesic_distances(mesh, std::vector<double>(), Vertex(0));

  // distances are written to a property map with vertex descriptors as keys
  AG::Surface_mesh_shortest_path<Mesh>(mesh).shortest_distances_to_source_points(numbers);

  // a source is a vertex descriptor, a Face_location or a Surface_point
  CGAL::approximate_geodesic_distances(mesh, distances, 0);

  // source, target: a vertex descriptor, Face_location, or Surface_point
  CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), 0, Vertex(1));

  // approximate_geodesic_path() does not read one of these named parameters
  CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                                  parameters::targets(vertices));

  // direction_to_source: distances there and back are the same in this graph
  CGAL::approximate_geodesic_distances(mesh, distances, Vertex(0),
                                       parameters::direction_to_source(true));

  // epsilon: the edge graph has no error bound
  AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>(mesh, parameters::epsilon(0.1));

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

  // A model of SurfaceGraph must have `attach(
  static_cast<void>(sizeof(AG::Surface_search<Graph_that_attaches_nothing>));

  // A model of SurfaceGraph must have `const Intrinsic_triangulation& triangulation()
  static_cast<void>(sizeof(AG::Surface_search<Graph_without_triangulation>));
}
