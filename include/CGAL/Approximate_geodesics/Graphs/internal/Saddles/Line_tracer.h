// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINE_TRACER_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINE_TRACER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Arrival.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Bends.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_trail.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Tracing_visitor.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Vertex_sights.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Follows a line back from the vertex where it arrives to the point that it has come from. Its
 * length is known, and its direction nearly so; there are hardly any vertices so close to it that
 * the search has to look on both sides of them.
 */
class Line_tracer
{
  using Index = Intrinsic_triangulation::Index;

public:
  Line_tracer(const Intrinsic_triangulation& triangulation,
              const Face_steps& steps,
              const Bends& bends)
    : m_triangulation(triangulation), m_steps(steps), m_bends(bends)
  {
  }

  // `length` is known up to `rounding`. Calls `f(h, t)` for the halfedges that the line crosses on
  // its way from the vertex to `end`, at the part `t` of the way from source to target. Returns its
  // length, or a negative number if it is not found: the direction says too little where edges have
  // no length, and where faces are thinner than numbers can tell.
  template <typename F>
  double for_each_crossing(const Index vertex,
                           const Arrival& arrival,
                           const Intrinsic_point& end,
                           const double length,
                           const double rounding,
                           F f) const
  {
    Sought_line line{length, rounding};
    if(!end.is_vertex())
      Lines_of_sight(m_triangulation, m_steps, m_bends, end)
          .consider_lines_in_faces(Intrinsic_point::at_vertex(vertex), line);
    for(double angle = 4 * Arrival::ROUNDING; angle < 1 && !line.is_found(); angle *= 1000)
      look_back(vertex, arrival, angle, end, line);
    return line.is_found() ? line.for_each_crossing(m_steps, f) : -1;
  }

private:
  // No part of a line is longer than the whole.
  struct Length_bound
  {
    double operator()(Index /* v */) const { return length; }
    double length;
  };

  using Visitor = Tracing_visitor<Length_bound>;

  void look_back(const Index vertex,
                 const Arrival& arrival,
                 const double angle,
                 const Intrinsic_point& end,
                 Sought_line& line) const
  {
    const Length_bound bound = length_bound(line);
    Visitor visitor{{}, m_triangulation, bound, end, line, {}, {}};
    Sight_expansion<Visitor> expansion(m_steps, m_bends, 0, visitor);
    Vertex_sights(m_triangulation, m_steps, m_bends)
        .for_each_back(
            vertex, arrival, angle,
            [&](const Index h) {
              if(m_triangulation.target(h) == end.vertex)
                line.consider(m_triangulation.length(h), {0, 0}, {}, {});
            },
            [&](const Sight& sight, const Index left_end, const Index right_end) {
              visitor.first = sight;
              expansion.look(sight, left_end, right_end);
            });
  }

  static Length_bound length_bound(const Sought_line& line)
  {
    constexpr double slack = 1e-6;
    return {line.length * (1 + slack) + line.rounding};
  }

  const Intrinsic_triangulation& m_triangulation;
  const Face_steps& m_steps;
  const Bends& m_bends;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINE_TRACER_H
