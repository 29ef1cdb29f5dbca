// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/internal/Unfolding.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// The windows that a vertex looks through, each with the one before it.
class Window_tree
{
public:
  using Index = Intrinsic_triangulation::Index;

  Window_tree() : m_windows(1, {Intrinsic_triangulation::null_index, 0}) {}

  // adds the window in `halfedge` behind the window `way`; 0 stands for none
  std::uint32_t add(const Index halfedge, const std::uint32_t way)
  {
    m_windows.push_back({halfedge, way});
    return static_cast<std::uint32_t>(m_windows.size() - 1);
  }

  // the halfedges on the way to and through a window
  std::vector<Index> halfedges(std::uint32_t way) const
  {
    std::vector<Index> result;
    for(; way != 0; way = m_windows[way].way)
      result.push_back(m_windows[way].halfedge);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  struct Entry
  {
    Index halfedge;
    std::uint32_t way;
  };

  std::vector<Entry> m_windows;
};

// Does what another filter does, and remembers the windows.
template <typename Filter>
struct Remembering : Filter
{
  std::uint32_t way_through(const Window::Index halfedge, const std::uint32_t way) const
  {
    return tree.add(halfedge, way);
  }

  Window_tree& tree;
};

// At which part of the way from `left` to `right`, in line with the origin, this is, or is nearest.
inline double part_at_origin(const Plane_vector left, const Plane_vector right)
{
  const double a = length(left), b = length(right);
  if(dot(left, right) > 0)
    return a < b ? 0 : 1;
  return a + b > 0 ? a / (a + b) : 0.5;
}

// Calls `f(h, t)` for the halfedges that `arc` crosses, at the part `t` of the way from their
// source to their target.
template <typename F>
void for_each_crossing(const Intrinsic_triangulation& triangulation,
                       const Straight_arc& arc,
                       const std::vector<Intrinsic_triangulation::Index>& halfedges,
                       F f)
{
  const Unfolding_on_demand unfolding(triangulation);
  Unfolded_face face = unfolding.face(arc.start);
  Plane_vector left{0, 0}, right{triangulation.length(arc.start), 0}; // of the face's base
  for(const auto h : halfedges)
  {
    const Plane_vector apex = face.position_of_apex(left, right);
    (h == face.right ? left : right) = apex;
    const double to_left = std::abs(cross(arc.position, left));
    const double to_right = std::abs(cross(right, arc.position));
    const double sum = to_left + to_right;
    f(h, sum > 0 ? to_left / sum : part_at_origin(left, right));
    face = unfolding.face(h);
  }
}

// Calls `f(h, t)` for every edge that an arc in a discrete geodesic graph crosses, from its source
// on: at the point that is at the part `t` of the way from the source to the target of the halfedge
// `h`. The arcs of the graph were found with a filter of the given type, or are some of those.
// Among those between the two vertices, the one of the given length is meant.
template <typename Filter, typename F>
void trace_arc(const Intrinsic_triangulation& triangulation,
               const double epsilon,
               const Intrinsic_triangulation::Index source,
               const Intrinsic_triangulation::Index target,
               const double length,
               F f)
{
  const Unfolding_on_demand unfolding(triangulation);
  const Cone_expansion<Unfolding_on_demand> expansion(triangulation, unfolding, epsilon);
  Window_tree tree;
  Straight_arc found{Intrinsic_triangulation::null_index, 0, {0, 0}, 0, 0};
  double smallest_difference = std::numeric_limits<double>::infinity();
  const auto compare = [&](const Straight_arc& arc) {
    const double difference = std::abs(arc.length - length);
    if(arc.target == target && difference < smallest_difference)
    {
      smallest_difference = difference;
      found = arc;
    }
  };
  expansion.expand(source, compare, Remembering<Filter>{Filter(), tree});
  CGAL_assertion(found.target == target);
  for_each_crossing(triangulation, found, tree.halfedges(found.way), f);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H
