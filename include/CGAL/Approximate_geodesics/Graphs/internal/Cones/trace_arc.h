// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The windows on lines from a vertex, each with the one before it.
class Window_tree
{
public:
  Window_tree() : m_windows(1, {null_index, 0}) {}

  // adds the window in `halfedge` behind the window `trail`; 0 stands for none
  std::uint32_t add(const Index halfedge, const std::uint32_t trail)
  {
    m_windows.push_back({halfedge, trail});
    return static_cast<std::uint32_t>(m_windows.size() - 1);
  }

  // the halfedges on the way to and through a window
  std::vector<Index> halfedges(std::uint32_t trail) const
  {
    std::vector<Index> result;
    for(; trail != 0; trail = m_windows[trail].trail)
      result.push_back(m_windows[trail].halfedge);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  struct Entry
  {
    Index halfedge;
    std::uint32_t trail;
  };

  std::vector<Entry> m_windows;
};

// Records windows, and does otherwise what `Visitor` does.
template <typename Visitor>
struct Remembering : Visitor
{
  std::uint32_t record_window(const Index halfedge, const std::uint32_t trail) const
  {
    return tree.add(halfedge, trail);
  }

  Window_tree& tree;
};

// Prunes windows farther away than `reach`, and does otherwise what `Visitor` does.
template <typename Visitor>
struct Within_reach : Visitor
{
  bool prune(const Window& w) const
  {
    const Plane_vector edge = w.left_position - w.right_position;
    const double square = dot(edge, edge);
    const double t = square > 0 ? -dot(w.right_position, edge) / square : 0;
    return length(w.right_position + (std::clamp)(t, 0., 1.) * edge) > reach;
  }

  double reach;
};

// Follows a line from the origin across edges that are laid out in the plane.
class Line_walk
{
public:
  // The end may be the origin, where vertices are at the same place.
  explicit Line_walk(const Plane_vector end)
    : m_direction(dot(end, end) > 0 ? 1 / length(end) * end : Plane_vector{1, 0}),
      m_length(length(end))
  {
  }

  // At which part of the way from `left` to `right` the line crosses this edge. If both are
  // collinear, as where faces have no area, it is the present position of the walk, or the next
  // point after it.
  double cross_edge(const Plane_vector left, const Plane_vector right)
  {
    constexpr double smallest_angle = 1e-9;
    const double to_left = std::abs(cross(m_direction, left));
    const double to_right = std::abs(cross(m_direction, right));
    const double start = dot(m_direction, left), end = dot(m_direction, right);
    double t = 0;
    if(to_left + to_right > smallest_angle * length(right - left))
      t = to_left / (to_left + to_right);
    else if(start != end)
      t = (std::clamp)((m_position - start) / (end - start), 0., 1.);
    const double position = start + t * (end - start);
    const bool is_beside_line = std::abs(end - start) > to_left + to_right; // badly conditioned
    if(is_beside_line && (position < m_position || position > m_length))
      t = (std::clamp)(((position < m_position ? m_position : m_length) - start) / (end - start),
                       0., 1.);
    m_position = (std::max)(m_position, start + t * (end - start));
    return t;
  }

private:
  Plane_vector m_direction;
  double m_length;
  double m_position = 0; // the position of the walk on the line
};

// Calls `f(h, t)` for the halfedges that the line from the origin to `end` crosses, at the part `t`
// of the way from their source to their target. `edge` has the positions `left` and `right()` of
// these for the first one; `cross_face(edge, h, next)` makes it the edge of `next`, across the face
// to the left of `h`.
template <typename Edge, typename CrossFace, typename F>
void for_each_crossed_edge(const std::vector<Index>& halfedges,
                           Edge edge,
                           const Plane_vector end,
                           CrossFace cross_face,
                           F f)
{
  Line_walk walk(end);
  for(std::size_t i = 0; i < halfedges.size(); ++i)
  {
    if(i > 0)
      cross_face(edge, halfedges[i - 1], halfedges[i]);
    f(halfedges[i], walk.cross_edge(edge.left, edge.right()));
  }
}

// The line whose length is closest to a given one.
template <typename Line>
struct Sought_line
{
  // Considers a line of that length, which `line()` returns.
  template <typename F>
  void consider(const double other_length, F line)
  {
    const double difference = std::abs(other_length - length);
    if(!(difference < smallest_difference))
      return;
    smallest_difference = difference;
    found = line();
  }

  // Other lines belong to another homotopy class.
  bool is_found(const double tolerance) const
  {
    return smallest_difference <= tolerance * length + rounding ||
           smallest_difference < std::numeric_limits<double>::min();
  }

  double length;   // the given length
  double rounding; // a bound on its error
  Line found;
  double smallest_difference = infinity;
};

// Looks for an arc, and for the windows that it goes through.
struct Line_search : Sought_line<Straight_arc>
{
  explicit Line_search(const double arc_length, const double rounding_of_length = 0)
    : Sought_line{arc_length, rounding_of_length, {null_index, 0, {0, 0}, 0, 0}}
  {
  }

