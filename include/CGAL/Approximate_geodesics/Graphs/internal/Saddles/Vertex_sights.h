// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_VERTEX_SIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_VERTEX_SIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Whether shortest paths can bend at a vertex: at saddle vertices, whose angles add up to more than
 * 2 pi, and at border vertices whose angles add up to more than pi; and where they cannot, whether
 * the surface, or its border, is straight there.
 *
 * Letting paths bend at a vertex without need costs time, but changes no distance. So paths may
 * bend by any angle at a vertex whose angle is uncertain because of a face without area or an edge
 * without length, and at a vertex where several parts of the surface meet, with borders between
 * them: there, paths go from one part to the others.
 */
enum class Bend_kind : std::uint8_t
{
  NONE,         // the angle is less than 2 pi, or less than pi at the border
  NONE_AS_FLAT, // the surface, or its border, is straight
  SADDLE,
  BORDER,
  ANY // by any angle, as the angle of the vertex is uncertain, or several parts meet
};

class Bends
{
public:
  // A bound on the errors of angles of faces that are not too thin.
  static constexpr double ROUNDING = 1e-11;
  static constexpr double FLAT = 1e-11;

  Bends(const Intrinsic_triangulation& triangulation, const Face_steps& steps)
  {
    if(!add_all(triangulation, steps, ROUNDING))
      heed_thin_faces(triangulation, steps);
    const auto number = static_cast<double>((std::max)(m_bends.size(), std::size_t(1)));
    m_mean_excess /= number;
    m_spacing = std::sqrt(m_spacing / number / (3 * std::sqrt(3.)));
    m_share_of_bends = static_cast<double>(std::count_if(
                           m_bends.begin(), m_bends.end(),
                           [](const Bend_kind kind) { return kind >= Bend_kind::SADDLE; })) /
                       number;
  }

  std::size_t number_of_vertices() const { return m_bends.size(); }
  Bend_kind operator[](const Index v) const { return m_bends[v]; }

  bool is_possible(const Index v) const { return m_bends[v] >= Bend_kind::SADDLE; }

  // Whether a vertex on one of the rays of a sight hides nothing from lines that pass it on the
  // inside only: all points behind it are seen past it, or paths can bend there. If lines went on
  // between two border vertices on the rays, one to the left and one to the right, rounding would
  // decide whether a line is found on the way back.
  bool hides_nothing(const Index v) const { return m_bends[v] != Bend_kind::NONE; }

  // The mean, over all vertices, of what the angles of saddle vertices exceed 2 pi by. Where it is
  // large, the surface is rough, and many sights start from each of these vertices.
  double mean_excess() const { return m_mean_excess; }

  // The length of edges if the same area had as many vertices, and equilateral faces.
  double spacing() const { return m_spacing; }

  // The share of vertices where paths can bend.
  double share_of_bends() const { return m_share_of_bends; }

  std::size_t memory() const { return memory_of(m_bends); }

private:
  // Whether the face to the left of a halfedge of this length, if there is one, is neither a needle
  // nor degenerate, by far: a quick test.
  static bool is_well_shaped(const Face_step& step, const double length)
  {
    constexpr double least = 0x1p-10, most = 0x1p10;
    return !step.has_face() ||
           (step.across > least && step.across < most && std::abs(step.along) < most &&
            least * length > Sight::SHORTEST_EDGE);
  }

  // Returns whether all faces are well shaped.
  bool add_all(const Intrinsic_triangulation& triangulation,
               const Face_steps& steps,
               const double largest_at_border)
  {
    m_bends.clear();
    m_bends.reserve(triangulation.number_of_vertices());
    m_mean_excess = m_spacing = 0;
    bool are_well_shaped = true;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      m_bends.push_back(bend(triangulation, steps, v, largest_at_border, are_well_shaped));
    return are_well_shaped;
  }

  void heed_thin_faces(const Intrinsic_triangulation& triangulation, const Face_steps& steps)
  {
    // Lines that rounding hides on one side of a border vertex are not found on another side.
    // Across needles, rounding may hide lines along a straight border, so paths may bend even if
    // the angle is slightly less than pi. They are continued only if their slack makes up for the
    // difference.
    if(has_needles(triangulation, steps))
      add_all(triangulation, steps, -Arrival::ROUNDING);
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(!is_well_shaped(steps[h], triangulation.length(h)) &&
         is_degenerate(triangulation, steps, h))
        m_bends[steps[h].apex] = Bend_kind::ANY;
  }

  // Whether any face is so thin that positions across it lose a third of their digits.
  static bool has_needles(const Intrinsic_triangulation& triangulation, const Face_steps& steps)
  {
    constexpr double smallest_height = 1e-6; // over a side, relative to its length
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(steps[h].has_face() && !(steps[h].across > smallest_height))
        return true;
    return false;
  }

