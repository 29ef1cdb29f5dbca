// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Golden_results.h"
#include "golden_graphs.h"
#include "golden_names.h"
#include "meshes/surface_points.h"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// What the class answers.

namespace geodesics_test {
namespace golden {

// Lengths of paths that are returned have a hash of their own: their last bit depends on the order
// in which the parts of a path are added up, which can change while nothing else does.
struct Hashes
{
  Hash distances, points, lengths;
};

inline void add_surface_point(const Surface_point& p, Hash& hash)
{
  hash.add(std::uint64_t(p.index()));
  if(const auto* const v = std::get_if<Vertex>(&p))
    hash.add(*v);
  else if(const auto* const on_edge = std::get_if<Edge_location>(&p))
  {
    hash.add(on_edge->first);
    hash.add(on_edge->second);
  }
  else
  {
    const auto& [face, coordinates] = std::get<Face_location>(p);
    hash.add(face);
    for(const double c : coordinates)
      hash.add(c);
  }
}

// One in a vertex, one on an edge, and one in a face.
inline std::vector<Surface_point> golden_sources(const Mesh& mesh)
{
  Random random(4);
  return {random_vertex(mesh, random), Edge_location(random_halfedge(mesh, random), 0.3),
          random_face_location(mesh, random)};
}

// No two random numbers are arguments of one call, as compilers differ in the order of these.
inline std::vector<Surface_point> golden_targets(const Mesh& mesh)
{
  Random random(5);
  std::vector<Surface_point> result = {
      Vertex(0), Vertex(static_cast<Mesh::size_type>(mesh.number_of_vertices() - 1))};
  for(int i = 0; i < 2; ++i)
  {
    result.push_back(random_vertex(mesh, random));
    const double part = random.between(0, 1);
    result.push_back(Edge_location(random_halfedge(mesh, random), part));
    result.push_back(Edge_location(random_border_halfedge(mesh, random), part));
    result.push_back(random_location_at_side(mesh, random));
    result.push_back(random_face_location(mesh, random));
  }
  return result;
}

template <typename Paths>
std::uint64_t number_of_source(const Paths& paths, const typename Paths::Source_point_iterator it)
{
  return static_cast<std::uint64_t>(std::distance(paths.source_points_begin(), it));
}

template <typename Paths>
void add_distance(Paths& paths, const Surface_point& target, Hash& hash)
{
  const auto [distance, source] = paths.shortest_distance_to_source_points(target);
  hash.add(distance);
  hash.add(number_of_source(paths, source));
}

// The path as places on the surface, and where these are in space.
template <typename Paths, typename NamedParameters>
void add_path(Paths& paths, const Surface_point& target, const NamedParameters& np, Hashes& hashes)
{
  std::vector<Surface_point> places;
  const auto [length, source] =
      paths.shortest_path_surface_points_to_source_points(target, std::back_inserter(places), np);
  hashes.lengths.add(length);
  hashes.points.add(number_of_source(paths, source));
  hashes.points.add(std::uint64_t(places.size()));
  for(const Surface_point& p : places)
  {
    add_surface_point(p, hashes.points);
    hashes.points.add(paths.point(p));
  }
}

template <typename Paths, typename NamedParameters>
void add_pair(Paths& paths,
              const Surface_point& source,
              const Surface_point& target,
              const NamedParameters& np,
              Hashes& hashes)
{
  std::vector<Point> points;
  hashes.lengths.add(
      double(paths.shortest_path_points(source, target, std::back_inserter(points), np)));
  hashes.points.add(points);
}

template <typename Paths, typename NamedParameters>
void add_paths(Paths& paths,
               const std::vector<Surface_point>& targets,
               const NamedParameters& np,
               Hashes& hashes)
{
  for(std::size_t i = 0; i < targets.size(); ++i)
  {
    add_path(paths, targets[i], np, hashes);
    if(i % 3 == 0) // a search each
      add_pair(paths, targets[(i + 1) % targets.size()], targets[i], np, hashes);
  }
}

template <typename Paths>
void add_distances(Paths& paths, const std::vector<Surface_point>& targets, Hashes& hashes)
{
  for(std::size_t i = 0; i < targets.size(); ++i)
  {
    add_distance(paths, targets[i], hashes.distances);
    if(i % 3 == 1)
      hashes.distances.add(
          double(paths.shortest_distance(targets[i], targets[(i + 1) % targets.size()])));
  }
}

template <typename Paths>
void add_sources(const Mesh& mesh, Paths& paths)
{
  double initial_distance = 0;
  for(const Surface_point& p : golden_sources(mesh))
  {
    paths.add_source_point(p, initial_distance);
    initial_distance += 0.4 * mean_edge_length(mesh);
  }
}

template <typename GeodesicGraph>
void add_all_queries(const Mesh& mesh,
                     const std::string& name,
                     GeodesicGraph graph,
                     Golden_results& results)
{
  Shortest_paths<GeodesicGraph> paths(mesh, std::move(graph));
  add_sources(mesh, paths);
  const std::vector<Surface_point> targets = golden_targets(mesh);
  Hashes plain, straight;
  add_distances(paths, targets, plain);
  add_paths(paths, targets, CGAL::parameters::default_values(), plain);
  results.add(name + ", points of paths", plain.distances, plain.points);
  results.add(name + ", lengths of paths", plain.lengths);
  const Triangulation& triangulation = paths.graph().triangulation();
  if(triangulation.has_weights() || triangulation.has_directional_costs())
    return; // cheapest paths are not straight
  add_paths(paths, targets, CGAL::parameters::straighten(true), straight);
  results.add(name + ", points of straightened paths", straight.points);
  results.add(name + ", lengths of straightened paths", straight.lengths);
}

// Weights that are other ones after a first search.
inline void add_exchanged_weights(const Mesh& mesh, Golden_results& results)
{
  Shortest_paths<With_points<Spaced_points>> paths(mesh,
                                                   CGAL::parameters::number_of_points_per_edge(1));
  add_sources(mesh, paths);
  const std::vector<Surface_point> targets = golden_targets(mesh);
  Hashes hashes;
  add_distances(paths, targets, hashes);
  const Weights weights = weights_of(mesh);
  paths.set_face_weights(weight_map(weights));
  add_distances(paths, targets, hashes);
  add_paths(paths, targets, CGAL::parameters::default_values(), hashes);
  results.add("exchanged weights, points of paths", hashes.distances, hashes.points);
  results.add("exchanged weights, lengths of paths", hashes.lengths);
}

} // namespace golden

void add_queries(const Mesh& mesh, Golden_results& results)
{
  golden::for_each_golden_graph(mesh, [&](const std::string& name, auto&& graph) {
    golden::add_all_queries(mesh, name, std::move(graph), results);
  });
  golden::add_exchanged_weights(mesh, results);
}

} // namespace geodesics_test
