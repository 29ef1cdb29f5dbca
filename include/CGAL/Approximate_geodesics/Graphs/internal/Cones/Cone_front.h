// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The data of a cone in addition to its window if lines may return to an edge, or there are extreme
// needles: see `Winding` and `Cone_expansion`.
struct Crossing_and_edge
{
  Crossing milestone;  // one of the halfedges on the way
  Plane_vector vector; // of the edge of the window, from its left end
};

/*
 * A cone of straight lines from a vertex, the tip, and the window that they go through: a part of
 * the edge between its ends. It takes two cache lines, unless `Way` is large.
 */
template <typename Way>
struct alignas(64) Narrow_cone
{
  // A ray through a vertex that is seen from the tip.
  struct Side
  {
    // the test of `Cone_side::is_passed()`, without branches
    bool is_passed(const Plane_vector x, const double outside) const
    {
      constexpr double rounding = 1e-14;
      const double along = dot(direction, x);
      return (outside >= 0) & ((along >= distance) | (outside > rounding * std::abs(along)));
    }

    Plane_vector direction; // of length 1
    double distance;        // of the vertex
  };

  // An end of the edge that the window is on.
  struct End
  {
    Plane_vector position;
    double distance;
    double rise; // from the label of the tip to that of the end
  };

  End left, right;
  Side left_side, right_side;
  Index halfedge; // of the window; the face ahead is to its left
  Index tip;
  std::uint32_t depth; // the number of faces on the way
  Way way;             // a halfedge on the way, or `Crossing_and_edge`
};

// Memory for the cones of a front, and for those that they become.
template <typename Cone>
struct Cone_memories
{
  // Makes room for `size` of the latter. What is there may be lost.
  Cone* make_room(const std::size_t size)
  {
    if(size > next.size())
    {
      next.clear(); // is not copied
      next.resize(2 * size);
    }
    return next.data();
  }

  std::size_t memory() const { return memory_of(cones, next); }

  std::vector<Cone, Uninitialized_allocator<Cone>> cones, next;
};

// Memory for one front after the other, of either kind. Each thread has one, in a cache line of its
// own.
struct alignas(64) Front_memory
{
  template <typename Cone>
  Cone_memories<Cone>& get()
  {
    return std::get<Cone_memories<Cone>>(both);
  }

  std::size_t memory() const { return memory_of(std::get<0>(both), std::get<1>(both)); }

  std::tuple<Cone_memories<Narrow_cone<Index>>, Cone_memories<Narrow_cone<Crossing_and_edge>>> both;
};

// Whether cones on a triangulation need a front that is general.
inline bool needs_general_front(const Intrinsic_triangulation& triangulation)
{
  return triangulation.lines_may_return() || triangulation.thin_faces().has_extreme_needles();
}

/*
 * Finds arcs of several vertices that a search with these labels may need. The cones of all of them
 * advance together, a face at a time. Whether a cone is split, passes a vertex or ends is
 * unpredictable, so no branch depends on it: each resulting cone is written, and the next one
 * overwrites it if it is not needed. Paths find these arcs again by `Cone_expansion`, whose cones
 * must not end before these: see `Lazy_discrete_geodesic_graph::rules_of_longest_arcs()`.
 *
 * A front that is not general is for triangulations where lines do not return, and that have no
 * extreme needles.
 *
 * `arcs` receives the arcs: `arcs.make_room(number)` reserves memory for that many, and
 * `arcs.append(is_arc, source, label_of_source, target, length)` appends an arc if `is_arc` is
 * true.
 */
template <bool IS_GENERAL, typename Unfolding, typename Labels, typename Arcs>
class Cone_front
{
  using Way = std::conditional_t<IS_GENERAL, Crossing_and_edge, Index>;
  using Cone = Narrow_cone<Way>;
  using Side = typename Cone::Side;
  using End = typename Cone::End;

public:
  Cone_front(const Intrinsic_triangulation& triangulation,
             const Unfolding& unfolding,
             const double epsilon,
             const Labels& labels,
             Arcs& arcs,
             Front_memory& memory)
    : m_triangulation(triangulation),
      m_unfolding(unfolding),
      m_labels(labels),
      m_arcs(arcs),
      m_winding(triangulation),
      m_carries_edges(triangulation.thin_faces().has_extreme_needles()),
      m_factor(1 + epsilon),
      m_part_saved(1 / (1 + Cone_rules::share_of_ends_beside_labels(epsilon) * epsilon)),
      m_part_lost((1 - m_part_saved * m_part_saved) / 2),
      m_memory(memory.get<Cone>())
  {
  }

