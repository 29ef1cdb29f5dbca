// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_POINTS_BY_FACE_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_POINTS_BY_FACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSurface
 *
 * Points of a triangulated surface, and which of them lie in a face. Vertices may be among the
 * points, but are not listed by face.
 */
class Points_by_face
{
public:
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// no points.
  Points_by_face() = default;

  /// sorts `points` by face. Run time is \cgalBigO{n \log n} for `n` points.
  /// \warning `triangulation` is referred to, not copied.
  Points_by_face(const Intrinsic_triangulation& triangulation, std::vector<Intrinsic_point> points)
    : m_triangulation(&triangulation), m_points(std::move(points))
  {
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(!m_points[i].is_vertex())
        m_points[i].for_each_face(triangulation,
                                  [&](const Index h) { m_entries.emplace_back(face(h), i); });
    std::sort(m_entries.begin(), m_entries.end());
  }

  /// returns whether there are no points other than vertices.
  bool is_empty() const { return m_entries.empty(); }

  /// returns the point with number `i`.
  const Intrinsic_point& operator[](const std::size_t i) const { return m_points[i]; }

  /// calls `f(i)` for each point in the face to the left of `h`, or on its sides.
  /// \pre `h` is not a border halfedge.
  template <typename F>
  void for_each_in_face(const Index h, F f) const
  {
    if(is_empty())
      return;
    const Index wanted = face(h);
    for(auto it = std::lower_bound(m_entries.begin(), m_entries.end(), Entry(wanted, 0));
        it != m_entries.end() && it->first == wanted; ++it)
      f(it->second);
  }

private:
  using Entry = std::pair<Index, std::size_t>; // a face, and the number of a point

  // the smallest of its halfedges
  Index face(const Index h) const
  {
    const auto sides = m_triangulation->halfedges_of_face(h);
    return *std::min_element(sides.begin(), sides.end());
  }

  const Intrinsic_triangulation* m_triangulation = nullptr;
  std::vector<Intrinsic_point> m_points;
  std::vector<Entry> m_entries; // sorted
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_POINTS_BY_FACE_H
