// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H
#define CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_types.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Paths/Landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Point_pairs.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Workspaces.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_matrices.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Workspaces that are kept cost a short list nothing: to make one takes time in proportion to the
// size of the graph.
template <typename Graph>
using Pair_workspaces = Workspaces<Surface_search<Graph>>;

/*
 * What a thread searches with. A group of pairs is a row of a distance matrix, with columns of its
 * own. Results are stored as they are found, so that no rows are kept.
 */
template <typename Graph, typename Find, typename Result>
struct Group_search
{
  struct Input
  {
    const Graph& graph;
    Pair_workspaces<Graph>& workspaces;
    const Pairs_by_start& pairs;
    double maximum_distance;
    const Find& find;
    std::vector<Result>& results; // threads write to different elements
  };

  struct Rows
  {
    struct Block
    {
    };
    void collect(Block& /* block */, std::size_t /* row */, bool /* is_found */) {}
    void add(std::size_t /* number */, Block& /* block */) {}
  };

  explicit Group_search(const Input& of_all) : input(of_all), search(of_all.workspaces.borrow()) {}

  bool find(const std::size_t group)
  {
    input.pairs.find(*search, group, input.maximum_distance, input.find, input.results);
    return true;
  }

  const Input& input;
  typename Pair_workspaces<Graph>::Borrowed search;
};

// Returns `find(search, end)` for all pairs, in their order; nothing if the visitor stopped the
// computation. Threads, visitor and limit are those of the named parameters.
template <typename Graph, typename NamedParameters, typename Find>
auto find_pairs(const Graph& graph,
                Pair_workspaces<Graph>& workspaces,
                const std::vector<Point_pair>& pairs,
                const NamedParameters& np,
                const Find& find)
{
  using Result = decltype(find(std::declval<const Surface_search<Graph>&>(), pairs[0].first));
  using Search = Group_search<Graph, Find, Result>;
  const Pairs_by_start groups(graph, pairs);
  std::optional<std::vector<Result>> results(std::in_place, pairs.size());
  std::vector<std::size_t> order(groups.number_of_groups());
  std::iota(order.begin(), order.end(), std::size_t(0));
  typename Search::Rows rows;
  if(!compute_rows<Search>(
         {graph, workspaces, groups, checked_maximum_distance(np), find, *results},
         Distance_matrix_plan(std::move(order), 0), rows, np))
    results.reset();
  return results;
}

// Whether `T` is a pair of points on the surface of a mesh.
template <typename TriangleMesh, typename T>
constexpr bool is_pair_of_points = false;
template <typename TriangleMesh, typename T, typename U>
constexpr bool is_pair_of_points<TriangleMesh, std::pair<T, U>> =
    is_surface_point<TriangleMesh, T>&& is_surface_point<TriangleMesh, U>;

// Converts pairs of points of a mesh.
template <typename Translation, typename Pairs>
std::vector<Point_pair> point_pairs(const Translation& translation, const Pairs& pairs)
{
  std::vector<Point_pair> result;
  for(const auto& pair : pairs)
    result.push_back(name_in_message([&] { return name_in_list("pair", result.size()); },
                                     [&]() -> Point_pair {
                                       return {intrinsic_point(translation, pair.first, "source"),
                                               intrinsic_point(translation, pair.second, "target")};
                                     }));
  return result;
}

/*
 * Answers lists of pairs of points of a mesh. Results have the order of the pairs; there are none
 * if the visitor stopped the computation.
 */
template <typename Graph, typename Translation>
class Mesh_pairs
{
public:
  // Both are referred to, not copied.
  Mesh_pairs(const Graph& graph, const Translation& translation)
    : m_graph(graph), m_translation(translation), m_workspaces(graph)
  {
  }

  // Must be called when all weights of the graph have been exchanged.
  void clear() { m_workspaces.clear(); }

  // Landmarks are referred to, not copied.
  template <typename Landmarks>
  void use_landmarks(const Landmarks& landmarks)
  {
    m_workspaces.set_up([&landmarks](auto& search) { search.use_landmarks(landmarks); });
  }

  template <typename Pairs, typename NamedParameters>
  std::vector<double> distances(const Pairs& pairs, const NamedParameters& np) const
  {
    return find(pairs, np,
                [](const auto& search, const Intrinsic_point& p) { return search.distance(p); });
  }

  template <typename Pairs, typename NamedParameters>
  auto distance_intervals(const Pairs& pairs, const NamedParameters& np) const
  {
    return find(pairs, np, [&](const auto& search, const Intrinsic_point& p) {
      return distance_interval(search, p, maximum_distance(np));
    });
  }

