// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_RIVALS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_RIVALS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Point_row.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

// The label of a point, and its distance from a corner.
struct Reached_point
{
  double label;
  double distance_from_corner;
};

/*
 * Two points on one side of a corner, whose paths compete for the points on its other side.
 *
 * Straight arcs from two points of a side to two points of the other need not cross: exchanging
 * their ends does not make them longer. So the points that one of the two reaches at a lower cost
 * are at its own end of the row, and a binary search finds the last of them.
 *
 * Sums of large labels and short arcs lose digits by rounding. So the difference of two arcs is
 * compared with that of two labels. Both have small relative errors, as
 *   d^2 - d'^2 = (x - x') (x + x' - 2 y cos(angle)).
 * All is divided by the weight, which may be zero.
 */
class Rivals
{
public:
  Rivals(const Reached_point& nearer, const Reached_point& farther, const Point_row& row)
    : m_row(row), m_nearer(nearer.distance_from_corner), m_farther(farther.distance_from_corner)
  {
    const double gap = m_farther - m_nearer;
    if(nearer.label != farther.label)
      m_head_start = divided(farther.label - nearer.label, row.weight);
    else if(gap == 0)
      m_head_start = (std::numeric_limits<double>::min)(); // ties go to the nearer one
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double label = divided((std::min)(nearer.label, farther.label), row.weight);
    m_doubt = (std::min)(SMALLEST_DIFFERENCE * gap, rounding * (label + m_farther + row.length));
  }

  // Returns the rank beyond the last of these points that the nearer one certainly reaches at a
  // lower cost.
  Index end_of_nearer(const Ranks& ranks) const
  {
    using Rank = boost::counting_iterator<Index>;
    const Rank end((std::max)(ranks.first, ranks.beyond));
    return *std::partition_point(Rank(ranks.first), end, [this](const Index rank) {
      return lead_of_nearer(m_row.distance_from_corner(rank), -m_doubt) > 0;
    });
  }

  // Returns the rank of the first of these points that the farther one certainly reaches at a lower
  // cost.
  Index start_of_farther(const Ranks& ranks) const
  {
    return first_rank_without(ranks, [this](const Index rank) {
      return !(lead_of_nearer(m_row.distance_from_corner(rank), m_doubt) < 0);
    });
  }

private:
  // Sums that are rounded to the same number are not pruned, so that costs are those with all arcs,
  // to the last bit, unless labels are so large that rounding cancels all arcs of a face.
  static constexpr double SMALLEST_DIFFERENCE = 1e-3;

  // In a face of weight zero, any difference of two labels decides.
  static double divided(const double label, const double weight)
  {
    return weight > 0 ? label / weight : std::copysign(infinity, label);
  }

  // Returns by how much the nearer one is better for the point at the distance `y` from the corner,
  // times a positive number.
  double lead_of_nearer(const double y, const double allowance) const
  {
    const Corner& corner = m_row.corner;
    const double sum = corner.distance(m_nearer, y) + corner.distance(m_farther, y);
    return (m_head_start + allowance) * sum +
           (m_farther - m_nearer) * (m_farther + m_nearer - (2 - corner.opening()) * y);
  }

  const Point_row& m_row;
  double m_nearer, m_farther; // distances from the corner
  double m_head_start = 0;    // of the nearer one
  double m_doubt;
};

/*
 * Returns the range of ranks of the points that `point` may reach at a lower cost than two other
 * points on the same side of the corner, one nearer to it and one farther from it. It has arcs to
 * the points of the range `arcs`, the nearer one has none from `beyond_of_nearer` on, and the
 * farther one none before `first_of_farther`.
 */
inline Ranks cell(const Point_row& row,
                  const Reached_point& point,
                  const Reached_point& nearer,
                  const Reached_point& farther,
                  const Ranks& arcs,
                  const Index beyond_of_nearer,
                  const Index first_of_farther)
{
  const Index first = Rivals(nearer, point, row).end_of_nearer({arcs.first, beyond_of_nearer});
  const Index low = (std::max)(first, first_of_farther);
  return {first, Rivals(point, farther, row).start_of_farther({low, arcs.beyond})};
}

// The same where all three have arcs to all points.
inline Ranks cell(const Point_row& row,
                  const Reached_point& point,
                  const Reached_point& nearer,
                  const Reached_point& farther)
{
  return cell(row, point, nearer, farther, {0, row.size}, row.size, 0);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_RIVALS_H