  static bool is_degenerate(const Intrinsic_triangulation& triangulation,
                            const Face_steps& steps,
                            const Index h)
  {
    // if an edge is shorter than the rounding errors of the others, its ends may coincide
    constexpr double smallest_part = 1e-12;
    const Face_step& step = steps[h];
    const bool has_area = step.across > 0 && step.across < 1e200 && std::abs(step.along) < 1e200;
    const Index second = triangulation.next(h), third = triangulation.next(second);
    const auto [shortest, longest] = std::minmax(
        {triangulation.length(h), triangulation.length(second), triangulation.length(third)});
    return !has_area || !(shortest > (std::max)(Sight::SHORTEST_EDGE, smallest_part * longest));
  }

  // Clears `are_well_shaped` if a face at the vertex is not. Where all are, angles are added up as
  // a product of complex numbers, whose sizes are ratios of lengths: without roots and divisions.
  Bend_kind bend(const Intrinsic_triangulation& triangulation,
                 const Face_steps& steps,
                 const Index v,
                 const double largest_at_border,
                 bool& are_well_shaped)
  {
    constexpr Index largest_degree = 64; // so that a `double` holds the product
    Plane_vector rest{1, 0};
    int half_turns = 0, number_of_borders = 0;
    bool is_plain = triangulation.degree(v) <= largest_degree;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      const Face_step& step = steps[h];
      const double length = triangulation.length(h);
      if(!is_well_shaped(step, length))
        is_plain = are_well_shaped = false;
      m_spacing += step.across * length * length; // twice the area, for each side
      if(!step.has_face())
        ++number_of_borders;
      else if(rest = turned_left(rest, {step.along, step.across}); rest.y < 0)
      {
        rest = -1 * rest;
        ++half_turns;
      }
    }
    if(number_of_borders > 1)
      return Bend_kind::ANY;
    const bool is_at_border = number_of_borders > 0;
    const int straight = is_at_border ? 1 : 2;
    double excess = (half_turns - straight) * straight_angle;
    if(!is_plain)
      excess = sum_of_angles(triangulation, steps, v) - straight * straight_angle;
    else if(half_turns >= straight || is_nearly_straight(rest)) // if not, it is far below zero
      excess += std::atan2(rest.y, rest.x);
    m_mean_excess += is_at_border ? 0 : (std::max)(0., excess);
    if(excess > (is_at_border ? largest_at_border : ROUNDING))
      return is_at_border ? Bend_kind::BORDER : Bend_kind::SADDLE;
    return excess >= -FLAT ? Bend_kind::NONE_AS_FLAT : Bend_kind::NONE;
  }

  static bool is_nearly_straight(const Plane_vector angle)
  {
    constexpr double difference = 4 * Arrival::ROUNDING;
    return angle.x < 0 && angle.y < difference * -angle.x;
  }

  static double sum_of_angles(const Intrinsic_triangulation& triangulation,
                              const Face_steps& steps,
                              const Index v)
  {
    Angle_sum sum;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      if(steps[h].has_face())
        sum.add(unit_corner(steps[h]));
    return sum.value();
  }

  std::vector<Bend_kind> m_bends; // per vertex
  double m_mean_excess = 0;       // a sum until all vertices are added
  double m_spacing = 0;           // likewise, of areas
  double m_share_of_bends = 0;
};

/*
 * The sectors around a vertex that shortest paths may go on to, if they arrive there on a given
 * line: those that leave an angle of at least pi to that line, on both sides.
 */
class Bend_sectors
{
public:
  Bend_sectors(const Intrinsic_triangulation& triangulation, const Face_steps& steps, const Index v)
    : m_triangulation(triangulation), m_steps(steps), m_vertex(v)
  {
  }

  // One end of a sector: a direction in the face to the left of a halfedge, which is the x axis.
  struct Boundary
  {
    Index halfedge = null_index;
    Plane_vector direction = {1, 0};

    bool exists() const { return halfedge != null_index; }
  };

