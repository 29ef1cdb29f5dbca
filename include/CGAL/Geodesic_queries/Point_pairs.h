// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_POINT_PAIRS_H
#define CGAL_GEODESIC_QUERIES_POINT_PAIRS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Paths/internal/tree_paths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/// \ingroup PkgGeodesicQueriesPairs
/// The source and the target of a path.
using Point_pair = std::pair<Intrinsic_point, Intrinsic_point>;

namespace internal {

/*
 * Pairs of points, grouped by the point where a search starts: the source, or the target if
 * distances are those to the sources of a search.
 */
class Pairs_by_start
{
public:
  // The pairs are referred to, not copied.
  template <typename SurfaceGraph>
  Pairs_by_start(const SurfaceGraph& graph, const std::vector<Point_pair>& pairs)
    : m_pairs(pairs), m_starts_at_target(leads_to_sources(graph)), m_order(pairs.size())
  {
    const Intrinsic_triangulation& t = graph.triangulation();
    for(std::size_t i = 0; i < pairs.size(); ++i)
      if(!pairs[i].first.is_valid(t) || !pairs[i].second.is_valid(t))
        reject(name_in_list("pair", i) + ": the " +
               (pairs[i].first.is_valid(t) ? "target" : "source") +
               " is not a point of the triangulated surface");
    // by vertices first, so that consecutive searches start from nearby points
    const auto place = [&](const std::size_t i) {
      const Intrinsic_point& p = start(i);
      return p.is_vertex() ? std::make_tuple(p.vertex, Intrinsic_triangulation::null_index, 0., 0.)
                           : std::make_tuple(t.source(p.halfedge), p.halfedge, p.t, p.s);
    };
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::sort(m_order.begin(), m_order.end(), [&](const std::size_t i, const std::size_t j) {
      return std::make_pair(place(i), i) < std::make_pair(place(j), j);
    });
    for(std::size_t i = 0; i < m_order.size(); ++i)
      if(i == 0 || place(m_order[i - 1]) != place(m_order[i]))
        m_first.push_back(i);
    m_first.push_back(m_order.size());
  }

  std::size_t number_of_groups() const { return m_first.size() - 1; }

  // Searches from the start of a group until the distances of all its ends are final, and sets
  // `results[i]` to `find(search, end)` for each of its pairs. Landmarks guide a search to each
  // end.
  template <typename SurfaceSearch, typename Find, typename Result>
  void find(SurfaceSearch& search,
            const std::size_t group,
            const double maximum_distance,
            const Find& find,
            std::vector<Result>& results) const
  {
    const std::size_t first = m_first[group], beyond = m_first[group + 1];
    const Intrinsic_point& start = this->start(m_order[first]);
    bool is_guided = false;
    if constexpr(can_be_guided<SurfaceSearch>)
      is_guided = search.guides_to_each_of(beyond - first);
    if(!is_guided)
    {
      typename SurfaceSearch::Stop_rule stop{maximum_distance};
      for(std::size_t i = first; i < beyond; ++i)
        stop.targets.push_back(end(m_order[i]));
      search.run({{start}}, stop);
    }
    for(std::size_t i = first; i < beyond; ++i)
    {
      if constexpr(can_be_guided<SurfaceSearch>)
        if(is_guided)
          search.run_to(end(m_order[i]), {{start}}, {}, maximum_distance);
      results[m_order[i]] = find(search, end(m_order[i]));
    }
  }

  // Does so for all groups.
  template <typename SurfaceSearch, typename Find>
  auto find_all(SurfaceSearch& search, const double maximum_distance, const Find& find) const
  {
    std::vector<decltype(find(search, m_pairs[0].first))> results(m_pairs.size());
    for(std::size_t group = 0; group < number_of_groups(); ++group)
      this->find(search, group, maximum_distance, find, results);
    return results;
  }

private:
  // Whether this is a `Guided_search`.
  template <typename SurfaceSearch>
  static constexpr bool can_be_guided =
      is_valid<const SurfaceSearch&>([](auto& search) -> decltype(search.uses_landmarks()) {});

  const Intrinsic_point& start(const std::size_t pair) const
  {
    return m_starts_at_target ? m_pairs[pair].second : m_pairs[pair].first;
  }

