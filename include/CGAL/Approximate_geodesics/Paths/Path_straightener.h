// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_STRAIGHTENER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_STRAIGHTENER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/// \cond SKIP_IN_MANUAL

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * Makes paths locally shortest: straight across edges, with bends only at vertices. It lays out the
 * faces along a path in the plane, finds the shortest path there by the funnel algorithm
 * \cgalCite{lp-espps-84}, and then tries the other side of the vertices where that path bends.
 */
class Path_straightener
{
public:
  /// a straightener for paths on `triangulation`.
  /// \warning `triangulation` is referred to, not copied.
  explicit Path_straightener(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /// returns a path between the same points that is not longer than `path`. It is locally shortest,
  /// unless that takes too many iterations. It visits no vertex twice, unless it is closed. Its
  /// length is the sum of its segments. Weighted faces are not supported, as cheapest paths are not
  /// straight there.
  ///
  /// Run time is linear in the number of faces crossed, in practice.
  Path shortened(const Path& path) const
  {
    if(path.points.size() < 2)
      return path;
    // The result depends on the sides of vertices that are chosen first, so the pass is repeated.
    constexpr double rounding = 1e-12;
    constexpr int largest_number_of_runs = 10;
    Path result = tightened(path.points);
    for(int i = 1; i < largest_number_of_runs && has_bend(result); ++i)
    {
      Path next = tightened(result.points);
      if(!(next.length < result.length * (1 - rounding)))
        break;
      result = std::move(next);
    }
    if(!std::isfinite(result.length)) // its points do not form a path
      return path;
    result.length *= m_triangulation.unit();
    return result;
  }

private:
  // The length of the result is in units of the triangulation.
  Path tightened(const std::vector<Intrinsic_point>& points) const
  {
    const internal::Path_steps steps(m_triangulation, points);
    if(!std::isfinite(steps.length()))
      return {points, steps.length()};
    Path result;
    result.points = internal::tightened_points(m_triangulation, steps);
    internal::cut_loops(result.points);
    result.length = internal::length_of_segments(m_triangulation, result.points);
    if(result.length <= steps.length())
      return result;
    const double length = internal::length_of_segments(m_triangulation, points);
    return result.length <= length ? result : Path{points, length};
  }

  static bool has_bend(const Path& path)
  {
    return path.points.size() > 2 &&
           std::any_of(path.points.begin() + 1, path.points.end() - 1,
                       [](const Intrinsic_point& p) { return p.is_vertex(); });
  }

  const Intrinsic_triangulation& m_triangulation;
};

/// \endcond

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_STRAIGHTENER_H
