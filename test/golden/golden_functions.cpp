// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Golden_results.h"
#include "golden_graphs.h"
#include "meshes/surface_points.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// What the functions answer, and what a graph is in a file.

namespace geodesics_test {
namespace golden {

namespace parameters = CGAL::parameters;

template <typename T>
auto by_vertex(const Mesh& mesh, std::vector<T>& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh));
}

template <typename T>
auto by_face(const Mesh& mesh, std::vector<T>& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

// Writes lines for one mesh.
class Functions
{
public:
  Functions(const Mesh& mesh, Golden_results& results)
    : m_mesh(mesh), m_results(results), m_weights(weights_of(mesh)), m_barriers(barriers_of(mesh))
  {
    Random random(6);
    for(int i = 0; i < 3; ++i)
      m_vertices.push_back(random_vertex(mesh, random));
    m_points = {m_vertices[0], Edge_location(random_halfedge(mesh, random), 0.7),
                random_face_location(mesh, random)};
    m_reach = 6 * mean_edge_length(mesh);
  }

  void add_distances()
  {
    add_distances("", parameters::default_values());
    add_distances("epsilon", parameters::epsilon(0.1));
    add_distances("points per edge", parameters::number_of_points_per_edge(2));
    add_distances("weights", with_weights(m_weights));
    add_distances("barriers", with_barriers(m_barriers));
    if(m_mesh.number_of_vertices() <= 1200)
      add_distances("weights, epsilon",
                    with_weights(m_weights).epsilon(1.).accept_weaker_bound(true));
    add_distances("maximum", parameters::maximum_distance(m_reach));
    add_distances("targets", parameters::targets(m_vertices).epsilon(0.1));
    add_everything();
  }

  void add_paths()
  {
    add_path("", m_vertices[1], m_vertices[2], parameters::default_values());
    add_path("between points", m_points[1], m_points[2], parameters::default_values());
    add_path("epsilon", m_points[1], m_points[2], parameters::epsilon(0.1));
    add_path("straight", m_points[1], m_points[2], parameters::epsilon(0.1).straighten(true));
    add_path("points per edge", m_points[1], m_points[2], parameters::number_of_points_per_edge(2));
    add_path("barriers", m_points[1], m_points[2], with_barriers(m_barriers));
    add_refined_path();
  }

  void add_samples()
  {
    add_sample("", parameters::default_values());
    add_sample("epsilon", parameters::epsilon(0.1));
  }

  void add_cells()
  {
    std::vector<std::size_t> cells(m_mesh.number_of_faces());
    AG::voronoi_partition(m_mesh, by_face(m_mesh, cells), m_vertices, parameters::epsilon(0.1));
    Hash hash;
    hash.add(cells);
    m_results.add("Voronoi partition", hash);
  }

  void add_fields()
  {
    std::vector<double> distances(m_mesh.number_of_vertices());
    const auto map = by_vertex(m_mesh, distances);
    CGAL::approximate_geodesic_distances(m_mesh, map, m_points, parameters::epsilon(0.1));
    Hash lines, slopes;
    std::vector<std::vector<Point>> isolines;
    const std::vector<double> values = {0.2 * m_reach, 0.5 * m_reach, 2 * m_reach};
    AG::isolines(m_mesh, map, values, std::back_inserter(isolines));
    lines.add(isolines);
    m_results.add("isolines", lines);
    std::vector<Kernel::Vector_3> gradients(m_mesh.number_of_faces());
    AG::gradient(m_mesh, map, by_face(m_mesh, gradients));
    slopes.add(gradients);
    m_results.add("gradients", slopes);
  }

  void add_file()
  {
    std::ostringstream stream;
    Built(Triangulation(m_mesh), parameters::epsilon(0.1)).save(stream);
    Hash hash;
    hash.add(stream.str());
    m_results.add("file", hash);
  }

private:
  static std::string title(const std::string& function, const std::string& with)
  {
    return with.empty() ? function : function + ", " + with;
  }

  template <typename NamedParameters>
  void add_distances(const std::string& with, const NamedParameters& np)
  {
    std::vector<double> distances(m_mesh.number_of_vertices());
    CGAL::approximate_geodesic_distances(m_mesh, by_vertex(m_mesh, distances), m_vertices, np);
    Hash hash;
    hash.add(distances);
    m_results.add(title("distances", with), hash);
  }

  // from all kinds of points, and with all that can be asked for
  void add_everything()
  {
    const std::vector<double> initial = {0.2 * m_reach, 0, 0.1 * m_reach};
    std::vector<double> distances(m_mesh.number_of_vertices());
    std::vector<Vertex> predecessors(m_mesh.number_of_vertices());
    std::vector<std::size_t> sources(m_mesh.number_of_vertices());
    CGAL::approximate_geodesic_distances(m_mesh, by_vertex(m_mesh, distances), m_points,
                                         parameters::epsilon(0.1)
                                             .initial_distances(initial)
                                             .predecessor_map(by_vertex(m_mesh, predecessors))
                                             .nearest_source_map(by_vertex(m_mesh, sources)));
    Hash hash, others;
    hash.add(distances);
    others.add(predecessors);
    others.add(sources);
    m_results.add("distances, predecessors and sources", hash, others);
  }

  template <typename Place, typename NamedParameters>
  void add_path(const std::string& with,
                const Place& source,
                const Place& target,
                const NamedParameters& np)
  {
    std::vector<Point> points;
    const double length =
        CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), source, target, np);
    add_path_lines(with, points, length);
  }

  void add_refined_path()
  {
    std::vector<Point> points;
    const double length =
        AG::refined_path(m_mesh, std::back_inserter(points), m_vertices[1], m_vertices[2]);
    add_path_lines("refined", points, length);
  }

  void
  add_path_lines(const std::string& with, const std::vector<Point>& points, const double length)
  {
    Hash hash, hash_of_length;
    hash.add(points);
    hash_of_length.add(length);
    m_results.add(title("path", with) + ": points", hash);
    m_results.add(title("path", with) + ": length", hash_of_length);
  }

  template <typename NamedParameters>
  void add_sample(const std::string& with, const NamedParameters& np)
  {
    std::vector<Vertex> sample;
    const double radius =
        AG::farthest_point_sampling(m_mesh, std::back_inserter(sample), 9, m_vertices[0], np);
    Hash hash;
    hash.add(sample);
    hash.add(radius);
    m_results.add(title("farthest points", with), hash);
  }

  const Mesh& m_mesh;
  Golden_results& m_results;
  const Weights m_weights;
  const Barriers m_barriers;
  std::vector<Vertex> m_vertices;
  std::vector<Surface_point> m_points;
  double m_reach;
};

} // namespace golden

void add_functions(const Mesh& mesh, Golden_results& results)
{
  golden::Functions functions(mesh, results);
  functions.add_distances();
  functions.add_paths();
  functions.add_samples();
  functions.add_cells();
  functions.add_fields();
  functions.add_file();
}

} // namespace geodesics_test
