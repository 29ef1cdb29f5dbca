// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_EXPANSION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_EXPANSION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Vertex_sights.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// The base of visitors of sights, which are notified neither of faces nor of sights, and end and
// defer none.
struct Sight_visitor_base
{
  static constexpr bool knows_arrivals = false;
  static constexpr bool wants_sights = false;
  static constexpr bool wants_faces = false;
  static constexpr bool ends_sights = false;
  static constexpr bool defers_sights = false;
};

/*
 * Follows straight lines from a tip, and reports to a visitor the vertices that they lead to. Lines
 * that are longer than the bounds of the labels allow are given up.
 *
 * The visitor has
 * - `bound(v)`: an upper bound on the lengths of shortest paths to `v` that are of interest;
 * - `on_vertex(v, path, sight, apex, left_edge)`: called for vertices that shortest paths may
 *   reach straight from the tip, when `sight` sees them in the face ahead;
 * - `label(v)`, `has_predecessor(v)` and `arrival(v)`, if it knows the lengths of real paths,
 *   whether their last line starts from a node, and how they arrive; the latter two are asked for
 *   where the first is finite;
 * - `on_sight(sight)` and `on_face(sight, apex)`, if it has to be notified;
 * - `is_end(sight)`, if it ends sights before a face;
 * - `horizon` and `defer(sight, milestone)`, if it defers sights through edges with both ends
 *   farther than the horizon from where the search starts; `defer()` returns whether it does.
 */
template <typename Visitor>
class Sight_expansion
{
  using Stack = boost::container::small_vector<Sight, 32>;

  static constexpr double rounding = Sight::ROUNDING;
  static constexpr std::size_t PARTS_BETWEEN_CHECKS = 4096; // milliseconds

public:
  Sight_expansion(const Sight_tables& tables, const double label_of_tip, Visitor& visitor)
    : m_tables(tables), m_steps(tables.steps), m_label_of_tip(label_of_tip), m_visitor(visitor)
  {
  }

  // Follows a sight through an edge. Its bounds are set here.
  void look(Sight sight, const Index left_end, const Index right_end)
  {
    sight.milestone = null_index;
    sight.depth = sight.number_of_milestones = 0;
    sight.left_end = left_end;
    sight.right_end = right_end;
    follow(sight);
  }

  // Follows a sight that was deferred, perhaps from another tip, with the milestone that the
  // visitor was given.
  void resume(const Sight& sight, const double label_of_tip, const Crossing& milestone)
  {
    m_label_of_tip = label_of_tip;
    m_milestones.resize(sight.number_of_milestones);
    m_milestones.back() = milestone; // the others are not needed
    follow(sight);
  }

private:
  // The third vertex of the face ahead.
  struct Apex
  {
    const Face_step& step;
    Plane_vector left_edge, position;
    double distance, bound;
  };

  double bound(const Index v) const { return m_visitor.bound(v) * (1 + rounding); }

  // Not inline, so that it is compiled once: another compilation may round differently.
  BOOST_NOINLINE void follow(Sight sight)
  {
    sight.left_bound = bound(sight.left_end);
    sight.right_bound = bound(sight.right_end);
    bool is_open = !sight.is_useless(m_label_of_tip);
    while(is_open || pop(m_stack, sight))
      is_open = advance(sight);
  }

  // Takes `sight` across the face ahead of it, which is the inner loop; a second part of it goes
  // onto the stack. Returns whether the sight is not empty.
  BOOST_FORCEINLINE bool advance(Sight& sight)
  {
    const Face_step& step = m_steps[sight.halfedge];
    m_steps.prefetch(step.left); // the next step is one of these
    m_steps.prefetch(step.right);
    if constexpr(Visitor::wants_sights)
      m_visitor.on_sight(sight);
    if(has_returned(sight, step.across))
      return false;
    if constexpr(Visitor::ends_sights)
      if(m_visitor.is_end(sight))
        return false;
    const Plane_vector left_edge = step.left_side(sight.edge), p = sight.apex(left_edge, step);
    const Apex apex{step, left_edge, p, length(p), bound(step.apex)};
    if constexpr(Visitor::wants_faces)
      m_visitor.on_face(sight, p);
    const double beyond_left = cross(sight.left_ray.direction, p),
                 beyond_right = cross(p, sight.right_ray.direction);
    // Most apexes are so far from the rays that a bound on the distance, which is known earlier,
    // tells the side.
    const double at_least_distance = std::abs(p.x) + std::abs(p.y);
    if(beyond_left > sight.left_ray.margin * at_least_distance)
      return go_right(sight, apex);
    if(beyond_right > sight.right_ray.margin * at_least_distance && beyond_left < 0)
      return go_left(sight, apex);
    return advance_past(apex, sight, beyond_left, beyond_right);
  }

