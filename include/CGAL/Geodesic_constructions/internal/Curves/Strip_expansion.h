// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIP_EXPANSION_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIP_EXPANSION_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What is seen through an edge along parallel rays that leave a segment at right angles (D. Bommes,
 * L. Kobbelt, Accurate computation of geodesic distance fields for polygonal curves on triangle
 * meshes, 2007). The segment is part of the x axis, and the rays point upward: the distance of a
 * point is its height.
 */
struct Strip
{
  Index halfedge;           // that of the edge whose face lies ahead, to its left
  Plane_vector left, right; // the positions of its source and target
  Plane_vector edge;        // from one to the other
  double begin, end;        // of the rays, on the x axis
  double left_bound = infinity, right_bound = infinity; // of labels, with a margin for rounding
  std::uint32_t depth = 0;                              // the number of faces on the way
  Crossing milestone = {};                              // one of the halfedges on the way

  // Where the ray at `x` crosses an edge, as a part of the way from its source to its target.
  static double part(const Plane_vector source, const Plane_vector target, const double x)
  {
    const double width = target.x - source.x;
    return width > 0 ? (std::clamp)((x - source.x) / width, 0., 1.) : x <= source.x ? 0 : 1;
  }

  // The smallest height of the edge between the rays.
  double height() const
  {
    return (std::min)(left.y + part(left, right, begin) * edge.y,
                      left.y + part(left, right, end) * edge.y);
  }

  // Whether all that is seen can be reached on a shorter way over an end of the edge: the proof is
  // that of `Sight::is_useless()`, as heights do not change faster than distances.
  bool is_useless(const double label_of_segment) const
  {
    constexpr double factor = 1 + Sight::ROUNDING;
    const double excess = label_of_segment + (std::max)(right.y - left_bound, left.y - right_bound);
    const double squared_length = dot(edge, edge);
    return (excess > 0 && excess * excess > factor * squared_length) ||
           !(squared_length > Sight::SHORTEST_EDGE * Sight::SHORTEST_EDGE);
  }

  // Whether all rays are beaten by a path straight to an earlier crossing of the same edge, and
  // along it: see `Winding`.
  bool is_detour() const
  {
    const double first = part(milestone.source, milestone.target, begin),
                 last = part(milestone.source, milestone.target, end),
                 length_of_edge = length(edge);
    const auto is_beaten = [&](const double x) {
      const double t = part(left, right, x);
      const double nearest = (std::clamp)(t, (std::min)(first, last), (std::max)(first, last));
      const double detour = milestone.point(nearest).y + std::abs(t - nearest) * length_of_edge;
      return detour <= (left.y + t * edge.y) * (1 + 1e-12) + length_of_edge * 1e-15;
    };
    return is_beaten(begin) && is_beaten(end);
  }
};

// Unfolds faces as `Face_steps` does; each is computed when it is asked for.
class Face_steps_on_demand
{
public:
  explicit Face_steps_on_demand(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Face_step operator[](const Index h) const
  {
    return Face_step::of(m_triangulation, m_triangulation.source(h), h);
  }

private:
  const Intrinsic_triangulation& m_triangulation;
};

/*
 * Follows the parallel rays from a segment, and reports to a visitor the vertices that they lead
 * to.
 *
 * The visitor has
 * - `bound(v)`: an upper bound on the lengths of shortest paths to `v` that are of interest;
 * - `on_vertex(v, length, x, strip, position, left_edge)`: called for vertices that are seen in the
 *   face ahead of `strip`, from the point at `x`;
 * - `ends(strip)`: whether the strip need not be followed.
 */
template <typename Steps, typename Visitor>
class Strip_expansion
{
  static constexpr double rounding = Sight::ROUNDING;

public:
  Strip_expansion(const Intrinsic_triangulation& triangulation,
                  const Steps& steps,
                  const double label_of_segment,
                  Visitor& visitor)
    : m_triangulation(triangulation), m_steps(steps), m_label(label_of_segment), m_visitor(visitor)
  {
  }

  // Follows the rays from the side of a segment where its left is, out of its face.
  void look(const Segment_layout& layout, const bool is_along_edge)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(is_along_edge && i == 0)
        continue;
      const Index outside = m_triangulation.opposite(layout.halfedge(i));
      const std::size_t next = (i + 1) % 3;
      const Plane_vector left = layout.corner(next), right = layout.corner(i);
      const double begin = (std::max)(0., left.x), end = (std::min)(layout.length(), right.x);
      if(left.x < right.x && begin <= end && !m_triangulation.is_border(outside))
        follow({outside, left, right, layout.edge(next, i), begin, end}, layout.vertex(next),
               layout.vertex(i));
    }
  }

private:
  double bound(const Index v) const { return m_visitor.bound(v) * (1 + rounding); }

  void follow(Strip strip, const Index left_end, const Index right_end)
  {
    strip.left_bound = bound(left_end);
    strip.right_bound = bound(right_end);
    bool is_open = goes_on(strip);
    while(is_open || pop(m_stack, strip))
      is_open = advance(strip);
  }

  // Takes the strip across the face ahead of it. Returns whether it is not empty.
  bool advance(Strip& strip)
  {
    const Face_step step = m_steps[strip.halfedge];
    if(has_returned(strip, step.across))
      return false;
    const Plane_vector left_edge = step.left_side(strip.edge), apex = strip.left + left_edge;
    const double bound_of_apex = bound(step.apex);
    const double x = (std::clamp)(apex.x, strip.begin, strip.end);
    const double distance = length({apex.x - x, apex.y});
    if(std::abs(apex.x - x) <= Sight_ray::TOLERANCE * length(apex) && apex.y >= 0 &&
       m_label + distance <= bound_of_apex)
      m_visitor.on_vertex(step.apex, distance, x, strip, apex, left_edge);

    const auto moved = [&](Strip side, const bool goes_left) {
      side.halfedge = goes_left ? step.left : step.right;
      side.edge = goes_left ? left_edge : step.right_edge(strip.edge);
      (goes_left ? side.right : side.left) = apex;
      (goes_left ? side.right_bound : side.left_bound) = bound_of_apex;
      return side;
    };
    if(apex.x <= strip.begin || apex.x >= strip.end)
    {
      strip = moved(strip, apex.x >= strip.end && apex.x > strip.begin);
      return goes_on(strip);
    }
    Strip right = moved(strip, false);
    right.begin = apex.x;
    if(goes_on(right))
      m_stack.push_back(right);
    strip = moved(strip, true);
    strip.end = apex.x;
    return goes_on(strip);
  }

  bool goes_on(const Strip& strip) const
  {
    return strip.halfedge != null_index && !strip.is_useless(m_label) && !m_visitor.ends(strip);
  }

  // Whether a strip returns to an edge, and is given up there: see `Winding`.
  bool has_returned(Strip& strip, const double height_of_face) const
  {
    constexpr double smallest_height = 1e-8;
    if(strip.halfedge == strip.milestone.halfedge &&
       (!m_triangulation.lines_may_return() || !(height_of_face > smallest_height) ||
        strip.is_detour()))
      return true;
    if(Winding::is_milestone(strip.depth))
      strip.milestone = {strip.halfedge, strip.left, strip.right};
    ++strip.depth;
    return false;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steps& m_steps;
  const double m_label;
  Visitor& m_visitor;
  boost::container::small_vector<Strip, 16> m_stack;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIP_EXPANSION_H
