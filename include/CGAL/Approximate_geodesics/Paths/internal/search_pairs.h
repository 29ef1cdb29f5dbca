// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_PAIRS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_PAIRS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Point_pairs.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

// The member functions of `Surface_search` for pairs.

template <typename SurfaceGraph, typename PriorityQueue>
std::vector<double>
Surface_search<SurfaceGraph, PriorityQueue>::distances(const std::vector<Point_pair>& pairs,
                                                       const double maximum_distance)
{
  return internal::Pairs_by_start(*m_graph, pairs)
      .find_all(*this, maximum_distance,
                [](const Surface_search& search, const Intrinsic_point& p) {
                  return search.distance(p);
                });
}

template <typename SurfaceGraph, typename PriorityQueue>
std::vector<std::pair<double, double>>
Surface_search<SurfaceGraph, PriorityQueue>::distance_intervals(
    const std::vector<Point_pair>& pairs, const double maximum_distance)
{
  return internal::Pairs_by_start(*m_graph, pairs)
      .find_all(*this, maximum_distance,
                [&](const Surface_search& search, const Intrinsic_point& p) {
                  return internal::distance_interval(search, p, maximum_distance);
                });
}

template <typename SurfaceGraph, typename PriorityQueue>
std::vector<Path>
Surface_search<SurfaceGraph, PriorityQueue>::paths(const std::vector<Point_pair>& pairs,
                                                   const double maximum_distance)
{
  return internal::Pairs_by_start(*m_graph, pairs)
      .find_all(*this, maximum_distance,
                [](const Surface_search& search, const Intrinsic_point& p) {
                  return internal::from_source_to_target(search.graph(), search.find_path(p));
                });
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_PAIRS_H
