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
#include <utility>
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

  // The directions from one corner of the hull to the next.
  struct Sector
  {
    std::size_t corner; // the number of the direction that it starts from
    bool is_finite;
    bool
        is_bridge; // whether directions were given inside, where zigzags between the ends cost less
    Plane_vector functional; // the gauge, as a vector to be multiplied by, if it is finite
    double error_at_start;   // how much too large the gauge can be, relatively, before the first
    double error_at_end;     // direction inside and behind the last one; the same if there is none

    double error() const { return (std::max)(error_at_start, error_at_end); }
  };

  // Computes the hull of other costs than before. The directions are unit vectors in
  // counterclockwise order, all around, and `sines` are those between each and the next one.
  void compute(const std::vector<Plane_vector>& directions,
               const std::vector<double>& sines,
               const std::vector<double>& costs)
  {
    m_directions = directions.data();
    m_sines = sines.data();
    m_costs = costs.data();
    m_number = directions.size();
    find_corners();
    find_sectors();
    estimate_errors();
  }

  // Ascending; none if all costs are infinite.
  const std::vector<Sector>& sectors() const { return m_sectors; }

  std::size_t next_sector(const std::size_t s) const
  {
    return s + 1 == m_sectors.size() ? 0 : s + 1;
  }
  std::size_t previous_sector(const std::size_t s) const
  {
    return (s == 0 ? m_sectors.size() : s) - 1;
  }

  // directions beside the one with the number `i`
  std::size_t next(const std::size_t i) const { return i + 1 == m_number ? 0 : i + 1; }
  std::size_t previous(const std::size_t i) const { return (i == 0 ? m_number : i) - 1; }

private:
  double sine(const std::size_t i, const std::size_t k) const
  {
    return next(i) == k ? m_sines[i] : cross(m_directions[i], m_directions[k]);
  }

  // ----- corners

  // Graham's scan, from a corner on.
  void find_corners()
  {
    m_finite.clear();
    m_corners.clear();
    for(std::size_t i = 0; i < m_number; ++i)
      if(m_costs[i] < std::numeric_limits<double>::infinity())
        m_finite.push_back(i);
    if(m_finite.empty())
      return;
    const auto [start, is_closed] = first_corner();
    for(std::size_t i = start; i < m_finite.size(); ++i)
      add_corner(m_finite[i]);
    for(std::size_t i = 0; i < start; ++i)
      add_corner(m_finite[i]);
    if(is_closed)
    {
      add_corner(m_finite[start]);
      m_corners.pop_back();
    }
    std::rotate(m_corners.begin(), std::min_element(m_corners.begin(), m_corners.end()),
                m_corners.end());
  }

  void add_corner(const std::size_t k)
  {
    while(m_corners.size() >= 2 &&
          is_needless(m_corners[m_corners.size() - 2], m_corners.back(), k))
      m_corners.pop_back();
    m_corners.push_back(k);
  }

  // The rank of a finite cost that is a corner: what follows a gap of half a circle, or else the
  // cheapest direction; and whether there is no gap.
  std::pair<std::size_t, bool> first_corner() const
  {
    std::size_t cheapest = 0;
    for(std::size_t i = 0; i < m_finite.size(); ++i)
    {
      if(!(sine(m_finite[(i == 0 ? m_finite.size() : i) - 1], m_finite[i]) > SMALLEST_SINE))
        return {i, false};
      if(m_costs[m_finite[i]] < m_costs[m_finite[cheapest]])
        cheapest = i;
    }
    return {cheapest, true};
  }

  // Whether going in directions `i` and `k` in turn costs no more than going in direction `j`.
  bool is_needless(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    constexpr double rounding = 1e-12; // lest it depends on where the scan starts
    const double sine_of_all = cross(m_directions[i], m_directions[k]);
    if(!(sine_of_all > SMALLEST_SINE))
      return false;
    return m_costs[j] * sine_of_all >=
           (1 - rounding) * (m_costs[i] * sine(j, k) + m_costs[k] * sine(i, j));
  }

  // ----- sectors

  void find_sectors()
  {
    m_sectors.resize(m_corners.size());
    for(std::size_t s = 0; s < m_corners.size(); ++s)
    {
      const std::size_t i = m_corners[s], k = m_corners[next_sector(s)];
      const double sine = this->sine(i, k);
      m_sectors[s] = {i, sine > SMALLEST_SINE, next(i) != k, {0, 0}, 0, 0};
      if(!m_sectors[s].is_finite)
        continue;
      const Plane_vector a = m_directions[i], b = m_directions[k];
      m_sectors[s].functional = {(m_costs[i] * b.y - m_costs[k] * a.y) / sine,
                                 (m_costs[k] * a.x - m_costs[i] * b.x) / sine};
    }
  }

  // If costs are those of a convex gauge, they are not below what the neighboring sectors continue
  // to, and a bridge is a flat piece that they share with the gauge. If not, nothing follows from
  // bridges: costs beside and below their ends may continue as they come from outside. What is
  // assumed is always the larger error of these, so that it is valid in the first case. The gauge
  // is taken to be right beside directions without end.
  void estimate_errors()
  {
    for(std::size_t s = 0; s < m_sectors.size(); ++s)
    {
      Sector& sector = m_sectors[s];
      if(!sector.is_finite)
        continue;
      const Sector &before = m_sectors[previous_sector(s)], &behind = m_sectors[next_sector(s)];
      const double at_start = drop(sector, before, m_directions[next(sector.corner)]);
      const double at_end = drop(sector, behind, m_directions[previous(behind.corner)]);
      if(sector.is_bridge)
      {
        sector.error_at_start = error_of_drop(at_start);
        sector.error_at_end = error_of_drop(at_end);
      }
      else
        sector.error_at_start = sector.error_at_end =
            before.is_bridge != behind.is_bridge
                ? error_of_drop(before.is_bridge ? at_end : at_start)
            : at_start > 0 && at_end > 0 ? error_of_drop(1 / (1 / at_start + 1 / at_end))
                                         : 0;
    }
  }

  // By which part of itself the gauge of a finite sector drops in the direction `d` to what another
  // sector continues to.
  static double drop(const Sector& sector, const Sector& other, const Plane_vector d)
  {
    if(!other.is_finite)
      return 0;
    const double largest = dot(sector.functional, d), smallest = dot(other.functional, d);
    if(!(largest > smallest))
      return 0;
    return largest > 0 ? 1 - smallest / largest : std::numeric_limits<double>::infinity();
  }

  static double error_of_drop(const double drop)
  {
    return drop < 1 ? drop / (1 - drop) : std::numeric_limits<double>::infinity();
  }

  const Plane_vector* m_directions = nullptr;
  const double* m_sines = nullptr;
  const double* m_costs = nullptr;
  std::size_t m_number = 0;
  std::vector<std::size_t> m_finite;  // directions of finite cost
  std::vector<std::size_t> m_corners; // directions that are corners
  std::vector<Sector> m_sectors;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H
