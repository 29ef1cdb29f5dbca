// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzzed_meshes.h"
#include "peers/Published_bucket_queue.h"
#include "peers/Published_geometric_points.h"
#include "require.h"

#include <CGAL/Approximate_geodesics.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Meshes, indices, lengths, weights and parameters of any kind: each is refused by one of the
// exceptions that are documented, or gives a graph whose searches keep their promises.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Triangulation = AG::Intrinsic_triangulation;
using Node = Triangulation::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1 + 1e-6; // of arcs in single precision, and of paths over many faces

template <typename T>
std::vector<T> fuzzed_values(Fuzzed_data& data, const std::size_t size)
{
  std::vector<T> result;
  for(std::size_t i = 0; i < size; ++i)
    if constexpr(std::is_same_v<T, double>)
      result.push_back(data.number());
    else
      result.push_back(static_cast<T>(data.byte()));
  return result;
}

template <typename Map, typename T>
auto map_of(const Map& index_map, std::vector<T>& values)
{
  return boost::make_iterator_property_map(values.begin(), index_map);
}

template <typename T>
struct Graph_type
{
  using Graph = T;
};

// Everything that a triangulation can be made from.
Triangulation fuzzed_triangulation(Fuzzed_data& data, const Mesh& mesh, const bool has_weights)
{
  const auto edge_index = get(boost::edge_index, mesh);
  std::vector<double> lengths = fuzzed_values<double>(data, mesh.num_edges());
  std::vector<double> weights = fuzzed_values<double>(data, mesh.num_faces());
  std::vector<char> barriers = fuzzed_values<char>(data, mesh.num_edges());
  for(char& is_barrier : barriers)
    is_barrier = is_barrier > 100;
  const auto face_weight_map = map_of(get(boost::face_index, mesh), weights);
  const auto barrier_map = map_of(edge_index, barriers);
  if(has_weights && data.coin())
    return Triangulation(mesh, parameters::face_weight_map(face_weight_map)
                                   .edge_is_constrained_map(barrier_map)
                                   .edge_length_map(map_of(edge_index, lengths)));
  if(has_weights)
    return Triangulation(
        mesh, parameters::face_weight_map(face_weight_map).edge_is_constrained_map(barrier_map));
  switch(data.below(3))
  {
  case 0:
    return Triangulation(mesh, parameters::edge_length_map(map_of(edge_index, lengths)));
  case 1:
  {
    std::vector<int> vertices = fuzzed_values<int>(data, mesh.num_vertices());
    std::vector<int> halfedges = fuzzed_values<int>(data, mesh.num_halfedges());
    return Triangulation(
        mesh, parameters::vertex_index_map(map_of(get(boost::vertex_index, mesh), vertices))
                  .halfedge_index_map(map_of(get(boost::halfedge_index, mesh), halfedges)));
  }
  default:
    return Triangulation(mesh);
  }
}

// In units of the triangulation.
double length_of_longest_edge(const Triangulation& t)
{
  return t.number_of_halfedges() == 0 ? 0
                                      : *std::max_element(t.lengths().begin(), t.lengths().end());
}

template <typename Search>
void check_paths(const Search& search)
{
  const Triangulation& t = search.graph().triangulation();
  const bool can_be_straightened = !t.has_weights() && !t.has_barriers();
  const double longest = length_of_longest_edge(t);
  for(Node v = 0; v < t.number_of_vertices(); ++v)
  {
    const double distance = search.distance(v);
    require(distance >= 0, "a distance is negative or not a number", distance);
    const AG::Path path = AG::internal::tree_path(search, v);
    require(path.points.empty() == !search.is_reached(v), "a path has no points, or too many");
    require(path.length <= distance * rounding, "a path is too long", path.length, distance);
    if constexpr(AG::internal::has_crossing_arcs<typename Search::Graph>)
      if(can_be_straightened)
      {
        const double length = AG::Path_straightener(t).shortened(path).length;
        // of heights of thin faces, and of lines across faces that are far longer than the path
        const double rounding_of_faces =
            1e-8 * std::sqrt(longest * t.unit()) * std::sqrt(path.length) +
            1e-15 * longest * t.unit();
        require(length <= path.length * rounding + rounding_of_faces, "a path gets longer", length,
                path.length);
      }
  }
}

template <typename Queue, typename Graph>
std::vector<double> distances(const Graph& graph, const Node source)
{
  AG::Propagation<Graph, Queue> search(graph);
  search.run_from(source);
  std::vector<double> result;
  for(Node n = 0; n < graph.triangulation().number_of_vertices(); ++n)
    result.push_back(search.distance(n));
  return result;
}

template <typename Queue, typename Graph>
void check_queue(const Graph& graph, const Node source, const std::vector<double>& expected)
{
  const std::vector<double> found = distances<Queue>(graph, source);
  for(std::size_t n = 0; n < expected.size(); ++n)
    require(found[n] >= expected[n] / rounding && found[n] <= expected[n] * rounding,
            "queues disagree", n, found[n], expected[n]);
}

