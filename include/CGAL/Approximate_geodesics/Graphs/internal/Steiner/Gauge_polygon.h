// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GAUGE_POLYGON_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GAUGE_POLYGON_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A gauge whose unit ball is a polygon: how far apart directions may be in the corners of a face.
 *
 * In a corner with the sides `a` and `b`, where a path goes from the point `z a` to `w b` or back,
 * its direction is a function of the logarithm of `w / z`. Between any two directions whose
 * logarithms differ by at most `step()`, the gauge is not below its chord by more than the given
 * relative error. So `step()` is the largest logarithm of the ratio of the distances of neighbors
 * from the corner.
 */
class Gauge_polygon
{
public:
  // The largest value of `step()`.
  static constexpr double LARGEST_STEP = 40;

  // Copies the polygon of the face to the left of `h`. If its gauge has a formula, it is sampled so
  // that the relative error is about `epsilon`. Returns a bound of this error.
  double assign(const Intrinsic_triangulation& triangulation,
                const Index h,
                const double epsilon,
                Gauge_samples& samples)
  {
    const Face_gauges& gauges = triangulation.gauges();
    const Index face = gauges.face(h);
    if(!gauges.has_formula(face))
    {
      assign(gauges, face);
      return 0; // the graph has the costs of the polygon
    }
    std::array<Plane_vector, 3> sides;
    const auto halfedges = triangulation.halfedges_of_face(h);
    std::transform(halfedges.begin(), halfedges.end(), sides.begin(),
                   [&](const Index g) { return gauges.side(g); });
    samples.sample(sides, epsilon, gauges.formula(face));
    assign(samples.hull());
    return samples.hull().largest_error();
  }

  // Copies the polygon of a face without a formula.
  void assign(const Face_gauges& gauges, const Index face)
  {
    m_sectors.assign(gauges.first_sector(face), gauges.beyond_sector(face));
  }

  // Copies the polygon of a hull.
  void assign(const Gauge_hull& hull)
  {
    m_sectors.clear();
    Face_gauges::append_sectors(hull, m_sectors);
  }

  // Returns whether no direction is free or forbidden.
  bool is_bounded() const
  {
    return !m_sectors.empty() && std::all_of(m_sectors.begin(), m_sectors.end(), [](const auto& s) {
      return s.is_finite() && dot(s.functional, s.direction) > 0;
    });
  }

  // Returns whether all directions cost nothing.
  bool is_free() const
  {
    return !m_sectors.empty() && std::all_of(m_sectors.begin(), m_sectors.end(), [](const auto& s) {
      return s.functional.x == 0 && s.functional.y == 0;
    });
  }

  // Returns the smallest cost per unit of length; infinity if all directions are forbidden.
  double smallest() const
  {
    double result = infinity;
    for(std::size_t i = 0; i < m_sectors.size(); ++i)
      if(m_sectors[i].is_finite())
        for(const Plane_vector d : {m_sectors[i].direction, cyclic_sector(i + 1).direction})
          result = (std::min)(result, (std::max)(dot(m_sectors[i].functional, d), 0.));
    return result;
  }

  // Returns the step for a corner whose sides have the directions `a` and, to the left, `b`.
  // \pre The gauge is bounded.
  double step(const Plane_vector a, const Plane_vector b, const double error)
  {
    if(!(cross(a, b) > 0))
      return 0;
    return (std::min)(step(a, b, b, error), step(a, b, -1 * b, error));
  }

private:
  using Sector = Face_gauges::Sector;

  // A direction, the number of sectors from the first one to its own, and the ratio `w / z`.
  struct Knot
  {
    Plane_vector direction;
    std::size_t sector;
    double ratio;
  };

  // The step of the directions from `start` to the left, until that of a side. They are looked at
  // in equal parts of their angle, which are refined until they are small beside the steps.
  double
  step(const Plane_vector a, const Plane_vector b, const Plane_vector start, const double error)
  {
    constexpr std::size_t first_number = 32, largest_number = 8192;
    constexpr double parts_of_interval = 12;
    const double angle = std::atan2(cross(a, b), -dot(a, b)); // beside that of the corner
    double result = 0;
    for(std::size_t number = first_number; number <= largest_number;)
    {
      list_knots(a, b, start, angle, number);
      const auto [step, interval] = step_between_knots(error);
      result = (std::max)(result, step);
      const double needed = interval > 0 ? parts_of_interval * angle / interval : infinity;
      if(double(number) >= needed)
        break;
      number = (std::max)(2 * number,
                          static_cast<std::size_t>((std::min)(needed, double(largest_number))));
    }
    return (std::min)(result, LARGEST_STEP);
  }

