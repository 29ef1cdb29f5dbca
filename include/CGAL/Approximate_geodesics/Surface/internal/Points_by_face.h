// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_POINTS_BY_FACE_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_POINTS_BY_FACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/faces_of_place.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Some places that are not vertices, and which of them are in a face, or on its sides.
 */
class Points_by_face
{
public:
  using Index = Intrinsic_triangulation::Index;

  Points_by_face() = default;

  Points_by_face(const Intrinsic_triangulation& triangulation,
                 const std::vector<Intrinsic_point>& places)
    : m_places(places)
  {
    for(std::size_t i = 0; i < places.size(); ++i)
      if(!places[i].is_vertex())
        for_each_face(triangulation, places[i],
                      [&](const Index h) { m_entries.emplace_back(face(triangulation, h), i); });
    std::sort(m_entries.begin(), m_entries.end());
  }

  bool is_empty() const { return m_entries.empty(); }

  const Intrinsic_point& operator[](const std::size_t i) const { return m_places[i]; }

  // Calls `f(i)` for the places in the face to the left of `h`.
  template <typename F>
  void for_each_in_face(const Intrinsic_triangulation& triangulation, const Index h, F f) const
  {
    if(is_empty())
      return;
    const Index wanted = face(triangulation, h);
    for(auto it = std::lower_bound(m_entries.begin(), m_entries.end(), Entry(wanted, 0));
        it != m_entries.end() && it->first == wanted; ++it)
      f(it->second);
  }

private:
  using Entry = std::pair<Index, std::size_t>; // a face, and the number of a place

  // the smallest of its halfedges
  static Index face(const Intrinsic_triangulation& triangulation, const Index h)
  {
    const auto sides = halfedges_of_face(triangulation, h);
    return *std::min_element(sides.begin(), sides.end());
  }

  std::vector<Intrinsic_point> m_places;
  std::vector<Entry> m_entries; // sorted
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_POINTS_BY_FACE_H
