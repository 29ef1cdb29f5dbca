// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_FACE_GAUGES_H
#define CGAL_GEODESIC_COSTS_INTERNAL_FACE_GAUGES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>
#include <CGAL/Geodesic_costs/internal/Gauge_formula.h>
#include <CGAL/Geodesic_costs/internal/Slope_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The largest convex gauge that is not above given costs in given directions: the costs of zigzags.
 * Its unit ball is the convex hull of the origin and the points at the cost 1. Zero costs put
 * points at infinity, and infinite costs put them at the origin. So the computation uses costs
 * instead of points: between two corners of the hull, the gauge is linear.
 *
 * Turning all directions by 180 degrees turns the results, to the last bit.
 */
class Gauge_hull
{
public:
  using Id = std::size_t; // of a direction, in the order of insertion

  // the smallest sine between the two directions of a sector
  static constexpr double SMALLEST_SINE = 1e-9;

  // A direction, and if it is a corner of the hull, the sector from there to the next corner.
  struct Direction
  {
    Plane_vector vector; // of length 1
    double cost;
    Id next, previous; // counterclockwise and clockwise
    bool is_corner;
    bool has_changed; // whether its sector has to be computed
    Id next_corner, previous_corner;
    bool is_finite;          // whether the gauge is, in the sector
    bool is_bridge;          // whether the sector contains directions, which are redundant
    Plane_vector functional; // the gauge as a linear functional, if it is finite
    // Bounds of the relative error of the gauge: before the first direction inside the sector, and
    // behind the last one. They are equal if there is none.
    double error_at_start, error_at_end;

    double error() const { return (std::max)(error_at_start, error_at_end); }
  };

  void clear()
  {
    m_directions.clear();
    m_some_corner = null_id;
  }

  std::size_t number_of_directions() const { return m_directions.size(); }

  double largest_error() const
  {
    double result = 0;
    for(const Direction& d : m_directions)
      result = d.is_corner ? (std::max)(result, d.error()) : result;
    return result;
  }

  const Direction& operator[](const Id i) const { return m_directions[i]; }

  // Adds a direction between `i` and the next one, or the first direction. Takes constant time for
  // each corner that it makes redundant, and for each direction inside the sector.
  Id insert(const Id i, const Plane_vector v, const double cost)
  {
    const Id m = link(i, v, cost);
    const bool is_finite = cost < infinity;
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
    m_directions[c].has_changed = true;
    if(is_finite && !is_needless(c, m, k))
    {
      make_corner(m, c, k);
      remove_needless_neighbors(m);
    }
    return m;
  }

  // Updates the sectors that have changed since the last call, and calls `f(c)` for the corners
  // whose sectors have new errors.
  template <typename F>
  void update(F f)
  {
    for(Direction& d : m_directions)
      if(d.has_changed && d.is_corner)
      {
        const Direction& end = m_directions[d.next_corner];
        const double sine = cross(d.vector, end.vector);
        d.is_finite = sine > SMALLEST_SINE;
        d.is_bridge = d.next != d.next_corner;
        if(d.is_finite)
          d.functional = {(d.cost * end.vector.y - end.cost * d.vector.y) / sine,
                          (end.cost * d.vector.x - d.cost * end.vector.x) / sine};
      }
    for(Id c = 0; c < m_directions.size(); ++c)
      if(Direction& d = m_directions[c];
         d.is_corner && (d.has_changed || m_directions[d.previous_corner].has_changed ||
                         m_directions[d.next_corner].has_changed))
      {
        estimate_errors(d);
        f(c);
      }
    for(Direction& d : m_directions)
      d.has_changed = false;
  }

private:
  static constexpr Id null_id = (std::numeric_limits<Id>::max)();

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

  // Makes `m` a corner between two others.
  void make_corner(const Id m, const Id previous, const Id next)
  {
    m_directions[m].is_corner = true;
    m_directions[m].next_corner = next;
    m_directions[m].previous_corner = previous;
    m_directions[previous].next_corner = m_directions[next].previous_corner = m;
    m_some_corner = m;
    m_directions[m].has_changed = true;
  }

