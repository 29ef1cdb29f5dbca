// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PAIR_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PAIR_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <memory>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Point-to-point searches with a separate workspace, which is allocated on first use.
 */
template <typename MeshSearch>
class Pair_search
{
public:
  // Uses the graph and the mesh of `other`. Returns -1 if there is no path.
  template <typename Source, typename Target, typename NamedParameters>
  double distance(const MeshSearch& other,
                  const Source& source,
                  const Target& target,
                  const NamedParameters& np)
  {
    if constexpr(is_given<NamedParameters, internal_np::straighten_t>)
      return for_each_point(other, source, target, np, [](const Intrinsic_point&) {});
    else
    {
      run(other, source, target, np);
      const auto& translation = other.translation();
      const auto answer = m_parts->search.search().nearest(
          leads_to_sources(other.search().graph()) ? translation.intrinsic_point(source)
                                                   : translation.intrinsic_point(target));
      return answer.is_reached() ? answer.distance : -1;
    }
  }

  // Calls `f(point)` for the points of the path. Returns its length, or -1 if there is no path.
  template <typename Source, typename Target, typename NamedParameters, typename F>
  double for_each_point(const MeshSearch& other,
                        const Source& source,
                        const Target& target,
                        const NamedParameters& np,
                        F f)
  {
    run(other, source, target, np);
    const bool is_backward = leads_to_sources(other.search().graph());
    const Path path = is_backward ? find_path(other, source, np) : find_path(other, target, np);
    if(is_backward)
      std::for_each(path.points.begin(), path.points.end(), f);
    else
      std::for_each(path.points.rbegin(), path.points.rend(), f);
    return path.points.empty() ? -1 : path.length;
  }

  // Must be called after the weights of the graph have changed.
  void reset() { m_parts.reset(); }

private:
  template <typename Point, typename NamedParameters>
  Path find_path(const MeshSearch& other, const Point& end, const NamedParameters& np) const
  {
    return m_parts->search.find_path(other.translation().intrinsic_point(end), np);
  }

  // In a reversed graph, the search starts at the target.
  template <typename Source, typename Target, typename NamedParameters>
  void run(const MeshSearch& other,
           const Source& source,
           const Target& target,
           const NamedParameters& np)
  {
    static_assert(!ignores_any<NamedParameters, internal_np::straighten_t,
                               internal_np::maximum_distance_t, internal_np::visitor_t>,
                  "single pairs read straighten, maximum_distance and visitor");
    if(!m_parts)
      m_parts = std::make_unique<Parts>(
          Parts{MeshSearch(other.search().graph(), other.translation(), other.point_map()),
                other.positions()});
    if(leads_to_sources(other.search().graph()))
      m_parts->search.run_to(target, source, m_parts->positions, np);
    else
      m_parts->search.run_to(source, target, m_parts->positions, np);
  }

  struct Parts
  {
    MeshSearch search;
    Vertex_positions positions;
  };

  std::unique_ptr<Parts> m_parts;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PAIR_SEARCH_H