  // The same if the apex is between the rays, or close to one of them.
  BOOST_FORCEINLINE bool
  advance_past(const Apex& apex, Sight& sight, const double beyond_left, const double beyond_right)
  {
    const double left_margin = sight.left_ray.margin * apex.distance,
                 right_margin = sight.right_ray.margin * apex.distance;
    const bool is_short = m_label_of_tip + apex.distance <= apex.bound;
    int side = beyond_left > left_margin ? 1 : beyond_right > right_margin ? -1 : 0;
    if(side == 0)
    {
      if(is_short)
        report(sight, apex);
      if(BOOST_UNLIKELY(!(beyond_left < -left_margin && beyond_right < -right_margin)))
      {
        side = side_at_ray(sight, apex, beyond_left, beyond_right);
        if(side > 0)
          sight.left_ray =
              sight.left_ray.before_fold(sight.left, sight.left_distance, apex.distance);
        if(side < 0)
          sight.right_ray =
              sight.right_ray.before_fold(sight.right, sight.right_distance, apex.distance);
      }
    }
    if(side != 0)
      return side > 0 ? go_right(sight, apex) : go_left(sight, apex);
    return split(sight, apex, is_short ? 0 : useful_side(sight, apex));
  }

  // Not inline, as few vertices are reached on a line that is not longer than their bounds. It
  // takes copies, so that the inner loop may keep all of the sight in registers.
  BOOST_NOINLINE void report(const Sight sight, const Apex apex)
  {
    const Sight_path path = sight.path_to(apex.position, apex.distance);
    if(m_label_of_tip + path.length <= apex.bound)
      m_visitor.on_vertex(apex.step.apex, path, sight, apex.position, apex.left_edge);
  }

  // Whether a sight returns to an edge, and is given up there: see `Winding`. If not, updates the
  // milestone and the depth.
  bool has_returned(Sight& sight, const double height_of_face)
  {
    if(BOOST_UNLIKELY(sight.halfedge == sight.milestone) && is_over(sight, height_of_face))
      return true;
    if(Winding::is_milestone(sight.depth))
    {
      if(m_tables.winding.is_over(sight.depth))
        return true;
      sight.milestone = sight.halfedge;
      append_milestone(sight.number_of_milestones++, sight.halfedge, sight.left, sight.right);
    }
    ++sight.depth;
    return false;
  }

  BOOST_NOINLINE bool is_over(const Sight sight, const double height_of_face) const
  {
    return m_tables.winding.is_over(
        {sight.halfedge, sight.left, sight.right}, m_milestones[sight.number_of_milestones - 1],
        sight.left_ray.direction, sight.right_ray.direction, height_of_face);
  }

  BOOST_NOINLINE void append_milestone(const std::size_t number_of_earlier,
                                       const Index halfedge,
                                       const Plane_vector left,
                                       const Plane_vector right)
  {
    m_milestones.resize(number_of_earlier);
    m_milestones.push_back({halfedge, left, right});
  }

  /*
   * On which side of the apex a sight continues if the apex is on a ray, up to rounding errors:
   * only on the side away from the ray, as the other part is no wider than these errors. If the
   * sight itself is as narrow, it continues on the wider side. Returns a positive number for the
   * right side, a negative one for the left side, and 0 if the sight is to be divided.
   */
  BOOST_NOINLINE int side_at_ray(const Sight sight,
                                 const Apex apex,
                                 const double beyond_left,
                                 const double beyond_right) const
  {
    const double distance = apex.distance;
    if(!(distance > 0)) // nothing is seen through an edge with both ends where the tip is
      return sight.right_distance > 0 ? 1 : -1;
    const Face_step& step = apex.step;
    const bool hides_nothing = m_tables.bends.hides_nothing(step.apex);
    const bool is_left_empty =
        hides_nothing && leads_away(step.left, apex.left_edge, sight.left_distance, distance);
    const bool is_right_empty = hides_nothing && leads_away(step.right, step.right_edge(sight.edge),
                                                            sight.right_distance, distance);
    const bool is_on_left = is_on(sight.left_ray, apex, beyond_left, is_left_empty);
    const bool is_on_right = is_on(sight.right_ray, apex, beyond_right, is_right_empty);
    if(is_on_left != is_on_right)
      return is_on_left ? 1 : -1;
    const bool is_narrow = beyond_left > -sight.left_ray.margin * distance &&
                           beyond_right > -sight.right_ray.margin * distance;
    if(is_on_left || (is_narrow && sight.is_behind(apex.position)))
      return beyond_left * sight.right_ray.margin < beyond_right * sight.left_ray.margin ? -1 : 1;
    return 0;
  }

  // Whether an apex counts as on a ray. Close to the ray inside the sight, it does so only if other
  // sights see all points between the two. The test of the direction excludes the other ray of a
  // sight that is as wide as half a plane.
  static bool
  is_on(const Sight_ray& ray, const Apex& apex, const double beyond, const bool is_rest_empty)
  {
    const double allowed = is_rest_empty ? Sight_ray::ROUNDING * ray.margin * apex.distance : 0;
    return beyond > -allowed && dot(ray.direction, apex.position) > 0;
  }

