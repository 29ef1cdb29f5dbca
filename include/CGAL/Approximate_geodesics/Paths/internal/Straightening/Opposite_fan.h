// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_OPPOSITE_FAN_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_OPPOSITE_FAN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Vertex_fan.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * How a sleeve could pass a vertex on the other side: through the faces around it that it does not
 * go through.
 */
class Opposite_fan
{
public:
  using Index = Intrinsic_triangulation::Index;

  Opposite_fan(const Sleeve& sleeve, const Gate_range& gates)
    : m_sleeve(sleeve),
      m_triangulation(sleeve.triangulation()),
      m_gates(gates),
      m_first(sleeve.halfedge_from(gates.first, gates.is_left)),
      m_last(sleeve.halfedge_from(gates.beyond - 1, gates.is_left)),
      m_vertex(m_triangulation.source(m_first))
  {
  }

  // Whether the path can pass there, and has an angle below pi. It comes from `back` and leads
  // `ahead`, seen from the vertex in a plane where the first and the last gate have the given
  // directions from left to right.
  bool is_convex(const Plane_vector back,
                 const Plane_vector first,
                 const Plane_vector last,
                 const Plane_vector ahead) const
  {
    if(winds_around())
      return true;
    const double to_back = length(back), to_ahead = length(ahead);
    if(!(to_back > 0 && to_ahead > 0)) // at a vertex in the same place
      return false;
    const double side = m_gates.is_left ? 1 : -1;
    const Plane_vector before{side * dot(back, first) / to_back, cross(back, first) / to_back};
    const Plane_vector after{side * dot(last, ahead) / to_ahead, cross(last, ahead) / to_ahead};
    return m_gates.is_left ? is_fan_convex(m_last, after, m_first, before)
                           : is_fan_convex(m_first, before, m_last, after);
  }

  // Leads a sleeve, which has got to the first gate, there. The last gate is behind it then.
  void pass(Sleeve& sleeve) const
  {
    if(winds_around())
    {
      const std::size_t first_of_last_turn = m_gates.beyond - m_triangulation.degree(m_vertex);
      for(std::size_t i = m_gates.first; i < first_of_last_turn; ++i)
        sleeve.cross(m_sleeve.gates()[i].halfedge);
    }
    else if(m_gates.is_left)
      for(Index h = m_triangulation.clockwise(m_vertex, m_first); h != m_last;
          h = m_triangulation.clockwise(m_vertex, h))
        sleeve.cross(m_triangulation.opposite(h));
    else
      for(Index h = m_triangulation.counterclockwise(m_vertex, m_first); h != m_last;
          h = m_triangulation.counterclockwise(m_vertex, h))
        sleeve.cross(h);
  }

private:
  // whether the sleeve goes all the way round, and farther
  bool winds_around() const
  {
    return m_gates.beyond - m_gates.first > m_triangulation.degree(m_vertex);
  }

  // Whether the angle of the fan counterclockwise from `first` to `beyond` is below pi, where the
  // path takes something off its first and its last corner.
  bool is_fan_convex(const Index first,
                     const Plane_vector off_first,
                     const Index beyond,
                     const Plane_vector off_last) const
  {
    Angle_sum sum;
    Index h = first, next = null_index;
    for(; next != beyond && sum.is_convex(); h = next)
    {
      next = m_triangulation.counterclockwise(m_vertex, h);
      if(m_triangulation.is_border(h) || (h != first && !m_triangulation.is_crossable(h)))
        return false;
      if(h == first && next == beyond) // one corner, and the path goes round all the others
        return true;
      Plane_vector angle = corner_angle(m_triangulation, h);
      if(h == first)
        angle = turned_right(angle, off_first);
      if(next == beyond)
        angle = turned_right(angle, off_last);
      sum.add(angle);
    }
    return sum.is_convex();
  }

  static constexpr Index null_index = Intrinsic_triangulation::null_index;

  const Sleeve& m_sleeve;
  const Intrinsic_triangulation& m_triangulation;
  const Gate_range m_gates;
  const Index m_first, m_last, m_vertex; // the halfedges start from the vertex
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_OPPOSITE_FAN_H
