// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_CURVATURE_POINTS_H
#define BENCHMARK_CURVATURE_POINTS_H

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Directional_points.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// The number of points that a bound for costs per direction takes if both ends of a segment are
// rounded independently, and the spacing follows the worst curvature of the polygon of a face and
// the smallest angle beside an edge.
class Curvature_points
{
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;
  using Index = Triangulation::Index;
  using Gauges = CGAL::Approximate_geodesics::internal::Face_gauges;
  using Vector = CGAL::Approximate_geodesics::internal::Plane_vector;
  using Progressions = CGAL::Approximate_geodesics::internal::Geometric_progressions;
  using Shape = CGAL::Approximate_geodesics::internal::Face_shape;

public:
  // \pre No gauge has a formula, and all are bounded.
  Curvature_points(const Triangulation& triangulation, const double epsilon)
    : m_triangulation(triangulation),
      m_spread(triangulation.gauges().number_of_faces()),
      m_smallest(m_spread.size()),
      m_crossings(0.65 * ((1 + epsilon) / (1 + triangulation.gauges().sampling_error()) - 1)),
      m_vicinities(7. / 13 * m_crossings / (1 + m_crossings))
  {
    for(Index face = 0; face < m_spread.size(); ++face)
      for(const double part : {0.15, 0.5})
        m_spread[face] = (std::max)(m_spread[face],
                                    (1 - part) * m_crossings / curvature(face, part * m_crossings));
  }

  std::size_t number_of_points() const
  {
    std::size_t result = 0;
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(h < m_triangulation.opposite(h) && m_triangulation.is_crossable(h))
        result += Progressions(end(h), end(m_triangulation.opposite(h))).number_of_points();
    return result;
  }

private:
  // Returns the largest quotient of the square of a step of functionals and what they fall short
  // of.
  double curvature(const Index face, const double rest)
  {
    const Gauges& gauges = m_triangulation.gauges();
    const auto *const first = gauges.first_sector(face), *const beyond = gauges.beyond_sector(face);
    double result = 0, least = std::numeric_limits<double>::infinity();
    for(auto s = first; s != beyond; ++s)
    {
      const Vector end = (s + 1 == beyond ? first : s + 1)->direction;
      const double at_start = dot(s->functional, s->direction), at_end = dot(s->functional, end);
      const double smallest = (std::min)(at_start, at_end);
      least = (std::min)(least, smallest);
      for(auto t = first; t != beyond; ++t)
      {
        const Vector step = t->functional - s->functional;
        const double gap = (std::min)((std::max)(-dot(step, s->direction), 0.) + rest * at_start,
                                      (std::max)(-dot(step, end), 0.) + rest * at_end);
        result = (std::max)(result, dot(step, step) / (2 * smallest * gap));
      }
    }
    m_smallest[face] = least;
    return result;
  }

  // Returns the end of an edge at the source of `h`.
  Progressions::End end(const Index h) const
  {
    const Gauges& gauges = m_triangulation.gauges();
    const Index v = m_triangulation.source(h), right = m_triangulation.opposite(h);
    double radius = std::numeric_limits<double>::infinity(), smallest = radius, largest = 0;
    for(Index g = m_triangulation.first_halfedge(v); g < m_triangulation.beyond_halfedge(v); ++g)
      if(m_triangulation.is_open(g))
      {
        const Index face = gauges.face(g);
        radius = (std::min)(radius, Shape(m_triangulation, g).distance_to_opposite_edge());
        smallest = (std::min)(smallest, m_smallest[face]);
        for(const Index side : {g, m_triangulation.halfedges_of_face(g)[2]})
          for(const double sign : {1., -1.})
            largest = (std::max)(largest, gauges.cost(face, sign * gauges.side(side)));
      }
    const double sine = (std::min)(Shape(m_triangulation, h).sine_of_corner(),
                                   Shape(m_triangulation, right).sine_of_next_corner());
    const double spread =
        (std::min)({m_spread[gauges.face(h)], m_spread[gauges.face(right)], 0.999});
    return {radius * m_vicinities / (2 * (largest / smallest + m_vicinities)) /
                m_triangulation.length(h),
            sine, 2 * std::asinh(sine * std::sqrt(spread))};
  }

  const Triangulation& m_triangulation;
  std::vector<double> m_spread, m_smallest; // per face
  double m_crossings, m_vicinities;         // the parts of the bound
};

#endif // BENCHMARK_CURVATURE_POINTS_H