  void remove_needless_neighbors(const Id m)
  {
    const auto remove = [&](const Id j) {
      const Id i = m_directions[j].previous_corner, k = m_directions[j].next_corner;
      m_directions[j].is_corner = false;
      m_directions[i].next_corner = k;
      m_directions[k].previous_corner = i;
      m_directions[i].has_changed = true;
    };
    for(Id k; (k = m_directions[m].next_corner) != m_directions[m].previous_corner &&
              is_needless(m, k, m_directions[k].next_corner);)
      remove(k);
    for(Id k; (k = m_directions[m].previous_corner) != m_directions[m].next_corner &&
              is_needless(m_directions[k].previous_corner, k, m);)
      remove(k);
  }

  // Returns whether zigzags in directions `i` and `k` cost no more than direction `j`.
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

  // Costs of a convex gauge are not below the linear continuations of the neighboring sectors, and
  // on a bridge they are linear. For other costs, bridges imply nothing: costs beside and below
  // their ends may continue like the neighboring sectors. The estimate is the larger error of both
  // cases, so that it is valid in the first one. Next to infinite sectors, it is zero.
  void estimate_errors(Direction& s) const
  {
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

  // Returns the relative difference of the gauge of a finite sector in the direction `d` and the
  // linear continuation of another sector.
  static double drop(const Direction& sector, const Direction& other, const Plane_vector d)
  {
    if(!other.is_finite)
      return 0;
    const double largest = dot(sector.functional, d), smallest = dot(other.functional, d);
    if(!(largest > smallest))
      return 0;
    return largest > 0 ? 1 - smallest / largest : infinity;
  }

  static double error_of_drop(const double drop) { return drop < 1 ? drop / (1 - drop) : infinity; }

  std::vector<Direction> m_directions;
  Id m_some_corner = null_id;
};

/*
 * Samples of a cost function in the plane of a face, in so many directions that the hull of these
 * costs is close to the function, if that is convex. Opposite directions are sampled together, so
 * that the samples of the reversed function are those of the function, turned by 180 degrees.
 */
class Gauge_samples
{
public:
  // directions are not added to this number or more
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

  // Replaces the samples, starting with given directions, such as those of the sides of the face,
  // the first of which is the x axis. `cost` is called with a unit vector.
  template <typename Directions, typename Cost>
  void sample(const Directions& directions, const double tolerance, const Cost& cost)
  {
    set_first_directions(directions);
    m_hull.clear();
    Id last = 0;
    for(const Plane_vector d : m_first)
      last = ask(last, d, cost);
    do
      find_wide_gaps(tolerance);
    while(m_hull.number_of_directions() < LARGEST_NUMBER && refine(cost));
  }

  // Returns the hull of the costs in all directions, the first of which is the x axis.
  const Gauge_hull& hull() const { return m_hull; }

private:
  using Id = Gauge_hull::Id;

  static constexpr int FIRST_NUMBER = 8;        // of directions in half a circle
  static constexpr double SMALLEST_SINE = 1e-5; // between directions
  static constexpr double SMALLEST_GAP = 0.002; // between a finite and an infinite cost

