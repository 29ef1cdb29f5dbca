// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_ONCE_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_ONCE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/equal_parts.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Returns no positions for the edge graph, where computing them takes as long as a search.
template <typename MeshSearch, typename NamedParameters>
Vertex_positions positions_for_one_run(const MeshSearch& search, const NamedParameters& /* np */)
{
  if constexpr(has_crossing_arcs<typename MeshSearch::Surface_search::Graph> &&
               !is_any_given<NamedParameters, internal_np::edge_length_t, internal_np::visitor_t>)
    return search.positions();
  else
    return Vertex_positions();
}

// Calls `f` with a search of a graph built on `tmesh`, for a single run.
template <typename Graph, typename TriangleMesh, typename NamedParameters, typename F>
auto search_graph(const Graph& graph,
                  const TriangleMesh& tmesh,
                  const NamedParameters& np,
                  const bool finds_path,
                  F f)
{
  Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
  if(finds_path ||
     is_any_given<NamedParameters, internal_np::visitor_t, internal_np::geodesic_predecessor_t>)
    translation.list_vertices();
  auto point_map = vertex_point_map(tmesh, np);
  Mesh_search<Graph, Adaptive_bucket_queue, decltype(translation), decltype(point_map)> search(
      graph, translation, std::move(point_map));
  return f(search);
}

