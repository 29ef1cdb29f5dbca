// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LINES_BY_DIRECTION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LINES_BY_DIRECTION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <cmath>
#include <optional>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The straight lines from a point of a mesh to others whose directions are known, as arcs that were
 * found in a retriangulation of its surface: in a strip of needles, there are very many others.
 */
class Lines_by_direction : public Cones_of_point
{
public:
  using Cones_of_point::Cones_of_point;

  // Considers the line of an arc from `source`, the point, that was found in another triangulation.
  void find_arc(const Retriangulation& other,
                const Index source,
                const Straight_arc& arc,
                const Intrinsic_point& end,
                Line_search& search) const
  {
    std::optional<Direction_in_mesh> direction = other.direction(source, arc.start);
    if(!direction)
      return;
    direction->angle += angle_of(arc.position);
    for(double tolerance = 1e-11; tolerance < 1e-3 && !search.is_found(); tolerance *= 100)
      find_line_along(end, *direction, tolerance, arc.length, search);
  }

private:
  // Windows that a line with this direction and length may go through.
  struct Along_line : Leave_out_nothing_in_doubt
  {
    bool prune(const Window& w) const
    {
      const Plane_vector edge = w.left_position - w.right_position;
      return cross(direction, w.left_position) < -tolerance * length(w.left_position) ||
             cross(w.right_position, direction) < -tolerance * length(w.right_position) ||
             cross(w.right_position, edge) > 1.01 * reach * cross(direction, edge);
    }

    Plane_vector direction; // of length 1, or zero, for which all windows are pruned
    double reach;
    double tolerance;
  };

  // Considers the lines to a point in the given direction, up to a small angle, that are no longer
  // than `reach`.
  void find_line_along(const Intrinsic_point& end,
                       const Direction_in_mesh& direction,
                       const double tolerance,
                       const double reach,
                       Line_search& search) const
  {
    const Intrinsic_triangulation& t = m_triangulation;
    const auto look = [&](const Index h, const double angle) {
      for_each_view_out_of_face(h, [&](const View& view) {
        const Plane_vector side = Face_layout(t, view.start).direction(h),
                           ray = turned_left(side, {std::cos(angle), std::sin(angle)});
        find_line_in_view(end, view, Along_line{{}, ray, reach, tolerance}, search);
      });
    };
    if(!m_point.is_vertex())
      return look(direction.halfedge, direction.angle);
    Index h = direction.halfedge;
    double angle = direction.angle;
    for(Index n = t.degree(m_point.vertex); n > 0 && !t.is_border(h) && angle >= -tolerance; --n)
    {
      const double corner = angle_of(corner_angle(t, h));
      if(angle <= corner + tolerance)
        look(h, angle);
      angle -= corner;
      h = t.counterclockwise(m_point.vertex, h);
    }
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LINES_BY_DIRECTION_H