  void expand(const Index* const nodes, const std::size_t number)
  {
    std::size_t size = 0;
    for(std::size_t i = 0; i < number; ++i)
      size += m_triangulation.beyond_halfedge(nodes[i]) - m_triangulation.first_halfedge(nodes[i]);
    m_arcs.make_room(size);
    m_end = m_memory.make_room(size + 1);
    for(std::size_t i = 0; i < number; ++i)
      open_cones(nodes[i]);
    for(;;)
    {
      size = static_cast<std::size_t>(m_end - m_memory.next.data());
      if(size == 0)
        return;
      std::swap(m_memory.cones, m_memory.next);
      m_arcs.make_room(size);
      m_end = m_memory.make_room(2 * size + 1);
      const Cone* const first = m_memory.cones.data();
      const Cone* const beyond = first + size;
      for(const Cone* cone = first; cone != beyond; ++cone)
      {
        if(beyond - cone > DISTANCE)
          m_unfolding.prefetch_sides(m_triangulation, cone[DISTANCE].halfedge);
        advance(*cone);
      }
    }
  }

private:
  static constexpr std::ptrdiff_t DISTANCE = 4; // in cones, at which data are prefetched

  // Appends the edges of a vertex, and what is seen across the faces around it.
  void open_cones(const Index v)
  {
    const double label = m_labels.distance(v);
    const Index first = m_triangulation.first_halfedge(v);
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = first; h < beyond; ++h)
    {
      const double distance = m_triangulation.length(h);
      const Index target = m_triangulation.target(h);
      m_arcs.append(true, v, label, target, distance);
      const Unfolded_face& face = m_unfolding[h];
      const bool has_angle = face.across > 0 || face.along < 0; // the latter for a straight angle
      if(face.apex == null_index || face.right == null_index || !(distance > 0 && has_angle))
        continue;
      const double distance_of_apex =
          m_triangulation.length(m_triangulation.counterclockwise(v, h));
      const Plane_vector apex{distance * face.along, distance * face.across};
      const End left{apex, distance_of_apex, m_labels.distance(face.apex) - label};
      const End right{{distance, 0}, distance, m_labels.distance(target) - label};
      *m_end = {left,
                right,
                {1 / distance_of_apex * apex, distance_of_apex},
                {{1, 0}, distance},
                face.right,
                v,
                0,
                first_way(h, face, right.position)};
      m_end += is_needed(left, right, face.right) ? 1 : 0;
      m_unfolding.prefetch(face.right);
    }
  }

  // Takes a cone across the face ahead of it.
  void advance(const Cone& cone)
  {
    const Unfolded_face& face = m_unfolding[cone.halfedge];
    const Plane_vector position = position_of_apex(cone, face);
    const bool passes_left =
        cone.left_side.is_passed(position, cross(cone.left_side.direction, position));
    const bool passes_right =
        !passes_left &
        cone.right_side.is_passed(position, cross(position, cone.right_side.direction));
    const bool is_seen = !(passes_left | passes_right);
    const double distance = length(position);
    const double label = m_labels.distance(cone.tip);
    const End apex{position, distance, m_labels.distance(face.apex) - label};
    const bool is_of_use = is_worth_a_look(cone, face);
    const bool is_open = is_of_use & (face.may_return | (face.apex != cone.tip));
    m_arcs.append(is_open & is_seen, cone.tip, label, face.apex, distance);

    // An apex where the tip is sees the same.
    const bool goes_on = is_open & (!is_seen | (distance > 0));
    const Side side{1 / (distance > 0 ? distance : 1) * position, distance};
    append(cone, cone.left, apex, cone.left_side, is_seen ? side : cone.right_side, face, face.left,
           goes_on & !passes_left);
    append(cone, apex, cone.right, is_seen ? side : cone.left_side, cone.right_side, face,
           face.right, goes_on & !passes_right);
  }

  void append(const Cone& before,
              const End& left,
              const End& right,
              const Side& left_side,
              const Side& right_side,
              const Unfolded_face& face,
              const Index halfedge,
              const bool is_open)
  {
    *m_end = {left,     right,      left_side,        right_side,
              halfedge, before.tip, before.depth + 1, next_way(before, face, halfedge)};
    // a valid halfedge if there is none ahead
    const Index edge = halfedge == null_index ? before.halfedge : halfedge;
    m_unfolding.prefetch(edge);
    m_end += (is_open & (halfedge != null_index) & is_needed(left, right, edge)) ? 1 : 0;
  }

  Plane_vector position_of_apex(const Cone& cone, const Unfolded_face& face) const
  {
    if constexpr(IS_GENERAL)
      if(m_carries_edges)
        return cone.left.position + face.left_side(cone.way.vector);
    return face.position_of_apex(cone.left.position, cone.right.position);
  }

  // The `Way` of a cone across the first face, to the left of `h`, whose vector is `edge`.
  Way first_way(const Index h, const Unfolded_face& face, const Plane_vector edge) const
  {
    if constexpr(IS_GENERAL)
      return {Crossing(), right_side(m_triangulation, h, face, edge)};
    else
      return null_index;
  }

  // The `Way` of a cone after it has crossed its window and the face ahead, to `halfedge`.
  Way next_way(const Cone& cone, const Unfolded_face& face, const Index halfedge) const
  {
    const bool is_milestone = Winding::is_milestone(cone.depth);
    if constexpr(IS_GENERAL)
      return {is_milestone ? crossing(cone) : cone.way.milestone,
              halfedge == face.left
                  ? face.left_side(cone.way.vector)
                  : right_side(m_triangulation, cone.halfedge, face, cone.way.vector)};
    else
      return is_milestone ? cone.halfedge : cone.way;
  }

  static Crossing crossing(const Cone& cone)
  {
    return {cone.halfedge, cone.left.position, cone.right.position};
  }

  bool has_returned(const Cone& cone, const double height_of_face) const
  {
    if constexpr(IS_GENERAL)
      return m_winding.is_over(crossing(cone), cone.way.milestone, cone.left_side.direction,
                               cone.right_side.direction, height_of_face);
    else
      return cone.halfedge == cone.way;
  }

  // Whether a search needs the points behind a window. It does not if, by the labels, all of them
  // are reached within the bound over an end of the window's edge: if, for all these points x,
  //   label(end) + (1 + epsilon) |end x| < label(tip) + (1 + epsilon) |tip x|.
  // The difference of the lengths is smallest at the other end of the edge.
  bool is_needed(const End& left, const End& right, const Index halfedge) const
  {
    const double edge = m_triangulation.length(halfedge);
    return !((left.rise < m_factor * (right.distance - edge)) |
             (right.rise < m_factor * (left.distance - edge)));
  }

  // Whether arcs behind the window may be needed. They are not if the vertex on one of the sides
  // serves the vertex on the other side, or if both serve the points behind the window on the line
  // in their middle: see `Cone_side`. Here, a vertex serves a point if the way over it saves all of
  // the distance of the vertex, but for the part that may be lost. In a triangle whose sides
  // enclose an angle with the cosine `cosine`, this amounts to the two comparisons below.
  bool is_worth_a_look(const Cone& cone, const Unfolded_face& face) const
  {
    const Side& left = cone.left_side;
    const Side& right = cone.right_side;
    const double nearer = (std::min)(left.distance, right.distance);
    const double farther = (std::max)(left.distance, right.distance);
    const double cosine = dot(left.direction, right.direction);
    const bool serves_other = farther * (cosine - m_part_saved) >= m_part_lost * nearer;

    const Plane_vector edge = cone.left.position - cone.right.position;
    const double area = cross(cone.right.position, cone.left.position);
    const double slope = cross(left.direction + right.direction, edge); // of the middle
    const double gain = 1 + cosine - m_part_saved * std::sqrt((std::max)(2 + 2 * cosine, 0.));
    const bool both_serve = (gain > 0) & (area * gain >= m_part_lost * farther * slope);

    const bool is_plane = (area >= 0) & ((slope > 0) | (cosine < 0)); // up to rounding
    const bool winds = !face.is_flipped & has_returned(cone, face.across);
    return is_plane & !(serves_other | both_serve | winds);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding& m_unfolding;
  const Labels& m_labels;
  Arcs& m_arcs;
  const Winding m_winding;
  const bool m_carries_edges; // read if the front is general
  double m_factor;            // of remaining lengths, in comparisons
  double m_part_saved;        // of the distance of a vertex, by going over it
  double m_part_lost;
  Cone_memories<Cone>& m_memory;
  Cone* m_end = nullptr; // where the next cone is written
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H
