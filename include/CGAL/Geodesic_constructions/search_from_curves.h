// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_SEARCH_FROM_CURVES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_SEARCH_FROM_CURVES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Curve_sources.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {

template <typename SurfaceSearch>
using Curves_of = Curve_sources<typename SurfaceSearch::Search, typename SurfaceSearch::Answer>;

// Checks curves, and makes them the sources of searches of a graph.
template <typename SurfaceSearch>
std::unique_ptr<typename SurfaceSearch::Sources>
attached_curves([[maybe_unused]] const typename SurfaceSearch::Graph& graph,
                [[maybe_unused]] std::vector<Intrinsic_curve> curves)
{
  if constexpr(!has_curves<typename SurfaceSearch::Graph>)
    reject("this graph does not support curves as sources");
  else
    return std::make_unique<Curves_of<SurfaceSearch>>(graph.triangulation(), std::move(curves));
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * forgets the last run of a search, and computes distances from the nearest of some curves and sets
 * of faces, whose indices are those of the sources. Distances are those to the nearest point of a
 * curve: exact in a `Saddle_vertex_graph`, and else with the bound that the graph has for points.
 *
 * \param search a `Surface_search`
 * \param curves where to start
 * \param stop when the run may end early
 * \param visitor a model of `GeodesicVisitor` for vertices of type `SurfaceSearch::Node`
 *
 * \throws std::invalid_argument as `Surface_search::run()` does; if two consecutive points of a
 *         polyline are not in the same face; if costs depend on the direction; or if the graph does
 *         not support curves, as `SurfaceGraph` says.
 *
 * Run time is that of `Surface_search::run()`, and for each point of a polyline that of attaching a
 * few points.
 */
template <typename SurfaceSearch, typename Visitor = Geodesic_visitor_base>
void run_from_curves(SurfaceSearch& search,
                     std::vector<Intrinsic_curve> curves,
                     const typename SurfaceSearch::Stop_rule& stop = {},
                     Visitor&& visitor = Visitor())
{
  search.run_from(internal::attached_curves<SurfaceSearch>(search.graph(), std::move(curves)), stop,
                  visitor);
}

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * returns the curves that the last run of a search has started from; none if it has started from
 * points.
 */
template <typename SurfaceSearch>
const std::vector<Intrinsic_curve>& curves_of(const SurfaceSearch& search)
{
  static const std::vector<Intrinsic_curve> none;
  if constexpr(internal::has_curves<typename SurfaceSearch::Graph>)
    if(const auto* const sources =
           dynamic_cast<const internal::Curves_of<SurfaceSearch>*>(search.other_sources()))
      return sources->curves();
  return none;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_SEARCH_FROM_CURVES_H
