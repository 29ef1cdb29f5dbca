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
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_place.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Part_growth.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Way_along_edges.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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

// Reads a mesh, builds the graph that the named parameters select, and calls `f` with a search of
// it, for a single run. Only edges are read if all `Points`, the types of sources and targets, are
// vertices.
template <typename... Points, typename TriangleMesh, typename NamedParameters, typename F>
auto search_once(const TriangleMesh& tmesh, const NamedParameters& np, const bool finds_path, F f)
{
  const auto search = [&](const auto& graph) {
    return search_graph(graph, tmesh, np, finds_path, f);
  };
  if constexpr(concerns_vertices_only<TriangleMesh, NamedParameters, Points...>())
  {
    Intrinsic_triangulation edges;
    Triangulation_builder<TriangleMesh, NamedParameters>(edges, tmesh, np).build_edges();
    return search(Edge_graph(std::move(edges), np));
  }
  else
    return with_graph<Lazy_discrete_geodesic_graph>(tmesh, np, search);
}

// Whether a part of a mesh can be bounded by positions in space: this requires paths that are at
// least as long as straight lines and not restricted by barriers. A visitor would observe the size
// of the part.
template <typename TriangleMesh, typename NamedParameters>
constexpr bool may_read_part()
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  return is_hashable<typename Graph_traits::vertex_descriptor> &&
         is_hashable<typename Graph_traits::halfedge_descriptor> &&
         !is_any_given<NamedParameters, internal_np::edge_length_t, internal_np::face_weight_t,
                       internal_np::direction_to_source_t, internal_np::edge_is_constrained_t,
                       internal_np::visitor_t>;
}

/*
 * Finds the part of a mesh that a run can reach, without reading the rest. It fails if the part is
 * not much smaller than the mesh, or if the mesh is unusual.
 */
template <typename TriangleMesh, typename NamedParameters>
class Part_to_read
{
  using Place = Mesh_place<TriangleMesh>;
  using Part = Mesh_part<TriangleMesh>;
  using Positions = Mesh_positions<TriangleMesh, NamedParameters>;

  static constexpr std::size_t SMALLEST_MESH = 1000; // vertices; smaller meshes are read completely

  // Budgets, as inverse fractions of the number of vertices of the mesh: of vertices reached by the
  // search along edges, and of faces read. A failed attempt costs a few percent of the call. After
  // an upper bound is known, attempts rarely fail, so the budget is larger.
  static constexpr std::size_t REACHED_BY_WAY = 32, BETWEEN_POINTS = 8, AROUND_SOURCES = 32;

  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  Part_to_read(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_np(np),
      m_number_of_vertices(num_vertices(tmesh)),
      m_maximum_distance(maximum_distance(np))
  {
  }

  // Finds the part for a path from the nearest source to `target`.
  template <typename Sources, typename Target>
  std::optional<Part> between(const Sources& sources, const Target& target)
  {
    if(!is_worth_trying() || !add_sources(sources))
      return std::nullopt;
    const auto end = mesh_place(m_mesh, target);
    if(!end)
      return std::nullopt;
    const auto distance = distance_along_edges(*end);
    if(!distance)
      return std::nullopt;
    const double limit = *distance < infinity ? *distance : 0; // no path: only the ends
    return part(limit, &*end);
  }

  // Finds the part for distances up to the maximum distance.
  template <typename Sources>
  std::optional<Part> around(const Sources& sources)
  {
    if(!is_worth_trying() || m_maximum_distance == infinity || !add_sources(sources) ||
       !set_initial_distances())
      return std::nullopt;
    return part(m_maximum_distance, nullptr);
  }

private:
  bool is_worth_trying() const
  {
    return m_number_of_vertices >= SMALLEST_MESH && m_maximum_distance >= 0;
  }

  template <typename Sources>
  bool add_sources(const Sources& sources)
  {
    if constexpr(is_surface_point<TriangleMesh, Sources>)
      return add_source(sources);
    else
    {
      for(const auto& source : sources)
        if(!add_source(source))
          return false;
      return !m_sources.empty();
    }
  }

  template <typename Source>
  bool add_source(const Source& source)
  {
    const auto place = mesh_place(m_mesh, source);
    if(place)
      m_sources.push_back({*place, 0});
    return place.has_value();
  }

  bool set_initial_distances()
  {
    if constexpr(is_given<NamedParameters, internal_np::initial_distances_t>)
    {
      std::size_t number = 0;
      for(const auto& distance : parameters::get_parameter(m_np, internal_np::initial_distances))
      {
        if(number == m_sources.size())
          return false;
        m_sources[number].distance = CGAL::to_double(distance);
        if(!(m_sources[number].distance >= 0 && std::isfinite(m_sources[number].distance)))
          return false;
        ++number;
      }
      return number == m_sources.size();
    }
    else
      return true;
  }

  // Returns an upper bound on the distance, but at most the maximum distance; infinity if there is
  // no path; nothing if the search fails.
  std::optional<double> distance_along_edges(const Place& target) const
  {
    const Positions positions = this->positions();
    Way_along_edges way(m_mesh, positions, target, share(REACHED_BY_WAY));
    for(const Source& source : m_sources)
      way.start_at(source.place);
    return way.run(m_maximum_distance);
  }

  std::optional<Part> part(const double limit, const Place* const target) const
  {
    const Positions positions = this->positions();
    Detour detour;
    constexpr double rounding = 1e-9; // relative, of path lengths
    detour.limit = limit * (1 + rounding);
    for(const Source& source : m_sources)
      detour.starts.push_back({positions(source.place), source.distance});
    if(target != nullptr)
      detour.target = positions(*target);

    Part result(m_mesh);
    Part_growth growth(result, positions, detour,
                       share(target == nullptr ? AROUND_SOURCES : BETWEEN_POINTS));
    for(const Source& source : m_sources)
      growth.start_at(source.place);
    if(target != nullptr)
      growth.start_at(*target);
    return growth.run() ? std::make_optional(std::move(result)) : std::nullopt;
  }

  // Returns a budget. Work on a part is lost if the part becomes too large, so the budget is
  // smaller for searches along edges, which are faster, and for many sources, which take longer.
  std::size_t share(const std::size_t number_of_parts) const
  {
    constexpr bool is_along_edges =
        !is_any_given<NamedParameters, internal_np::epsilon_t,
                      internal_np::number_of_points_per_edge_t, internal_np::straighten_t>;
    const std::size_t number_for_edges = is_along_edges ? 3 : 1;
    return m_number_of_vertices /
           (number_of_parts * number_for_edges * (1 + m_sources.size() / 16));
  }

  Positions positions() const { return {m_mesh, m_np, m_sources.front().place.corner[0]}; }

  struct Source
  {
    Place place;
    double distance;
  };

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  const std::size_t m_number_of_vertices;
  const double m_maximum_distance;
  std::vector<Source> m_sources;
};

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

// Calls `f` with a search of a part, as `search_once()` does. Returns false if the part is refused;
// reading the whole mesh then diagnoses the error.
template <typename TriangleMesh, typename NamedParameters, typename F>
bool search_part_once(const Mesh_part<TriangleMesh>& part,
                      const NamedParameters& np,
                      const bool finds_path,
                      F f)
{
  Intrinsic_triangulation triangulation;
  Triangulation_builder<Mesh_part<TriangleMesh>, NamedParameters> builder(triangulation, part, np);
  if(!builder.try_to_build() || !is_accepted_by_graphs(triangulation, np))
    return false;
  with_graph_on<Lazy_discrete_geodesic_graph, Saddle_vertex_graph>(
      std::move(triangulation), np,
      [&](const auto& graph) { search_graph(graph, part, np, finds_path, f); });
  return true;
}

/*
 * Maps the vertices of the whole mesh to nodes of a part. Vertices outside the part have no node.
 */
template <typename Translation>
class Whole_translation
{
  using Part = typename Translation::Triangle_mesh;

public:
  using Triangle_mesh = typename Part::Triangle_mesh;
  using vertex_descriptor = typename Part::vertex_descriptor;
  using Index = typename Part::Index;

