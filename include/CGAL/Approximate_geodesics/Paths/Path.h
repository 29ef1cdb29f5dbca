// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPaths
 *
 * A path on a triangulated surface. Between two points that follow each other, it runs straight
 * through a face, or along an edge.
 */
struct Path
{
  /// the points; none if there is no path.
  std::vector<Intrinsic_point> points;

  /// the length, in the unit of the mesh; the cost, if faces have weights.
  double length = 0;
};

namespace internal {

// Appends a point to a path, unless it is where the path has got to. Removes the last point if the
// path goes straight on there, along an edge.
inline void
append(const Intrinsic_point& point, const Intrinsic_triangulation& triangulation, Path& path)
{
  auto& points = path.points;
  if(point.is_same(points.back(), triangulation))
    return;
  const auto h = points.back().halfedge;
  if(points.size() > 1 && points.back().is_on_edge() &&
     points[points.size() - 2].is_on_edge_of(h, triangulation) &&
     point.is_on_edge_of(h, triangulation))
    points.pop_back();
  points.push_back(point);
}

// Leaves out what a path does between two visits of a vertex, unless that is all of the path.
inline void cut_loops(std::vector<Intrinsic_point>& points)
{
  std::unordered_map<Intrinsic_point::Index, std::size_t> last_visit;
  for(std::size_t i = 1; i < points.size(); ++i)
    if(points[i].is_vertex())
      last_visit[points[i].vertex] = i;
  std::size_t size = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    points[size++] = points[i];
    const auto visit = last_visit.find(points[i].vertex);
    if(visit != last_visit.end() && (i > 0 || visit->second + 1 < points.size()))
      i = visit->second;
  }
  points.resize(size, Intrinsic_point::at_vertex(0));
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H
