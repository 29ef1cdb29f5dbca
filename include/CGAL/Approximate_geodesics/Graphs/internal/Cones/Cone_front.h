// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Double_pair.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>

#include <boost/config.hpp>

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

// What bounds a cone on the left and on the right.
struct Cone_bounds
{
  // Whether a point is out of sight on the left and on the right: the test of
  // `Cone_side::is_passed()` for both sides, without branches.
  Double_pair::Mask is_passed_by(const Plane_vector point) const
  {
    const Double_pair point_x(point.x), point_y(point.y), zero(0);
    const Double_pair outside = Double_pair(1, -1) * (ray_x * point_y - ray_y * point_x);
    const Double_pair along = ray_x * point_x + ray_y * point_y;
    const Double_pair rounding = Double_pair(1e-14) * along; // or the opposite, if it is negative
    return (zero <= outside) &
           ((reach <= along) | ((rounding < outside) & (zero - rounding < outside)));
  }

  // The same on the left, and what bounds another cone on the right.
  Cone_bounds with_right(const Cone_bounds& other) const
  {
    return {x.with_right(other.x),
            y.with_right(other.y),
            distance.with_right(other.distance),
            rise.with_right(other.rise),
            ray_x.with_right(other.ray_x),
            ray_y.with_right(other.ray_y),
            reach.with_right(other.reach)};
  }

  // The ends of the edge that the window is on.
  Plane_vector left() const { return {x.left(), y.left()}; }
  Plane_vector right() const { return {x.right(), y.right()}; }

  Double_pair x, y;         // the positions of both ends, ...
  Double_pair distance;     // ... their distances ...
  Double_pair rise;         // ... and the differences of their labels and that of the tip
  Double_pair ray_x, ray_y; // the directions of the sides, which are rays through seen vertices ...
  Double_pair reach;        // ... and the distances of these vertices
};

/*
 * A cone of straight lines from a vertex, the tip, and the window that they go through: a part of
 * the edge between its ends. It takes two cache lines, unless `Way` is large.
 */
template <typename Way>
struct alignas(64) Narrow_cone
{
  Cone_bounds bounds;
  Index halfedge; // of the window; the face ahead is to its left
  Index tip;
  Index unused; // fills the cache lines, so that g++ copies each pair by itself
  Way way;      // a halfedge on the way, or `Crossing_and_edge`
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
 * advance together, a face at a time. Whether a cone is split, passes a vertex or is needed is
 * unpredictable, so no branch depends on it: each resulting cone is written, and the next one
 * overwrites it if it is not needed. Few cones end by their shape, so this is a branch. Paths find
 * these arcs again by `Cone_expansion`, whose cones must not end before these: see
 * `Lazy_discrete_geodesic_graph::rules_of_longest_arcs()`.
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
    Cone* end = m_memory.make_room(size + 1);
    for(std::size_t i = 0; i < number; ++i)
      end = open_cones(nodes[i], end);
    for(std::uint32_t depth = 0;; ++depth)
    {
      size = static_cast<std::size_t>(end - m_memory.next.data());
      if(size == 0)
        return;
      m_is_milestone = Winding::is_milestone(depth);
      std::swap(m_memory.cones, m_memory.next);
      m_arcs.make_room(size);
      end = m_memory.make_room(2 * size + 1);
      const Cone* const first = m_memory.cones.data();
      const Cone* const beyond = first + size;
      for(const Cone* cone = first; cone != beyond; ++cone)
      {
        if(beyond - cone > DISTANCE)
          m_unfolding.prefetch_sides(m_triangulation, cone[DISTANCE].halfedge);
        end = advance(*cone, end);
      }
    }
  }

