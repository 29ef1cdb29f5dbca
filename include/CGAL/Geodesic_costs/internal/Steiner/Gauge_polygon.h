// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_POLYGON_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_POLYGON_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/internal/Face_gauges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A gauge whose unit ball is a polygon: how far apart directions may be in the corners of a face,
 * and what is lost where points are rounded to a vertex.
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
    m_is_sampled = gauges.has_formula(face);
    if(!m_is_sampled)
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

  // Returns the smallest cost of a vector from the line through the ends of `a` and `b` to their
  // common origin, or back. It is that of a corner of the polygon.
  // \pre The gauge is bounded, and `b` is to the left of `a`.
  double height(const Plane_vector a, const Plane_vector b) const
  {
    double result = infinity;
    for(const Sector& s : m_sectors)
      if(const double part = std::abs(cross(s.direction, b - a)) / cross(a, b); part > 0)
        result = (std::min)(result, dot(s.functional, s.direction) / part);
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

  // How far the gauge is from being linear between the directions of the sides of a corner and that
  // from the end of one to the end of the other, for `a` and `b` of any lengths.
  struct Bend
  {
    double turn;   // the largest change of its slope along one side
    double excess; // by how much, relatively, its chords are too high at most
  };

  // \pre The gauge is bounded.
  Bend bend(const Plane_vector a, const Plane_vector b) const
  {
    Bend result{0, 0};
    for(const double sign : {1., -1.})
    {
      const Plane_vector start = sign * b, middle = sign * (b - a), end = -sign * a;
      const std::size_t i = sector(start), j = sector(middle), k = sector(end);
      const std::size_t margin = m_is_sampled ? 1 : 0; // the slope of what is sampled is not known
      const auto turn = [&](const std::size_t from, const std::size_t to, const Plane_vector way) {
        return dot(functional(to) - functional(from), way);
      };
      result.turn = (std::max)({result.turn, turn(before(i, margin), j + margin, middle - start),
                                turn(k + margin, before(j, margin), middle - end)});
      result.excess =
          (std::max)({result.excess, excess(start, i, middle, j), excess(middle, j, end, k)});
    }
    return result;
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
    constexpr double parts_of_interval = 24;
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

  // Returns whether the gauge is close to its chord between two knots.
  bool is_flat(const std::size_t first, const std::size_t last, const double error) const
  {
    const Knot &a = m_knots[first], &b = m_knots[last];
    if(!(cross(a.direction, b.direction) > 0)) // rounded
      return last == first + 1;
    return excess(a.direction, a.sector, b.direction, b.sector) <= error;
  }

  // Returns by how much, relatively, the chord of the gauge is too high between two directions `a`
  // and `b` in given sectors. It is highest above the gauge at the corner where the functional of
  // the sector passes that of the chord.
  double excess(const Plane_vector a,
                const std::size_t sector_of_a,
                const Plane_vector b,
                const std::size_t sector_of_b) const
  {
    const double sine = cross(a, b);
    if(!(sine > 0))
      return infinity;
    const double at_a = dot(functional(sector_of_a), a), at_b = dot(functional(sector_of_b), b);
    const Plane_vector chord{(at_a * b.y - at_b * a.y) / sine, (at_b * a.x - at_a * b.x) / sine};
    std::size_t low = sector_of_a,
                high = sector_of_b < low ? sector_of_b + m_sectors.size() : sector_of_b;
    while(low < high)
    {
      const std::size_t middle = (low + high) / 2;
      if(cross(functional(middle), chord) > 0)
        low = middle + 1;
      else
        high = middle;
    }
    const Sector& corner = cyclic_sector(low);
    return low == sector_of_a
               ? 0
               : dot(chord, corner.direction) / dot(corner.functional, corner.direction) - 1;
  }

  // Returns a sector, counted from the first one and around at most twice.
  const Sector& cyclic_sector(const std::size_t i) const
  {
    return m_sectors[i < m_sectors.size() ? i : i - m_sectors.size()];
  }

  Plane_vector functional(const std::size_t i) const { return cyclic_sector(i).functional; }

  // Returns a sector that is `number` sectors before another one.
  std::size_t before(const std::size_t i, const std::size_t number) const
  {
    return i < number ? i + m_sectors.size() - number : i - number;
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
  bool m_is_sampled = false; // whether the gauge is not the polygon, but below it between corners
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_POLYGON_H
