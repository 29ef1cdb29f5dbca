// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Approximate_geodesics/Queries/internal/other_sources.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Adapts a visitor of vertices to a visitor of nodes.
 */
template <typename Visitor, typename Vertices>
class Vertex_visitor
{
public:
  Vertex_visitor(Visitor& visitor, const Vertices& vertices)
    : m_visitor(visitor), m_vertices(vertices)
  {
  }

  template <typename Node>
  void on_settled(const Node node, const double distance)
  {
    if(m_vertices.is_vertex(node))
      m_visitor.on_settled(m_vertices.vertex(node), distance);
  }

  void on_progress(const std::size_t number_of_settled_nodes, const std::size_t number_of_nodes)
  {
    m_visitor.on_progress(number_of_settled_nodes, number_of_nodes);
  }

  bool go_further() { return m_visitor.go_further(); }

private:
  Visitor& m_visitor;
  const Vertices& m_vertices;
};

// What `signed_distances` asks for: `of(search)` returns the distances of all vertices. The package
// Geodesic_constructions defines it.
template <typename SurfaceSearch>
struct Signed_distances;

/*
 * A search of a graph in terms of a mesh: the common implementation of the class and of the free
 * functions, which reads the named parameters of runs. The translation identifies the mesh.
 */
template <typename Graph, typename PriorityQueue, typename Translation, typename VertexPointMap>
class Mesh_search
{
  using Triangle_mesh = typename Translation::Triangle_mesh;
  using vertex_descriptor = typename boost::graph_traits<Triangle_mesh>::vertex_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  using Surface_search = Approximate_geodesics::Surface_search<Graph, PriorityQueue>;
  using Node = typename Surface_search::Node;

  // The graph and the translation are referred to, not copied.
  Mesh_search(const Graph& graph, const Translation& translation, VertexPointMap point_map)
    : m_translation(translation), m_point_map(std::move(point_map)), m_search(graph)
  {
  }

  const Translation& translation() const { return m_translation; }
  const VertexPointMap& point_map() const { return m_point_map; }
  const Surface_search& search() const { return m_search; }
  Surface_search& search() { return m_search; }

  // Converts a point of the surface, or a range of points.
  template <typename Sources>
  std::vector<Source_point> source_points(const Sources& sources) const
  {
    std::vector<Source_point> result;
    for(const Intrinsic_point& point : intrinsic_points(m_translation, sources, "source"))
      result.push_back({point});
    return result;
  }

  // Searches from a source, or from a range of sources.
  template <typename Sources, typename NamedParameters>
  void run_from(const Sources& sources, const NamedParameters& np)
  {
    if constexpr(are_other_sources<Triangle_mesh, Sources>)
      run(attached(sources, np), np);
    else
    {
      std::vector<Source_point> points = source_points(sources);
      set_initial_distances(np, points);
      run(std::move(points), np);
    }
  }

  // Searches from `Source_point`s, or from attached sources of another kind.
  template <typename Sources, typename NamedParameters>
  void run(Sources sources, const NamedParameters& np)
  {
    run(std::move(sources), stop_rule(np), np);
  }

  // Searches until the distance of `target` is final. Uses A* search with straight-line distances,
  // unless a visitor is given: visitors expect nodes in the order of their distances.
  template <typename Sources, typename Target, typename NamedParameters>
  void run_to(const Sources& sources,
              const Target& target,
              const Vertex_positions& positions,
              const NamedParameters& np)
  {
    const Intrinsic_point end = intrinsic_point(m_translation, target, "target");
    auto stop = stop_rule(np);
    stop.targets.push_back(end);
    if constexpr(are_other_sources<Triangle_mesh, Sources>)
      run(attached(sources, parameters::default_values()), stop, np);
    else if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
      run(source_points(sources), stop, np);
    else
      m_search.run_to(end, source_points(sources), positions, stop.maximum_distance);
  }

  // Returns the positions of the vertices, if the point type belongs to a kernel.
  Vertex_positions positions() const
  {
    if constexpr(is_point_of_kernel<Point>)
      return Vertex_positions(m_search.graph().triangulation(),
                              m_translation.position_of_vertex(m_point_map));
    else
      return Vertex_positions();
  }

