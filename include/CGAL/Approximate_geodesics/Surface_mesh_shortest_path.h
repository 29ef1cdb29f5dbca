// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_locations.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h> // for users of the class

#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {

// Reads changes of costs in terms of a mesh. It is defined in the package of costs.
template <typename Translation>
class Change_reader;
} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * Shortest paths on a triangle mesh, from any number of sources: exact ones, or those of another
 * graph.
 *
 * The graph is built once, by the constructor; runs from other sources only search it. Names and
 * results of the member functions are those of the exact class `CGAL::Surface_mesh_shortest_path`,
 * so a program exchanges the header and the type, and its distances and paths are still exact.
 *
 * Other graphs trade exactness for speed, or have costs. Their distances and paths are never
 * shorter than the exact ones. For `Discrete_geodesic_graph`, the error is at most `epsilon`, and
 * also for `Steiner_graph`, which supports faces with weights: there, "length" and "distance" mean
 * cost. `Edge_graph` is the fastest, and has no error bound: it has to be named.
 *
 * In a `Directional_graph`, where costs depend on the direction, distances are those from the
 * sources, or to the sources if the graph was constructed with `direction_to_source(true)` or is
 * `reversed()`. Paths are reported from the query point to the source, which is the order of travel
 * in the latter case only.
 *
 * As in the exact class, sources can be added and removed at any time; the next query, or
 * `build_sequence_tree()`, runs the search.
 *
 * The class is not thread-safe. Several threads can share a `graph()`, each with its own
 * `Surface_search`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal vertex
 *         point map
 * \tparam SurfaceGraph a model of `SurfaceGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 *
 * \sa `approximate_geodesic_distances()`, `approximate_geodesic_path()`
 */
template <typename TriangleMesh,
          typename SurfaceGraph = Saddle_vertex_graph,
          typename PriorityQueue = Adaptive_bucket_queue>
class Surface_mesh_shortest_path : public Surface_locations<TriangleMesh>
{
  using Locations = Surface_locations<TriangleMesh>;

  struct Listed_source
  {
    typename Locations::Face_location location;
    Source_point source;                         // one of its points if it is of another kind
    std::shared_ptr<const void> other = nullptr; // what a source of another kind was read to
  };

  struct Location_of_source
  {
    const auto& operator()(const Listed_source& source) const { return source.location; }
  };

public:
  /// \name Types
  /// @{

  /// the type of the graph that is searched.
  using Graph = SurfaceGraph;

  /// the search, with its results.
  using Search = Propagation<SurfaceGraph, PriorityQueue>;

  /// \cond SKIP_IN_MANUAL
  using typename Locations::Barycentric_coordinates;
  using typename Locations::face_descriptor;
  using typename Locations::Face_location;
  using typename Locations::FT;
  using typename Locations::Point_3;
  using typename Locations::Surface_point;
  using typename Locations::Triangle_mesh;
  using typename Locations::vertex_descriptor;
  /// \endcond

#ifdef DOXYGEN_RUNNING
  /// a model of `BidirectionalIterator` with value type `Face_location`. It stays valid until its
  /// source is removed.
  using Source_point_iterator = unspecified_type;
#else
  using Source_point_iterator =
      boost::transform_iterator<Location_of_source,
                                typename std::list<Listed_source>::const_iterator>;
#endif

  /// a distance, and the corresponding source.
  using Shortest_path_result = std::pair<FT, Source_point_iterator>;

  /// @}

  /// \name Creation
  /// @{

  /*!
   * builds the graph of `tmesh`.
   *
   * \param tmesh the triangle mesh
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the
   *           constructor of `Intrinsic_triangulation` and those of the constructor of the graph:
   *           `epsilon` and `concurrency_tag` for most graphs, those of the placement for
   *           `Steiner_graph`
   *
   * \warning `tmesh` is referred to, and must neither be changed nor destroyed during the lifetime
   * of this object.
   *
   * \throws std::invalid_argument and std::length_error as `Intrinsic_triangulation` and the graph
   * do.
   */
  template <typename NamedParameters = parameters::Default_named_parameters,
            typename = std::enable_if_t<!std::is_same_v<NamedParameters, Graph>>>
  explicit Surface_mesh_shortest_path(const Triangle_mesh& tmesh,
                                      const NamedParameters& np = parameters::default_values())
    : Surface_mesh_shortest_path(Graph(Intrinsic_triangulation(tmesh, np), np), tmesh, np)
  {
    static_assert(
        !internal::query_ignores_any<NamedParameters, internal_np::nb_points_per_distance_unit_t,
                                     internal_np::direction_to_source_t>,
        "the constructor does not run: maximum_distance, targets and visitor are for "
        "build_sequence_tree(), straighten is for a path, initial distances go with sources");
  }

  /*!
   * takes a graph of `tmesh` that was built before, or read from a file. `tmesh` is referred to, as
   * above. The named parameters are `vertex_point_map` and, if one was given for the triangulation,
   * `vertex_index_map`.
   *
   * \throws std::invalid_argument if `graph` belongs to a mesh of another size.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  Surface_mesh_shortest_path(const Triangle_mesh& tmesh,
                             Graph graph,
                             const NamedParameters& np = parameters::default_values())
    : Surface_mesh_shortest_path(std::move(graph), tmesh, np)
  {
    static_assert(
        !internal::ignores_any<NamedParameters>,
        "with a graph that was built before, only vertex_point_map and vertex_index_map are "
        "read; pass the others to the graph, its triangulation, or a query");
  }

  /// not copyable.
  Surface_mesh_shortest_path(const Surface_mesh_shortest_path&) = delete;
  Surface_mesh_shortest_path& operator=(const Surface_mesh_shortest_path&) = delete;

  /// @}

  /// \name Sources
  /// @{

  /*!
   * adds `v` as a source, and returns an iterator to it.
   *
   * \param v a vertex
   * \param initial_distance a distance that is added to all distances from `v`. Exact searches
   *        reject distances of more than \f$10^{10}\f$ times the longest edge.
   *
   * \throws std::invalid_argument if `v` is not a vertex of the mesh, or the initial distance is
   *         negative, infinite, or NaN.
   */
  Source_point_iterator add_source_point(const vertex_descriptor v, const FT initial_distance = 0)
  {
    const Intrinsic_point p = m_translation.intrinsic_point(v); // throws if `v` is invalid
    return add_source(p, initial_distance, this->face_location(v));
  }

  /// adds a point of the face `f` as a source.
  /// \throws std::invalid_argument if `f` is not a face of the mesh, the coordinates are invalid,
  ///         or the initial distance is invalid.
  Source_point_iterator add_source_point(const face_descriptor f,
                                         const Barycentric_coordinates& location,
                                         const FT initial_distance = 0)
  {
    return add_source(m_translation.intrinsic_point(f, location), initial_distance, {f, location});
  }

  /// adds the point at `location` as a source.
  Source_point_iterator add_source_point(const Face_location& location,
                                         const FT initial_distance = 0)
  {
    return add_source_point(location.first, location.second, initial_distance);
  }

  /// adds a point of the surface as a source.
  Source_point_iterator add_source_point(const Surface_point& point, const FT initial_distance = 0)
  {
    const Intrinsic_point p = m_translation.intrinsic_point(point); // throws if `point` is invalid
    return add_source(p, initial_distance, this->face_location(point));
  }

  /// adds a range of vertices, `Face_location`s or `Surface_point`s as sources, and returns an
  /// iterator to the first one, or `source_points_end()` if the range is empty.
  template <typename InputIterator>
  Source_point_iterator add_source_points(InputIterator first, const InputIterator beyond)
  {
    Source_point_iterator result = source_points_end();
    for(std::size_t number = 0; first != beyond; ++first, ++number)
    {
      const auto added =
          internal::name_in_message([&] { return internal::name_in_list("source", number); },
                                    [&] { return add_source_point(*first); });
      result = number == 0 ? added : result;
    }
    return result;
  }

  /*!
   * adds a curve as one source, and returns an iterator to it, which refers to its first point.
   * Distances are those from the nearest point of the curve, and paths end there. The header
   * `CGAL/Geodesic_constructions.h` has to be included.
   *
   * \throws std::invalid_argument if the curve has no points, or one of them is not a point of the
   *         surface, if two of them cannot be joined, or if the initial distance is invalid. The
   * next search throws the same if costs depend on the direction.
   */
  template <typename Curve = Source_curve<Triangle_mesh>>
  Source_point_iterator add_source_curve(const Curve& curve, const FT initial_distance = 0)
  {
    return add_other_source(curve, initial_distance);
  }

  /// adds all points of a set of faces as one source, and returns an iterator to it, which refers
  /// to a corner of one of the faces.
  template <typename Region = Source_region<Triangle_mesh>>
  Source_point_iterator add_source_region(const Region& region, const FT initial_distance = 0)
  {
    return add_other_source(region, initial_distance);
  }

  /// removes a source. \pre `it` is dereferenceable.
  void remove_source_point(const Source_point_iterator it)
  {
    m_has_changed = true;
    m_sources.erase(it.base());
  }

  /// removes all sources.
  void remove_all_source_points()
  {
    m_sources.clear();
    m_has_changed = true;
  }

  /// returns an iterator to the first source. Sources have the order of insertion.
  Source_point_iterator source_points_begin() const
  {
    return Source_point_iterator(m_sources.begin());
  }

  /// returns the past-the-end iterator.
  Source_point_iterator source_points_end() const { return Source_point_iterator(m_sources.end()); }

  /// returns the number of sources.
  std::size_t number_of_source_points() const { return m_sources.size(); }

  /// @}

  /// \name Search
  /// @{

  /// searches the graph if the sources or weights have changed since the last search. In a graph
  /// whose weights can change, the results of that are repaired if few of them have, as
  /// `Propagation::repair()` says: they are those of a new search.
  void build_sequence_tree()
  {
    if(changed_since_last_build())
      search_from_sources(parameters::default_values(),
                          [this](auto sources) { update(std::move(sources)); });
  }

  /*!
   * searches the graph with the given parameters. Subsequent queries use this run until the sources
   * change; points that it did not reach count as unreachable.
   *
   * \param np a sequence of \ref bgl_namedparameters "Named Parameters": `maximum_distance`,
   *        `targets` and `visitor`, as for `approximate_geodesic_distances()`
   */
  template <typename NamedParameters>
  void build_sequence_tree(const NamedParameters& np)
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                         internal_np::targets_t, internal_np::visitor_t>,
                  "build_sequence_tree() reads maximum_distance, targets and visitor");
    search_from_sources(np, [&](auto sources) { m_search.run(std::move(sources), np); });
  }

  /// returns whether sources or weights have changed since the last search, or there was none.
  bool changed_since_last_build() const { return m_has_changed; }

  /// removes all sources and results, and keeps the graph.
  void clear()
  {
    remove_all_source_points();
    build_sequence_tree();
  }

  /*!
   * replaces the weights of the faces, without rebuilding the graph. No other thread may use the
   * graph during this call, and `restart()` must be called for each `Surface_search` on it. The
   * header `CGAL/Geodesic_costs.h` has to be included, as for the next two functions.
   *
   * \param face_weight_map a property map as for the constructor of `Intrinsic_triangulation`
   *
   * \pre `Graph` has a member function `set_weights()`, as `Steiner_graph` does.
   *
   * \throws std::invalid_argument if a weight is negative or NaN, or if costs overflow a `double`;
   * the weights are then unchanged.
   */
  template <typename FaceWeightMap>
  void set_face_weights(const FaceWeightMap& face_weight_map)
  {
    change_costs(
        [&](const auto& reader) { m_graph.set_weights(reader.face_weights(face_weight_map)); });
    m_pair_search.reset();
    m_search.search().restart();
  }

  /*!
   * changes the weights of some faces. The next query repairs the results of the last search, in
   * time that depends on how much is different. No other thread may use the graph during this call;
   * each `Surface_search` on it can be repaired, too.
   *
   * \tparam WeightChanges a model of `ConstRange` of `std::pair`s of a `face_descriptor` and its
   *         new weight, which is as in the `face_weight_map` of the constructor of
   *         `Intrinsic_triangulation`
   *
   * \pre `Graph` has a member function `set_weights()` for changes, as `Steiner_graph` does.
   *
   * \throws std::invalid_argument if a face is not a face of the mesh, or a weight is negative,
   * NaN, or so large that costs might overflow a `double`; the weights are then unchanged.
   */
  template <typename WeightChanges>
  void set_weights(const WeightChanges& changes)
  {
    change_costs([&](const auto& reader) { m_graph.set_weights(reader.weights(changes)); });
  }

  /*!
   * lifts barriers, or puts them back, as doors are opened and closed. The next query repairs the
   * results of the last search, as after `set_weights()`.
   *
   * \tparam BarrierChanges a model of `ConstRange` of `std::pair`s of an `edge_descriptor` and
   *         whether the edge is a barrier from now on. Only edges that were barriers when the graph
   *         was built can change.
   *
   * \pre `Graph` has a member function `set_barriers()`, as `Steiner_graph` does.
   *
   * \throws std::invalid_argument if an edge was not a barrier; no barrier has changed then.
   */
  template <typename BarrierChanges>
  void set_barriers(const BarrierChanges& changes)
  {
    change_costs([&](const auto& reader) { m_graph.set_barriers(reader.barriers(changes)); });
  }

  /// @}

  /// \name Distances
  /// @{

  /*!
   * returns the distance from `v` to the nearest source, and that source.
   *
   * If `v` is not reachable, the distance is negative and the iterator is `source_points_end()`.
   *
   * \throws std::invalid_argument if `v` is not a vertex of the mesh.
   */
  Shortest_path_result shortest_distance_to_source_points(const vertex_descriptor v)
  {
    return shortest_distance(m_translation.intrinsic_point(v));
  }

  /// returns the distance from a point in the face `f` to the nearest source, and that source.
  /// \throws std::invalid_argument if `f` is not a face of the mesh, or the coordinates are
  ///         invalid.
  Shortest_path_result shortest_distance_to_source_points(const face_descriptor f,
                                                          const Barycentric_coordinates& location)
  {
    return shortest_distance(m_translation.intrinsic_point(f, location));
  }

  /// returns the distance from a point of the surface to the nearest source, and that source.
  Shortest_path_result shortest_distance_to_source_points(const Surface_point& point)
  {
    return shortest_distance(m_translation.intrinsic_point(point));
  }

  /*!
   * writes the distances of all vertices to the nearest source to a property map, infinity for
   * unreachable vertices. This is faster than a query per vertex.
   *
   * \param vertex_distance_map a writable property map with `vertex_descriptor` as key type and a
   *        value type to which `double` is convertible
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
   *        `nearest_source_map`, which receives positions in the order of `source_points_begin()`,
   *        `predecessor_map` and `signed_distances`, as for `approximate_geodesic_distances()`
   */
  template <typename VertexDistanceMap,
            typename NamedParameters = parameters::Default_named_parameters>
  void shortest_distances_to_source_points(VertexDistanceMap vertex_distance_map,
                                           const NamedParameters& np = parameters::default_values())
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::nearest_source_t,
                                         internal_np::geodesic_predecessor_t,
                                         internal_np::signed_distances_t>,
                  "distances to sources read nearest_source_map, predecessor_map and "
                  "signed_distances; "
                  "maximum_distance, targets and visitor are for build_sequence_tree()");
    constexpr bool is_map = internal::takes_distances<VertexDistanceMap, vertex_descriptor>;
    static_assert(is_map,
                  "distances are written to a property map with vertex descriptors as keys");
    build_sequence_tree();
    if constexpr(is_map)
      m_search.write_results(vertex_distance_map, np);
  }

  /// @}

  /*!
   * \name Paths
   *
   * All these functions return the length of the path, and the source at its end. If the start of
   * the path is not reachable, nothing is written, the length is negative, and the iterator is
   * `source_points_end()`. The length includes the initial distance of the source.
   *
   * Their last parameter is a sequence of \ref bgl_namedparameters "Named Parameters" with
   * `straighten`, as for `approximate_geodesic_path()`.
   */
  /// @{

  /*!
   * writes the points of a shortest path from `v` to the nearest source to `points`: vertices on
   * the path, intersections with edges, and its ends.
   *
   * \tparam OutputIterator a model of `OutputIterator` that takes values of type `Point_3`
   */
  template <typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  Shortest_path_result
  shortest_path_points_to_source_points(const vertex_descriptor v,
                                        OutputIterator points,
                                        const NamedParameters& np = parameters::default_values())
  {
    return for_each_point(m_translation.intrinsic_point(v), np,
                          [&](const Intrinsic_point& p) { *points++ = point_of(p); });
  }

  /// writes the points of a shortest path from a point in the face `f`.
  template <typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  Shortest_path_result
  shortest_path_points_to_source_points(const face_descriptor f,
                                        const Barycentric_coordinates& location,
                                        OutputIterator points,
                                        const NamedParameters& np = parameters::default_values())
  {
    return for_each_point(m_translation.intrinsic_point(f, location), np,
                          [&](const Intrinsic_point& p) { *points++ = point_of(p); });
  }

  /*!
   * reports to `visitor` the sequence of vertices, edges and faces on a shortest path from `v` to
   * the nearest source. Only the ends of the path can lie inside faces.
   *
   * \tparam Visitor a model of `SurfaceMeshShortestPathVisitor`
   */
  template <typename Visitor, typename NamedParameters = parameters::Default_named_parameters>
  Shortest_path_result
  shortest_path_sequence_to_source_points(const vertex_descriptor v,
                                          Visitor& visitor,
                                          const NamedParameters& np = parameters::default_values())
  {
    return for_each_point(m_translation.intrinsic_point(v), np,
                          [&](const Intrinsic_point& p) { m_translation.visit(p, visitor); });
  }

  /// reports to `visitor` the sequence of a shortest path from a point in the face `f`.
  template <typename Visitor, typename NamedParameters = parameters::Default_named_parameters>
  Shortest_path_result
  shortest_path_sequence_to_source_points(const face_descriptor f,
                                          const Barycentric_coordinates& location,
                                          Visitor& visitor,
                                          const NamedParameters& np = parameters::default_values())
  {
    return for_each_point(m_translation.intrinsic_point(f, location), np,
                          [&](const Intrinsic_point& p) { m_translation.visit(p, visitor); });
  }

  /*!
   * writes the points of a shortest path from a point of the surface to the nearest source, as
   * points of the surface. Two consecutive points lie in the same face.
   *
   * \tparam OutputIterator a model of `OutputIterator` that takes values of type `Surface_point`
   */
  template <typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  Shortest_path_result shortest_path_surface_points_to_source_points(
      const Surface_point& start,
      OutputIterator points,
      const NamedParameters& np = parameters::default_values())
  {
    return for_each_point(m_translation.intrinsic_point(start), np, [&](const Intrinsic_point& p) {
      *points++ = m_translation.surface_point(p);
    });
  }

  /// @}

  /*!
   * \name Single Pairs
   *
   * These functions find paths between two points of the surface, independent of the sources. The
   * search stops as soon as the distance is final. It is an A* search with straight-line distances,
   * unless faces have weights, lengths do not come from the points of the mesh, or there is a
   * visitor. It has a separate workspace of 24 additional bytes per vertex. For many pairs,
   * `Pair_queries` is faster.
   *
   * They return the length of the path; if there is no path, it is negative, and nothing is
   * written. If costs depend on the direction, the path always leads from `source` to `target`. The
   * named parameters are `straighten`, `maximum_distance` and `visitor`, as above.
   *
   * \tparam Source `vertex_descriptor`, `Face_location` or `Surface_point`
   * \tparam Target the same
   */
  /// @{

  /// returns the distance from `source` to `target`, or the length of the straightened path.
  template <typename Source,
            typename Target,
            typename NamedParameters = parameters::Default_named_parameters>
  FT shortest_distance(const Source& source,
                       const Target& target,
                       const NamedParameters& np = parameters::default_values())
  {
    if constexpr(internal::is_given<NamedParameters, internal_np::straighten_t>)
      return for_each_point_between(source, target, np, [](const Intrinsic_point&) {});
    else
    {
      const Intrinsic_point end = run_between(source, target, np);
      const auto answer = m_pair_search->search.search().nearest(end);
      return answer.is_reached() ? answer.distance : -1;
    }
  }

  /// writes the points of a shortest path from `source` to `target` to `points`, in this order.
  template <typename Source,
            typename Target,
            typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  FT shortest_path_points(const Source& source,
                          const Target& target,
                          OutputIterator points,
                          const NamedParameters& np = parameters::default_values())
  {
    return for_each_point_between(source, target, np,
                                  [&](const Intrinsic_point& p) { *points++ = point_of(p); });
  }

  /// @}

  /// \name Access
  /// @{

  /// \cond SKIP_IN_MANUAL
  using Locations::point;
  /// \endcond

  /// returns the position of a point of the surface.
  Point_3 point(const Surface_point& p) const { return point_of(m_translation.intrinsic_point(p)); }

  /// returns the graph that is searched.
  const Graph& graph() const { return m_graph; }

  /// returns the search, with its results and statistics.
  const Search& search() const { return m_search.search().search(); }

  /// enables or disables statistics for subsequent runs: see `search().statistics()`.
  void collect_statistics(const bool counts) { m_search.search().collect_statistics(counts); }

  /// returns the node of `v` in the graph.
  /// \throws std::invalid_argument if `v` is not a vertex of the mesh.
  typename Search::Node node(const vertex_descriptor v) const { return m_translation.node(v); }

  /// \cond SKIP_IN_MANUAL

  // The search in terms of the mesh, which other classes use.
  const auto& mesh_search() const { return m_search; }

  /// \endcond

  /// @}

private:
  using Node = typename Search::Node;
  using Index_function = internal::Function_property_map<vertex_descriptor, std::size_t>;
  using Point_function = typename Locations::Point_function;
  using Translation = Mesh_translation<Triangle_mesh, Index_function>;
  using Mesh_search = internal::Mesh_search<Graph, PriorityQueue, Translation, Point_function>;

  // The constructor that the others delegate to.
  template <typename NamedParameters>
  Surface_mesh_shortest_path(Graph graph, const Triangle_mesh& tmesh, const NamedParameters& np)
    : Locations(tmesh, internal::vertex_point_map(tmesh, np)),
      m_graph(std::move(graph)),
      m_translation(tmesh,
                    internal::function_property_map<vertex_descriptor, std::size_t>(
                        internal::vertex_index_map(tmesh, np)),
                    m_graph.triangulation()),
      m_search(m_graph, m_translation, this->point_map())
  {
    m_translation.check_size();
    m_translation.list_vertices();
  }

  Source_point_iterator
  add_source(const Intrinsic_point& p, const FT initial_distance, const Face_location& location)
  {
    internal::check_initial_distance(initial_distance, m_sources.size());
    m_has_changed = true;
    return Source_point_iterator(
        m_sources.insert(m_sources.end(), Listed_source{location, {p, initial_distance}}));
  }

  // Adds a source that is not a point.
  template <typename Source>
  Source_point_iterator add_other_source(const Source& source, const FT initial_distance)
  {
    static_assert(internal::is_other_source<Triangle_mesh, Source>,
                  "Source_curve, Source_region: include <CGAL/Geodesic_constructions.h>");
    using Kind = internal::Other_source<Triangle_mesh, Source>;
    auto read = std::make_shared<typename Kind::Read>(Kind::read(m_graph, m_translation, source));
    read->distance = initial_distance;
    const Intrinsic_point first = Kind::first_point(m_graph.triangulation(), *read);
    const auto result = add_source(first, initial_distance,
                                   this->face_location(m_translation.surface_point(first)));
    m_sources.back().other = std::move(read);
    m_attach = &attached<Kind>;
    return result;
  }

  using Attached_sources = std::unique_ptr<typename Mesh_search::Surface_search::Sources>;

  // Converts all sources to one kind, which points are a special case of.
  template <typename Kind>
  static Attached_sources attached(const Graph& graph, const std::list<Listed_source>& sources)
  {
    using Read = typename Kind::Read;
    std::vector<Read> all;
    for(const auto& [location, source, other] : sources)
      all.push_back(other ? *static_cast<const Read*>(other.get()) : Kind::of_point(source));
    return Kind::template attach<typename Mesh_search::Surface_search>(graph, std::move(all));
  }

  Shortest_path_result shortest_distance(const Intrinsic_point& p)
  {
    build_sequence_tree();
    const auto answer = m_search.search().nearest(p);
    if(!answer.is_reached())
      return {-1, source_points_end()};
    return {answer.distance, m_source_points[answer.source]};
  }

  // Calls `f(point)` for the points of the path from `p` to its nearest source.
  template <typename NamedParameters, typename F>
  Shortest_path_result for_each_point(const Intrinsic_point& p, const NamedParameters& np, F f)
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::straighten_t>,
                  "paths to sources read straighten; maximum_distance, targets and visitor are for "
                  "build_sequence_tree()");
    Shortest_path_result result = shortest_distance(p);
    if(result.second == source_points_end())
      return result;
    const Path path = internal::find_path(m_search, p, np);
    std::for_each(path.points.begin(), path.points.end(), f);
    result.first = path.length + result.second.base()->source.distance;
    return result;
  }

  // A workspace for single pairs, which is allocated on first use.
  struct Pair_search
  {
    Mesh_search search;
    Vertex_positions positions;
  };

  // Returns where the search ends: in a reversed graph, it runs from the target to the source.
  template <typename Source, typename Target, typename NamedParameters>
  Intrinsic_point run_between(const Source& source, const Target& target, const NamedParameters& np)
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::straighten_t,
                                         internal_np::maximum_distance_t, internal_np::visitor_t>,
                  "single pairs read straighten, maximum_distance and visitor");
    if(!m_pair_search)
      m_pair_search = std::make_unique<Pair_search>(Pair_search{
          Mesh_search(m_graph, m_translation, this->point_map()), m_search.positions()});
    const auto run = [&](const auto& from, const auto& to) {
      m_pair_search->search.run_to(from, to, m_pair_search->positions, np);
      return m_translation.intrinsic_point(to);
    };
    return internal::leads_to_sources(m_graph) ? run(target, source) : run(source, target);
  }

  // Calls `f(point)` for the points of the path. Returns its length, or -1 if there is no path.
  template <typename Source, typename Target, typename NamedParameters, typename F>
  FT for_each_point_between(const Source& source,
                            const Target& target,
                            const NamedParameters& np,
                            F f)
  {
    const Intrinsic_point end = run_between(source, target, np);
    const Path path = internal::from_source_to_target(
        m_graph, internal::find_path(m_pair_search->search, end, np));
    std::for_each(path.points.begin(), path.points.end(), f);
    return path.points.empty() ? -1 : path.length;
  }

  // Calls `search(sources)`, or searches from sources of another kind if there are any.
  template <typename NamedParameters, typename F>
  void search_from_sources(const NamedParameters& np, const F& search)
  {
    m_has_changed = true; // in case it throws
    m_source_points.clear();
    std::vector<Source_point> sources;
    for(auto it = source_points_begin(); it != source_points_end(); ++it)
    {
      sources.push_back(it.base()->source);
      m_source_points.push_back(it);
    }
    if(std::none_of(m_sources.begin(), m_sources.end(), [](const auto& s) { return s.other; }))
      search(std::move(sources));
    else
      m_search.run(m_attach(m_graph, m_sources), np);
    m_has_changed = false;
  }

  // Finds the same distances as a new search, whether or not it repairs the results of the last.
  void update(std::vector<Source_point> sources)
  {
    if constexpr(internal::has_changes<Graph>)
      m_search.search().repair(std::move(sources));
    else
    {
      Geodesic_visitor_base visitor; // as in the compiled searches
      m_search.search().run(std::move(sources), {}, visitor);
    }
  }

  // Calls `change(reader)`, where the reader translates changes in terms of the mesh.
  template <typename F>
  void change_costs(const F& change)
  {
    using Reader = internal::Change_reader<Translation>;
    static_assert(
        internal::is_defined<Reader>,
        "set_face_weights(), set_weights(), set_barriers(): include <CGAL/Geodesic_costs.h>");
    if constexpr(internal::is_defined<Reader>)
      change(Reader(m_translation, m_graph.triangulation()));
    m_has_changed = true;
  }

  Point_3 point_of(const Intrinsic_point& p) const
  {
    return m_search.point(p, parameters::default_values());
  }

  Graph m_graph;
  Translation m_translation;
  Mesh_search m_search;
  std::unique_ptr<Pair_search> m_pair_search;
  std::list<Listed_source> m_sources;
  Attached_sources (*m_attach)(const Graph&, const std::list<Listed_source>&) = nullptr;
  std::vector<Source_point_iterator> m_source_points; // of the last search
  bool m_has_changed = true;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H