  explicit Whole_translation(const Translation& translation) : m_translation(translation) {}

  const Triangle_mesh& mesh() const { return whole(m_translation.mesh()); }

  Index node(const vertex_descriptor v) const
  {
    const bool is_in_part = m_translation.mesh().number(v) != Part::null_index;
    return is_in_part ? m_translation.node(v) : Part::null_index;
  }

  vertex_descriptor vertex(const Index node) const { return m_translation.vertex(node); }

private:
  const Translation& m_translation;
};

// Finds the part of the mesh that contains a path from the nearest source to `target`, and calls
// `f` with a search of it. Returns false if the part cannot be determined without reading the whole
// mesh.
template <typename TriangleMesh,
          typename Sources,
          typename Target,
          typename NamedParameters,
          typename F>
bool search_part_between([[maybe_unused]] const TriangleMesh& tmesh,
                         [[maybe_unused]] const Sources& sources,
                         [[maybe_unused]] const Target& target,
                         [[maybe_unused]] const NamedParameters& np,
                         [[maybe_unused]] F f)
{
  if constexpr(may_read_part<TriangleMesh, NamedParameters>())
    if(const auto part = Part_to_read(tmesh, np).between(sources, target))
      return search_part_once(*part, np, true, f);
  return false;
}

// Writes the results of a search of the part within the maximum distance. Returns false if the part
// cannot be determined without reading the whole mesh.
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Sources,
          typename NamedParameters>
bool write_distances_of_part([[maybe_unused]] const TriangleMesh& tmesh,
                             [[maybe_unused]] VertexDistanceMap distances,
                             [[maybe_unused]] const Sources& sources,
                             [[maybe_unused]] const NamedParameters& np)
{
  if constexpr(may_read_part<TriangleMesh, NamedParameters>() &&
               is_given<NamedParameters, internal_np::maximum_distance_t> &&
               !is_given<NamedParameters, internal_np::targets_t>)
    if(const auto part = Part_to_read(tmesh, np).around(sources))
      return search_part_once(*part, np, false, [&](auto& search) {
        search.run_from(sources, np);
        Vertex_results(search.search().search(), Whole_translation(search.translation()))
            .write(distances, np);
      });
  return false;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_ONCE_H
