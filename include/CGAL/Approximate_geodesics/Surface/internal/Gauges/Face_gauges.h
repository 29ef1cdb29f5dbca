// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_FACE_GAUGES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_FACE_GAUGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Gauge_samples.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The costs of paths in faces that depend on the direction: for each face, a convex gauge whose
 * unit ball is a polygon, in a frame that is given by the directions of its sides. Costs are in
 * units of `unit()`.
 */
class Face_gauges
{
public:
  using Index = std::uint32_t;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

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

  bool is_forbidden(const Index face) const
  {
    return m_first_sector[face] == m_first_sector[face + 1];
  }

  // Returns the gauge of a vector in the frame of the face.
  double cost(const Index face, const Plane_vector v) const
  {
    if(v.x == 0 && v.y == 0)
      return 0;
    if(is_forbidden(face))
      return infinity;
    const Sector* s = sector(face, v);
    if(!s->is_finite())
      s = neighbor_at_end(face, s, v);
    return s->is_finite() ? (std::max)(dot(s->functional, v), 0.) : infinity;
  }

  std::size_t memory() const
  {
    return sizeof(Sector) * m_sectors.capacity() + sizeof(Plane_vector) * m_side.capacity() +
           sizeof(std::size_t) * m_first_sector.capacity() +
           sizeof(Index) * (m_corner_of_halfedge.capacity() + m_beyond_upper.capacity());
  }

  const std::vector<Sector>& all_sectors() const { return m_sectors; }

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
    for(std::size_t i = 0; i < 3; ++i)
    {
      m_corner_of_halfedge[halfedges[i]] = static_cast<Index>(m_side.size());
      m_side.push_back(sides[i]);
    }
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    const Gauge_hull& hull = samples.hull();
    Gauge_hull::Id i = 0;
    do
    {
      const Gauge_hull::Direction& d = hull[i];
      if(d.is_corner)
      {
        m_sectors.push_back(
            {d.vector, d.is_finite ? d.functional : Plane_vector{no_number, no_number}});
        m_sampling_error = (std::max)(m_sampling_error, d.error());
      }
      i = d.next;
    } while(i != 0);
    m_first_sector.push_back(m_sectors.size());
    const Sector* const first = first_sector(number_of_faces());
    const Sector* const beyond = sectors() + m_sectors.size();
    const Sector* const
        lower = // not the first one, which may be to the right of itself by rounding
        first == beyond ? beyond : std::find_if(first + 1, beyond, [&](const Sector& sector) {
          return !is_ahead(*first, sector.direction);
        });
    m_beyond_upper.push_back(static_cast<Index>(lower - first));
  }

  // Chooses a power of two as unit, so that products with lengths neither overflow nor underflow.
  void normalize(const double unit_of_lengths)
  {
    double largest = 0;
    for(const Sector& s : m_sectors)
      if(s.is_finite())
        largest = (std::max)({largest, std::abs(s.functional.x), std::abs(s.functional.y)});
    if(largest == 0 || std::isinf(largest))
      return;
    constexpr int smallest_of_costs = -1000;
    const int exponent =
        (std::max)(std::ilogb(largest), smallest_of_costs - std::ilogb(unit_of_lengths));
    m_unit = std::ldexp(1., exponent);
    const double root = std::ldexp(1., -(exponent / 2)); // powers of two within the range of double
    const double rest = std::ldexp(1., exponent / 2 - exponent);
    for(Sector& s : m_sectors)
      s.functional = rest * (root * s.functional);
  }

private:
  const Sector* sectors() const { return m_sectors.data(); }

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
  double m_unit = 1;
  double m_sampling_error = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_GAUGES_FACE_GAUGES_H
