// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_POINT_PAIRS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_POINT_PAIRS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/Exact_landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
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
  // end: as they may change its distance, this must not depend on the other ones.
  template <typename SurfaceSearch, typename Find, typename Result>
  void find(SurfaceSearch& search,
            const std::size_t group,
            const double maximum_distance,
            const Find& find,
            std::vector<Result>& results) const
  {
    const Intrinsic_point& start = this->start(m_order[m_first[group]]);
    const bool is_guided = has_guided_runs(search, m_first[group + 1] - m_first[group]);
    if(!is_guided)
    {
      typename SurfaceSearch::Stop_rule stop{maximum_distance};
      for(std::size_t i = m_first[group]; i < m_first[group + 1]; ++i)
        stop.targets.push_back(end(m_order[i]));
      search.run({{start}}, stop);
    }
    for(std::size_t i = m_first[group]; i < m_first[group + 1]; ++i)
    {
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
  // Whether pairs with so many ends are found by a guided run to each of them. Exact distances are
  // the same, to the last bit, and one run to all ends takes as long as about ten that are guided.
  template <typename SurfaceSearch>
  static bool has_guided_runs(const SurfaceSearch& search, const std::size_t number_of_ends)
  {
    constexpr std::size_t most_of_exact = 8;
    return search.uses_landmarks() && (number_of_ends <= most_of_exact ||
                                       !can_stay_in_corridor<typename SurfaceSearch::Graph>);
  }

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

// Returns a path that a search has found as one from the source to the target of a pair.
template <typename SurfaceGraph>
Path from_source_to_target(const SurfaceGraph& graph, Path path)
{
  if(!leads_to_sources(graph))
    std::reverse(path.points.begin(), path.points.end());
  return path;
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_POINT_PAIRS_H