  // Given directions replace others that are near.
  template <typename Directions>
  void set_first_directions(const Directions& directions)
  {
    constexpr double close = 0.02, same = 1e-6;
    m_first.assign(1, {1, 0});
    for(auto i = std::next(std::begin(directions)); i != std::end(directions); ++i)
      if(const Plane_vector d = i->y < 0 ? -1 * *i : *i; is_apart(d, same))
        m_first.push_back(d);
    for(const Plane_vector d : m_equal_parts)
      if(is_apart(d, close))
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
  // first.
  template <typename Cost>
  Id ask(const Id i, const Plane_vector d, const Cost& cost)
  {
    const Plane_vector back = -1 * d;
    const double there_cost = cost(d), back_cost = cost(back);
    const Id result = m_hull.insert(i, d, there_cost);
    m_hull.insert(result == 0 ? result : opposite(i), back, back_cost);
    return result;
  }

  // Bisects wide gaps between directions. Returns whether there are any.
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
        // the boundary of the finite costs is somewhere in the gap
        for(const Id i : {c, last})
          if(std::isinf(m_hull[i].cost) != std::isinf(m_hull[m_hull[i].next].cost))
            widen(i, SMALLEST_GAP);
    });
  }

  // Marks the gap behind a direction, or the opposite gap if that is in the first half circle,
  // unless it is too small.
  void widen(const Id i, const double smallest)
  {
    const double sine = cross(m_hull[i].vector, m_hull[m_hull[i].next].vector);
    if(sine > smallest)
      m_is_wide[i % 2 == 0 ? i : opposite(i)] = true;
  }

  std::vector<Plane_vector> m_equal_parts; // half a circle, divided into equal parts
  std::vector<Plane_vector> m_first;       // initial directions, from the x axis on
  std::vector<char> m_is_wide;             // per direction: whether to bisect the gap behind it
  Gauge_hull m_hull;
};

// Returns the exponent of a power of two near the largest cost per unit of length, or a larger one,
// so that products with the unit of lengths do not underflow.
inline int exponent_of_costs(const double largest, const double unit_of_lengths)
{
  constexpr int smallest = -1000;
  return (std::max)(std::ilogb(largest), smallest - std::ilogb(unit_of_lengths));
}

/*
 * The costs of paths in faces that depend on the direction: for each face, a convex gauge in a
 * frame that is given by the directions of its sides. It has a formula, or its unit ball is a
 * polygon, with one sector per side. Costs are in units of `unit()`.
 *
 * With a limit of the slope, costs of steeper directions are infinite, which is not convex: no
 * zigzags take the place of these directions. A face none of whose directions is steeper keeps its
 * gauge.
 */
class Face_gauges
{
public:
  // A sector of directions between two corners of the polygon, counterclockwise from `direction`.
  struct Sector
  {
    Plane_vector direction;
    Plane_vector functional; // its scalar product with a vector is the gauge; NaN if infinite

    bool is_finite() const { return !std::isnan(functional.x); }
  };

  bool is_empty() const { return m_first_sector.empty(); }
  Index number_of_faces() const { return static_cast<Index>(m_beyond_upper.size()); }
  double unit() const { return m_unit; }

  // Returns a bound of the relative error of the gauges, which holds if cost functions are convex.
  double sampling_error() const { return m_sampling_error; }

  // ----- faces; there is one to the left of `h`

  Index face(const Index h) const { return m_corner_of_halfedge[h] / 3; }

  // Returns the direction of `h` in the frame of its face; zero if its length is zero.
  Plane_vector side(const Index h) const { return m_side[m_corner_of_halfedge[h]]; }

  const Sector* first_sector(const Index face) const { return sectors() + m_first_sector[face]; }
  const Sector* beyond_sector(const Index face) const
  {
    return sectors() + m_first_sector[face + 1];
  }

  bool has_formula(const Index face) const { return !m_formulas.empty() && m_formulas[face]; }
  const Gauge_formula& formula(const Index face) const { return m_formulas[face]; }

  bool is_forbidden(const Index face) const
  {
    return !has_formula(face) && m_first_sector[face] == m_first_sector[face + 1];
  }

  // Returns whether some directions of a face are steeper than the limit.
  bool is_limited(const Index face) const
  {
    return face < m_rises.size() && !(m_rises[face].x == 0 && m_rises[face].y == 0);
  }

  // Returns an upper bound of the finite costs of unit vectors.
  double largest_cost(const Index face) const
  {
    double result = has_formula(face) ? m_formulas[face].largest() : 0;
    for(const Sector* s = first_sector(face); s != beyond_sector(face); ++s)
      result = s->is_finite() ? (std::max)(result, length(s->functional)) : result;
    return result;
  }

