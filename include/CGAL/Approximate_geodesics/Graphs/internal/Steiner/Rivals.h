// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_RIVALS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_RIVALS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Point_row.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// A point that is reached at some cost, and its distance from a corner.
struct Reached_point
{
  double label;
  double distance_from_corner;
};

/*
 * Two points of one side of a corner, from which paths compete for the points of its other side.
 *
 * Straight arcs from two points of a side to two points of the other need not cross: exchanging
 * their ends does not make them longer. So what either of the two reaches at less cost lies at its
 * own end of the row, and a binary search finds where it ends.
 *
 * Beside large labels, costs of arcs vanish, and many sums are the same. So what is compared is the
 * difference of two arcs with that of two labels. Each is right up to a small part of itself, as
 *   d^2 - d'^2 = (x - x') (x + x' - 2 y cos(angle)).
 * All is divided by the weight, which may be zero.
 */
class Rivals
{
  using Index = Point_row::Index;

public:
  Rivals(const Reached_point& nearer,
         const Reached_point& farther,
         const Point_row& row,
         const Corner& corner,
         const double weight)
    : m_row(row),
      m_corner(corner),
      m_nearer(nearer.distance_from_corner),
      m_farther(farther.distance_from_corner)
  {
    const double gap = m_farther - m_nearer;
    if(nearer.label != farther.label)
      m_head_start = divided(farther.label - nearer.label, weight);
    else if(gap == 0)
      m_head_start = (std::numeric_limits<double>::min)(); // ties go to the nearer one
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double label = divided((std::min)(nearer.label, farther.label), weight);
    m_doubt = (std::min)(SMALLEST_DIFFERENCE * gap, rounding * (label + m_farther + row.length()));
  }

  // Returns the number of points that the nearer one reaches at less cost, beyond doubt.
  Index end_of_nearer() const
  {
    return search([this](const double y) { return lead_of_nearer(y, -m_doubt) > 0; });
  }

  // Returns the rank of the first point that the farther one reaches at less cost, beyond doubt.
  Index start_of_farther() const
  {
    return search([this](const double y) { return !(lead_of_nearer(y, m_doubt) < 0); });
  }

private:
  // Sums that are rounded to the same number shall not count, so that costs are those with all
  // arcs, to the last bit; unless labels are so large that nothing else is left of a whole face.
  static constexpr double SMALLEST_DIFFERENCE = 1e-3;

  // In a face of weight zero, the difference of two labels decides, however small it is.
  static double divided(const double label, const double weight)
  {
    return weight > 0 ? label / weight
                      : std::copysign(std::numeric_limits<double>::infinity(), label);
  }

  // By how much the nearer one is better for the point at the distance `y` from the corner, times
  // a positive number.
  double lead_of_nearer(const double y, const double allowance) const
  {
    const double sum = m_corner.distance(m_nearer, y) + m_corner.distance(m_farther, y);
    return (m_head_start + allowance) * sum +
           (m_farther - m_nearer) * (m_farther + m_nearer - (2 - m_corner.opening()) * y);
  }

  // Returns the first rank of which `f` is not true.
  template <typename F>
  Index search(const F& f) const
  {
    using Rank = boost::counting_iterator<Index>;
    return *std::partition_point(Rank(0), Rank(m_row.size()), [&](const Index rank) {
      return f(m_row.distance_from_corner(rank));
    });
  }

  const Point_row& m_row;
  const Corner& m_corner;
  double m_nearer, m_farther; // distances from the corner
  double m_head_start = 0;    // of the nearer one
  double m_doubt;
};

/*
 * The ranks of those points of a row that two rivals of a point do not reach at less cost: as a
 * first one and one beyond. One rival is nearer to the corner and one farther from it, on the same
 * side of it.
 */
inline std::pair<Point_row::Index, Point_row::Index> cell(const Point_row& row,
                                                          const Corner& corner,
                                                          const double weight,
                                                          const Reached_point& point,
                                                          const Reached_point& nearer,
                                                          const Reached_point& farther)
{
  const auto first = Rivals(nearer, point, row, corner, weight).end_of_nearer();
  return {first, (std::max)(first, Rivals(point, farther, row, corner, weight).start_of_farther())};
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_RIVALS_H