private:
  static constexpr std::ptrdiff_t DISTANCE = 4; // in cones, at which data are prefetched

  // Appends the edges of a vertex, and what is seen across the faces around it. Cones are written
  // from `end` on. Returns where the next one is written.
  BOOST_FORCEINLINE Cone* open_cones(const Index v, Cone* end)
  {
    const double label = m_labels.distance(v);
    const Index first = m_triangulation.first_halfedge(v);
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = first; h < beyond; ++h)
    {
      const double length = m_triangulation.length(h);
      const Index target = m_triangulation.target(h);
      m_arcs.append(true, v, label, target, length);
      const Unfolded_face& face = m_unfolding[h];
      const bool has_angle = face.across > 0 || face.along < 0; // the latter for a straight angle
      if(face.apex == null_index || face.right == null_index || !(length > 0 && has_angle))
        continue;
      const Plane_vector left{length * face.along, length * face.across}, right{length, 0};
      const Double_pair distance(m_triangulation.length(m_triangulation.counterclockwise(v, h)),
                                 length);
      const Double_pair rise(m_labels.distance(face.apex) - label,
                             m_labels.distance(target) - label);
      const Plane_vector left_ray = 1 / distance.left() * left;
      *end = {{{left.x, right.x},
               {left.y, right.y},
               distance,
               rise,
               {left_ray.x, 1},
               {left_ray.y, 0},
               distance},
              face.right,
              v,
              0,
              first_way(h, face, right)};
      const double edge = m_triangulation.length(face.right);
      end += (rise < m_factor * (distance.swapped() - Double_pair(edge))).bits() == 0 ? 1 : 0;
      m_unfolding.prefetch(face.right);
    }
    return end;
  }

  // Takes a cone across the face ahead of it.
  BOOST_FORCEINLINE Cone* advance(const Cone& cone, Cone* const end)
  {
    const Unfolded_face& face = m_unfolding[cone.halfedge];
    if(!is_worth_a_look(cone, face))
      return end;
    const Plane_vector position = position_of_apex(cone, face);
    const int passed = cone.bounds.is_passed_by(position).bits();
    const bool passes_left = passed & 1, passes_right = passed == 2, is_seen = passed == 0;
    const double distance = length(position);
    const double label = m_labels.distance(cone.tip);
    const bool is_open = face.may_return | (face.apex != cone.tip);
    m_arcs.append(is_open & is_seen, cone.tip, label, face.apex, distance);

    const double rise = m_labels.distance(face.apex) - label;
    const Cone_bounds apex = bounds_at_apex(cone.bounds, position, distance, rise, is_seen);
    // An apex where the tip is sees the same.
    const bool goes_on = is_open & (!is_seen | (distance > 0));
    return append_both(cone, face, apex, goes_on & !passes_left, goes_on & !passes_right, end);
  }

  // What bounds the next cones at the apex, on either side. The old rays go on if it is not seen.
  static Cone_bounds bounds_at_apex(const Cone_bounds& before,
                                    const Plane_vector position,
                                    const double distance,
                                    const double rise,
                                    const bool is_seen)
  {
    const Double_pair::Mask turns(is_seen);
    const Plane_vector ray = 1 / (distance > 0 ? distance : 1) * position;
    return {Double_pair(position.x),
            Double_pair(position.y),
            Double_pair(distance),
            Double_pair(rise),
            turns.choose(Double_pair(ray.x), before.ray_x),
            turns.choose(Double_pair(ray.y), before.ray_y),
            turns.choose(Double_pair(distance), before.reach)};
  }

  // Appends the cones through the other two sides of a face that are open and that a search needs.
  // It does not need a cone if, by the labels, all points behind its window are reached within the
  // bound over an end of the window's edge: if, for all these points x,
  //   label(end) + (1 + epsilon) |end x| < label(tip) + (1 + epsilon) |tip x|.
  // The difference of the lengths is smallest at the other end of the edge.
  BOOST_FORCEINLINE Cone* append_both(const Cone& cone,
                                      const Unfolded_face& face,
                                      const Cone_bounds& apex,
                                      const bool is_left_open,
                                      const bool is_right_open,
                                      Cone* end) const
  {
    // valid halfedges if there is none ahead
    const Index left = face.left == null_index ? cone.halfedge : face.left;
    const Index right = face.right == null_index ? cone.halfedge : face.right;
    m_unfolding.prefetch(left);
    m_unfolding.prefetch(right);
    const Double_pair edges(m_triangulation.length(left), m_triangulation.length(right));
    const int not_needed = ((cone.bounds.rise < m_factor * (apex.distance - edges)) |
                            (apex.rise < m_factor * (cone.bounds.distance - edges)))
                               .bits();
    *end = {cone.bounds.with_right(apex), face.left, cone.tip, 0, next_way(cone, face, face.left)};
    end += (is_left_open & (face.left != null_index) & !(not_needed & 1)) ? 1 : 0;
    *end = {apex.with_right(cone.bounds), face.right, cone.tip, 0,
            next_way(cone, face, face.right)};
    return end + ((is_right_open & (face.right != null_index) & !(not_needed & 2)) ? 1 : 0);
  }

  Plane_vector position_of_apex(const Cone& cone, const Unfolded_face& face) const
  {
    if constexpr(IS_GENERAL)
      if(m_carries_edges)
        return cone.bounds.left() + face.left_side(cone.way.vector);
    return face.position_of_apex(cone.bounds.left(), cone.bounds.right());
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
    if constexpr(IS_GENERAL)
      return {m_is_milestone ? crossing(cone) : cone.way.milestone,
              halfedge == face.left
                  ? face.left_side(cone.way.vector)
                  : right_side(m_triangulation, cone.halfedge, face, cone.way.vector)};
    else
      return m_is_milestone ? cone.halfedge : cone.way;
  }

  static Crossing crossing(const Cone& cone)
  {
    return {cone.halfedge, cone.bounds.left(), cone.bounds.right()};
  }

  bool has_returned(const Cone& cone, const double height_of_face) const
  {
    if constexpr(IS_GENERAL)
      return m_winding.is_over(
          crossing(cone), cone.way.milestone, {cone.bounds.ray_x.left(), cone.bounds.ray_y.left()},
          {cone.bounds.ray_x.right(), cone.bounds.ray_y.right()}, height_of_face);
    else
      return cone.halfedge == cone.way;
  }

  // Whether arcs behind the window may be needed. They are not if the vertex on one of the sides
  // serves the vertex on the other side, or if both serve the points behind the window on the line
  // in their middle: see `Cone_side`. Here, a vertex serves a point if the way over it saves all of
  // the distance of the vertex, but for the part that may be lost. In a triangle whose sides
  // enclose an angle with the cosine `cosine`, this amounts to the two comparisons below.
  bool is_worth_a_look(const Cone& cone, const Unfolded_face& face) const
  {
    const double nearer = (std::min)(cone.bounds.reach.left(), cone.bounds.reach.right());
    const double farther = (std::max)(cone.bounds.reach.left(), cone.bounds.reach.right());
    const Plane_vector left{cone.bounds.ray_x.left(), cone.bounds.ray_y.left()};
    const Plane_vector right{cone.bounds.ray_x.right(), cone.bounds.ray_y.right()};
    const double cosine = dot(left, right);
    const bool serves_other = farther * (cosine - m_part_saved) >= m_part_lost * nearer;

    const Plane_vector edge = cone.bounds.left() - cone.bounds.right();
    const double area = cross(cone.bounds.right(), cone.bounds.left());
    const double slope = cross(left + right, edge); // of the middle
    const double gain = 1 + cosine - m_part_saved * std::sqrt((std::max)(2 + 2 * cosine, 0.));
    const bool both_serve = (gain > 0) & (area * gain >= m_part_lost * farther * slope);

    const bool is_plane = area >= 0 && (slope > 0 || cosine < 0); // up to rounding
    const bool winds = has_returned(cone, face.across) && !face.is_flipped;
    return !(serves_other | both_serve) && is_plane && !winds;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding& m_unfolding;
  const Labels& m_labels;
  Arcs& m_arcs;
  const Winding m_winding;
  const bool m_carries_edges; // read if the front is general
  Double_pair m_factor;       // of remaining lengths, in comparisons
  double m_part_saved;        // of the distance of a vertex, by going over it
  double m_part_lost;
  Cone_memories<Cone>& m_memory;
  bool m_is_milestone = false; // whether lines remember the halfedges of the cones that advance
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_FRONT_H
