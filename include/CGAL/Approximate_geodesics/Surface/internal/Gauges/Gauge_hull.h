// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

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
  using Id = std::size_t; // of a direction, in the order of insertion

  // Two directions with a smaller sine between them make no sector.
  static constexpr double SMALLEST_SINE = 1e-9;

  // A direction, and if that is a corner of the hull, the sector from there to the next corner.
  struct Direction
  {
    Plane_vector vector; // of length 1
    double cost;
    Id next, previous; // counterclockwise and clockwise
    bool is_corner;
    bool is_listed; // whether its sector is to be computed
    Id next_corner, previous_corner;
    bool is_finite;          // whether the gauge is, in the sector
    bool is_bridge;          // whether directions were given inside, where zigzags cost no more
    Plane_vector functional; // the gauge, as a vector to be multiplied by, if it is finite
    double error_at_start;   // how much too large the gauge can be, relatively, before the first
    double error_at_end;     // direction inside and behind the last one; the same if there is none

    double error() const { return (std::max)(error_at_start, error_at_end); }
  };

  void clear()
  {
    m_directions.clear();
    m_changed.clear();
    m_some_corner = null_id;
  }

  std::size_t number_of_directions() const { return m_directions.size(); }
  const Direction& operator[](const Id i) const { return m_directions[i]; }

  // Adds a direction between `i` and the next one, unless it is the first of all. Takes constant
  // time for each corner that is none any more, and for each direction inside the sector.
  Id insert(const Id i, const Plane_vector v, const double cost)
  {
    const Id m = link(i, v, cost);
    const bool is_finite = cost < std::numeric_limits<double>::infinity();
    if(m_some_corner == null_id)
    {
      if(is_finite)
        make_corner(m, m, m);
      return m;
    }
    Id c = m_directions[m].previous;
    while(!m_directions[c].is_corner)
      c = m_directions[c].previous;
    const Id k = m_directions[c].next_corner;
    list(c);
    if(is_finite && !is_needless(c, m, k))
    {
      make_corner(m, c, k);
      remove_needless_neighbors(m);
    }
    return m;
  }

  // Computes what has changed since the last call, and calls `f(c)` for the corners whose sectors
  // have errors that are new.
  template <typename F>
  void update(F f)
  {
    for(const Id c : m_changed)
      compute_sector(c);
    const std::size_t number = m_changed.size();
    for(std::size_t i = 0; i < number; ++i)
      if(const Id c = m_changed[i]; m_directions[c].is_corner)
      {
        list(m_directions[c].previous_corner);
        list(m_directions[c].next_corner);
      }
    for(const Id c : m_changed)
    {
      m_directions[c].is_listed = false;
      if(!m_directions[c].is_corner)
        continue;
      estimate_errors(c);
      f(c);
    }
    m_changed.clear();
  }

private:
  static constexpr Id null_id = std::numeric_limits<Id>::max();

  // ----- corners

  Id link(const Id i, const Plane_vector v, const double cost)
  {
    const Id m = m_directions.size();
    Direction d{};
    d.vector = v;
    d.cost = cost;
    d.previous = m == 0 ? m : i;
    d.next = m == 0 ? m : m_directions[i].next;
    m_directions.push_back(d);
    m_directions[d.previous].next = m_directions[d.next].previous = m;
    return m;
  }

  // ... between two others
  void make_corner(const Id m, const Id previous, const Id next)
  {
    m_directions[m].is_corner = true;
    m_directions[m].next_corner = next;
    m_directions[m].previous_corner = previous;
    m_directions[previous].next_corner = m_directions[next].previous_corner = m;
    m_some_corner = m;
    list(m);
  }

  void remove_needless_neighbors(const Id m)
  {
    const auto remove = [&](const Id j) {
      const Id i = m_directions[j].previous_corner, k = m_directions[j].next_corner;
      m_directions[j].is_corner = false;
      m_directions[i].next_corner = k;
      m_directions[k].previous_corner = i;
      list(i);
    };
    for(Id k; (k = m_directions[m].next_corner) != m_directions[m].previous_corner &&
              is_needless(m, k, m_directions[k].next_corner);)
      remove(k);
    for(Id k; (k = m_directions[m].previous_corner) != m_directions[m].next_corner &&
              is_needless(m_directions[k].previous_corner, k, m);)
      remove(k);
  }

  // Whether going in directions `i` and `k` in turn costs no more than going in direction `j`.
  bool is_needless(const Id i, const Id j, const Id k) const
  {
    constexpr double rounding = 1e-12; // so that the order of insertion does not matter
    const Direction &a = m_directions[i], &b = m_directions[j], &c = m_directions[k];
    const double sine = cross(a.vector, c.vector);
    return sine > SMALLEST_SINE &&
           b.cost * sine >= (1 - rounding) * (a.cost * cross(b.vector, c.vector) +
                                              c.cost * cross(a.vector, b.vector));
  }

  // ----- sectors

  // Notes that the sector at a corner is another one.
  void list(const Id c)
  {
    if(m_directions[c].is_listed)
      return;
    m_directions[c].is_listed = true;
    m_changed.push_back(c);
  }

  void compute_sector(const Id c)
  {
    Direction& s = m_directions[c];
    if(!s.is_corner)
      return;
    const Direction& end = m_directions[s.next_corner];
    const double sine = cross(s.vector, end.vector);
    s.is_finite = sine > SMALLEST_SINE;
    s.is_bridge = s.next != s.next_corner;
    if(s.is_finite)
      s.functional = {(s.cost * end.vector.y - end.cost * s.vector.y) / sine,
                      (end.cost * s.vector.x - s.cost * end.vector.x) / sine};
  }

  // If costs are those of a convex gauge, they are not below what the neighboring sectors continue
  // to, and a bridge is a flat piece that they share with the gauge. If not, nothing follows from
  // bridges: costs beside and below their ends may continue as they come from outside. What is
  // assumed is always the larger error of these, so that it is valid in the first case. The gauge
  // is taken to be right beside directions without end.
  void estimate_errors(const Id c)
  {
    Direction& s = m_directions[c];
    s.error_at_start = s.error_at_end = 0;
    if(!s.is_finite)
      return;
    const Direction& before = m_directions[s.previous_corner];
    const Direction& behind = m_directions[s.next_corner];
    const double at_start = drop(s, before, m_directions[s.next].vector);
    const double at_end = drop(s, behind, m_directions[behind.previous].vector);
    if(s.is_bridge)
    {
      s.error_at_start = error_of_drop(at_start);
      s.error_at_end = error_of_drop(at_end);
    }
    else if(before.is_bridge != behind.is_bridge)
      s.error_at_start = s.error_at_end = error_of_drop(before.is_bridge ? at_end : at_start);
    else if(at_start > 0 && at_end > 0)
    {
      const double sum = 1 / at_start + 1 / at_end; // zero if both are infinite
      s.error_at_start = s.error_at_end = error_of_drop(sum > 0 ? 1 / sum : at_start);
    }
  }

  // By which part of itself the gauge of a finite sector drops in the direction `d` to what another
  // sector continues to.
  static double drop(const Direction& sector, const Direction& other, const Plane_vector d)
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

  std::vector<Direction> m_directions;
  std::vector<Id> m_changed; // corners whose sectors are to be computed
  Id m_some_corner = null_id;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_HULL_H
