// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>

#include <boost/container/small_vector.hpp>

#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// The base of visitors of cones, which prune nothing and record no windows.
struct Cone_visitor_base
{
  static constexpr bool wants_distances = false;
  static constexpr bool wants_faces = false; // to be told of, by `on_face(cone, apex)`
  static constexpr double slack = 0;         // tolerance of visibility, relative to the distance
  bool prune(const Window& /* window */) const { return false; }
  std::uint32_t record_window(Index /* halfedge */, std::uint32_t /* trail */) const { return 0; }
};

// Leaves out arcs that a detour replaces well enough.
struct Leave_out_detours : Cone_visitor_base
{
  static constexpr bool leaves_out_arcs = true;
};

// Leaves out no arc that leads to a vertex in sight.
struct Leave_out_nothing : Cone_visitor_base
{
  static constexpr bool leaves_out_arcs = false;
};

// Finds every arc that the same visitor finds when compiled with other rounding (FMA).
struct Leave_out_nothing_in_doubt : Leave_out_nothing
{
  static constexpr double slack = 1e-9;
};

// Prunes windows that a search with these labels does not need: those where all points behind them
// are reached within the bound over an end of the window's edge. Does otherwise what `Visitor`
// does. `Cone_front::is_needed()` has the same test.
template <typename Visitor, typename Labels>
struct Label_pruning : Visitor
{
  static constexpr bool wants_distances = true;

  bool prune(const Window& w) const
  {
    const double edge = triangulation.length(w.halfedge);
    return labels.distance(w.left_end) - label_of_tip < factor * (w.right_distance - edge) ||
           labels.distance(w.right_end) - label_of_tip < factor * (w.left_distance - edge);
  }

  const Intrinsic_triangulation& triangulation;
  const Labels& labels;
  double label_of_tip;
  double factor; // of remaining lengths, in comparisons
};

/*
 * Finds the arcs of a vertex in a discrete geodesic graph: unfolds the faces around it outwards and
 * follows the cones of straight lines through them. The technical report proves the error bound.
 *
 * If there are extreme needles, cones carry the vectors of the edges that they come to: those of
 * short edges that are far away would be lost in differences of positions, and with them the
 * directions of needles.
 */
template <typename Unfolding>
class Cone_expansion
{
  using Stack = boost::container::small_vector<Cone, 32>;

public:
  Cone_expansion(const Intrinsic_triangulation& triangulation,
                 const Unfolding& unfolding,
                 const Cone_rules& rules)
    : m_triangulation(triangulation),
      m_unfolding(unfolding),
      m_rules(rules),
      m_winding(triangulation),
      m_carries_edges(triangulation.thin_faces().has_extreme_needles())
  {
  }

  // Calls `f` with the arcs that start from `source`; there may be several to the same vertex.
  // Windows for which `visitor.prune(window)` is true are not looked through.
  template <typename F, typename Visitor = Leave_out_detours>
  void expand(const Index source, F f, const Visitor visitor = Visitor()) const
  {
    Stack cones;
    Cone cone{};
    for(Index h = m_triangulation.first_halfedge(source);
        h < m_triangulation.beyond_halfedge(source); ++h)
    {
      const double distance = m_triangulation.length(h);
      f(Straight_arc{m_triangulation.target(h), distance, {distance, 0}, h, 0});
      bool is_open = open_first_cone(cone, source, h, visitor);
      while(is_open || pop(cones, cone))
        is_open = advance(cone, cones, source, h, f, visitor);
    }
  }

  // The same for the arcs from the origin through a window whose ends have distances above 0.
  template <typename F, typename Visitor>
  void expand_through(const View& view, F f, const Visitor visitor) const
  {
    const Window& window = view.window;
    const bool has_angle = cross(window.right_position, window.left_position) > 0 ||
                           dot(window.right_position, window.left_position) < 0; // a straight angle
    if(!has_angle || visitor.prune(window))
      return;
    Cone cone{window,
              side(window.left_position, window.left_distance),
              side(window.right_position, window.right_distance),
              0,
              {}};
    cone.window.trail = visitor.record_window(window.halfedge, 0);
    Stack cones;
    bool is_open = true;
    while(is_open || pop(cones, cone))
      is_open = advance(cone, cones, null_index, view.start, f, visitor);
  }

private:
  Cone_side side(const Plane_vector position, const double distance) const
  {
    const Plane_vector direction = 1 / distance * position;
    return {direction,
            distance,
            position,
            distance,
            m_rules.part_saved * distance,
            m_rules.large_part_saved * distance};
  }

  // Opens the cone across the face to the left of `h`, from its source. All functions that open a
  // cone or change its window return whether the cone is not empty.
  template <typename Visitor>
  bool open_first_cone(Cone& cone, const Index source, const Index h, const Visitor& visitor) const
  {
    const Unfolded_face& face = m_unfolding[h];
    if(face.apex == null_index || face.right == null_index)
      return false;
    const double distance = m_triangulation.length(h);
    const bool has_angle = face.across > 0 || face.along < 0; // the latter for a straight angle
    if(!(distance > 0 && has_angle))
      return false;
    Window& window = cone.window;
    window = window_across(m_triangulation, source, h, face);
    window.trail = visitor.record_window(face.right, 0);
    if(visitor.prune(window))
      return false;
    if(m_carries_edges)
      window.edge = right_side(m_triangulation, h, face, window.right_position);
    cone.left = side(window.left_position, window.left_distance);
    cone.right = side(window.right_position, distance);
    cone.has_middle = false;
    cone.depth = 0;
    cone.milestone = Crossing();
    return true;
  }

