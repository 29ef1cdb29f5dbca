// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_TRAIL_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_TRAIL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The halfedges that a sight has crossed. Sights are followed depth first: those that belong to one
 * are the first so many of those that were recorded last.
 */
class Sight_trail
{
public:
  using Index = Intrinsic_triangulation::Index;

  void record(const Sight& sight)
  {
    m_halfedges.resize(sight.depth);
    m_halfedges.push_back(sight.halfedge);
  }

  const std::vector<Index>& halfedges() const { return m_halfedges; }

private:
  std::vector<Index> m_halfedges;
};

// The line whose length is closest to a given one, and the halfedges that it crosses.
struct Sought_line
{
  using Index = Intrinsic_triangulation::Index;

  double length;   // what is sought
  double rounding; // what this may be wrong by
  double smallest_difference = std::numeric_limits<double>::infinity();
  double length_found = 0;
  Plane_vector end = {0, 0};
  Sight start = {};
  std::vector<Index> halfedges = {};

  void consider(const double other_length,
                const Plane_vector position,
                const Sight& first,
                const std::vector<Index>& crossed)
  {
    const double difference = std::abs(other_length - length);
    if(!(difference < smallest_difference))
      return;
    smallest_difference = difference;
    length_found = other_length;
    end = position;
    start = first;
    halfedges = crossed;
  }

  // Others of about this length lead round something.
  bool is_found(const double tolerance = 1e-12) const
  {
    return smallest_difference <= tolerance * length + rounding ||
           smallest_difference < std::numeric_limits<double>::min();
  }

  // Calls `f(h, t)` for the halfedges, at the part `t` of the way from source to target. Returns
  // the length of the line.
  template <typename F>
  double for_each_crossing(const Face_steps& steps, F f) const
  {
    walk(steps, f);
    return length_found;
  }

private:
  template <typename F>
  void walk(const Face_steps& steps, F& f) const
  {
    Line_walk walk(end);
    Plane_vector left = start.left, edge = start.edge;
    for(std::size_t i = 0; i < halfedges.size(); ++i)
    {
      f(halfedges[i], walk.cross_edge(left, left + edge));
      if(i + 1 == halfedges.size())
        return;
      const Face_step& step = steps[halfedges[i]];
      if(halfedges[i + 1] == step.right)
      {
        left = left + step.left_edge(edge);
        edge = step.right_edge(edge);
      }
      else
        edge = step.left_edge(edge);
    }
  }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_TRAIL_H