// Whether a query reads only edges: it runs along edges, and all `Points` and targets are vertices.
template <typename TriangleMesh, typename NamedParameters, typename... Points>
constexpr bool needs_edges_only()
{
  if constexpr(needs_faces<NamedParameters> || !(are_vertices<TriangleMesh, Points> && ...))
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

// Returns whether graphs accept the triangulation of a part. Their messages would give vertices the
// numbers of the part.
template <typename NamedParameters>
bool is_accepted_by_graphs(const Intrinsic_triangulation& triangulation,
                           [[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::number_of_points_per_edge_t>)
    if(has_more_points(triangulation, Fixed_number_of_points(np),
                       maximum_number_of_points(triangulation, maximum_number_of_points(np))))
      return false;
  return triangulation.face_without_shape() == Intrinsic_triangulation::null_index;
}

// Reads a mesh, builds the graph that the named parameters select, and calls `f` with a search of
// it, for a single run between `Points`, the types of sources and targets. Returns false if a part
// of a mesh is refused; reading the whole mesh then diagnoses the error.
template <typename... Points, typename TriangleMesh, typename NamedParameters, typename F>
bool search_once(const TriangleMesh& tmesh, const NamedParameters& np, const bool finds_path, F f)
{
  const auto search = [&](const auto& graph) { search_graph(graph, tmesh, np, finds_path, f); };
  Intrinsic_triangulation triangulation;
  Triangulation_builder<TriangleMesh, NamedParameters> builder(triangulation, tmesh, np);
  if constexpr(needs_edges_only<TriangleMesh, NamedParameters, Points...>())
    if(builder.try_to_build_edges())
    {
      search(Edge_graph(std::move(triangulation), np));
      return true;
    }
  if constexpr(!is_part<TriangleMesh>)
    builder.build();
  else if(!builder.try_to_build() || !is_accepted_by_graphs(triangulation, np))
    return false;
  try
  {
    with_graph_on<Lazy_discrete_geodesic_graph>(std::move(triangulation), np, search);
  }
  catch(const Untraceable_line&)
  {
    if(!is_part<TriangleMesh>)
      throw;
    return false;
  }
  return true;
}

// Whether a part of a mesh can be bounded by positions in space: this requires paths that are at
// least as long as straight lines and not restricted by barriers. A visitor would observe the size
// of the part.
template <typename TriangleMesh, typename NamedParameters>
constexpr bool may_read_part()
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  return is_hashable<typename Graph_traits::vertex_descriptor> &&
         is_hashable<typename Graph_traits::halfedge_descriptor> && !has_weights<NamedParameters> &&
         !is_any_given<NamedParameters, internal_np::edge_length_t, internal_np::visitor_t>;
}

/*
 * Finds the part of a mesh that a run can reach, without reading the rest. It fails if the part is
 * not much smaller than the mesh, or if the mesh is unusual.
 */
template <typename TriangleMesh, typename NamedParameters>
class Part_to_read
{
  using Positions = Mesh_positions<TriangleMesh, NamedParameters>;
  using Growth = Part_growth<TriangleMesh, Positions>;

  static constexpr std::size_t SMALLEST_MESH = 1000; // vertices; smaller meshes are read completely

  // Budgets of faces, as inverse fractions of the number of vertices of the mesh. A failed attempt
  // costs a few percent of the call.
  static constexpr std::size_t BETWEEN_POINTS = 8, AROUND_SOURCES = 32;

  // The first limit on the length of a path, relative to the straight line, and the factor by which
  // it increases until a path is found. Paths along edges are longer.
  static constexpr double FIRST_LIMIT = needs_faces<NamedParameters> ? 1.1 : 1.2, INCREASE = 1.25;

  static constexpr double margin = 1 + 1e-9; // for rounding, of path lengths
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  Part_to_read(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_np(np),
      m_number_of_vertices(num_vertices(tmesh)),
      m_maximum_distance(maximum_distance(np))
  {
  }

  // Calls `search(part, limit)` with a part that contains all paths from the nearest source to
  // `target` up to the limit, and again with a larger limit if it returns a distance beyond it. The
  // limit is infinite if the part is a whole component of the mesh.
  // Returns whether the last distance is that on the mesh.
  template <typename Sources, typename Target, typename Search>
  bool between(const Sources& sources, const Target& target, Search search)
  {
    if(!is_worth_trying([&] {
         add_sources(sources);
         add_place(target);
       }))
      return false;
    m_detour.target = (*m_positions)(m_places.back());
    for(double limit = FIRST_LIMIT * m_detour.over(*m_detour.target);;)
    {
      limit = (std::min)(limit, m_maximum_distance);
      Growth growth = growth_up_to(limit, BETWEEN_POINTS);
      if(!growth.run())
        return false;
      const bool is_whole = growth.next_limit() == infinity; // a component of the mesh
      const double longest = is_whole ? infinity : m_detour.limit;
      const std::optional<double> distance = search(growth.part(), longest);
      if(!distance)
        return false;
      if(*distance <= longest || limit == m_maximum_distance)
        return true;
      limit = *distance < infinity ? *distance : (std::max)(INCREASE * limit, growth.next_limit());
    }
  }

  // Finds the part for distances up to the maximum distance.
  template <typename Sources>
  std::optional<Mesh_part<TriangleMesh>> around(const Sources& sources)
  {
    const auto read_sources = [&] {
      add_sources(sources);
      set_initial_distances(m_np, m_detour.starts);
      for(std::size_t i = 0; i < m_detour.starts.size(); ++i)
        check_initial_distance(m_detour.starts[i].distance, i);
    };
    if(m_maximum_distance == infinity || !is_worth_trying(read_sources))
      return std::nullopt;
    Growth growth = growth_up_to(m_maximum_distance, AROUND_SOURCES);
    return growth.run() ? std::make_optional(std::move(growth.part())) : std::nullopt;
  }

private:
  // Fails for points that may be invalid; reading the whole mesh then diagnoses the error.
  template <typename F>
  bool is_worth_trying(const F& read_points)
  {
    if(m_number_of_vertices < SMALLEST_MESH || !(m_maximum_distance >= 0))
      return false;
    try
    {
      read_points();
    }
    catch(const std::invalid_argument&)
    {
      return false;
    }
    return !m_detour.starts.empty();
  }

  template <typename Sources>
  void add_sources(const Sources& sources)
  {
    if constexpr(is_surface_point<TriangleMesh, Sources>)
      add_place(sources);
    else
      for(const auto& source : sources)
        add_place(source);
    for(const auto& place : m_places)
      m_detour.starts.push_back({(*m_positions)(place), 0});
  }

  template <typename Point>
  void add_place(const Point& point)
  {
    m_places.push_back(checked_place(m_mesh, point));
    if(!m_positions)
      m_positions.emplace(m_mesh, m_np, m_places.back().corner[0]);
  }

  // The budget is smaller for searches along edges, which are faster, and for many sources, which
  // take longer: work on a part is lost if the part becomes too large.
  Growth growth_up_to(const double limit, const std::size_t number_of_parts)
  {
    m_detour.limit = margin * limit;
    const std::size_t divisor = number_of_parts * (needs_faces<NamedParameters> ? 1 : 3);
    Growth result(m_mesh, *m_positions, m_detour,
                  m_number_of_vertices / (divisor * (1 + m_detour.starts.size() / 16)));
    for(const auto& place : m_places)
      result.start_at(place);
    return result;
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  const std::size_t m_number_of_vertices;
  const double m_maximum_distance;
  std::vector<Mesh_place<TriangleMesh>> m_places; // the sources, and the target
  std::optional<Positions> m_positions;
  Detour m_detour;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_ONCE_H