  // The direction at the angle pi counterclockwise from the line; none if there is a border before
  // it.
  Boundary right_boundary(const Arrival& arrival) const
  {
    Index h = side(arrival);
    if(!m_steps[h].has_face())
      return {};
    Plane_vector angle = turned_right(corner(h), way_back(arrival));
    angle = turned_left(angle.y > 0 ? angle : Plane_vector{1, 0}, slack());
    if(is_straight(angle)) // the rest of the face and the slack
      angle = {-1, 0};
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      h = m_triangulation.counterclockwise(m_vertex, h);
      if(!m_steps[h].has_face())
        return {};
      const Plane_vector next = turned_left(angle, corner(h));
      if(is_straight(next) || next.y < 0)
        return {h, {-angle.x, angle.y}};
      angle = next;
    }
    return {};
  }

  // The same clockwise.
  Boundary left_boundary(const Arrival& arrival) const
  {
    Index h = side(arrival);
    Plane_vector angle = turned_left(way_back(arrival), slack());
    if(is_straight(angle)) // the line and the slack
      angle = {-1, 0};
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      h = m_triangulation.clockwise(m_vertex, h);
      if(!m_steps[h].has_face())
        return {};
      const Plane_vector c = corner(h), next = turned_left(angle, c);
      if(is_straight(next) || next.y < 0)
        return {h, turned_right(c, {-angle.x, angle.y})};
      angle = next;
    }
    return {};
  }

  // The direction that the line comes from, turned by an angle to the right, or to the left; the
  // side of the face if there is a border before it.
  Boundary right_of(const Arrival& arrival, const double angle) const
  {
    Index h = side(arrival);
    Plane_vector direction = turned_right(way_back(arrival), unit_vector(angle));
    for(Index n = m_triangulation.degree(m_vertex); n > 0 && direction.y < 0; --n)
    {
      const Index next = m_triangulation.clockwise(m_vertex, h);
      if(!m_steps[next].has_face())
        return {h, {1, 0}};
      h = next;
      direction = turned_left(direction, corner(h));
    }
    return {h, direction.y < 0 ? Plane_vector{1, 0} : direction};
  }

  // does not exist if there is no border, and the angle is at least the total angle of the vertex

  Boundary left_of(const Arrival& arrival, const double angle) const
  {
    Index h = side(arrival);
    Plane_vector direction = turned_left(way_back(arrival), unit_vector(angle));
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      if(!m_steps[h].has_face())
        return {h, {1, 0}};
      if(!(cross(corner(h), direction) > 0))
        return {h, direction};
      const Index next = m_triangulation.counterclockwise(m_vertex, h);
      if(!m_steps[next].has_face())
        return {h, corner(h)};
      direction = turned_right(direction, corner(h));
      h = next;
    }
    return {};
  }

  // Calls `f(h, cosine)` for the halfedges from the vertex: with the cosine of the angle to the
  // line on that side where it is smaller, up to pi.
  template <typename F>
  void for_each_cosine(const Arrival& arrival, F f) const;

private:
  // `angle` is small
  static Plane_vector unit_vector(const double angle)
  {
    return 1 / std::sqrt(1 + angle * angle) * Plane_vector{1, angle};
  }

  // Whether a sum of angles of less than pi and a small angle is a straight angle, or more.
  static bool is_straight(const Plane_vector angle) { return angle.y <= 0 && angle.x < 0; }

  static Plane_vector slack() { return unit_vector(Arrival::ROUNDING); }

  // The halfedge from the vertex whose face the line has come through, or that it has come along.
  Index side(const Arrival& arrival) const
  {
    if(arrival.is_along_halfedge())
      return m_triangulation.opposite(arrival.halfedge);
    return m_triangulation.next(m_triangulation.next(arrival.halfedge));
  }

  static Plane_vector way_back(const Arrival& arrival)
  {
    return arrival.is_along_halfedge() ? Plane_vector{1, 0} : arrival.way_back();
  }

  Plane_vector corner(const Index h) const { return unit_corner(m_steps[h]); }

  const Intrinsic_triangulation& m_triangulation;
  const Face_steps& m_steps;
  const Index m_vertex;
};

// What is computed in advance for searches for lines of sight.
struct Sight_tables
{
  // Throws if a face breaks the triangle inequality.
  Sight_tables(const Intrinsic_triangulation& triangulation, const Loop& loop)
    : steps(triangulation, loop), bends(triangulation, steps), winding(triangulation)
  {
  }

  std::size_t memory() const { return memory_of(steps, bends); }

  Face_steps steps;
  Bends bends;
  Winding winding;
};

/*
 * The edges, and the sights across faces, on which paths continue that arrive at a vertex on a
 * given line.
 */
class Vertex_sights
{
  using Boundary = Bend_sectors::Boundary;

public:
  Vertex_sights(const Intrinsic_triangulation& triangulation, const Sight_tables& tables)
    : m_triangulation(triangulation), m_steps(tables.steps), m_bends(tables.bends)
  {
  }

  // Calls `on_edge(h)` for edges, and `on_sight(sight, left_end, right_end)`.
  template <typename OnEdge, typename OnSight>
  void for_each(const Index v, const Arrival& arrival, OnEdge on_edge, OnSight on_sight) const
  {
    for_each_corner(v, arrival, on_edge,
                    [&](const Index h, const Plane_vector right, const Plane_vector left) {
                      open(h, right, left, on_sight);
                    });
  }