  template <typename Pairs, typename NamedParameters>
  std::vector<Path> paths(const Pairs& pairs, const NamedParameters& np) const
  {
    return find<internal_np::straighten_t>(
        pairs, np, [&](const auto& search, const Intrinsic_point& end) {
          Path path = search.find_path(end);
          straighten_if_wanted(m_graph.triangulation(), np, path);
          return from_source_to_target(m_graph, std::move(path));
        });
  }

private:
  template <typename... Read, typename Pairs, typename NamedParameters, typename Find>
  auto find(const Pairs& pairs, const NamedParameters& np, const Find& find) const
  {
    static_assert(!ignores_any<NamedParameters, internal_np::maximum_distance_t,
                               internal_np::visitor_t, Read...>,
                  "lists of pairs read maximum_distance, concurrency_tag and visitor; paths also "
                  "straighten");
    auto found = find_pairs(m_graph, m_workspaces, point_pairs(m_translation, pairs), np, find);
    return found ? *std::move(found) : typename decltype(found)::value_type();
  }

  const Graph& m_graph;
  const Translation& m_translation;
  mutable Pair_workspaces<Graph> m_workspaces;
};

// Writes the distances of pairs, unless the visitor stopped the computation.
template <typename Graph, typename OutputIterator, typename NamedParameters>
bool write_pair_distances(const Graph& graph,
                          const std::vector<Point_pair>& pairs,
                          OutputIterator distances,
                          const NamedParameters& np)
{
  const auto find = [](const Surface_search<Graph>& search, const Intrinsic_point& p) {
    return search.distance(p);
  };
  Pair_workspaces<Graph> workspaces(graph);
  const auto found = find_pairs(graph, workspaces, pairs, np, find);
  if(found)
    std::copy(found->begin(), found->end(), distances);
  return found.has_value();
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * computes approximate geodesic distances between pairs of points.
 *
 * Pairs with the same source share a search, which ends when the distances of their targets are
 * final. So it is best if there are fewer different sources than targets.
 *
 * The distance of a pair is bitwise identical to that of a search from its source with its target
 * as the only target, by `Approximate_geodesics::Surface_search::run()`, except for the cases in
 * section \ref AG_same_bits. It depends neither on other pairs nor on the number of threads.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam PairRange a model of `ConstRange` with a `std::pair` as value type, of two points of type
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, or `Approximate_geodesics::Surface_point`
 * \tparam OutputIterator a model of `OutputIterator` that takes values of type `double`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed. Instead, a model of `SurfaceGraph` can be
 *        given, with pairs of `Approximate_geodesics::Intrinsic_point`s.
 * \param pairs the sources and the targets; duplicates are allowed
 * \param distances receives one distance per pair, in the order of the pairs and in the unit of the
 *        mesh: from the source to the target if costs depend on the direction, and infinity if
 *        there is no path
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
 * `maximum_distance`, `concurrency_tag`, and `visitor`, as for
 * `approximate_geodesic_distance_matrix()`, where a row is a source; and, with a mesh, the
 * parameters of meshes and graphs that this function reads, except for `direction_to_source`
 *
 * \return whether distances were written: if the visitor stopped the computation, none is.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does; the
 *         message gives the position of an invalid pair. Nothing is written then.
 *
 * The run time is that of a search per different source, and of building the graph, which is that
 * of `approximate_geodesic_distance_matrix()`. Each thread needs a workspace of 40 bytes per node.
 *
 * \sa `approximate_geodesic_distance_matrix()`
 */
template <typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
bool approximate_geodesic_pair_distances(const TriangleMesh& tmesh,
                                         const PairRange& pairs,
                                         OutputIterator distances,
                                         const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  if constexpr(AG::internal::is_surface_graph<TriangleMesh>)
  {
    static_assert(!AG::internal::ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                             internal_np::visitor_t>,
                  "approximate_geodesic_pair_distances() with a graph reads maximum_distance, "
                  "concurrency_tag and visitor; pass the others to the graph");
    return AG::internal::write_pair_distances(tmesh, {pairs.begin(), pairs.end()}, distances, np);
  }
  else
  {
    using Pair = AG::internal::Element_of_range<PairRange>;
    constexpr bool are_pairs = AG::internal::is_pair_of_points<TriangleMesh, Pair>;
    static_assert(are_pairs, "pairs: a range of std::pair, of two vertex descriptors, "
                             "Face_locations or Surface_points");
    static_assert(!AG::internal::query_ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                                   internal_np::visitor_t>,
                  "approximate_geodesic_pair_distances() does not read one of these named "
                  "parameters: its documentation lists the supported ones");
    if constexpr(are_pairs)
      return AG::internal::with_graph<AG::Discrete_geodesic_graph>(
          tmesh, np,
          [&](const auto& graph) {
            const AG::Mesh_translation translation(tmesh, AG::internal::vertex_index_map(tmesh, np),
                                                   graph.triangulation());
            return AG::internal::write_pair_distances(
                graph, AG::internal::point_pairs(translation, pairs), distances, np);
          },
          Sequential_tag()); // pairs are parallel, so that exact searches need not be
    else
      return false;
  }
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H
