// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BENDS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BENDS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Whether shortest paths can bend at a vertex: at saddle vertices, whose angles add up to more than
 * 2 pi, and at border vertices whose angles add up to more than pi; and where they cannot, whether
 * the surface, or its border, is straight there.
 *
 * A vertex at which a path bends for no reason costs time, and changes no distance. So a vertex
 * counts as one if a face without area, or an edge without length, leaves doubts about its angle;
 * and at such vertices, paths may bend by any angle. So they may at a vertex where parts of the
 * surface meet, with a border between them: they go from one part to the others.
 */
enum class Bend_kind : std::uint8_t
{
  NONE,
  NONE_AS_FLAT,
  SADDLE,
  BORDER,
  ANY
};

class Bends
{
public:
  using Index = Intrinsic_triangulation::Index;

  // What angles of faces that are not too thin may be wrong by.
  static constexpr double ROUNDING = 1e-11;
  static constexpr double FLAT = 1e-11;

  Bends(const Intrinsic_triangulation& triangulation, const Face_steps& steps)
  {
    // At a border vertex, there is no other side that sees what rounding hides on this one, and
    // across needles, it may hide lines along a straight border. Where the angle is less than pi,
    // paths that arrive are continued only if their slack makes up for that.
    const double largest_at_border =
        has_needles(triangulation, steps) ? -Arrival::ROUNDING : ROUNDING;
    m_bends.reserve(triangulation.number_of_vertices());
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      m_bends.push_back(bend(triangulation, steps, v, largest_at_border));
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(steps[h].has_face() && is_degenerate(triangulation, steps, h))
        m_bends[steps[h].apex] = Bend_kind::ANY;
  }

  Bend_kind operator[](const Index v) const { return m_bends[v]; }

  bool is_possible(const Index v) const { return m_bends[v] >= Bend_kind::SADDLE; }

  // Whether a vertex on one of the rays of a sight hides nothing from lines that pass it on the
  // inside only: what is beyond lies straight ahead on all sides, or paths can bend there. If
  // lines went on between two border vertices on them, one to the left and one to the right,
  // rounding would decide whether a line is found on the way back.
  bool hides_nothing(const Index v) const { return m_bends[v] != Bend_kind::NONE; }

  std::size_t memory() const { return m_bends.capacity() * sizeof(Bend_kind); }

private:
  // Whether any face is so thin that positions across it lose a third of their digits.
  static bool has_needles(const Intrinsic_triangulation& triangulation, const Face_steps& steps)
  {
    constexpr double smallest_height = 1e-6; // over a side, as a part of it
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(steps[h].has_face() && !(steps[h].across > smallest_height))
        return true;
    return false;
  }

  static bool is_degenerate(const Intrinsic_triangulation& triangulation,
                            const Face_steps& steps,
                            const Index h)
  {
    // where an edge is shorter than rounding errors of the others, so may paths over its ends be
    constexpr double smallest_part = 1e-12;
    const Face_step& step = steps[h];
    const bool has_area = step.across > 0 && step.across < 1e200 && std::abs(step.along) < 1e200;
    const Index second = triangulation.next(h), third = triangulation.next(second);
    const auto [shortest, longest] = std::minmax(
        {triangulation.length(h), triangulation.length(second), triangulation.length(third)});
    return !has_area || !(shortest > (std::max)(Sight::SHORTEST_EDGE, smallest_part * longest));
  }

  static Bend_kind bend(const Intrinsic_triangulation& triangulation,
                        const Face_steps& steps,
                        const Index v,
                        const double largest_at_border)
  {
    Angle_sum sum;
    int number_of_borders = 0;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      if(steps[h].has_face())
        sum.add(unit_corner(steps[h]));
      else
        ++number_of_borders;
    }
    if(number_of_borders > 1)
      return Bend_kind::ANY;
    const double excess = sum.value() - (2 - number_of_borders) * straight_angle;
    if(excess > (number_of_borders > 0 ? largest_at_border : ROUNDING))
      return number_of_borders > 0 ? Bend_kind::BORDER : Bend_kind::SADDLE;
    return excess >= -FLAT ? Bend_kind::NONE_AS_FLAT : Bend_kind::NONE;
  }

  std::vector<Bend_kind> m_bends; // per vertex
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BENDS_H