  // Returns the cost of a vector in the frame of the face.
  double cost(const Index face, const Plane_vector v) const
  {
    return is_limited(face) && !is_allowed(m_limit, m_rises[face], v) ? infinity : gauge(face, v);
  }

  // Returns the gauge of a vector, whether or not it is too steep.
  double gauge(const Index face, const Plane_vector v) const
  {
    if(v.x == 0 && v.y == 0)
      return 0;
    if(has_formula(face))
      return m_formulas[face](v);
    if(is_forbidden(face))
      return infinity;
    const Sector* s = sector(face, v);
    if(!s->is_finite())
      s = neighbor_at_end(face, s, v);
    return s->is_finite() ? (std::max)(dot(s->functional, v), 0.) : infinity;
  }

  std::size_t memory() const
  {
    return memory_of(m_sectors, m_formulas, m_side, m_first_sector, m_corner_of_halfedge,
                     m_beyond_upper, m_rises);
  }

  const std::vector<Sector>& all_sectors() const { return m_sectors; }

  // Appends the sectors of the polygon of a hull.
  static void append_sectors(const Gauge_hull& hull, std::vector<Sector>& sectors)
  {
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    Gauge_hull::Id i = 0;
    do
    {
      const Gauge_hull::Direction& d = hull[i];
      if(d.is_corner)
        sectors.push_back(
            {d.vector, d.is_finite ? d.functional : Plane_vector{no_number, no_number}});
      i = d.next;
    } while(i != 0);
  }

  // ----- construction

  void reserve(const std::size_t number_of_halfedges, const std::size_t number_of_faces)
  {
    m_corner_of_halfedge.assign(number_of_halfedges, 0);
    m_side.reserve(3 * number_of_faces);
    m_first_sector.reserve(number_of_faces + 1);
    m_first_sector.push_back(0);
    m_beyond_upper.reserve(number_of_faces);
  }

  // Adds a face with the given halfedges and their directions.
  template <typename Halfedges, typename Sides>
  void add(const Halfedges& halfedges, const Sides& sides, const Gauge_samples& samples)
  {
    add_corners(halfedges, sides);
    append_sectors(samples.hull(), m_sectors);
    m_sampling_error = (std::max)(m_sampling_error, samples.hull().largest_error());
    m_first_sector.push_back(m_sectors.size());
    const Sector* const first = first_sector(number_of_faces());
    const Sector* const beyond = sectors() + m_sectors.size();
    const Sector* const
        lower = // not the first one, which may be to the right of itself by rounding
        first == beyond ? beyond : std::find_if(first + 1, beyond, [&](const Sector& sector) {
          return !is_ahead(*first, sector.direction);
        });
    m_beyond_upper.push_back(static_cast<Index>(lower - first));
    if(!m_formulas.empty())
      m_formulas.emplace_back();
  }

  // Adds a face whose gauge has a formula.
  template <typename Halfedges, typename Sides>
  void add(const Halfedges& halfedges, const Sides& sides, const Gauge_formula& formula)
  {
    add_corners(halfedges, sides);
    m_formulas.resize(number_of_faces());
    m_formulas.push_back(formula);
    m_first_sector.push_back(m_sectors.size());
    m_beyond_upper.push_back(0);
  }

  // Keeps paths in the face that was added last from directions that are too steep. `rises` are
  // those of the axes of its plane. All faces have the same limit.
  void limit(const Slope_limit limit, const Plane_vector rises)
  {
    m_limit = limit;
    if(has_steep_directions(limit, rises))
    {
      m_rises.resize(number_of_faces(), {0, 0});
      m_rises.back() = rises;
    }
  }

  // Returns whether some directions of a plane are too steep.
  static bool has_steep_directions(const Slope_limit limit, const Plane_vector rises)
  {
    return !limit.is_none() && !is_allowed(limit, rises, direction_of(rises));
  }

