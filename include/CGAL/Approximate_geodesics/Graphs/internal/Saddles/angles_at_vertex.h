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
void Bend_sectors::for_each_cosine(const Arrival& arrival, F f) const
{
  const Index first = m_triangulation.first_halfedge(m_vertex), start = side(arrival);
  const std::size_t degree = m_triangulation.degree(m_vertex);
  boost::container::small_vector<double, 16> cosines(degree, -1.);
  const auto raise = [&](const Index h, const Plane_vector angle) {
    double& cosine = cosines[h - first];
    cosine = (std::max)(cosine, angle.x);
  };
  const Plane_vector to_start = way_back(arrival);
  raise(start, to_start);
  Index h = start;
  if(degree > 1 && m_steps[h].has_face())
  {
    Plane_vector angle = turned_right(corner(h), to_start);
    h = m_triangulation.counterclockwise(m_vertex, h);
    raise(h, angle);
    for(std::size_t n = degree; n > 2 && m_steps[h].has_face(); --n)
    {
      angle = turned_left({angle.x, (std::max)(angle.y, 0.)}, corner(h)); // it was rounded
      if(angle.y < 0)                                                     // more than pi
        break;
      h = m_triangulation.counterclockwise(m_vertex, h);
      raise(h, angle);
    }
  }
  Plane_vector angle = to_start;
  h = m_triangulation.clockwise(m_vertex, start);
  for(std::size_t n = degree; n > 1 && m_steps[h].has_face(); --n)
  {
    angle = turned_left(angle, corner(h));
    if(angle.y < 0)
      break;
    raise(h, angle);
    h = m_triangulation.clockwise(m_vertex, h);
  }
  for(std::size_t i = 0; i < degree; ++i)
    f(static_cast<Index>(first + i), cosines[i]);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ANGLES_AT_VERTEX_H
