// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_QUERY_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_QUERY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Vertex_predecessors.h>
#include <CGAL/Approximate_geodesics/Queries/internal/graph_for_one_run.h>
#include <CGAL/Approximate_geodesics/Queries/internal/run_parameters.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Queries/internal/write_points.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * One run on a mesh that is not seen again: what the free functions have in common.
 */
template <typename PriorityQueue, typename TriangleMesh, typename NamedParameters>
class Mesh_query
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertex_index_map = decltype(vertex_index_map(std::declval<const TriangleMesh&>(),
                                                     std::declval<const NamedParameters&>()));
  using Places = Mesh_translation<TriangleMesh, Vertex_index_map>;
  using Graph = decltype(graph_for_one_run(std::declval<const TriangleMesh&>(),
                                           std::declval<const NamedParameters&>()));
  using Search = Surface_search<Graph, PriorityQueue>;
  using Node = typename Search::Node;

public:
  Mesh_query(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_np(np),
      m_graph(graph_for_one_run(tmesh, np)),
      m_places(tmesh, vertex_index_map(tmesh, np), m_graph.triangulation()),
      m_search(m_graph)
  {
    if constexpr(is_any_given<NamedParameters, internal_np::visitor_t,
                              internal_np::geodesic_predecessor_t>)
      m_places.list_vertices();
  }

  // from one point of the surface or from a range of them
  template <typename Sources>
  void run(const Sources& sources)
  {
    std::vector<Source> places = places_of(sources);
    set_initial_distances(places);
    internal::run(m_search, std::move(places), stop_rule<Search>(m_graph, m_places, m_np), m_places,
                  m_np);
  }

  // ... until the distance of `target` is certain
  template <typename SurfacePoint, typename Target>
  void run(const SurfacePoint& source, const Target& target)
  {
    m_places.list_vertices(); // for the points of the path
    auto stop = stop_rule<Search>(m_graph, m_places, m_np);
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      add_target(stop, m_graph, m_places.place(target));
      internal::run(m_search, places_of(source), stop, m_places, m_np);
    }
    else
      m_search.run_to(m_places.place(target), places_of(source), stop, positions());
  }

  // Writes the points of the path from the source to `target`, if that was reached. Returns its
  // length, or infinity.
  template <typename SurfacePoint, typename Target, typename OutputIterator>
  double
  write_path(const SurfacePoint& /* source */, const Target& target, OutputIterator points) const
  {
    const Intrinsic_point place = m_places.place(target);
    Path path = m_search.find_path(place);
    straighten_if_wanted(m_graph.triangulation(), m_np, path);
    constexpr bool has_points_between = has_crossing_arcs<Graph> ||
                                        is_given<NamedParameters, internal_np::straighten_t> ||
                                        !std::is_convertible_v<SurfacePoint, vertex_descriptor> ||
                                        !std::is_convertible_v<Target, vertex_descriptor>;
    write_points<has_points_between>(path, m_places, m_mesh, points, m_np);
    return has_points_between && !path.points.empty() ? path.length * m_graph.unit()
                                                      : m_search.nearest(place).distance;
  }

  // Writes the distances, and what else the named parameters ask for. All memory for that is
  // allocated before anything is written.
  template <typename VertexDistanceMap>
  void write_results(VertexDistanceMap distances) const
  {
    if constexpr(is_given<NamedParameters, internal_np::geodesic_predecessor_t>)
    {
      Vertex_predecessors<typename Search::Search> before(m_search.search());
      write_distances_and_sources(distances);
      write_predecessors(before);
    }
    else
      write_distances_and_sources(distances);
  }

private:
  template <typename VertexDistanceMap>
  void write_distances_and_sources(VertexDistanceMap distances) const
  {
    const auto& search = m_search.search();
    constexpr bool with_sources = is_given<NamedParameters, internal_np::nearest_source_t>;
    if constexpr(with_sources)
      allocate_sources();
    for(const vertex_descriptor v : vertices(m_mesh))
      put(distances, v, search.distance(m_places.node(v)));
    if constexpr(with_sources)
    {
      const auto sources = parameters::get_parameter(m_np, internal_np::nearest_source);
      using Value = typename boost::property_traits<std::decay_t<decltype(sources)>>::value_type;
      for(const vertex_descriptor v : vertices(m_mesh))
        put(sources, v, static_cast<Value>(search.source(m_places.node(v))));
    }
  }

  // What the first question for a source allocates is enough for all.
  void allocate_sources() const
  {
    const auto& search = m_search.search();
    for(const Node node : search.reached_nodes())
      if(search.source(node) != Search::null_source)
        return;
  }

  void write_predecessors(Vertex_predecessors<typename Search::Search>& before) const
  {
    const auto predecessors = parameters::get_parameter(m_np, internal_np::geodesic_predecessor);
    for(const vertex_descriptor v : vertices(m_mesh))
      put(predecessors, v, predecessor(v, before));
  }

  // Positions lead the search to its goal. Where arcs are edges, finding these takes as long as the
  // whole search.
  Vertex_positions positions() const
  {
    if constexpr(has_crossing_arcs<Graph> && !is_given<NamedParameters, internal_np::edge_length_t>)
    {
      const auto points = vertex_point_map(m_mesh, m_np);
      return Vertex_positions(m_graph.triangulation(), m_places.position_of_vertex(points));
    }
    else
      return Vertex_positions();
  }

  template <typename Sources>
  std::vector<Source> places_of(const Sources& sources) const
  {
    std::vector<Source> result;
    if constexpr(is_surface_point<TriangleMesh, Sources>)
      result.push_back({m_places.place(sources)});
    else
      for(const auto& source : sources)
        result.push_back({m_places.place(source)});
    return result;
  }

  void set_initial_distances(std::vector<Source>& sources) const
  {
    if constexpr(is_given<NamedParameters, internal_np::initial_distances_t>)
    {
      std::size_t number = 0;
      for(const auto& distance : parameters::get_parameter(m_np, internal_np::initial_distances))
      {
        if(number < sources.size())
          sources[number].distance = checked_initial_distance(CGAL::to_double(distance));
        ++number;
      }
      if(number != sources.size())
        reject("there are " + std::to_string(number) + " initial distances, and " +
               std::to_string(sources.size()) + " sources");
    }
  }

  vertex_descriptor predecessor(const vertex_descriptor v,
                                Vertex_predecessors<typename Search::Search>& vertices_before) const
  {
    const Node node = m_places.node(v);
    if(!m_search.search().is_reached(node))
      return boost::graph_traits<TriangleMesh>::null_vertex();
    const Node before = vertices_before(node);
    return before == Search::Search::null_node ? v : m_places.vertex(before);
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  Graph m_graph;
  Places m_places;
  Search m_search;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_QUERY_H
