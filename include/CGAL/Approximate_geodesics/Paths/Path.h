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
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A path on a triangulated surface: a polyline, each segment of which lies in a face or on an edge.
 */
struct Path
{
  /// the points; empty if there is no path.
  std::vector<Intrinsic_point> points;

  /// the length, in the unit of the mesh; the cost, if faces have weights.
  double length = 0;
};

namespace internal {

// Appends a point to a path, unless it is the last point. Removes the last point if it lies between
// two others on the same edge.
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

// Removes loops from a vertex back to it, unless the loop is the whole path.
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
