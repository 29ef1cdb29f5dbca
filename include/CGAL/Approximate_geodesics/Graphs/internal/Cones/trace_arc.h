// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>

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

  // the halfedges on the lines to a window, and its own
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

// Calls `f(h, t)` for the halfedges that the line from the origin to `end` crosses, at the part `t`
// of the way from their source to their target. `edge(i)` returns the positions of the source and
// the target of the `i`th one; it is called for one after the other. If an edge and the line are
// collinear, as where faces have no area, the line crosses it at its present position, or at
// the next point. The end may be the origin, where vertices are at the same place.
template <typename Edge, typename F>
void for_each_crossed_edge(const std::vector<Index>& halfedges,
                           const Plane_vector end,
                           Edge edge,
                           F f)
{
  constexpr double smallest_angle = 1e-9;
  const double line = length(end);
  const Plane_vector direction = dot(end, end) > 0 ? 1 / line * end : Plane_vector{1, 0};
  double here = 0; // on the line
  for(std::size_t i = 0; i < halfedges.size(); ++i)
  {
    const auto [left, right] = edge(i);
    const double to_left = std::abs(cross(direction, left));
    const double to_right = std::abs(cross(direction, right));
    const double start = dot(direction, left), step = dot(direction, right) - start;
    double t = 0;
    if(to_left + to_right > smallest_angle * length(right - left))
      t = to_left / (to_left + to_right);
    else if(step != 0)
      t = (std::clamp)((here - start) / step, 0., 1.);
    const double position = start + t * step;
    const bool is_beside_line = std::abs(step) > to_left + to_right; // badly conditioned
    if(is_beside_line && (position < here || position > line))
      t = (std::clamp)(((position < here ? here : line) - start) / step, 0., 1.);
    here = (std::max)(here, start + t * step);
    f(halfedges[i], t);
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
           smallest_difference < (std::numeric_limits<double>::min)();
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

  // Calls `f(h, t)` for the edges that the arc found crosses, of which `window` is the first.
  template <typename F>
  void for_each_crossing(const Intrinsic_triangulation& triangulation, Window window, F f) const
  {
    const Unfolding_on_demand unfolding{triangulation};
    const bool carries_edges = triangulation.thin_faces().has_extreme_needles();
    const std::vector<Index> halfedges = tree.halfedges(found.trail);
    const auto edge = [&](const std::size_t i) {
      if(i > 0)
      {
        const Unfolded_face face = unfolding[halfedges[i - 1]];
        window.go_on(triangulation, face, window.apex(face, carries_edges),
                     halfedges[i] != face.right, carries_edges);
      }
      return std::make_pair(window.left_position, window.right_position);
    };
    for_each_crossed_edge(halfedges, found.position, edge, f);
  }

  static constexpr double TOLERANCE = 1e-6; // single precision, flat faces

  Window_tree tree;
};

// Looks for the arc from one vertex to another in a discrete geodesic graph with these rules.
class Arc_search : public Line_search
{
public:
  Arc_search(const Intrinsic_triangulation& triangulation,
             const Cone_rules& rules,
             const Index source,
             const Index target,
             const double arc_length,
             const double rounding_of_length = 0)
    : Line_search(arc_length, rounding_of_length),
      m_triangulation(triangulation),
      m_rules(rules),
      m_source(source),
      m_target(target)
  {
  }

  // The arcs of the graph were found with a visitor of this type, or are some of those.
  template <typename Visitor>
  void find()
  {
    find(Within_reach<Visitor>{{}, reach()}, m_rules);
    if(!is_found())
      find(Visitor(), m_rules);
    find_in_doubt();
  }

  // Looks for an arc that was not found again, because of rounding: with a tolerance of visibility,
  // and with cones that end farther away.
  void find_in_doubt()
  {
    for(const double part : {1. / 4, 1. / 64, 1. / 1024})
      if(!is_found())
        find(Leave_out_nothing_in_doubt(), m_rules.farther(part));
  }

  // Whether there is any arc to the target. It has the length that is closest to the given one.
  bool has_arc() const { return found.target == m_target; }

  // Calls `f(h, t)` for the edges that the arc crosses, from its source on: at the point that is at
  // the part `t` of the way from the source to the target of the halfedge `h`. Returns its length.
  template <typename F>
  double for_each_crossing(F f) const
  {
    if(!has_arc())
      reject("the graph has an arc that is not in the mesh; was it read from a file that was "
             "changed?");
    const Unfolded_face face = Unfolding_on_demand{m_triangulation}[found.start];
    Window window = window_across(m_triangulation, m_source, found.start, face);
    window.edge = right_side(m_triangulation, found.start, face, window.right_position);
    Line_search::for_each_crossing(m_triangulation, window, f);
    return found.length;
  }

private:
  template <typename Visitor>
  void find(const Visitor& visitor, const Cone_rules& rules)
  {
    const Unfolding_on_demand unfolding{m_triangulation};
    const Cone_expansion<Unfolding_on_demand> expansion(m_triangulation, unfolding, rules);
    const auto consider = [&](const Straight_arc& arc) {
      if(arc.target == m_target)
        Line_search::consider(arc);
    };
    expansion.expand(m_source, consider, Remembering<Visitor>{visitor, tree});
  }

  const Intrinsic_triangulation& m_triangulation;
  const Cone_rules m_rules;
  const Index m_source, m_target;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_ARC_H
