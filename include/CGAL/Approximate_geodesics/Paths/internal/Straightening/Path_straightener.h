// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STRAIGHTENER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STRAIGHTENER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Path_sleeves.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Path_steps.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_segments.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Makes paths locally shortest.
 */
class Path_straightener
{
public:
  using Index = Intrinsic_triangulation::Index;

  // The triangulation is referred to, not copied.
  explicit Path_straightener(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  // Returns a path between the same places that is not longer than `path`. It is locally shortest,
  // unless that takes too many rounds. Its length is the sum of its segments.
  Path shortened(const Path& path) const
  {
    if(path.points.size() < 2)
      return path;
    // Which ways past other vertices are tried depends on the sides on which it passes its own.
    constexpr double rounding = 1e-12;
    constexpr int largest_number_of_runs = 10;
    Path result = tightened(path);
    for(int i = 1; i < largest_number_of_runs && has_bend(result); ++i)
    {
      Path next = tightened(result);
      if(!(next.length < result.length * (1 - rounding)))
        break;
      result = std::move(next);
    }
    return result;
  }

private:
  Path tightened(const Path& path) const
  {
    const Path_steps steps(m_triangulation, path.points);
    if(!std::isfinite(steps.length()))
      return path;
    Path result;
    append(steps.points.front(), result.points);
    Sleeve_straightener tightening(m_triangulation);
    Path_sleeves(m_triangulation, steps)
        .for_each_sleeve([&](const Sleeve& sleeve, const Intrinsic_point& end) {
          tightening.tighten(sleeve);
          tightening.for_each_point([&](const Intrinsic_point& p) { append(p, result.points); });
          append(end, result.points);
        });
    result.length = length_of_segments(m_triangulation, result.points);
    if(result.length <= steps.length())
      return result;
    const double length = length_of_segments(m_triangulation, path.points);
    return result.length <= length ? result : Path{path.points, length};
  }

  static bool has_bend(const Path& path)
  {
    return path.points.size() > 2 &&
           std::any_of(path.points.begin() + 1, path.points.end() - 1,
                       [](const Intrinsic_point& p) { return p.is_vertex(); });
  }

  // Crossings at the end of an edge are at its vertex, where there may be several of them.
  void append(const Intrinsic_point& p, std::vector<Intrinsic_point>& points) const
  {
    const Intrinsic_point q = simplified(m_triangulation, p);
    if(points.empty() || !q.is_vertex() || q.vertex != points.back().vertex)
      points.push_back(q);
  }

  const Intrinsic_triangulation& m_triangulation;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STRAIGHTENER_H