  // Whether an edge along a ray, from one end of the sight to the apex, leads away from the tip and
  // is not short: a vertex next to it is then in line with both of its ends, up to the rounding
  // errors of arrivals, and found by paths over these; unless it is between them, in a needle.
  bool leads_away(const Index h,
                  const Plane_vector edge,
                  const double distance_of_end,
                  const double distance_of_apex) const
  {
    constexpr double smallest_part = 1e-6;
    const double shortest = smallest_part * distance_of_apex, squared_length = dot(edge, edge);
    if(!(distance_of_apex > distance_of_end && squared_length > shortest * shortest))
      return false;
    if(h == null_index)
      return true;
    const Face_step& ahead = m_steps[h];
    const double thinnest = Sight_ray::TOLERANCE * distance_of_apex;
    return !(ahead.along > 0 && ahead.beyond > 0) ||
           ahead.across * ahead.across * squared_length > thinnest * thinnest;
  }

  /*
   * Where a shorter path is known to the apex that has crossed the same edge, one of the two parts
   * of a sight is useless: "one angle, one split" (J. Chen, Y. Han, Shortest paths on a polyhedron,
   * 1990). Where that path comes from farther right, seen from the apex, it crosses all lines from
   * the tip to points on the right of the apex, and makes them shorter from there on. Returns a
   * positive number if only the right part is of use, a negative one for the left part, and else 0.
   */
  int useful_side(const Sight& sight, const Apex& apex) const
  {
    if constexpr(Visitor::knows_arrivals)
    {
      const Index v = apex.step.apex;
      if(m_label_of_tip + apex.distance > m_visitor.label(v) * (1 + rounding))
      {
        const Arrival& other = m_visitor.arrival(v);
        if(other.halfedge == sight.halfedge && other.has_direction() &&
           m_visitor.has_predecessor(v)) // a line from a source may have started in the face
        {
          const double way =
              Arrival::across(sight.halfedge, apex.position, apex.left_edge).direction;
          return int(way > other.direction + Arrival::ROUNDING) -
                 int(way < other.direction - Arrival::ROUNDING);
        }
      }
    }
    return 0;
  }

  // Returns whether the sight is not followed now. Like `report()`, it takes a copy.
  BOOST_NOINLINE bool defer(const Sight sight) const
  {
    return sight.is_beaten(m_label_of_tip) ||
           m_visitor.defer(sight, m_milestones[sight.number_of_milestones - 1]);
  }

  BOOST_FORCEINLINE bool goes_on(const Sight& sight) const
  {
    if(sight.halfedge == null_index || sight.is_useless(m_label_of_tip))
      return false;
    if constexpr(Visitor::defers_sights)
      if(BOOST_UNLIKELY(m_label_of_tip + (std::min)(sight.left_distance, sight.right_distance) >
                        m_visitor.horizon))
        return !defer(sight);
    return true;
  }

  // Moves the sight to the edge between the apex and its right end.
  BOOST_FORCEINLINE bool go_right(Sight& sight, const Apex& apex) const
  {
    sight.halfedge = apex.step.right;
    sight.left_end = apex.step.apex;
    sight.left = apex.position;
    sight.edge = apex.step.right_edge(sight.edge);
    sight.left_distance = apex.distance;
    sight.left_bound = apex.bound;
    return goes_on(sight);
  }

  BOOST_FORCEINLINE bool go_left(Sight& sight, const Apex& apex) const
  {
    sight.halfedge = apex.step.left;
    sight.right_end = apex.step.apex;
    sight.right = apex.position;
    sight.edge = apex.left_edge;
    sight.right_distance = apex.distance;
    sight.right_bound = apex.bound;
    return goes_on(sight);
  }

  BOOST_FORCEINLINE bool split(Sight& sight, const Apex& apex, const int useful_side)
  {
    const Sight_ray between(apex.position, apex.distance, apex.bound);
    if(useful_side > 0)
    {
      sight.left_ray = between;
      return go_right(sight, apex);
    }
    if(useful_side == 0)
    {
      if(BOOST_UNLIKELY(++m_number_of_parts % PARTS_BETWEEN_CHECKS == 0))
        check_for_interruption();
      m_stack.push_back(sight);
      m_stack.back().left_ray = between;
      if(!go_right(m_stack.back(), apex))
        m_stack.pop_back();
    }
    sight.right_ray = between;
    return go_left(sight, apex);
  }

  const Sight_tables& m_tables;
  const Face_steps& m_steps;
  double m_label_of_tip;
  Visitor& m_visitor;
  Stack m_stack;
  std::size_t m_number_of_parts = 0; // of sights that were divided
  // of the sight that is followed; those on the stack share the first of them
  boost::container::static_vector<Crossing, 33> m_milestones;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_EXPANSION_H
