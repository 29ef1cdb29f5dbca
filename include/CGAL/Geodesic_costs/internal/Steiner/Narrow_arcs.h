// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_NARROW_ARCS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_NARROW_ARCS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Point_row.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs between the points of two sides of a corner that are left out, since they are narrow:
 * they make a small angle with a side at their end that is farther from the corner. The way along
 * this side toward the corner, as long as the angle is small, and across from there, is hardly
 * longer.
 *
 * The angle is small if one end is farther from the corner than the other by a ratio. So the
 * points of a side that a point has arcs to are consecutive. An arc is kept unless those next to
 * it, which are less narrow, are narrow, too: then all paths that are rounded to it are narrow. The
 * report proves what this means for the bound. Both ends of an arc compare the same numbers.
 */
class Narrow_arcs
{
public:
  // Two sides have all arcs if one has fewer points.
  static constexpr Index SMALLEST_SIZE = 128;

  // The arcs from points of `side` to those of `row`. `tangent` is that of the largest small angle.
  Narrow_arcs(const Corner& corner,
              const double tangent,
              const Point_row& side,
              const Point_row& row)
    : m_side(side), m_row(row)
  {
    const double o = corner.opening(), sine = std::sqrt(o * (1 - o / 4));
    m_ratio = (std::max)(1 - o / 2 + sine / tangent, 1.);
  }

  // Returns the rank of the first point of the row that a node of the side has an arc to. It is not
  // below `low`.
  Index first(const Index rank, const Index low = 0) const
  {
    if(rank >= m_side.size) // a vertex, which has all arcs
      return 0;
    const double inner = m_side.distance_of_node(rank - 1);
    return first_rank_without({low, m_row.size}, [&](const Index i) {
      return inner >= m_ratio * m_row.distance_of_node(i + 1);
    });
  }

  // Returns the rank beyond the last one that it has an arc to, likewise.
  Index beyond(const Index rank, const Index low = 0) const
  {
    if(rank >= m_side.size)
      return m_row.size;
    const double outer = m_ratio * m_side.distance_of_node(rank + 1);
    return first_rank_without({low, m_row.size},
                              [&](const Index i) { return m_row.distance_of_node(i - 1) < outer; });
  }

private:
  const Point_row& m_side;
  const Point_row& m_row;
  double m_ratio; // from which on the angle is small
};

/*
 * The points on the sides of faces of a Steiner graph, and those that narrow arcs would join.
 */
class Steiner_sides : public Steiner_view
{
protected:
  using Steiner_view::Steiner_view;

  // Returns the points of the edge of `h`, ranked from its source or its target.
  Point_row
  row(const Index h, const bool is_from_source, const Corner& corner, const double weight) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    return {m_nodes.node_of_point(first),
            m_points.number_of_points(e),
            m_points.positions(first),
            m_triangulation.length(h),
            m_points.is_first(h) == is_from_source ? Index(0) : Index(1),
            corner,
            weight};
  }

  // Whether arcs between two sides of a face may be left out since they are narrow.
  bool have_narrow_arcs(const Index a, const Index b) const
  {
    return m_nodes.tangent_of_narrow_arcs() > 0 &&
           (std::min)(m_points.number_of_points(m_points.edge(a)),
                      m_points.number_of_points(m_points.edge(b))) >= Narrow_arcs::SMALLEST_SIZE;
  }

  // Returns the range of ranks of the points on the third side of a face that `origin`, on the
  // other side, has arcs to. They are ranked from the corner of the first side.
  Ranks arcs_of_origin(const Face& face, const Node origin, const bool is_third_at_source) const
  {
    const Corner opposite = corner(face[2]);
    const Point_row before = row(face[1], false, opposite, 1),
                    behind = row(face[2], true, opposite, 1);
    const Point_row& side = is_third_at_source ? before : behind;
    const Point_row& third = is_third_at_source ? behind : before;
    const Narrow_arcs narrow(opposite, m_nodes.tangent_of_narrow_arcs(), side, third);
    const Index rank = side.rank(origin);
    return {third.size - narrow.beyond(rank), third.size - narrow.first(rank)};
  }

  // Returns the corner at the source of `h`, which is the same to the last bit for both sides.
  Corner corner(const Index h) const
  {
    const Index next = m_triangulation.next(h), last = m_triangulation.next(next);
    return corner_of_face(m_triangulation, h, m_triangulation.length(h),
                          m_triangulation.length(last), m_triangulation.length(next));
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_NARROW_ARCS_H