  // Lists `number + 1` directions, and the corners of the polygon between them.
  void list_knots(const Plane_vector a,
                  const Plane_vector b,
                  const Plane_vector start,
                  const double angle,
                  const std::size_t number)
  {
    const double part = angle / double(number);
    const Plane_vector turn{std::cos(part), std::sin(part)};
    std::size_t i = sector(start);
    m_knots.clear();
    const auto add = [&](const Plane_vector d) {
      const double to_a = std::abs(cross(a, d)), to_b = std::abs(cross(b, d)); // may be rounded
      m_knots.push_back({d, i, to_b > 0 ? to_a / to_b : infinity});
    };
    Plane_vector d = start;
    for(std::size_t k = 0; k <= number; ++k, d = turned_left(d, turn))
    {
      while(cross(cyclic_sector(i + 1).direction, d) > 0)
        add(cyclic_sector(++i).direction);
      add(d);
    }
    m_knots.front().ratio = infinity; // not rounded
    m_knots.back().ratio = 0;
  }

  // Returns the largest step such that each interval of this size is in one between two knots that
  // is flat, and the smallest angle of a flat interval that cannot be extended.
  std::pair<double, double> step_between_knots(const double error) const
  {
    double ratio = infinity, smallest_sine = 1;
    std::size_t last = 1;
    for(std::size_t k = 0; k + 1 < m_knots.size(); ++k)
    {
      last = (std::max)(last, k + 1);
      while(last + 1 < m_knots.size() && is_flat(k, last + 1, error))
        ++last;
      if(last + 1 == m_knots.size())
        break;
      ratio = (std::min)(ratio, m_knots[k + 1].ratio / m_knots[last].ratio);
      if(dot(m_knots[k].direction, m_knots[last].direction) > 0)
        smallest_sine =
            (std::min)(smallest_sine, cross(m_knots[k].direction, m_knots[last].direction));
    }
    return {std::log((std::max)(ratio, 1.)), smallest_sine};
  }

  // Returns whether the gauge is close to its chord between two knots. The chord is highest above
  // it, relatively, at the corner where the functional of the sector passes that of the chord.
  bool is_flat(const std::size_t first, const std::size_t last, const double error) const
  {
    const Knot &a = m_knots[first], &b = m_knots[last];
    const double sine = cross(a.direction, b.direction);
    if(!(sine > 0)) // rounded
      return last == first + 1;
    const double at_a = dot(cyclic_sector(a.sector).functional, a.direction);
    const double at_b = dot(cyclic_sector(b.sector).functional, b.direction);
    const Plane_vector chord{(at_a * b.direction.y - at_b * a.direction.y) / sine,
                             (at_b * a.direction.x - at_a * b.direction.x) / sine};
    std::size_t low = a.sector, high = b.sector;
    while(low < high)
    {
      const std::size_t middle = (low + high) / 2;
      if(cross(cyclic_sector(middle).functional, chord) > 0)
        low = middle + 1;
      else
        high = middle;
    }
    const Sector& corner = cyclic_sector(low);
    return low == a.sector ||
           dot(chord, corner.direction) <= (1 + error) * dot(corner.functional, corner.direction);
  }

  // Returns a sector, counted from the first one and around at most twice.
  const Sector& cyclic_sector(const std::size_t i) const
  {
    return m_sectors[i < m_sectors.size() ? i : i - m_sectors.size()];
  }

  std::size_t sector(const Plane_vector d) const
  {
    std::size_t i = 0;
    while(i + 1 < m_sectors.size() &&
          !(cross(m_sectors[i].direction, d) >= 0 && cross(cyclic_sector(i + 1).direction, d) < 0))
      ++i;
    return i;
  }

  std::vector<Sector> m_sectors;
  std::vector<Knot> m_knots;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GAUGE_POLYGON_H
