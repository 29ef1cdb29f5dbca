// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ANGLES_AT_VERTEX_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ANGLES_AT_VERTEX_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Vertex_sights.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

// The member function of `Bend_sectors` for distances beside a line, which offsets of curves need.

template <typename F>
void Bend_sectors::for_each_angle(const Arrival& arrival, F f) const
{
  const Index first = m_triangulation.first_halfedge(m_vertex), start = side(arrival);
  const std::size_t degree = m_triangulation.degree(m_vertex);
  boost::container::small_vector<double, 16> angles(degree, straight_angle);
  const auto lower = [&](const Index h, const double angle) {
    angles[h - first] = (std::min)(angles[h - first], angle);
  };
  const double to_start = angle_of(way_back(arrival));
  lower(start, to_start);
  double angle = -to_start;
  Index h = start;
  for(std::size_t n = degree; n > 1 && m_steps[h].has_face() && angle < straight_angle; --n)
  {
    angle += angle_of(corner(h));
    h = m_triangulation.counterclockwise(m_vertex, h);
    lower(h, angle);
  }
  angle = to_start;
  h = m_triangulation.clockwise(m_vertex, start);
  for(std::size_t n = degree; n > 1 && m_steps[h].has_face() && angle < straight_angle; --n)
  {
    angle += angle_of(corner(h));
    lower(h, angle);
    h = m_triangulation.clockwise(m_vertex, h);
  }
  for(std::size_t i = 0; i < degree; ++i)
    f(static_cast<Index>(first + i), angles[i]);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ANGLES_AT_VERTEX_H
