// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_CONVEX_OBSTACLE_H
#define APPROXIMATE_GEODESICS_TEST_CONVEX_OBSTACLE_H

#include "oracles/test_oracles.h"

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace geodesics_test {

/*
 * A convex polygon in the plane, counterclockwise, and shortest paths from its outside that do not
 * enter it.
 */
class Convex_obstacle
{
public:
  using Point_2 = Kernel::Point_2;

  explicit Convex_obstacle(const std::vector<Point_2>& corners) : m_corners(corners) {}

  bool contains(const Point_2& p) const // inside, not at the border
  {
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      if(to_the_left(i, p) <= 0)
        return false;
    return true;
  }

  double distance(const Point_2& p) const
  {
    if(contains(p))
      return 0;
    double result = infinity;
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      result = (std::min)(
          result, std::sqrt(CGAL::squared_distance(p, Kernel::Segment_2(m_corners[i], next(i)))));
    return result;
  }

  // A string around the polygon is as long as one side of the convex hull.
  double length_around(const Point_2& s, const Point_2& t) const
  {
    if(!hides(s, t))
      return straight(s, t);
    const std::vector<Point_2> hull = hull_with(s, t);
    double sides[2] = {0, 0};
    bool is_beyond = false;
    for(std::size_t i = 0; i + 1 < hull.size(); ++i)
    {
      is_beyond = is_beyond || hull[i] == t;
      sides[is_beyond] += straight(hull[i], hull[i + 1]);
    }
    return (std::min)(sides[0], sides[1]);
  }

private:
  static double straight(const Point_2& p, const Point_2& q)
  {
    return std::sqrt(CGAL::squared_distance(p, q));
  }

  const Point_2& next(const std::size_t i) const { return m_corners[(i + 1) % m_corners.size()]; }

  // How far `p` is to the left of the edge `i`, times the length of that.
  double to_the_left(const std::size_t i, const Point_2& p) const
  {
    const Point_2 &a = m_corners[i], &b = next(i);
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  }

  // Whether the straight line comes through the inside: what edges cut off leaves something.
  bool hides(const Point_2& s, const Point_2& t) const
  {
    double first = 0, last = 1;
    for(std::size_t i = 0; i < m_corners.size(); ++i)
    {
      const double a = to_the_left(i, s), b = to_the_left(i, t);
      if(a <= 0 && b <= 0)
        return false;
      if(a < 0)
        first = (std::max)(first, a / (a - b));
      else if(b < 0)
        last = (std::min)(last, a / (a - b));
    }
    return first < last;
  }

  // from `s` around to `s` again
  std::vector<Point_2> hull_with(const Point_2& s, const Point_2& t) const
  {
    std::vector<Point_2> points = m_corners, hull;
    points.push_back(s);
    points.push_back(t);
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    std::rotate(hull.begin(), std::find(hull.begin(), hull.end(), s), hull.end());
    hull.push_back(s);
    for(std::size_t i = 1; i < hull.size(); ++i) // which has no points inside its edges
      if(CGAL::are_strictly_ordered_along_line(hull[i - 1], t, hull[i]))
        hull.insert(hull.begin() + static_cast<std::ptrdiff_t>(i), t);
    return hull;
  }

  std::vector<Point_2> m_corners;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_CONVEX_OBSTACLE_H
