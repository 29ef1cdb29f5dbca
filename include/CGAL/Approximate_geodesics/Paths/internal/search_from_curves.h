// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_FROM_CURVES_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_FROM_CURVES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

// The member function of `Surface_search` for curves.

template <typename SurfaceGraph, typename PriorityQueue>
template <typename Visitor>
void Surface_search<SurfaceGraph, PriorityQueue>::run_from_curves(
    std::vector<Intrinsic_curve> curves, const Stop_rule& stop, Visitor&& visitor)
{
  if constexpr(!internal::has_curves<Graph>)
    internal::reject("this graph does not support curves as sources");
  else
  {
    internal::Curve_sources sources(m_graph->triangulation(), std::move(curves));
    const auto seeds = sources.seeds(*m_graph);
    check(seeds, {});
    run_and_adopt({}, {}, stop, [&](const auto&, const auto& rule, const auto&) {
      m_search.run(seeds, rule, visitor, [&] { return sources.entries(m_search, seeds); });
    });
    m_curves = std::move(sources);
  }
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SEARCH_FROM_CURVES_H
