// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Adjacency_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Adjacency_reader.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Vertex_numbers.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_results.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_visitor.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Whether a search runs along edges, and all `Points` and targets are given as vertices.
template <typename TriangleMesh, typename NamedParameters, typename... Points>
constexpr bool concerns_vertices_only()
{
  constexpr bool needs_faces =
      is_any_given<NamedParameters, internal_np::epsilon_t,
                   internal_np::number_of_points_per_edge_t, internal_np::face_weight_t,
                   internal_np::edge_is_constrained_t, internal_np::straighten_t>;
  if constexpr(needs_faces || !(are_vertices<TriangleMesh, Points> && ...))
    return false;
  else if constexpr(is_given<NamedParameters, internal_np::targets_t>)
  {
    using Targets = decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                       internal_np::targets));
    return are_vertices<TriangleMesh, std::decay_t<Targets>>;
  }
  else
    return true;
}

/*
 * A search along edges between vertices, in terms of a mesh: the counterpart of `Mesh_search` that
 * requires no triangulation.
 */
template <typename Numbers>
class Vertex_search
{
  using Triangle_mesh = typename Numbers::Triangle_mesh;
  using vertex_descriptor = typename Numbers::vertex_descriptor;
  using Search = Propagation<Adjacency_graph>;
  using Node = typename Search::Node;

public:
  // Both arguments are referred to, not copied.
  Vertex_search(const Adjacency_graph& graph, const Numbers& numbers)
    : m_numbers(numbers), m_search(graph)
  {
  }

  // Searches from a vertex or from a range of vertices. Returns false, without searching, if a
  // source or a target is not a vertex of the mesh.
  template <typename Sources, typename NamedParameters>
  bool run_from(const Sources& sources, const NamedParameters& np)
  {
    std::vector<Seed> seeds = this->seeds(sources);
    set_initial_distances(np, seeds);
    return run(seeds, stop_rule(np), np);
  }

  // Searches until the distance of `target` is final. Returns false in the same cases as
  // run_from().
  template <typename Sources, typename NamedParameters>
  bool run_to(const Sources& sources, const vertex_descriptor target, const NamedParameters& np)
  {
    Stop_rule stop;
    stop.maximum_distance = maximum_distance(np);
    stop.targets.push_back(m_numbers.node(target));
    return run(seeds(sources), stop, np);
  }

  // Calls `f(vertex)` for the vertices of the path from the nearest source to `target`. Returns its
  // length, or infinity if there is no path.
  template <typename F>
  double for_each_vertex_of_path(const vertex_descriptor target, F f) const
  {
    const Node last = m_numbers.node(target);
    std::vector<Node> path;
    if(m_search.is_reached(last))
      for(Node node = last; node != Search::null_node; node = m_search.predecessor(node))
        path.push_back(node);
    std::for_each(path.rbegin(), path.rend(), [&](const Node n) { f(m_numbers.vertex(n)); });
    return m_search.distance(last);
  }

  template <typename VertexDistanceMap, typename NamedParameters>
  void write_results(VertexDistanceMap distances, const NamedParameters& np) const
  {
    Vertex_results(m_search, m_numbers).write(distances, np);
  }

private:
  template <typename NamedParameters>
  bool run(const std::vector<Seed>& seeds, const Stop_rule& stop, const NamedParameters& np)
  {
    for(const Seed& seed : seeds)
      if(seed.node == Numbers::null_index)
        return false;
    for(const Node target : stop.targets)
      if(target == Numbers::null_index)
        return false;
    for(const Seed& seed : seeds)
      check_initial_distance(seed.distance, seed.source);
    run_with_visitor(np, m_numbers, [&](auto&& visitor) { m_search.run(seeds, stop, visitor); });
    return true;
  }

  template <typename Sources>
  std::vector<Seed> seeds(const Sources& sources) const
  {
    std::vector<Seed> result;
    for(const Node node : nodes(sources))
      result.push_back({node, 0, result.size()});
    return result;
  }

  template <typename Vertices>
  std::vector<Node> nodes(const Vertices& vertices) const
  {
    std::vector<Node> result;
    if constexpr(is_surface_point<Triangle_mesh, Vertices>)
      result.push_back(m_numbers.node(vertices));
    else
      for(const auto& v : vertices)
        result.push_back(m_numbers.node(v));
    return result;
  }

  template <typename NamedParameters>
  Stop_rule stop_rule(const NamedParameters& np) const
  {
    Stop_rule result;
    result.maximum_distance = maximum_distance(np);
    if constexpr(is_given<NamedParameters, internal_np::targets_t>)
      result.targets = nodes(parameters::get_parameter(np, internal_np::targets));
    return result;
  }

  const Numbers& m_numbers;
  Search m_search;
};

// Reads the edges of a mesh, and calls `f` with a search of them. Returns false if `f` does, or if
// the mesh is invalid or unusual. The caller then falls back to `search_once()`, which diagnoses
// errors.
template <typename TriangleMesh, typename NamedParameters, typename F>
bool search_vertices_once(const TriangleMesh& tmesh, const NamedParameters& np, F f)
{
  using Numbers = Vertex_numbers<TriangleMesh, decltype(vertex_index_map(tmesh, np))>;
  const std::size_t number_of_vertices = num_vertices(tmesh);
  if((std::max)(number_of_vertices, std::size_t(num_halfedges(tmesh))) >= Numbers::null_index)
    return false;
  Numbers numbers(tmesh, vertex_index_map(tmesh, np), number_of_vertices);
  Adjacency_reader reader(numbers, halfedge_index_map(tmesh, np));
  if(!numbers.list_vertices() || !reader.read())
    return false;
  Edge_lengths lengths = reader.lengths(np);
  lengths.points = std::vector<Space_vector>(); // frees their memory
  const Adjacency_graph graph(std::move(reader.adjacency()), std::move(lengths.of_halfedge),
                              lengths.unit);
  Vertex_search<Numbers> search(graph, numbers);
  return f(search);
}

// Writes the points of a path along edges. Returns its length, or nothing if the caller has to fall
// back to `search_once()`.
template <typename TriangleMesh, typename OutputIterator, typename Source, typename NamedParameters>
std::optional<double>
write_path_once(const TriangleMesh& tmesh,
                OutputIterator points,
                const Source& source,
                const typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                const NamedParameters& np)
{
  std::optional<double> length;
  search_vertices_once(tmesh, np, [&](auto& search) {
    if(!search.run_to(source, target, np))
      return false;
    const auto point_map = vertex_point_map(tmesh, np);
    length = search.for_each_vertex_of_path(target,
                                            [&](const auto v) { *points++ = get(point_map, v); });
    return true;
  });
  return length;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_SEARCH_H
