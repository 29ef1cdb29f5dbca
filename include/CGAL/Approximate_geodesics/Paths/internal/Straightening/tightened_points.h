// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_TIGHTENED_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_TIGHTENED_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Path_sleeves.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve_straightener.h>

#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The points of the path that is left when the sleeves of a path are tightened, one after the
// other. Crossings at the end of an edge are at its vertex, where there may be several of them.
inline std::vector<Intrinsic_point> tightened_points(const Intrinsic_triangulation& triangulation,
                                                     const Path_steps& path)
{
  std::vector<Intrinsic_point> result;
  const auto append = [&](const Intrinsic_point& p) {
    const Intrinsic_point q = p.reduced(triangulation);
    if(result.empty() || !q.is_vertex() || q.vertex != result.back().vertex)
      result.push_back(q);
  };
  append(path.points.front());
  Sleeve_straightener straightener(triangulation);
  Path_sleeves(triangulation, path)
      .for_each_sleeve([&](const Sleeve& sleeve, const Intrinsic_point& end) {
        straightener.tighten(sleeve);
        straightener.for_each_point(append);
        append(end);
      });
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_TIGHTENED_POINTS_H
