// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_SAMPLES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_SAMPLES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Gauge_hull.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Directions in the plane of a face, and what a function says they cost: so many that the hull of
 * these costs is close to the function, if that is convex. With each direction comes the opposite
 * one, and costs in the opposite directions lead to the opposite directions.
 */
class Gauge_samples
{
public:
  // no directions are added to this number
  static constexpr std::size_t LARGEST_NUMBER = 2048;

  Gauge_samples()
  {
    constexpr double half_circle = 3.14159265358979323846;
    for(int i = 1; i < FIRST_NUMBER; ++i)
    {
      const double angle = half_circle * i / FIRST_NUMBER;
      m_equal_parts.push_back({std::cos(angle), std::sin(angle)});
    }
  }

  // Starts with the directions of the sides of the face, the first of which is the x axis. `cost`
  // is called with a unit vector. What was sampled before is forgotten.
  template <typename Cost>
  void sample(const std::array<Plane_vector, 3>& sides, const double tolerance, const Cost& cost)
  {
    set_first_directions(sides);
    m_hull.clear();
    Id last = 0;
    for(const Plane_vector d : m_first)
      last = ask(last, d, cost);
    do
      find_wide_gaps(tolerance);
    while(m_hull.number_of_directions() < LARGEST_NUMBER && refine(cost));
  }

  // the hull of the costs in all directions, the first of which is the x axis
  const Gauge_hull& hull() const { return m_hull; }

private:
  using Id = Gauge_hull::Id;

  static constexpr int FIRST_NUMBER = 8;        // of directions in half a circle
  static constexpr double SMALLEST_SINE = 1e-5; // between directions
  static constexpr double SMALLEST_GAP = 0.002; // where one side of it has infinite cost

  // Those of the sides take the places of others that are near.
  void set_first_directions(const std::array<Plane_vector, 3>& sides)
  {
    constexpr double near = 0.02, same = 1e-6;
    m_first.assign(1, {1, 0});
    for(Plane_vector side : {sides[1], sides[2]})
    {
      side = side.y < 0 ? -1 * side : side;
      if(is_apart(side, same))
        m_first.push_back(side);
    }
    for(const Plane_vector d : m_equal_parts)
      if(is_apart(d, near))
        m_first.push_back(d);
    std::sort(m_first.begin(), m_first.end(),
              [](const Plane_vector a, const Plane_vector b) { return cross(a, b) > 0; });
  }

  bool is_apart(const Plane_vector d, const double angle) const
  {
    return std::all_of(m_first.begin(), m_first.end(),
                       [&](const Plane_vector v) { return std::abs(cross(v, d)) > angle; });
  }

  // Opposite directions follow each other in the order of insertion.
  static Id opposite(const Id i) { return i ^ 1; }

  // Inserts a direction of the first half circle behind `i`, and the opposite one. Returns the
  // former.
  template <typename Cost>
  Id ask(const Id i, const Plane_vector d, const Cost& cost)
  {
    const Plane_vector back = -1 * d;
    const double there_cost = cost(d), back_cost = cost(back);
    const Id result = m_hull.insert(i, d, there_cost);
    m_hull.insert(result == 0 ? result : opposite(i), back, back_cost);
    return result;
  }

  // Asks between directions that are too far apart. Returns whether there are any.
  template <typename Cost>
  bool refine(const Cost& cost)
  {
    const std::size_t number = m_hull.number_of_directions();
    for(Id i = 0; i != opposite(0);)
    {
      const Id next = m_hull[i].next;
      if(m_is_wide[i])
      {
        const Plane_vector sum = m_hull[i].vector + m_hull[next].vector;
        ask(i, 1 / length(sum) * sum, cost);
      }
      i = next;
    }
    return m_hull.number_of_directions() > number;
  }

  void find_wide_gaps(const double tolerance)
  {
    m_is_wide.assign(m_hull.number_of_directions(), false);
    m_hull.update([&](const Id c) {
      const Gauge_hull::Direction& sector = m_hull[c];
      const Id last = m_hull[sector.next_corner].previous;
      if(sector.error_at_start > tolerance)
        widen(c, SMALLEST_SINE);
      if(sector.error_at_end > tolerance)
        widen(last, SMALLEST_SINE);
      if(!sector.is_finite)
        // where directions with finite costs end is somewhere between the last one and the next
        for(const Id i : {c, last})
          if(std::isinf(m_hull[i].cost) != std::isinf(m_hull[m_hull[i].next].cost))
            widen(i, SMALLEST_GAP);
    });
  }

  // Marks the gap behind a direction in the first half circle, or behind the opposite one, if it is
  // not too small.
  void widen(const Id i, const double smallest)
  {
    const double sine = cross(m_hull[i].vector, m_hull[m_hull[i].next].vector);
    if(sine > smallest)
      m_is_wide[i % 2 == 0 ? i : opposite(i)] = true;
  }

  std::vector<Plane_vector> m_equal_parts; // directions that divide half a circle
  std::vector<Plane_vector> m_first;       // directions to start with, from the x axis on
  std::vector<char> m_is_wide;             // by direction, whether to ask between it and the next
  Gauge_hull m_hull;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_SAMPLES_H
