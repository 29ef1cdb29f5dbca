// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_PAIR_QUERIES_H
#define CGAL_GEODESIC_QUERIES_PAIR_QUERIES_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/Geodesic_queries/internal/compiled_pairs.h>
#include <CGAL/Geodesic_queries/internal/find_pairs.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * Answers many pairs of points of a mesh: lists, and single pairs that landmarks make fast. It
 * searches the graph of a `Surface_mesh_shortest_path`, independent of its sources.
 *
 * If costs depend on the direction, paths always lead from the source to the target of a pair.
 *
 * When weights or barriers of the graph change, pairs have the new distances, without landmarks
 * until `prepare()` is called again. No other thread may use the object meanwhile.
 *
 * Member functions that are `const` may be called by several threads at the same time. Each needs a
 * workspace of 40 bytes per node, which is kept for further calls.
 *
 * \tparam TriangleMesh, SurfaceGraph, PriorityQueue those of the `Surface_mesh_shortest_path`
 */
template <typename TriangleMesh,
          typename SurfaceGraph = Saddle_vertex_graph,
          typename PriorityQueue = Adaptive_bucket_queue>
class Pair_queries
{
public:
  /// what the pairs are those of.
  using Shortest_paths = Surface_mesh_shortest_path<TriangleMesh, SurfaceGraph, PriorityQueue>;

  /// the number type of distances.
  using FT = typename Shortest_paths::FT;

  /// the type of the mesh's points.
  using Point_3 = typename Shortest_paths::Point_3;

  /// \name Creation
  /// @{

  /// refers to `paths`, whose graph is searched. Nothing is allocated.
  explicit Pair_queries(const Shortest_paths& paths)
    : m_mesh(paths.mesh_search()), m_workspaces(paths.graph())
  {
  }

  /// pairs of a temporary object would outlive it.
  explicit Pair_queries(const Shortest_paths&& paths) = delete;

  /*!
   * makes landmarks, see `Landmarks`, which guide searches to single targets from now on. After
   * weights or barriers have changed, they are not used any more, until this is called again. With
   * weights, pairs then take a small part of the time, and so do exact pairs, for which it makes
   * `Exact_landmarks`. In a list, each pair is then a search of its own: for very many targets of
   * each source, do not prepare. Exact pairs share a search if there are more than eight with the
   * same source, as their distances are the same.
   *
   * \pre `SurfaceGraph` has a member function `asymmetry()`, as `Steiner_graph` does, or is
   * `Saddle_vertex_graph`.
   *
   * \throws std::invalid_argument if `number_of_landmarks` is `0`.
   *
   * Run time and memory are those of the constructor of `Landmarks`, or of `Exact_landmarks`.
   */
  void prepare(const std::size_t number_of_landmarks = Landmarks<SurfaceGraph>::DEFAULT_NUMBER)
  {
    auto landmarks =
        std::make_unique<const typename Search::Landmarks>(graph(), number_of_landmarks);
    m_workspaces.set_up([l = landmarks.get()](Search& search) { search.use_landmarks(*l); });
    m_landmarks = std::move(landmarks);
  }

  /// @}

  /*!
   * \name Lists of Pairs
   *
   * One search finds all pairs with the same source, as in `approximate_geodesic_pair_distances()`,
   * unless `prepare()` was called. Results have the order of the pairs; there are none if the
   * visitor stopped the computation. The named parameters are `maximum_distance`,
   * `concurrency_tag`, and `visitor`, a `DistanceMatrixVisitor`.
   *
   * \tparam PairRange a model of `ConstRange` of `std::pair`s of points of type
   *         `vertex_descriptor`, `Face_location` or `Surface_point`
   */
  /// @{

  /// returns the distance from the source to the target of each pair, infinity if there is no path.
  template <typename PairRange, typename NamedParameters = parameters::Default_named_parameters>
  std::vector<double> distances(const PairRange& pairs,
                                const NamedParameters& np = parameters::default_values()) const
  {
    return find_all(pairs, np, [](const Search& search, const Intrinsic_point& end) {
      return search.distance(end);
    });
  }

  /// returns an interval that contains the distance on the surface, for each pair. Its margins are
  /// those of `distance_intervals()`, and a relative 2.4e-7 if the error bound is not `0`, as arcs
  /// may be stored in single precision. Without an error bound, it begins with `0`.
  template <typename PairRange, typename NamedParameters = parameters::Default_named_parameters>
  std::vector<std::pair<double, double>>
  distance_intervals(const PairRange& pairs,
                     const NamedParameters& np = parameters::default_values()) const
  {
    return find_all(pairs, np, [&](const Search& search, const Intrinsic_point& end) {
      return internal::distance_interval(search, end, internal::maximum_distance(np));
    });
  }