  // Calls `on_edge(h)` for edges, and `on_corner(h, right, left)` for the faces ahead, to the left
  // of `h`, with the directions between which paths continue; `h` is the x axis.
  template <typename OnEdge, typename OnCorner>
  void
  for_each_corner(const Index v, const Arrival& arrival, OnEdge on_edge, OnCorner on_corner) const
  {
    const Index first = m_triangulation.first_halfedge(v),
                beyond = m_triangulation.beyond_halfedge(v);
    if(arrival.is_none() || m_bends[v] == Bend_kind::ANY ||
       (arrival.is_unknown() && m_bends.is_possible(v)))
    {
      for(Index h = first; h < beyond; ++h)
      {
        on_edge(h);
        on_corner(h, Plane_vector{1, 0}, unit_corner(m_steps[h]));
      }
      return;
    }
    if(!m_bends.is_possible(v) || arrival.is_on_curve())
      return;
    const Bend_sectors sectors(m_triangulation, m_steps, v);
    const Boundary right = sectors.right_boundary(arrival), left = sectors.left_boundary(arrival);
    if(right.exists())
      for_each_corner_of_sector(v, right, left, on_edge, on_corner);
    if(left.exists() && m_bends[v] == Bend_kind::BORDER)
      for_each_corner_of_sector(v, {first_after_border(v)}, left, on_edge, on_corner);
  }

  // The same in the opposite direction, back along the line, up to an angle.
  template <typename OnEdge, typename OnSight>
  void for_each_back(const Index v,
                     const Arrival& arrival,
                     const double angle,
                     OnEdge on_edge,
                     OnSight on_sight) const
  {
    if(arrival.is_unknown() || arrival.is_on_curve() || arrival.is_none())
      return for_each(v, Arrival(), on_edge, on_sight);
    const Bend_sectors sectors(m_triangulation, m_steps, v);
    const Boundary right = sectors.right_of(arrival, angle);
    Boundary left = sectors.left_of(arrival, angle);
    if(left.halfedge == right.halfedge && cross(right.direction, left.direction) < 0)
      left = {}; // all around the vertex
    open_sector(v, right, left, on_edge, on_sight);
  }

  // The same for a sector, from one boundary counterclockwise to the other, or to the border, or
  // all around the vertex.
  template <typename OnEdge, typename OnSight>
  void open_sector(const Index v,
                   const Boundary& right,
                   const Boundary& left,
                   OnEdge& on_edge,
                   OnSight& on_sight) const
  {
    for_each_corner_of_sector(
        v, right, left, on_edge,
        [&](const Index h, const Plane_vector right_end, const Plane_vector left_end) {
          open(h, right_end, left_end, on_sight);
        });
  }

  // The first halfedge counterclockwise from the border.
  Index first_after_border(const Index v) const
  {
    Index h = m_triangulation.first_halfedge(v);
    while(m_steps[h].has_face())
      ++h;
    return m_triangulation.counterclockwise(v, h);
  }

private:
  template <typename OnEdge, typename OnCorner>
  void for_each_corner_of_sector(const Index v,
                                 const Boundary& right,
                                 const Boundary& left,
                                 OnEdge& on_edge,
                                 const OnCorner& on_corner) const
  {
    Index h = right.halfedge;
    Plane_vector start = right.direction;
    if(start.y == 0)
      on_edge(h);
    for(Index n = m_triangulation.degree(v); n > 0; --n)
    {
      if(!m_steps[h].has_face())
        return;
      if(h == left.halfedge)
        return on_corner(h, start, left.direction);
      on_corner(h, start, unit_corner(m_steps[h]));
      h = m_triangulation.counterclockwise(v, h);
      start = {1, 0};
      on_edge(h);
    }
  }

  // Looks across the face to the left of `h`, between two directions; `h` is the x axis.
  template <typename OnSight>
  void open(const Index h,
            const Plane_vector right_direction,
            const Plane_vector left_direction,
            OnSight& on_sight) const
  {
    const Face_step& step = m_steps[h];
    const double distance = m_triangulation.length(h);
    if(!step.has_face() || step.right == null_index || !(distance > 0) ||
       !(step.across > 0 || step.along < 0))
      return;
    const Plane_vector left{distance * step.along, distance * step.across}, right{distance, 0};
    Sight sight{step.right,   null_index, 0, 0, left, right, step.right_edge(right),
                length(left), distance};
    const auto narrow = [](Sight_ray& ray, const Plane_vector direction,
                           const Plane_vector direction_of_vertex,
                           const double distance_of_vertex) {
      if(direction.x != direction_of_vertex.x || direction.y != direction_of_vertex.y)
        ray = Sight_ray::boundary(direction, distance_of_vertex);
    };
    narrow(sight.left_ray, left_direction, unit_corner(step), sight.left_distance);
    narrow(sight.right_ray, right_direction, {1, 0}, distance);
    on_sight(sight, step.apex, m_triangulation.target(h));
  }

  const Intrinsic_triangulation& m_triangulation;
  const Face_steps& m_steps;
  const Bends& m_bends;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_VERTEX_SIGHTS_H