// Returns the distances, unless the graph is so large that a fuzzer has no time for it: there can
// be thousands of nodes on an edge.
template <typename Graph>
std::vector<double> check_searches(const Graph& graph, const Node source, Fuzzed_data& data)
{
  if(graph.number_of_nodes() > 5000)
    return {};
  AG::Propagation<Graph> search(graph);
  search.run_from(source);
  check_paths(search);
  const std::vector<double> result = distances<AG::Adaptive_bucket_queue>(graph, source);
  if constexpr(!std::is_same_v<Graph, AG::Lazy_discrete_geodesic_graph>)
    switch(data.below(3))
    {
    case 0:
      check_queue<AG::Binary_heap_queue>(graph, source, result);
      break;
    case 1:
      check_queue<AG::Radix_heap_queue>(graph, source, result);
      break;
    default:
      check_queue<AG::Published_bucket_queue>(graph, source, result);
    }
  return result;
}

void check_edges(const AG::Edge_graph& graph, const std::vector<double>& distance)
{
  const Triangulation& t = graph.triangulation();
  for(Node h = 0; h < t.number_of_halfedges(); ++h)
    require(distance[t.target(h)] <= (distance[t.source(h)] / t.unit() + t.length(h)) * t.unit(),
            "an edge is shorter");
}

// What arcs in single precision are rounded up to if they are shorter.
double length_of_shortest_arcs(const Triangulation& triangulation)
{
  return length_of_longest_edge(triangulation) * triangulation.unit() * 1e-40;
}

// Searches a graph whose paths are no longer than those along edges, if lengths are those of
// triangles.
template <typename Graph, typename NamedParameters>
void check_shortcuts(const Triangulation& triangulation,
                     const std::vector<double>& along_edges,
                     const Node source,
                     Fuzzed_data& data,
                     const NamedParameters& np)
{
  const std::vector<double> across_faces = check_searches(Graph(triangulation, np), source, data);
  const double tolerance = length_of_shortest_arcs(triangulation);
  for(std::size_t i = 0; i < across_faces.size(); ++i)
  {
    require((across_faces[i] == infinity) <= (along_edges[i] == infinity), "no path was found");
    require(across_faces[i] <= along_edges[i] * rounding + tolerance, "no shorter than along edges",
            i, across_faces[i], along_edges[i]);
  }
}

// A bound to build a graph for, which does not get so large that a fuzzer has no time for it.
auto fuzzed_epsilon(Fuzzed_data& data, const double smallest)
{
  const double epsilon = data.number();
  return parameters::epsilon(epsilon > 0 && epsilon < smallest ? smallest : epsilon);
}

// For all meshes, and with few points.
auto fuzzed_lenient_epsilon(Fuzzed_data& data)
{
  return fuzzed_epsilon(data, 0.1).accept_weaker_bound(true).maximum_number_of_points_per_edge(500);
}

void check_graphs(const Triangulation& triangulation, Fuzzed_data& data)
{
  const Node source = static_cast<Node>(data.below(triangulation.number_of_vertices()));
  const AG::Edge_graph edges(triangulation);
  const std::vector<double> along_edges = check_searches(edges, source, data);
  check_edges(edges, along_edges);
  const auto check = [&](const auto type, const auto& np) {
    using Graph = typename decltype(type)::Graph;
    check_shortcuts<Graph>(triangulation, along_edges, source, data, np);
  };
  switch(data.below(6))
  {
  case 0:
    return check(Graph_type<AG::Discrete_geodesic_graph>(), fuzzed_epsilon(data, 0.02));
  case 1:
    return check(Graph_type<AG::Lazy_discrete_geodesic_graph>(), fuzzed_epsilon(data, 0.02));
  case 2:
    return check(Graph_type<AG::Steiner_graph<AG::Geometric_points>>(),
                 fuzzed_lenient_epsilon(data));
  case 3:
    return check(Graph_type<AG::Steiner_graph<AG::Published_geometric_points>>(),
                 fuzzed_epsilon(data, 1));
  default:
    check(Graph_type<AG::Steiner_graph<AG::Fixed_number_of_points>>(),
          parameters::number_of_points_per_edge(data.below(6)));
  }
}

void check_weighted_graph(const Triangulation& triangulation, Fuzzed_data& data)
{
  const Node source = static_cast<Node>(data.below(triangulation.number_of_vertices()));
  if(data.coin())
    check_searches(
        AG::Steiner_graph<AG::Geometric_points>(triangulation, fuzzed_lenient_epsilon(data)),
        source, data);
  else
    check_searches(AG::Steiner_graph<AG::Fixed_number_of_points>(
                       triangulation, parameters::number_of_points_per_edge(data.below(6))),
                   source, data);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, const std::size_t size)
{
  Fuzzed_data data(bytes, size);
  const bool has_weights = data.coin();
  const Mesh mesh = fuzzed_mesh(data);
  try
  {
    const Triangulation triangulation = fuzzed_triangulation(data, mesh, has_weights);
    require(triangulation.is_valid(), "a triangulation is not valid");
    if(triangulation.number_of_vertices() == 0)
      return 0;
    has_weights ? check_weighted_graph(triangulation, data) : check_graphs(triangulation, data);
  }
  catch(const std::invalid_argument&)
  {
  }
  catch(const std::length_error&) // too many points
  {
  }
  return 0;
}