  template <typename NamedParameters>
  Point point(const Intrinsic_point& p, const NamedParameters& np) const
  {
    return internal::point(m_translation, p, m_point_map, np);
  }

  // Writes the distances, and the other results requested by named parameters, to property maps.
  // All memory is allocated before the first write.
  template <typename VertexDistanceMap, typename NamedParameters>
  void write_results(VertexDistanceMap distances, [[maybe_unused]] const NamedParameters& np) const
  {
    using Search = typename Surface_search::Search;
    constexpr bool with_sources = is_given<NamedParameters, internal_np::nearest_source_t>;
    constexpr bool with_predecessors =
        is_given<NamedParameters, internal_np::geodesic_predecessor_t>;
    const Search& search = m_search.search();
    std::optional<Vertex_predecessors<Search>> predecessors;
    if constexpr(with_predecessors)
      predecessors.emplace(search);
    if constexpr(with_sources)
      for(const auto node : search.reached_nodes())
        if(m_search.source(node) != Search::null_source)
          break; // the first source that is found allocates memory for all
    const std::vector<double> with_sign = distances_with_sign(np);
    put_for_all(distances, [&](auto /* vertex */, const auto node) {
      if(node == Search::null_node)
        return infinity;
      return with_sign.empty() ? search.distance(node) : with_sign[node];
    });
    if constexpr(with_sources)
    {
      const auto map = parameters::get_parameter(np, internal_np::nearest_source);
      using Value = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
      put_for_all(map, [&](auto /* vertex */, const auto node) {
        return static_cast<Value>(node == Search::null_node ? Search::null_source
                                                            : m_search.source(node));
      });
    }
    if constexpr(with_predecessors)
      put_for_all(parameters::get_parameter(np, internal_np::geodesic_predecessor),
                  [&](const vertex_descriptor v, const auto node) -> vertex_descriptor {
                    if(node == Search::null_node || !search.is_reached(node))
                      return boost::graph_traits<Triangle_mesh>::null_vertex();
                    const auto before = (*predecessors)(node);
                    return before == Search::null_node ? v : m_translation.vertex(before);
                  });
  }

private:
  using Stop_rule = typename Surface_search::Stop_rule;

  // Returns none unless the named parameters request them.
  template <typename NamedParameters>
  std::vector<double> distances_with_sign([[maybe_unused]] const NamedParameters& np) const
  {
    if constexpr(is_given<NamedParameters, internal_np::signed_distances_t>)
    {
      using Distances = Signed_distances<Surface_search>;
      static_assert(is_defined<Distances>,
                    "signed_distances: include <CGAL/Geodesic_constructions.h>");
      if constexpr(is_defined<Distances>)
        if(parameters::get_parameter(np, internal_np::signed_distances))
          return Distances::of(m_search);
    }
    return {};
  }

  // Converts sources of another kind.
  template <typename Sources, typename NamedParameters>
  auto attached(const Sources& sources, const NamedParameters& np) const
  {
    using Source = Other_source_of<Triangle_mesh, Sources>;
    auto read = Source::read_all(m_search.graph(), m_translation, sources);
    set_initial_distances(np, read);
    return Source::template attach<Surface_search>(m_search.graph(), std::move(read));
  }

  // Reads the named parameters that limit a run.
  template <typename NamedParameters>
  Stop_rule stop_rule(const NamedParameters& np) const
  {
    Stop_rule result{maximum_distance(np)};
    if constexpr(is_given<NamedParameters, internal_np::targets_t>)
      result.targets = intrinsic_points(
          m_translation, parameters::get_parameter(np, internal_np::targets), "target");
    return result;
  }