  // Returns whether a vector is not too steep. \pre There is a limit.
  static bool is_allowed(const Slope_limit limit, const Plane_vector rises, const Plane_vector v)
  {
    constexpr double rounding = 1e-13;
    const double rise = dot(rises, v), square = dot(v, v);
    return limit.allows(rise, std::sqrt((std::max)(square - rise * rise, 0.)),
                        rounding * std::sqrt(square));
  }

  // Chooses a power of two as unit, so that products with lengths neither overflow nor underflow.
  void normalize(const double unit_of_lengths)
  {
    double largest = 0;
    for(const Sector& s : m_sectors)
      if(s.is_finite())
        largest = (std::max)({largest, std::abs(s.functional.x), std::abs(s.functional.y)});
    for(const Gauge_formula& formula : m_formulas)
      largest = formula ? (std::max)(largest, formula.largest()) : largest;
    if(largest == 0 || std::isinf(largest))
      return;
    const int exponent = exponent_of_costs(largest, unit_of_lengths);
    m_unit = std::ldexp(1., exponent);
    const double root = std::ldexp(1., -(exponent / 2)); // powers of two within the range of double
    const double rest = std::ldexp(1., exponent / 2 - exponent);
    for(Sector& s : m_sectors)
      s.functional = rest * (root * s.functional);
    for(Gauge_formula& formula : m_formulas)
    {
      formula.multiply(root);
      formula.multiply(rest);
    }
  }

private:
  const Sector* sectors() const { return m_sectors.data(); }

  template <typename Halfedges, typename Sides>
  void add_corners(const Halfedges& halfedges, const Sides& sides)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      m_corner_of_halfedge[halfedges[i]] = static_cast<Index>(m_side.size());
      m_side.push_back(sides[i]);
    }
  }

  // Returns whether a direction is in the half circle that begins with the first one of the face.
  static bool is_ahead(const Sector& first, const Plane_vector v)
  {
    const double sine = cross(first.direction, v);
    return sine > 0 || (sine == 0 && dot(first.direction, v) > 0);
  }

  // Returns the last sector of the same half circle that starts before `v`, or at it. If there is
  // none in the second half, that is the last one of the first half.
  const Sector* sector(const Index face, const Plane_vector v) const
  {
    const Sector *const begin = first_sector(face), *const end = beyond_sector(face);
    const Sector* const middle = begin + m_beyond_upper[face];
    const auto starts_before = [v](const Sector& s) { return cross(s.direction, v) >= 0; };
    const bool is_first_half = is_ahead(*begin, v);
    return std::partition_point(is_first_half ? begin + 1 : middle, is_first_half ? middle : end,
                                starts_before) -
           1;
  }

  // Returns the adjacent sector if `v` is a boundary direction of the infinite sector `s`, up to
  // rounding, and else `s`: boundaries belong to the finite sectors.
  const Sector* neighbor_at_end(const Index face, const Sector* const s, const Plane_vector v) const
  {
    const Sector *const begin = first_sector(face), *const end = beyond_sector(face);
    const Sector* const next = s + 1 == end ? begin : s + 1;
    const auto is_at = [v](const Plane_vector d) {
      constexpr double rounding = 1e-12;
      return std::abs(cross(d, v)) <= rounding * dot(d, v);
    };
    if(is_at(s->direction))
      return (s == begin ? end : s) - 1;
    return is_at(next->direction) ? next : s;
  }

  std::vector<Index> m_corner_of_halfedge; // three times the face, plus the rank of its source
  std::vector<Plane_vector> m_side;        // per corner: the direction of the halfedge from there
  std::vector<std::size_t> m_first_sector; // per face, and one beyond
  std::vector<Index> m_beyond_upper; // per face: number of sectors that start in the first half
  std::vector<Sector> m_sectors;
  std::vector<Gauge_formula> m_formulas; // per face; empty if there is none
  std::vector<Plane_vector> m_rises;     // per face, up to the last one that is limited; else zero
  Slope_limit m_limit;
  double m_unit = 1;
  double m_sampling_error = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_FACE_GAUGES_H