  void consider(const Straight_arc& arc)
  {
    Sought_line::consider(arc.length, [&] { return arc; });
  }

  bool is_found() const { return Sought_line::is_found(TOLERANCE); }

  // The length of the longest line that is found.
  double reach() const { return (length + rounding) * (1 + TOLERANCE); }

  // Calls `f(h, t)` for the edges that the arc found crosses, the first of which has these ends;
  // `edge` is the vector from its left to its right end. See `Cone_expansion` for such vectors.
  template <typename F>
  void for_each_crossing(const Intrinsic_triangulation& triangulation,
                         const Plane_vector left,
                         const Plane_vector right,
                         const Plane_vector edge,
                         F f) const
  {
    struct Edge
    {
      Plane_vector right() const { return right_end; }
      Plane_vector left, right_end, vector;
    };
    const Unfolding_on_demand unfolding(triangulation);
    const bool carries_edges = triangulation.thin_faces().has_extreme_needles();
    const auto cross_face = [&](Edge& e, const Index h, const Index next) {
      const Unfolded_face face = unfolding.face(h);
      const bool goes_right = next == face.right;
      const Plane_vector apex = carries_edges ? e.left + face.left_side(e.vector)
                                              : face.position_of_apex(e.left, e.right_end);
      e.vector =
          goes_right ? right_side(triangulation, h, face, e.vector) : face.left_side(e.vector);
      (goes_right ? e.left : e.right_end) = apex;
    };
    for_each_crossed_edge(tree.halfedges(found.trail), Edge{left, right, edge}, found.position,
                          cross_face, f);
  }

  static constexpr double TOLERANCE = 1e-6; // single precision, flat faces

  Window_tree tree;
};

// Looks for the arc with these rules from one vertex to another.
template <typename Visitor>
void find_arc(const Intrinsic_triangulation& triangulation,
              const Cone_rules& rules,
              const Index source,
              const Index target,
              const Visitor& visitor,
              Line_search& search)
{
  const Unfolding_on_demand unfolding(triangulation);
  const Cone_expansion<Unfolding_on_demand> expansion(triangulation, unfolding, rules);
  const auto consider = [&](const Straight_arc& arc) {
    if(arc.target == target)
      search.consider(arc);
  };
  expansion.expand(source, consider, Remembering<Visitor>{visitor, search.tree});
}

// Looks for an arc of the graph that was not found again, because of rounding: with a tolerance of
// visibility, and with cones that end farther away.
inline void search_in_doubt(const Intrinsic_triangulation& triangulation,
                            const Cone_rules& rules,
                            const Index source,
                            const Index target,
                            Line_search& search)
{
  for(const double part : {1. / 4, 1. / 64, 1. / 1024})
    if(!search.is_found())
      find_arc(triangulation, rules.farther(part), source, target, Leave_out_nothing_in_doubt(),
               search);
}

// Looks for an arc of the graph with these rules, whose arcs were found with a visitor of this
// type.
template <typename Visitor>
void find_arc_of_graph(const Intrinsic_triangulation& triangulation,
                       const Cone_rules& rules,
                       const Index source,
                       const Index target,
                       Line_search& search)
{
  find_arc(triangulation, rules, source, target, Within_reach<Visitor>{{}, search.reach()}, search);
  if(!search.is_found())
    find_arc(triangulation, rules, source, target, Visitor(), search);
  search_in_doubt(triangulation, rules, source, target, search);
}

// Calls `f(h, t)` for the edges that the line found to `target` crosses. Returns its length.
template <typename F>
double report_line(const Intrinsic_triangulation& triangulation,
                   const Line_search& search,
                   const Index target,
                   F f)
{
  if(search.found.target != target)
    reject(
        "the graph has an arc that is not in the mesh; was it read from a file that was changed?");
  const Straight_arc& arc = search.found;
  const Plane_vector right{triangulation.length(arc.start), 0};
  const Unfolded_face face = Unfolding_on_demand(triangulation).face(arc.start);
  search.for_each_crossing(triangulation, face.position_of_apex({0, 0}, right), right,
                           right_side(triangulation, arc.start, face, right), f);
  return arc.length;
}

// Calls `f(h, t)` for every edge that an arc in a discrete geodesic graph crosses, from its source
// on: at the point that is at the part `t` of the way from the source to the target of the halfedge
// `h`. The arcs of the graph were found with a visitor of the given type, or are some of those. Of
// several arcs between the two vertices, it is the one whose length is closest to the given one.
// Returns its length.
template <typename Visitor, typename F>
double trace_arc(const Intrinsic_triangulation& triangulation,
                 const Cone_rules& rules,
                 const Index source,
                 const Index target,
                 const double length,
                 F f)
{
  Line_search search{length};
  find_arc_of_graph<Visitor>(triangulation, rules, source, target, search);
  return report_line(triangulation, search, target, f);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H
