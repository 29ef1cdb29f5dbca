// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Approximate_geodesics/internal/Function_property_map.h>
#include <CGAL/Approximate_geodesics/internal/Mesh_vertices.h>
#include <CGAL/Approximate_geodesics/internal/Path.h>
#include <CGAL/Approximate_geodesics/internal/Source_list.h>
#include <CGAL/Approximate_geodesics/internal/index_maps.h>
#include <CGAL/Approximate_geodesics/internal/messages.h>
#include <CGAL/Approximate_geodesics/internal/run_parameters.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * Shortest paths on a triangle mesh, from any number of sources, as often as wanted.
 *
 * The graph is built once, by the constructor; a run from other sources only searches it. Names and
 * results of the member functions are those of the exact class
 * `CGAL::Surface_mesh_shortest_path`, so that exchanging one for the other is a matter of a type
 * definition. Paths and distances are those of the graph: never shorter than the exact ones, and
 * longer by an error that the choice of the graph determines: `Edge_graph` has no bound and
 * is the fastest, `Discrete_geodesic_graph` has one that the named parameter `epsilon` chooses, and
 * so has `Steiner_graph`, which is the graph for faces with weights: where there are weights,
 * "length" and "distance" mean costs.
 *
 * As in the exact class, sources can be added and removed at any time, and the search is run by the
 * first query after that, or by `build_sequence_tree()`.
 *
 * An object of this class is to be used by one thread at a time. Several threads can share its
 * `graph()` and search it with a `Propagation` of their own.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal vertex
 *         point map
 * \tparam GeodesicGraph a model of `GeodesicGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `approximate_geodesic_path()`
 */
template <typename TriangleMesh,
          typename GeodesicGraph = Edge_graph,
          typename PriorityQueue = Adaptive_bucket_queue>
class Surface_mesh_shortest_path
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Sources = internal::Source_list<TriangleMesh>;

public:
  /// \name Types
  /// @{

  /// the type of the mesh.
  using Triangle_mesh = TriangleMesh;

  /// the type of the graph that is searched.
  using Graph = GeodesicGraph;

  /// the search, with its results.
  using Search = Propagation<GeodesicGraph, PriorityQueue>;

  /// a vertex of the mesh.
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  /// a halfedge of the mesh.
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  /// a face of the mesh.
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// the number type of distances.
  using FT = double;

  /// the type of the mesh's points.
  using Point_3 = typename boost::property_traits<
      typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

  /// the weights of a face's vertices, in the order in which `source(halfedge(f, tmesh), tmesh)` is
  /// the first one.
  using Barycentric_coordinates = std::array<FT, 3>;

  /// a place on the surface: a face, and barycentric coordinates in it.
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;

#ifdef DOXYGEN_RUNNING
  /// a model of `BidirectionalIterator` with value type `Face_location`. It stays valid until its
  /// source is removed.
  using Source_point_iterator = unspecified_type;
#else
  using Source_point_iterator = typename Sources::Iterator;
#endif

  /// a distance, and the source that it is the distance to.
  using Shortest_path_result = std::pair<FT, Source_point_iterator>;

  /// @}

  /// \name Creation
  /// @{

  /*!
   * builds the graph of `tmesh`.
   *
   * \param tmesh the triangle mesh
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the
   *           constructor of `Intrinsic_triangulation` and those of the constructor of the graph,
   *           which it is passed to: `epsilon` and `concurrency_tag` in the case of
   *           `Discrete_geodesic_graph`, those of the placement in that of `Steiner_graph`
   *
   * \warning `tmesh` is referred to, and must neither change nor go away before this object does.
   *
   * \throws std::invalid_argument and std::length_error as `Intrinsic_triangulation` and the graph
   * do.
   */
  template <typename NamedParameters = parameters::Default_named_parameters,
            typename = std::enable_if_t<!std::is_same_v<NamedParameters, Graph>>>
  explicit Surface_mesh_shortest_path(const Triangle_mesh& tmesh,
                                      const NamedParameters& np = parameters::default_values())
    : Surface_mesh_shortest_path(tmesh, Graph(Intrinsic_triangulation(tmesh, np), np), np)
  {
  }

  /*!
   * takes a graph that was built before, or read from a file.
   *
   * \param tmesh the triangle mesh
   * \param graph a graph of `tmesh`
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
   *           `vertex_index_map`, if one was given for the triangulation of `graph`, and
   *           `vertex_point_map`
   *
   * \warning `tmesh` is referred to, and must neither change nor go away before this object does.
   *
   * \throws std::invalid_argument if `graph` is that of a mesh of another size.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  Surface_mesh_shortest_path(const Triangle_mesh& tmesh,
                             Graph graph,
                             const NamedParameters& np = parameters::default_values())
    : m_mesh(tmesh),
      m_graph(std::move(graph)),
      m_vertices(tmesh, internal::vertex_index_map(tmesh, np), m_graph.triangulation()),
      m_point_map(
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, tmesh))),
      m_search(m_graph)
  {
    check_size();
  }

  /// not copyable: sources are referred to by iterators, and the graph by the search.
  Surface_mesh_shortest_path(const Surface_mesh_shortest_path&) = delete;
  Surface_mesh_shortest_path& operator=(const Surface_mesh_shortest_path&) = delete;

  /// @}

  /// \name Sources
  /// @{

  /// adds `v` as a source, and returns an iterator to it.
  /// \throws std::invalid_argument if `v` is not a vertex of the mesh.
  Source_point_iterator add_source_point(const vertex_descriptor v)
  {
    m_vertices.node(v); // throws if there is none
    m_has_changed = true;
    return m_sources.add(v, face_location(v));
  }

  /// adds the vertices of a range as sources, and returns an iterator to the first of them, or
  /// `source_points_end()` if there is none.
  /// \tparam InputIterator a model of `InputIterator` with value type `vertex_descriptor`
  template <typename InputIterator>
  Source_point_iterator add_source_points(InputIterator first, const InputIterator beyond)
  {
    if(first == beyond)
      return source_points_end();
    const Source_point_iterator result = add_source_point(*first);
    while(++first != beyond)
      add_source_point(*first);
    return result;
  }

  /// removes a source. \pre `it` can be dereferenced.
  void remove_source_point(const Source_point_iterator it)
  {
    m_sources.remove(it);
    m_has_changed = true;
  }

  /// removes all sources.
  void remove_all_source_points()
  {
    m_sources.clear();
    m_has_changed = true;
  }

  /// returns the first of the sources, which are in the order in which they were added.
  Source_point_iterator source_points_begin() const { return m_sources.begin(); }

  /// returns the place after the last source.
  Source_point_iterator source_points_end() const { return m_sources.end(); }

  /// returns the number of sources.
  std::size_t number_of_source_points() const { return m_sources.size(); }

  /// @}

  /// \name Search
  /// @{

  /// searches the graph from the sources, if these have changed since the last time.
  void build_sequence_tree()
  {
    if(changed_since_last_build())
      build_sequence_tree(parameters::default_values());
  }

  /*!
   * searches the graph from the sources, under the given conditions.
   *
   * Queries that follow are answered from this run until the sources change; what it did not reach
   * counts as unreachable.
   *
   * \param np a sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{maximum_distance}
   *     \cgalParamDescription{the distance beyond which vertices are not reached}
   *     \cgalParamType{a number type convertible to `double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{targets}
   *     \cgalParamDescription{vertices; the run ends as soon as the distances to all of them are
   *                           certain}
   *     \cgalParamType{a model of `ConstRange` with value type `vertex_descriptor`}
   *     \cgalParamDefault{none: the run goes on to the end, as it does if the range is empty}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{an object that is told of settled vertices and of progress, and that
   *                           may end the run}
   *     \cgalParamType{a class model of `GeodesicVisitor`, or a `std::reference_wrapper` of one}
   *     \cgalParamDefault{`Geodesic_visitor_base`}
   *     \cgalParamExtra{The visitor is copied unless it is given as `std::ref(visitor)`.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   */
  template <typename NamedParameters>
  void build_sequence_tree(const NamedParameters& np)
  {
    m_has_changed = true; // should the run throw
    m_source_of_seed.clear();
    std::vector<typename Search::Seed> seeds;
    for(auto it = source_points_begin(); it != source_points_end(); ++it)
    {
      seeds.push_back({m_vertices.node(Sources::vertex(it)), 0, seeds.size()});
      m_source_of_seed.push_back(it);
    }
    const auto stop = internal::stop_rule<Search>(m_vertices, np);
    internal::run(m_search, seeds, stop, m_vertices, np);
    m_has_changed = false;
  }

  /// returns whether sources were added or removed since the last search, or there was none.
  bool changed_since_last_build() const { return m_has_changed; }

  /// removes all sources and results; the graph stays.
  void clear()
  {
    remove_all_source_points();
    build_sequence_tree();
  }

  /*!
   * exchanges the weights of the faces, without building the graph again. The next query searches
   * it anew.
   *
   * \param face_weight_map a property map as for the constructor of `Intrinsic_triangulation`
   *
   * \pre `Graph` has a member function of the same name, as `Steiner_graph` does.
   *
   * \throws std::invalid_argument if a weight is negative or not a number, or if costs do not fit a
   *         `double`; the weights are then those that they were before.
   */
  template <typename FaceWeightMap>
  void set_face_weights(const FaceWeightMap& face_weight_map)
  {
    m_graph.set_face_weights(m_mesh, face_weight_map,
                             parameters::vertex_index_map(m_vertices.index_map()));
    m_search = Search(m_graph);
    m_has_changed = true;
  }

  /// @}

  /// \name Distances and Paths
  /// @{

  /*!
   * returns the distance from `v` to the nearest source, and that source.
   *
   * If no source reaches `v`, the distance is negative and the iterator `source_points_end()`.
   *
   * \throws std::invalid_argument if `v` is not a vertex of the mesh.
   */
  Shortest_path_result shortest_distance_to_source_points(const vertex_descriptor v)
  {
    const Node node = m_vertices.node(v);
    build_sequence_tree();
    if(!m_search.is_reached(node))
      return {-1, source_points_end()};
    return {m_search.distance(node), m_source_of_seed[m_search.source(node)]};
  }

  /*!
   * writes the points of a shortest path from `v` to the nearest source to `points`, and returns
   * its length and that source. Nothing is written if no source reaches `v`. The points are those
   * of the vertices on the path, and those where it crosses edges.
   *
   * \tparam OutputIterator a model of `OutputIterator` that takes values of type `Point_3`
   */
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(const vertex_descriptor v,
                                                             OutputIterator points)
  {
    const Shortest_path_result result = shortest_distance_to_source_points(v);
    for(const Place& p : internal::find_path(m_search, m_vertices.node(v)).points)
      *points++ = point(p);
    return result;
  }

  /*!
   * tells `visitor` the sequence of vertices and edges that a shortest path from `v` to the nearest
   * source goes through, and returns its length and that source. The visitor is not called if no
   * source reaches `v`.
   *
   * \tparam Visitor a model of `SurfaceMeshShortestPathVisitor`
   */
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(const vertex_descriptor v,
                                                               Visitor& visitor)
  {
    const Shortest_path_result result = shortest_distance_to_source_points(v);
    for(const Place& p : internal::find_path(m_search, m_vertices.node(v)).points)
      if(p.is_vertex())
        visitor(m_vertices.vertex(p.vertex));
      else
        visitor(m_vertices.halfedge(p.halfedge), p.t);
    return result;
  }

  /// @}

  /// \name Places on the Surface
  /// @{

  /// returns the point of `v`.
  Point_3 point(const vertex_descriptor v) const { return get(m_point_map, v); }

  /// returns a place of `v` in one of its faces. If it has none, the face is
  /// `boost::graph_traits<Triangle_mesh>::%null_face()`.
  Face_location face_location(const vertex_descriptor v) const
  {
    Face_location result(Graph_traits::null_face(), {0, 0, 0});
    if(halfedge(v, m_mesh) == Graph_traits::null_halfedge())
      return result;
    for(const halfedge_descriptor h : halfedges_around_target(v, m_mesh))
      if(!is_border(h, m_mesh))
      {
        result.first = face(h, m_mesh);
        break;
      }
    if(result.first != Graph_traits::null_face())
    {
      halfedge_descriptor h = halfedge(result.first, m_mesh);
      for(FT& weight : result.second)
      {
        weight = source(h, m_mesh) == v ? 1 : 0;
        h = next(h, m_mesh);
      }
    }
    return result;
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the graph that is searched.
  const Graph& graph() const { return m_graph; }

  /// returns the search, with its results and figures.
  const Search& search() const { return m_search; }

  /// says whether the searches to come shall count what they do: see `search().statistics()`.
  void collect_statistics(const bool counts) { m_search.collect_statistics(counts); }

  /// returns the node of the graph that stands for `v`.
  /// \throws std::invalid_argument if `v` is not a vertex of the mesh.
  typename Search::Node node(const vertex_descriptor v) const { return m_vertices.node(v); }

  /// @}

private:
  using Node = typename Search::Node;
  using Index_function = internal::Function_property_map<vertex_descriptor, std::size_t>;

  Point_3 point(const Place& p) const
  {
    if constexpr(internal::has_crossing_arcs<Graph>)
      return m_vertices.point(p, m_point_map, typename Kernel_traits<Point_3>::Kernel());
    else
      return m_vertices.point_of_vertex(p, m_point_map);
  }

  // Counts what is there: some meshes' numbers include what was removed.
  void check_size() const
  {
    const Intrinsic_triangulation& t = m_graph.triangulation();
    const auto count = [](const auto& range) {
      return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    };
    const std::size_t v = count(vertices(m_mesh)), h = count(halfedges(m_mesh));
    if(v != t.number_of_vertices() || h != t.number_of_halfedges())
      internal::reject("the graph is that of another mesh: it has " +
                       std::to_string(t.number_of_vertices()) + " vertices and " +
                       std::to_string(t.number_of_halfedges()) + " halfedges, and the mesh has " +
                       std::to_string(v) + " and " + std::to_string(h));
  }

  const Triangle_mesh& m_mesh;
  Graph m_graph;
  const internal::Mesh_vertices<Triangle_mesh, Index_function> m_vertices;
  const internal::Function_property_map<vertex_descriptor, Point_3> m_point_map;
  Search m_search;
  Sources m_sources;
  std::vector<Source_point_iterator> m_source_of_seed; // of the last search
  bool m_has_changed = true;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_MESH_SHORTEST_PATH_H
