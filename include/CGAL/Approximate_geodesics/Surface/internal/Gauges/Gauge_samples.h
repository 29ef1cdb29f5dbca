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
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Directions in the plane of a face, and what a function says they cost: so many that the hull of
 * these costs is close to the function, if that is convex. With each direction comes the opposite
 * one, and costs in the opposite directions lead to the opposite directions.
 */
class Gauge_samples
{
public:
  // there are no more directions than so
  static constexpr std::size_t LARGEST_NUMBER = 2048;

  // Starts with the directions of the sides of the face, the first of which is the x axis. `cost`
  // is called with a unit vector.
  template <typename Cost>
  Gauge_samples(const std::array<Plane_vector, 3>& sides, const double tolerance, const Cost& cost)
  {
    set_first_directions(sides);
    ask(cost);
    while(2 * m_half.size() < LARGEST_NUMBER && refine(tolerance))
      ask(cost);
  }

  // all around, counterclockwise
  const std::vector<Plane_vector>& directions() const { return m_directions; }
  const std::vector<double>& costs() const { return m_costs; }

private:
  struct Sample
  {
    Plane_vector direction;
    bool is_known;
    double cost, cost_back;
  };

  static constexpr int FIRST_NUMBER = 8;        // of directions in half a circle
  static constexpr double SMALLEST_SINE = 1e-5; // between directions
  static constexpr double SMALLEST_GAP = 0.002; // where one side of it has infinite cost

  // Those of the sides take the places of others that are near.
  void set_first_directions(const std::array<Plane_vector, 3>& sides)
  {
    constexpr double near = 0.02, same = 1e-6, half_circle = 3.14159265358979323846;
    add({1, 0});
    for(Plane_vector side : {sides[1], sides[2]})
    {
      side = side.y < 0 ? -1 * side : side;
      if(is_apart(side, same))
        add(side);
    }
    for(int i = 1; i < FIRST_NUMBER; ++i)
    {
      const double angle = half_circle * i / FIRST_NUMBER;
      const Plane_vector d{std::cos(angle), std::sin(angle)};
      if(is_apart(d, near))
        add(d);
    }
    std::sort(m_half.begin(), m_half.end(),
              [](const Sample& a, const Sample& b) { return cross(a.direction, b.direction) > 0; });
  }

  bool is_apart(const Plane_vector d, const double angle) const
  {
    return std::all_of(m_half.begin(), m_half.end(),
                       [&](const Sample& s) { return std::abs(cross(s.direction, d)) > angle; });
  }

  void add(const Plane_vector d) { m_half.push_back({d, false, 0, 0}); }

  template <typename Cost>
  void ask(const Cost& cost)
  {
    const std::size_t number = m_half.size();
    m_directions.resize(2 * number);
    m_costs.resize(2 * number);
    for(std::size_t i = 0; i < number; ++i)
    {
      Sample& s = m_half[i];
      const Plane_vector back = -1 * s.direction;
      if(!s.is_known)
        s = {s.direction, true, cost(s.direction), cost(back)};
      m_directions[i] = s.direction;
      m_directions[number + i] = back;
      m_costs[i] = s.cost;
      m_costs[number + i] = s.cost_back;
    }
  }

  // Adds directions between those that are too far apart. Returns whether there are any.
  bool refine(const double tolerance)
  {
    const std::size_t number = m_half.size();
    std::vector<bool> is_wide(number); // between the direction and the next one, or opposite to it
    const Gauge_hull hull(m_directions, m_costs);
    for(std::size_t s = 0; s < hull.corners().size(); ++s)
    {
      const std::size_t i = hull.corners()[s], k = hull.before(hull.corners()[hull.next(s)]);
      const bool is_bridge = hull.is_bridge(s);
      if((is_bridge ? hull.error_at_start(s) : hull.error(s)) > tolerance)
        is_wide[i % number] = sine_to_next(i) > SMALLEST_SINE || is_wide[i % number];
      if(is_bridge && hull.error_at_end(s) > tolerance)
        is_wide[k % number] = sine_to_next(k) > SMALLEST_SINE || is_wide[k % number];
    }
    find_ends(hull, is_wide);

    std::vector<Sample> refined;
    for(std::size_t i = 0; i < number; ++i)
    {
      refined.push_back(m_half[i]);
      if(!is_wide[i])
        continue;
      const Plane_vector sum = m_directions[i] + m_directions[i + 1];
      refined.push_back({1 / length(sum) * sum, false, 0, 0});
    }
    m_half.swap(refined);
    return m_half.size() > number;
  }

  // Where directions with finite costs end is somewhere between the last one and the next.
  void find_ends(const Gauge_hull& hull, std::vector<bool>& is_wide) const
  {
    const std::size_t number = m_half.size();
    const auto look = [&](const std::size_t i, const std::size_t k, const std::size_t first) {
      if(std::isinf(m_costs[i]) != std::isinf(m_costs[k]) && sine_to_next(first) > SMALLEST_GAP)
        is_wide[first % number] = true;
    };
    for(std::size_t s = 0; s < hull.corners().size(); ++s)
    {
      const std::size_t last = hull.corners()[s], first = hull.corners()[hull.next(s)];
      if(hull.is_finite(s))
        continue;
      look(last, (last + 1) % (2 * number), last);
      const std::size_t before = (first == 0 ? 2 * number : first) - 1;
      look(before, first, before);
    }
  }

  double sine_to_next(const std::size_t i) const
  {
    return cross(m_directions[i], m_directions[(i + 1) % m_directions.size()]);
  }

  std::vector<Sample> m_half; // from the x axis on, by angle
  std::vector<Plane_vector> m_directions;
  std::vector<double> m_costs;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_SAMPLES_H
