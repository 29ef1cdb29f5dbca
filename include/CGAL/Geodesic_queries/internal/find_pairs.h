// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_FIND_PAIRS_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_FIND_PAIRS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/Geodesic_queries/internal/Workspaces.h>
#include <CGAL/Geodesic_queries/internal/distance_matrix.h>

#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What a thread searches with. A group of pairs is a row of a distance matrix, with columns of its
 * own. Results are stored as they are found, so that no rows are kept.
 */
template <typename SurfaceSearch, typename Find, typename Result>
struct Group_search
{
  struct Input
  {
    const typename SurfaceSearch::Graph& graph;
    Workspaces<SurfaceSearch>& workspaces;
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
  typename Workspaces<SurfaceSearch>::Borrowed search;
};

// Returns `find(search, end)` for all pairs, in their order; nothing if the visitor stopped the
// computation. Threads, visitor and limit are those of the named parameters.
template <typename SurfaceSearch, typename NamedParameters, typename Find>
auto find_pairs(const typename SurfaceSearch::Graph& graph,
                Workspaces<SurfaceSearch>& workspaces,
                const std::vector<Point_pair>& pairs,
                const NamedParameters& np,
                const Find& find)
{
  using Result = decltype(find(std::declval<const SurfaceSearch&>(), pairs[0].first));
  using Search = Group_search<SurfaceSearch, Find, Result>;
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_FIND_PAIRS_H
