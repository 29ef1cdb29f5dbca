// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_LAYOUT_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_LAYOUT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Apex_position.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <array>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The face to the left of a halfedge, laid out in the plane: its corners are the source and the
 * target of the halfedge, and the third vertex, in counterclockwise order.
 */
class Face_layout
{
public:
  using Index = Intrinsic_triangulation::Index;

  Face_layout(const Intrinsic_triangulation& triangulation, const Index h)
    : m_triangulation(triangulation), m_halfedges(triangulation.halfedges_of_face(h))
  {
    const std::array<double, 3> lengths{triangulation.length(m_halfedges[0]),
                                        triangulation.length(m_halfedges[1]),
                                        triangulation.length(m_halfedges[2])};
    std::size_t base = 0; // the longest side, as others may have no length
    for(const std::size_t i : {std::size_t(1), std::size_t(2)})
      if(lengths[i] > lengths[base])
        base = i;
    const double c = lengths[base], a = lengths[(base + 1) % 3], b = lengths[(base + 2) % 3];
    m_corners[base] = {0, 0};
    m_corners[(base + 1) % 3] = {c, 0};
    const auto face = thin_face(triangulation, m_halfedges[base], a, b, c);
    if(face)
      m_corners[(base + 2) % 3] = {face->at_corner[0] / c, face->doubled_area / c};
    else if(c > 0)
      m_corners[(base + 2) % 3] = {0.5 * (c + (b - a) * ((b + a) / c)),
                                   2 * area_of_triangle(a, b, c) / c};
    else
      m_corners[(base + 2) % 3] = {0, 0};
    for(std::size_t i = 0; i < 3; ++i)
      m_edges[i] = m_corners[(i + 1) % 3] - m_corners[i];
    if(face) // a short edge that does not start from the origin would lose its direction
      m_edges[(base + 1) % 3] = {-face->at_corner[1] / c, face->doubled_area / c};
  }

  // The halfedge from corner `i` to the next one.
  Index halfedge(const std::size_t i) const { return m_halfedges[i]; }

  Index vertex(const std::size_t i) const
  {
    return m_triangulation.target(m_halfedges[(i + 2) % 3]);
  }

  Plane_vector corner(const std::size_t i) const { return m_corners[i]; }

  // The vector from corner `i` to corner `j`, accurate in its direction and length.
  Plane_vector edge(const std::size_t i, const std::size_t j) const
  {
    return i == j ? Plane_vector{0, 0} : j == (i + 1) % 3 ? m_edges[i] : -1. * m_edges[j];
  }

  // Calls `f(position)` for where a point is in the face.
  template <typename F>
  void for_each_position(const Intrinsic_point& p, F f) const
  {
    for_each_face_point(m_triangulation, p, m_halfedges[0], [&](const Face_point& point) {
      f(point.seen_from(m_triangulation, m_halfedges[0]).position(m_corners));
    });
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::array<Index, 3> m_halfedges;
  std::array<Plane_vector, 3> m_corners;
  std::array<Plane_vector, 3> m_edges; // from each corner to the next
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_LAYOUT_H
