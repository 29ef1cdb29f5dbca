// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_GAUGE_SHAPE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_GAUGE_SHAPE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Face_gauges.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What the error of a path across a face depends on, where the face has a gauge.
 */
class Gauge_shape
{
public:
  using Index = Face_gauges::Index;
  using Sector = Face_gauges::Sector;

  Gauge_shape(const Face_gauges& gauges, const Index face)
    : m_first(gauges.first_sector(face)), m_beyond(gauges.beyond_sector(face))
  {
    for(const Sector* s = m_first; s != m_beyond; ++s)
    {
      m_is_finite = m_is_finite && s->is_finite();
      if(!s->is_finite())
        continue;
      for(const Plane_vector d : {s->direction, next(s)->direction})
        m_smallest = (std::min)(m_smallest, (std::max)(dot(s->functional, d), 0.));
      m_largest = (std::max)(m_largest, length(s->functional));
    }
  }

  bool is_forbidden() const { return m_first == m_beyond; }
  bool is_free() const { return !is_forbidden() && m_is_finite && m_largest == 0; }

  // whether no direction is free, and none is forbidden, unless all are
  bool is_bounded() const { return is_forbidden() || is_free() || (m_is_finite && m_smallest > 0); }

  // the cost of the cheapest direction, per unit of length
  double smallest() const { return m_smallest; }

  // A number Q such that a change `c` of a vector `d` adds at most
  //   F(d) (r + Q |c|^2 / (2 |d|^2))
  // to what a linear function of `c`, which depends on `d` only, says of the gauge F. \pre The face
  // is neither free nor forbidden. Sectors where F is zero or infinite are left out.
  //
  // From sector s to sector t, F(d + c) exceeds the functional of s by (t - s)(d + c), and the
  // largest Q for that is |t - s|^2 / (2 F(d) (r F(d) - (t - s) d)), for |d| = 1. Both factors
  // below are smallest at one of the ends of s.
  double curvature(const double r) const
  {
    double result = 0;
    for(const Sector* s = m_first; s != m_beyond; ++s)
      if(s->is_finite())
        result = (std::max)(result, curvature(*s, next(s)->direction, r));
    return result;
  }

private:
  const Sector* next(const Sector* const s) const { return s + 1 == m_beyond ? m_first : s + 1; }

  double curvature(const Sector& s, const Plane_vector end, const double r) const
  {
    const double at_start = dot(s.functional, s.direction), at_end = dot(s.functional, end);
    const double smallest = (std::min)(at_start, at_end);
    if(!(smallest > 0))
      return 0;
    double result = 0;
    for(const Sector* t = m_first; t != m_beyond; ++t)
    {
      const Plane_vector step = t->functional - s.functional;
      const double gap = (std::min)((std::max)(-dot(step, s.direction), 0.) + r * at_start,
                                    (std::max)(-dot(step, end), 0.) + r * at_end);
      const double q = dot(step, step) / (2 * smallest * gap);
      result = q > result ? q : result; // not if it is not a number
    }
    return result;
  }

  const Sector* m_first;
  const Sector* m_beyond;
  double m_smallest = std::numeric_limits<double>::infinity();
  double m_largest = 0;
  bool m_is_finite = true;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_GAUGE_SHAPE_H