  // Takes `cone` across the face ahead of it; a second part of it goes onto the stack.
  template <typename F, typename Visitor>
  bool advance(Cone& cone,
               Stack& cones,
               const Index source,
               const Index start,
               F& f,
               const Visitor& visitor) const
  {
    const Unfolded_face& face = m_unfolding[cone.window.halfedge];
    if(has_ended(cone, face))
      return false;
    if(face.apex == source && !face.may_return)
      return false; // a shortest path does not come back to a face that it has left
    const Plane_vector apex = cone.window.apex(face, m_carries_edges);
    if constexpr(Visitor::wants_faces)
      visitor.on_face(cone, apex);
    double slack = 0;
    if constexpr(Visitor::slack > 0)
      slack = Visitor::slack * length(apex);
    if(cone.left.is_passed(apex, cross(cone.left.direction, apex) - slack))
      return go_on(cone.window, face, apex, false, visitor);
    if(cone.right.is_passed(apex, cross(apex, cone.right.direction) - slack))
      return go_on(cone.window, face, apex, true, visitor);

    const double distance = length(apex);
    if(!(distance > 0)) // the apex is where the source is, and sees the same
    {
      f(Straight_arc{face.apex, 0, apex, start, cone.window.trail});
      return false;
    }
    if constexpr(Visitor::leaves_out_arcs)
    {
      const bool left = cone.left.serves(apex, distance, cone.left.large_saving);
      const bool right = cone.right.serves(apex, distance, cone.right.large_saving);
      if(left || right)
        return !(left && right) && pass(cone, face, apex, distance, left, visitor);
    }
    f(Straight_arc{face.apex, distance, apex, start, cone.window.trail});
    return split(cone, cones, face, apex, distance, visitor);
  }

  // Moves the window to a side of the face ahead of it.
  template <typename Visitor>
  bool go_on(Window& window,
             const Unfolded_face& face,
             const Plane_vector apex,
             const bool goes_left,
             const Visitor& visitor) const
  {
    window.go_on(m_triangulation, face, apex, goes_left, m_carries_edges);
    if(Visitor::wants_distances)
      (goes_left ? window.right_distance : window.left_distance) = length(apex);
    if(window.halfedge == null_index || visitor.prune(window))
      return false;
    window.trail = visitor.record_window(window.halfedge, window.trail);
    return true;
  }

  // Whether no arc behind the window is needed. Lines may return to flipped edges, which are not
  // shortest paths.
  bool has_ended(Cone& cone, const Unfolded_face& face) const
  {
    if(!cone.has_middle)
      cone.find_middle();
    const Plane_vector edge = cone.window.left_position - cone.window.right_position;
    const double area = cross(cone.window.right_position, cone.window.left_position);
    const double slope = cross(cone.middle, edge);
    if(!(area >= 0 && slope > 0))
      return true; // no more than rounding errors
    return area >= cone.end_of_interest * slope || (!face.is_flipped && has_returned(cone, face));
  }

  // Whether lines return to an edge, and are given up there: see `Winding`. If not, updates the
  // milestone and the depth.
  bool has_returned(Cone& cone, const Unfolded_face& face) const
  {
    const Window& window = cone.window;
    const Crossing here{window.halfedge, window.left_position, window.right_position};
    if(m_winding.is_over(here, cone.milestone, cone.left.direction, cone.right.direction,
                         face.across))
      return true;
    if(Winding::is_milestone(cone.depth))
      cone.milestone = here;
    ++cone.depth;
    return false;
  }

  // One of the sides serves the apex, and thus all points seen between the two.
  template <typename Visitor>
  bool pass(Cone& cone,
            const Unfolded_face& face,
            const Plane_vector apex,
            const double distance,
            const bool left,
            const Visitor& visitor) const
  {
    (left ? cone.left : cone.right).move_to(apex, distance);
    cone.has_middle = false;
    return go_on(cone.window, face, apex, !left, visitor);
  }

  template <typename Visitor>
  bool split(Cone& cone,
             Stack& cones,
             const Unfolded_face& face,
             const Plane_vector apex,
             const double distance,
             const Visitor& visitor) const
  {
    const Cone_side between = side(apex, distance);
    cone.has_middle = false;
    Window window = cone.window;
    if(go_on(window, face, apex, false, visitor))
      cones.push_back({window, between, cone.right, cone.depth, cone.milestone});
    cone.right = between;
    return go_on(cone.window, face, apex, true, visitor);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding& m_unfolding;
  const Cone_rules m_rules;
  Winding m_winding;
  bool m_carries_edges;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H