  const Intrinsic_point& end(const std::size_t pair) const
  {
    return m_starts_at_target ? m_pairs[pair].first : m_pairs[pair].second;
  }

  const std::vector<Point_pair>& m_pairs;
  bool m_starts_at_target;
  std::vector<std::size_t> m_order; // pairs, group by group
  std::vector<std::size_t> m_first; // of each group, and one beyond
};

// Returns an interval that contains the distance of two points on the surface, from the ends of one
// for the length of the shortest path in the graph.
template <typename SurfaceGraph>
std::pair<double, double> interval_on_surface(const SurfaceGraph& graph,
                                              const Intrinsic_point& source,
                                              const Intrinsic_point& target,
                                              const double lower,
                                              const double upper)
{
  const double epsilon = error_bound(graph);
  const double costs = cost_to_corner(graph, source) + cost_to_corner(graph, target);
  const double rounding = epsilon > 0 ? 2.4e-7 : rounding_of_distances; // stored arcs are `float`
  return {smallest_distance(lower, epsilon, costs) * (1 - rounding), upper * (1 + rounding)};
}

// Returns an interval that contains the distance of a point from the source of a search.
template <typename SurfaceSearch>
std::pair<double, double> distance_interval(const SurfaceSearch& search,
                                            const Intrinsic_point& point,
                                            const double maximum_distance)
{
  const double distance = search.distance(point);
  return interval_on_surface(search.graph(), search.sources().front().point, point,
                             (std::min)(distance, maximum_distance), distance);
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * returns the distance from the source to the target of each pair, infinity if there is no path.
 *
 * A search from the source of a pair ends at its target, or the other way around if distances are
 * those to the sources of a search. One search serves all pairs with the same start. If landmarks
 * guide it, each pair has its own, unless distances are exact and there are more than eight such
 * pairs. So results do not depend on other pairs.
 *
 * \tparam SurfaceSearch `Surface_search` or `Guided_search`
 *
 * \param search a workspace, whose last run is lost
 * \param pairs the pairs; results have their order
 * \param maximum_distance points farther than this, in the unit of the mesh, are not reached
 *
 * \throws std::invalid_argument if a point is not a point of the surface.
 *
 * \sa `approximate_geodesic_pair_distances()`, which does the same by several threads
 */
template <typename SurfaceSearch>
std::vector<double>
pair_distances(SurfaceSearch& search,
               const std::vector<Point_pair>& pairs,
               const double maximum_distance = std::numeric_limits<double>::infinity())
{
  return internal::Pairs_by_start(search.graph(), pairs)
      .find_all(search, maximum_distance,
                [](const SurfaceSearch& s, const Intrinsic_point& p) { return s.distance(p); });
}

/// \ingroup PkgGeodesicQueriesPairs
/// does the same as `pair_distances()`, and returns intervals that contain the distances on the
/// surface. Their margins are those of `distance_intervals()`, and a relative 2.4e-7 if the error
/// bound is not `0`, as arcs may be stored in single precision. Without an error bound, they begin
/// with `0`.
template <typename SurfaceSearch>
std::vector<std::pair<double, double>>
pair_intervals(SurfaceSearch& search,
               const std::vector<Point_pair>& pairs,
               const double maximum_distance = std::numeric_limits<double>::infinity())
{
  return internal::Pairs_by_start(search.graph(), pairs)
      .find_all(search, maximum_distance, [&](const SurfaceSearch& s, const Intrinsic_point& p) {
        return internal::distance_interval(s, p, maximum_distance);
      });
}

/// \ingroup PkgGeodesicQueriesPairs
/// does the same as `pair_distances()`, and returns shortest paths from sources to targets; a path
/// has no points if there is none.
template <typename SurfaceSearch>
std::vector<Path>
pair_paths(SurfaceSearch& search,
           const std::vector<Point_pair>& pairs,
           const double maximum_distance = std::numeric_limits<double>::infinity())
{
  return internal::Pairs_by_start(search.graph(), pairs)
      .find_all(search, maximum_distance, [](const SurfaceSearch& s, const Intrinsic_point& p) {
        return internal::from_source_to_target(s.graph(), s.find_path(p));
      });
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_POINT_PAIRS_H