  // Runs with the visitor of the named parameters, if any.
  template <typename Sources, typename NamedParameters>
  void run(Sources sources, const Stop_rule& stop, const NamedParameters& np)
  {
    const auto search = [&](auto&& visitor) {
      if constexpr(std::is_same_v<Sources, std::vector<Source_point>>)
        m_search.run(std::move(sources), stop, visitor);
      else
        m_search.run_from(std::move(sources), stop, visitor);
    };
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      auto visitor = parameters::get_parameter(np, internal_np::visitor);
      search(Vertex_visitor(std::ref(visitor).get(), m_translation));
    }
    else
    {
      Geodesic_visitor_base visitor; // as in the compiled searches
      search(visitor);
    }
  }

  // Writes `value(v, node)` for each vertex of the mesh and its node. If a part of the mesh was
  // searched, vertices outside the part have the null node.
  template <typename VertexMap, typename F>
  void put_for_all(VertexMap map, const F& value) const
  {
    for(const auto v : vertices(whole(m_translation.mesh())))
    {
      bool has_node = true;
      if constexpr(is_part<Triangle_mesh>)
        has_node = m_translation.mesh().number(v) != null_index;
      put(map, v, value(v, has_node ? m_translation.node(v) : null_index));
    }
  }

  const Translation& m_translation;
  VertexPointMap m_point_map;
  Surface_search m_search;
};

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
    if constexpr(is_defined<Cost_graphs<NamedParameters>>)
      if(!Cost_graphs<NamedParameters>::is_in_limit(triangulation, np))
        return false;
  return triangulation.face_without_shape() == null_index;
}

// Reads a mesh, builds the graph that the named parameters select, and calls `f` with a search of
// it, for a single run between `Points`, the types of sources and targets. Returns false if a part
// of a mesh is refused; reading the whole mesh then diagnoses the error.
template <typename... Points, typename TriangleMesh, typename NamedParameters, typename F>
bool search_once(const TriangleMesh& tmesh, const NamedParameters& np, const bool finds_path, F f)
{
  const auto search_graph = [&](const auto& graph) {
    Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
    if(finds_path ||
       is_any_given<NamedParameters, internal_np::visitor_t, internal_np::geodesic_predecessor_t>)
      translation.list_vertices();
    auto point_map = vertex_point_map(tmesh, np);
    Mesh_search<std::decay_t<decltype(graph)>, Adaptive_bucket_queue, decltype(translation),
                decltype(point_map)>
        search(graph, translation, std::move(point_map));
    f(search);
  };
  Intrinsic_triangulation triangulation;
  Triangulation_builder<TriangleMesh, NamedParameters> builder(triangulation, tmesh, np);
  if constexpr(needs_edges_only<TriangleMesh, NamedParameters, Points...>())
    if(builder.try_to_build_edges())
    {
      search_graph(Edge_graph(std::move(triangulation), np));
      return true;
    }
  if constexpr(!is_part<TriangleMesh>)
    builder.build();
  else if(!builder.try_to_build() || !is_accepted_by_graphs(triangulation, np))
    return false;
  try
  {
    with_graph_on<Lazy_discrete_geodesic_graph>(std::move(triangulation), np, search_graph);
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
         is_hashable<typename Graph_traits::halfedge_descriptor> && !has_costs<NamedParameters> &&
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

public:
  Part_to_read(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_np(np),
      m_number_of_vertices(num_vertices(tmesh)),
      m_maximum_distance(maximum_distance(np)),
      m_positions(tmesh, np)
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
         m_places.push_back(m_positions.place(target));
       }))
      return false;
    m_detour.target = m_places.back().position;
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
      m_places.push_back(m_positions.place(sources));
    else
      for(const auto& source : sources)
        m_places.push_back(m_positions.place(source));
    for(const auto& place : m_places)
      m_detour.starts.push_back({place.position, 0});
  }

  // The budget is smaller for searches along edges, which are faster, and for many sources, which
  // take longer: work on a part is lost if the part becomes too large.
  Growth growth_up_to(const double limit, const std::size_t number_of_parts)
  {
    m_detour.limit = margin * limit;
    const std::size_t divisor = number_of_parts * (needs_faces<NamedParameters> ? 1 : 3);
    Growth result(m_mesh, m_positions, m_detour,
                  m_number_of_vertices / (divisor * (1 + m_detour.starts.size() / 16)));
    for(const auto& place : m_places)
      result.start_at(place);
    return result;
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  const std::size_t m_number_of_vertices;
  const double m_maximum_distance;
  std::vector<typename Positions::Place> m_places; // the sources, and the target
  Positions m_positions;
  Detour m_detour;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