  /// returns the points of a shortest path from the source to the target of each pair, none if
  /// there is no path. Another named parameter is `straighten`.
  template <typename PairRange, typename NamedParameters = parameters::Default_named_parameters>
  std::vector<std::vector<Point_3>>
  paths(const PairRange& pairs, const NamedParameters& np = parameters::default_values()) const
  {
    std::vector<std::vector<Point_3>> result;
    for(const Path& path : find_all<internal_np::straighten_t>(pairs, np, path_finder(np)))
    {
      std::vector<Point_3>& points = result.emplace_back();
      for(const Intrinsic_point& p : path.points)
        points.push_back(point_of(p));
    }
    return result;
  }

  /// @}

  /*!
   * \name Single Pairs
   *
   * These functions do the same as those of `Surface_mesh_shortest_path`, guided by landmarks once
   * `prepare()` was called. They return the length of the path; if there is no path, it is
   * negative, and nothing is written. The named parameters are `straighten` and `maximum_distance`.
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
                       const NamedParameters& np = parameters::default_values()) const
  {
    if constexpr(internal::is_given<NamedParameters, internal_np::straighten_t>)
      return length_of(find_path(source, target, np));
    else
      return find_one(source, target, np, [](const Search& search, const Intrinsic_point& end) {
        const auto answer = search.nearest(end);
        return answer.is_reached() ? answer.distance : -1;
      });
  }

  /// writes the points of a shortest path from `source` to `target` to `points`, in this order.
  template <typename Source,
            typename Target,
            typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  FT shortest_path_points(const Source& source,
                          const Target& target,
                          OutputIterator points,
                          const NamedParameters& np = parameters::default_values()) const
  {
    const Path path = find_path(source, target, np);
    for(const Intrinsic_point& p : path.points)
      *points++ = point_of(p);
    return length_of(path);
  }

  /// @}

private:
  using Mesh_search = std::decay_t<decltype(std::declval<const Shortest_paths&>().mesh_search())>;
  using Search = Guided_search<SurfaceGraph, PriorityQueue>;

  const SurfaceGraph& graph() const { return m_mesh.search().graph(); }

  template <typename... Read, typename Pairs, typename NamedParameters, typename Find>
  auto find_all(const Pairs& pairs, const NamedParameters& np, const Find& find) const
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                         internal_np::visitor_t, Read...>,
                  "lists of pairs read maximum_distance, concurrency_tag and visitor; paths also "
                  "straighten");
    auto found = internal::find_pairs(graph(), m_workspaces,
                                      internal::point_pairs(m_mesh.translation(), pairs), np, find);
    return found ? *std::move(found) : typename decltype(found)::value_type();
  }

  // Returns `find(search, end)`, where the search ends at the target, or in a reversed graph, at
  // the source.
  template <typename Source, typename Target, typename NamedParameters, typename Find>
  auto find_one(const Source& source,
                const Target& target,
                const NamedParameters& np,
                const Find& find) const
  {
    static_assert(!internal::ignores_any<NamedParameters, internal_np::straighten_t,
                                         internal_np::maximum_distance_t>,
                  "single pairs read straighten and maximum_distance");
    Intrinsic_point start = internal::intrinsic_point(m_mesh.translation(), source, "source");
    Intrinsic_point end = internal::intrinsic_point(m_mesh.translation(), target, "target");
    if(internal::leads_to_sources(graph()))
      std::swap(start, end);
    const auto search = m_workspaces.borrow();
    search->run_to(end, {{start}}, positions(), internal::maximum_distance(np));
    return find(*search, end);
  }

  template <typename Source, typename Target, typename NamedParameters>
  Path find_path(const Source& source, const Target& target, const NamedParameters& np) const
  {
    return find_one(source, target, np, path_finder(np));
  }

  // Returns a function for the path from the source to the target of a pair.
  template <typename NamedParameters>
  auto path_finder(const NamedParameters& np) const
  {
    return [this, &np](const Search& search, const Intrinsic_point& end) {
      Path path = search.find_path(end);
      internal::straighten_if_wanted(graph().triangulation(), np, path);
      return internal::from_source_to_target(graph(), std::move(path));
    };
  }

  static FT length_of(const Path& path) { return path.points.empty() ? -1 : path.length; }

  Point_3 point_of(const Intrinsic_point& p) const
  {
    return m_mesh.point(p, parameters::default_values());
  }

  // Guide single pairs without landmarks. They are read at the first one.
  const Vertex_positions& positions() const
  {
    const std::lock_guard lock(m_mutex);
    if(!m_positions)
      m_positions = m_mesh.positions();
    return *m_positions;
  }

  const Mesh_search& m_mesh;
  std::unique_ptr<const typename Search::Landmarks> m_landmarks; // if pairs are prepared
  mutable internal::Workspaces<Search> m_workspaces;
  mutable std::optional<Vertex_positions> m_positions;
  mutable std::mutex m_mutex; // of the positions
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_PAIR_QUERIES_H
