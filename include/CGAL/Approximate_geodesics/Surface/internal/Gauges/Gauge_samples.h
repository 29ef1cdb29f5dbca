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
    ask(cost);
    while(2 * m_half.size() < LARGEST_NUMBER && refine(tolerance))
      ask(cost);
  }

  // all around, counterclockwise
  const std::vector<Plane_vector>& directions() const { return m_directions; }

  // the hull of the costs in these directions
  const Gauge_hull& hull() const { return m_hull; }

private:
  struct Sample
  {
    Plane_vector direction;
    double cost, cost_back;
    bool is_known;
    bool is_wide; // whether to ask in between it and the next one
  };

  static constexpr int FIRST_NUMBER = 8;        // of directions in half a circle
  static constexpr double SMALLEST_SINE = 1e-5; // between directions
  static constexpr double SMALLEST_GAP = 0.002; // where one side of it has infinite cost

  // Those of the sides take the places of others that are near.
  void set_first_directions(const std::array<Plane_vector, 3>& sides)
  {
    constexpr double near = 0.02, same = 1e-6;
    m_half.clear();
    add({1, 0});
    for(Plane_vector side : {sides[1], sides[2]})
    {
      side = side.y < 0 ? -1 * side : side;
      if(is_apart(side, same))
        add(side);
    }
    for(const Plane_vector d : m_equal_parts)
      if(is_apart(d, near))
        add(d);
    std::sort(m_half.begin(), m_half.end(),
              [](const Sample& a, const Sample& b) { return cross(a.direction, b.direction) > 0; });
  }

  bool is_apart(const Plane_vector d, const double angle) const
  {
    return std::all_of(m_half.begin(), m_half.end(),
                       [&](const Sample& s) { return std::abs(cross(s.direction, d)) > angle; });
  }

  void add(const Plane_vector d) { m_half.push_back({d, 0, 0, false, false}); }

  template <typename Cost>
  void ask(const Cost& cost)
  {
    const std::size_t number = m_half.size();
    m_directions.resize(2 * number);
    m_sines.resize(2 * number);
    m_costs.resize(2 * number);
    for(std::size_t i = 0; i < number; ++i)
    {
      Sample& s = m_half[i];
      const Plane_vector back = -1 * s.direction;
      if(!s.is_known)
        s = {s.direction, cost(s.direction), cost(back), true, false};
      m_directions[i] = s.direction;
      m_directions[number + i] = back;
      m_costs[i] = s.cost;
      m_costs[number + i] = s.cost_back;
    }
    for(std::size_t i = 0; i < number; ++i)
      m_sines[i] = m_sines[number + i] = cross(m_directions[i], m_directions[i + 1]);
    m_hull.compute(m_directions, m_sines, m_costs);
  }

  // Adds directions between those that are too far apart. Returns whether there are any.
  bool refine(const double tolerance)
  {
    const std::vector<Gauge_hull::Sector>& sectors = m_hull.sectors();
    for(std::size_t s = 0; s < sectors.size(); ++s)
    {
      if(sectors[s].error_at_start > tolerance)
        widen(sectors[s].corner, SMALLEST_SINE);
      if(sectors[s].error_at_end > tolerance)
        widen(m_hull.previous(sectors[m_hull.next_sector(s)].corner), SMALLEST_SINE);
      if(!sectors[s].is_finite)
        find_ends(sectors[s].corner, sectors[m_hull.next_sector(s)].corner);
    }

    m_refined.clear();
    for(std::size_t i = 0; i < m_half.size(); ++i)
    {
      m_refined.push_back(m_half[i]);
      if(!m_half[i].is_wide)
        continue;
      m_refined.back().is_wide = false;
      const Plane_vector sum = m_directions[i] + m_directions[i + 1];
      m_refined.push_back({1 / length(sum) * sum, 0, 0, false, false});
    }
    m_half.swap(m_refined);
    return m_half.size() > m_refined.size();
  }

  // Marks the gap between a direction and the next one, if it is not too small.
  void widen(const std::size_t i, const double smallest)
  {
    Sample& s = m_half[i < m_half.size() ? i : i - m_half.size()];
    s.is_wide = s.is_wide || m_sines[i] > smallest;
  }

  // Where directions with finite costs end is somewhere between the last one and the next.
  void find_ends(const std::size_t last, const std::size_t first)
  {
    const auto look = [this](const std::size_t i) {
      if(std::isinf(m_costs[i]) != std::isinf(m_costs[m_hull.next(i)]))
        widen(i, SMALLEST_GAP);
    };
    look(last);
    look(m_hull.previous(first));
  }

  std::vector<Plane_vector> m_equal_parts; // directions that divide half a circle
  std::vector<Sample> m_half;              // from the x axis on, by angle
  std::vector<Sample> m_refined;           // to be swapped with these
  std::vector<Plane_vector> m_directions;
  std::vector<double> m_sines; // between each direction and the next one
  std::vector<double> m_costs;
  Gauge_hull m_hull;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_GAUGE_SAMPLES_H
