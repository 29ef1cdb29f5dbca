// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The largest convex gauge that is not above given costs in given directions: what zigzags cost.
 * Its unit ball is the convex hull of the origin and the points that one unit of cost leads to.
 * Costs of zero put points at infinity, and infinite ones none, so that all is done in terms of
 * costs: between two corners of the hull, the gauge is linear.
 *
 * If directions and costs are those of another hull turned by half a circle, so are all results, to
 * the last bit.
 */
class Gauge_hull
{
public:
  // Two directions with a smaller sine between them make no sector.
  static constexpr double SMALLEST_SINE = 1e-9;

  // The directions are unit vectors in counterclockwise order, all around.
  Gauge_hull(const std::vector<Plane_vector>& directions, const std::vector<double>& costs)
    : m_directions(directions), m_costs(costs)
  {
    std::vector<std::size_t> finite;
    for(std::size_t i = 0; i < costs.size(); ++i)
      if(costs[i] < std::numeric_limits<double>::infinity())
        finite.push_back(i);
    if(!finite.empty())
      scan(finite);
  }

  // The directions that are corners, ascending; none if all costs are infinite.
  const std::vector<std::size_t>& corners() const { return m_corners; }

  std::size_t next(const std::size_t s) const { return s + 1 == m_corners.size() ? 0 : s + 1; }
  std::size_t previous(const std::size_t s) const { return (s == 0 ? m_corners.size() : s) - 1; }

  // Whether the gauge is finite in sector `s`, from that corner to the next one.
  bool is_finite(const std::size_t s) const
  {
    return sine(m_corners[s], m_corners[next(s)]) > SMALLEST_SINE;
  }

  // The gauge in a sector, as a vector to be multiplied by. \pre It is finite.
  Plane_vector functional(const std::size_t s) const
  {
    const std::size_t i = m_corners[s], k = m_corners[next(s)];
    const Plane_vector a = m_directions[i], b = m_directions[k];
    const double determinant = sine(i, k);
    return {(m_costs[i] * b.y - m_costs[k] * a.y) / determinant,
            (m_costs[k] * a.x - m_costs[i] * b.x) / determinant};
  }

  // How much too large the gauge can be in a sector, relatively. If costs are those of a convex
  // gauge, they are not below what the neighboring sectors continue to, and a bridge is a flat
  // piece that they share with the gauge. If not, nothing follows from bridges: costs beside and
  // below their ends may continue as they come from outside. What is assumed is always the larger
  // error of these, so that it is valid in the first case. The gauge is taken to be right beside
  // directions without end.
  double error(const std::size_t s) const
  {
    if(is_bridge(s))
      return (std::max)(error_at_start(s), error_at_end(s));
    const bool follows_bridge = is_bridge(previous(s)), precedes_bridge = is_bridge(next(s));
    if(follows_bridge != precedes_bridge)
      return follows_bridge ? error_at_end(s) : error_at_start(s);
    const double at_start = drop_at_start(s), at_end = drop_at_end(s);
    return at_start > 0 && at_end > 0 ? error_of_drop(1 / (1 / at_start + 1 / at_end)) : 0;
  }

  // Whether directions were given inside a sector, where zigzags between its corners cost no more.
  bool is_bridge(const std::size_t s) const
  {
    return (m_corners[s] + 1) % m_directions.size() != m_corners[next(s)];
  }

  // The error if costs continue from the first corner on as they come there, up to the next
  // direction that was given.
  double error_at_start(const std::size_t s) const { return error_of_drop(drop_at_start(s)); }

  // ... in the opposite direction, from the other corner on
  double error_at_end(const std::size_t s) const { return error_of_drop(drop_at_end(s)); }

  // the direction before the one with the number `i`
  std::size_t before(const std::size_t i) const { return (i == 0 ? m_directions.size() : i) - 1; }

private:
  // By which part of itself the gauge drops to what the sector before continues to.
  double drop_at_start(const std::size_t s) const
  {
    return drop(s, previous(s), m_directions[(m_corners[s] + 1) % m_directions.size()]);
  }

  double drop_at_end(const std::size_t s) const
  {
    return drop(s, next(s), m_directions[before(m_corners[next(s)])]);
  }

  double drop(const std::size_t s, const std::size_t other, const Plane_vector d) const
  {
    if(!is_finite(s) || !is_finite(other))
      return 0;
    const double largest = dot(functional(s), d), smallest = dot(functional(other), d);
    if(!(largest > smallest))
      return 0;
    return largest > 0 ? 1 - smallest / largest : std::numeric_limits<double>::infinity();
  }

  static double error_of_drop(const double drop)
  {
    return drop < 1 ? drop / (1 - drop) : std::numeric_limits<double>::infinity();
  }

  double sine(const std::size_t i, const std::size_t k) const
  {
    return cross(m_directions[i], m_directions[k]);
  }

  // Graham's scan, from a corner on.
  void scan(std::vector<std::size_t> finite)
  {
    const bool is_closed = start_with_corner(finite);
    if(is_closed)
      finite.push_back(finite.front());
    for(const std::size_t k : finite)
    {
      while(m_corners.size() >= 2 &&
            is_needless(m_corners[m_corners.size() - 2], m_corners.back(), k))
        m_corners.pop_back();
      m_corners.push_back(k);
    }
    if(is_closed)
      m_corners.pop_back();
    std::rotate(m_corners.begin(), std::min_element(m_corners.begin(), m_corners.end()),
                m_corners.end());
  }

  // Brings a corner to the front: what follows a gap of half a circle, or else the cheapest
  // direction. Returns whether there is no gap.
  bool start_with_corner(std::vector<std::size_t>& finite) const
  {
    for(std::size_t i = 0; i < finite.size(); ++i)
    {
      const std::size_t before = finite[(i == 0 ? finite.size() : i) - 1];
      if(!(sine(before, finite[i]) > SMALLEST_SINE))
      {
        std::rotate(finite.begin(), finite.begin() + std::ptrdiff_t(i), finite.end());
        return false;
      }
    }
    std::rotate(finite.begin(),
                std::min_element(finite.begin(), finite.end(),
                                 [this](const std::size_t i, const std::size_t j) {
                                   return m_costs[i] < m_costs[j];
                                 }),
                finite.end());
    return true;
  }

  // Whether going in directions `i` and `k` in turn costs no more than going in direction `j`.
  bool is_needless(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    constexpr double rounding = 1e-12; // lest it depends on where the scan starts
    if(!(sine(i, k) > SMALLEST_SINE))
      return false;
    return m_costs[j] * sine(i, k) >=
           (1 - rounding) * (m_costs[i] * sine(j, k) + m_costs[k] * sine(i, j));
  }

  const std::vector<Plane_vector>& m_directions;
  const std::vector<double>& m_costs;
  std::vector<std::size_t> m_corners;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H
