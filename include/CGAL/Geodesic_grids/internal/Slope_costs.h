// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_SLOPE_COSTS_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_SLOPE_COSTS_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Costs per unit of horizontal length by slope, in classes of 1/2000, between which they are
 * interpolated.
 *
 * A slope `s` can be climbed in zigzags of any slope `t` between 0 and `s`, which are `s / t` times
 * as long. So the cost is the smallest `s / t * f(t)`. If `f` is convex, this is the largest convex
 * gauge below the costs of any plane; and where costs are convex, interpolation makes them larger,
 * not smaller.
 *
 * Without a function, costs are lengths on the surface.
 */
class Slope_costs
{
public:
  static constexpr double CLASSES_PER_UNIT = 2000;
  static constexpr double STEEPEST_CLASS = 4; // beyond, costs are proportional to the slope

  // lengths
  Slope_costs() = default;

  // `f(slope)` is the cost per unit of length on the surface, in the direction of the search.
  template <typename F>
  explicit Slope_costs(const F& f)
  {
    constexpr auto number = static_cast<std::size_t>(CLASSES_PER_UNIT * STEEPEST_CLASS);
    m_costs.resize(2 * number + 1);
    m_costs[number] = checked(f(0.), 0);
    add_side(f, 1, number);
    add_side(f, -1, number);
    for(std::size_t i = 1; i + 1 < m_costs.size(); ++i)
      m_is_convex =
          m_is_convex && !(m_costs[i] > (m_costs[i - 1] + m_costs[i + 1]) / 2 * (1 + 1e-12));
    m_smallest = *std::min_element(m_costs.begin(), m_costs.end());
  }

  // Returns the costs of the opposite direction.
  Slope_costs reversed() const
  {
    Slope_costs result = *this;
    std::reverse(result.m_costs.begin(), result.m_costs.end());
    return result;
  }

  double operator()(const double slope) const
  {
    if(m_costs.empty())
      return std::sqrt(1 + slope * slope);
    constexpr double end = CLASSES_PER_UNIT * STEEPEST_CLASS;
    const double x = slope * CLASSES_PER_UNIT;
    if(!(std::abs(x) < end))
      return std::abs(x) / end * (x > 0 ? m_costs.back() : m_costs.front());
    const auto i = static_cast<std::size_t>(x + end);
    const double part = x + end - static_cast<double>(i), step = m_costs[i + 1] - m_costs[i];
    if(!(std::abs(step) < infinity)) // next to, or among, slopes that cannot be climbed
      return part == 0 ? m_costs[i] : infinity;
    return m_costs[i] + part * step;
  }

  // Returns a lower bound of the cost of any profile with this mean slope.
  double lower_bound(const double slope) const { return m_is_convex ? (*this)(slope) : m_smallest; }

  // Returns the smallest cost.
  double smallest() const { return m_smallest; }

  // Returns the largest relative error of interpolation, as far as a few slopes in each class show.
  double error() const { return m_error; }

  std::size_t memory() const { return memory_of(m_costs); }

private:
  static constexpr std::size_t SAMPLES_PER_CLASS = 4;

  static double checked(const double cost, const double slope)
  {
    if(!(cost >= 0))
      reject("the cost function returns " + text_of(cost) + " for the slope " + text_of(slope) +
             "; it must be a number that is not negative, or infinity");
    return cost;
  }

  template <typename F>
  void add_side(const F& f, const int sign, const std::size_t number)
  {
    double smallest_climb = infinity; // per unit of height
    std::vector<double> between;      // costs of the samples in a class
    double last = m_costs[number];
    for(std::size_t i = 1; i <= SAMPLES_PER_CLASS * number; ++i)
    {
      const double slope = static_cast<double>(i) / (SAMPLES_PER_CLASS * CLASSES_PER_UNIT);
      const double straight = checked(f(sign * slope), sign * slope) * std::sqrt(1 + slope * slope);
      smallest_climb = (std::min)(smallest_climb, straight / slope);
      const double cost = (std::min)(straight, smallest_climb * slope);
      between.push_back(cost);
      if(i % SAMPLES_PER_CLASS != 0)
        continue;
      const std::size_t k = i / SAMPLES_PER_CLASS;
      m_costs[sign > 0 ? number + k : number - k] = cost;
      measure(last, between);
      last = cost;
      between.clear();
    }
  }

  void measure(const double first, const std::vector<double>& costs)
  {
    const double last = costs.back();
    for(std::size_t i = 0; i < costs.size(); ++i)
    {
      if(costs[i] == 0) // there is no ratio
        continue;
      const double part = static_cast<double>(i + 1) / static_cast<double>(costs.size());
      const double error = std::abs((first + part * (last - first)) / costs[i] - 1);
      if(error < infinity) // nor if a cost is infinite
        m_error = (std::max)(m_error, error);
    }
  }

  std::vector<double> m_costs; // by class, from the steepest descent on; empty for lengths
  bool m_is_convex = true;
  double m_smallest = 1;
  double m_error = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_SLOPE_COSTS_H
