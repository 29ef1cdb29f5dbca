// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_SLEEVES_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_SLEEVES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A segment of a path. If it runs along an edge, both points are seen from the halfedge `edge`,
// whose direction is that of the path.
struct Step : Segment
{
  Index edge = null_index;

  bool is_along_edge() const { return edge != null_index; }
};

/*
 * The vertices of a path and its points on edges, and the steps from each to the next. Points
 * inside faces, except for the first and the last point, and points between two steps along the
 * same edge are removed.
 */
class Path_steps
{
public:
  Path_steps(const Intrinsic_triangulation& triangulation, const std::vector<Intrinsic_point>& path)
    : m_triangulation(triangulation)
  {
    for(std::size_t i = 0; i < path.size(); ++i)
      if(i == 0 || i + 1 == path.size() || !path[i].is_in_face())
        add(path[i].reduced(triangulation));
  }

  // The sum of the steps; infinity if two of them do not meet.
  double length() const
  {
    double result = 0;
    for(const Step& s : steps)
      result += s.length;
    return result;
  }

  std::vector<Intrinsic_point> points;
  std::vector<Step> steps;

private:
  void add(const Intrinsic_point& p)
  {
    while(!points.empty())
    {
      if(p.is_vertex() && p.vertex == points.back().vertex)
        return;
      const Step next = step(points.back(), p);
      // a path that turns back at a barrier may do so to get to its other side
      if(steps.empty() || !is_along_same_edge(steps.back(), next) ||
         (points.back().is_vertex() && m_triangulation.is_barrier(next.edge) &&
          !m_triangulation.is_lifted(next.edge)))
      {
        steps.push_back(next);
        break;
      }
      points.pop_back();
      steps.pop_back();
    }
    points.push_back(p);
  }

  bool is_along_same_edge(const Step& a, const Step& b) const
  {
    return a.is_along_edge() && b.is_along_edge() &&
           (a.edge == b.edge || a.edge == m_triangulation.opposite(b.edge));
  }

  Step step(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    Step result{shortest_segment(m_triangulation, p, q)};
    if(std::isinf(result.length) || !result.from.is_on_edge() || !result.to.is_on_edge())
      return result;
    for(const Index h : {result.from.halfedge, result.to.halfedge})
    {
      const Face_point from = result.from.seen_from(m_triangulation, h);
      const Face_point to = result.to.seen_from(m_triangulation, h);
      if(from.is_on_edge() && to.is_on_edge())
      {
        follow_edge(from, to, result);
        break;
      }
    }
    return result;
  }

  void follow_edge(const Face_point& from, const Face_point& to, Step& step) const
  {
    const bool is_forward = from.weight[1] <= to.weight[1]; // points next to an end are at it
    step.edge = is_forward ? from.halfedge : m_triangulation.opposite(from.halfedge);
    step.from = is_forward ? from : from.seen_from_opposite(step.edge);
    step.to = is_forward ? to : to.seen_from_opposite(step.edge);
  }

  const Intrinsic_triangulation& m_triangulation;
};

/*
 * The sleeves of a path. They pass each vertex of the path on the side where the angle is smaller.
 * Where borders and barriers make both sides impassable, one sleeve ends and another one starts.
 */
class Path_sleeves
{
public:
  // \pre Each point of the path shares a face or an edge with the next.
  Path_sleeves(const Intrinsic_triangulation& triangulation, const Path_steps& path)
    : m_triangulation(triangulation), m_path(path), m_stops(path.points.size())
  {
    m_stops.front().is_end = m_stops.back().is_end = true;
    for(std::size_t i = 1; i + 1 < m_stops.size(); ++i)
      open_sides(i);
    for(std::size_t i = m_stops.size() - 1; i-- > 1;)
      if(!is_crossable(i))
        agree(m_stops[i], m_stops[i + 1]);
    for(std::size_t i = 1; i + 1 < m_stops.size(); ++i)
      choose_side(i);
  }

  // Calls `f(sleeve, end)` for each sleeve, with its last point.
  template <typename F>
  void for_each_sleeve(F f) const
  {
    Sleeve sleeve(m_triangulation);
    for(std::size_t i = 0; i + 1 < m_stops.size(); ++i)
    {
      const Step& step = m_path.steps[i];
      if(m_stops[i].is_end)
        sleeve.start_at(seen_from(step.from, first_face(i)));
      else
        pass(i, sleeve);
      if(step.is_along_edge() && first_face(i) != last_face(i))
        sleeve.cross(last_face(i));
      if(m_stops[i + 1].is_end)
      {
        sleeve.end_at(seen_from(step.to, last_face(i)));
        f(sleeve, m_path.points[i + 1]);
      }
    }
  }

private:
  enum Side
  {
    LEFT,
    RIGHT
  };

  // How the sleeves pass a point of the path.
  struct Stop
  {
    std::array<double, 2> angle{}; // by side; infinity if the side is impassable
    Side side = LEFT;              // the one that is chosen
    bool is_end = false;           // whether a sleeve ends here

    bool is_open(const Side s) const { return !std::isinf(angle[s]); }
    bool is_closed() const { return !is_open(LEFT) && !is_open(RIGHT); }
  };

  // A direction at a vertex, along a halfedge or inside the face to its left.
  struct Direction
  {
    Index halfedge;
    double angle;
    bool is_inside;
  };

  // ----- sides

  void open_sides(const std::size_t i)
  {
    Stop& stop = m_stops[i];
    const Step &before = m_path.steps[i - 1], &after = m_path.steps[i];
    if(m_path.points[i].is_vertex())
    {
      const Direction back = direction(i, true), ahead = direction(i, false);
      stop.angle = {angle(ahead, back), angle(back, ahead)};
      stop.is_end = stop.is_closed();
    }
    else if(before.is_along_edge()) // the side of the next face stays open
      close(stop, after.from.halfedge == before.edge ? RIGHT : LEFT);
    else if(after.is_along_edge())
      close(stop, before.to.halfedge == after.edge ? RIGHT : LEFT);
  }

  static void close(Stop& stop, const Side side) { stop.angle[side] = infinity; }

  // whether the path may change to the other side of the edge during the step
  bool is_crossable(const std::size_t step) const
  {
    return !m_path.steps[step].is_along_edge() ||
           m_triangulation.is_crossable(m_path.steps[step].edge);
  }

  // Makes two stops choose the same side, as there is an uncrossable edge between them.
  static void agree(Stop& stop, Stop& next)
  {
    if(stop.is_end || next.is_end)
      return;
    const Stop before = stop;
    for(const Side side : {LEFT, RIGHT})
      if(!next.is_open(side))
        close(stop, side);
    if(stop.is_closed())
    {
      stop = before;
      next.is_end = true;
    }
  }

  void choose_side(const std::size_t i)
  {
    const Stop& previous = m_stops[i - 1];
    Stop& stop = m_stops[i];
    stop.side = stop.angle[LEFT] <= stop.angle[RIGHT] ? LEFT : RIGHT;
    if(!previous.is_end && !is_crossable(i - 1) && stop.is_open(previous.side))
      stop.side = previous.side;
  }

  // A halfedge of the face that the step starts in: one of its edge if it runs along an edge.
  Index first_face(const std::size_t i) const
  {
    const Step& step = m_path.steps[i];
    if(!step.is_along_edge())
      return step.from.halfedge;
    if(!m_stops[i].is_end)
      return face(step, m_stops[i].side);
    if(!m_stops[i + 1].is_end)
      return face(step, m_stops[i + 1].side);
    return face(step, m_triangulation.is_border(step.edge) ? RIGHT : LEFT);
  }

  // Likewise of the face that it ends in.
  Index last_face(const std::size_t i) const
  {
    const Step& step = m_path.steps[i];
    if(!step.is_along_edge())
      return step.to.halfedge;
    return m_stops[i + 1].is_end ? first_face(i) : face(step, m_stops[i + 1].side);
  }

  Index face(const Step& step, const Side side) const
  {
    return side == LEFT ? step.edge : m_triangulation.opposite(step.edge);
  }

  // A point of a step, as seen in one of the faces above.
  Face_point seen_from(const Face_point& p, const Index h) const
  {
    const Face_point result = p.halfedge == h ? p : p.seen_from_opposite(h);
    if(result.weight[1] == 1 && !m_triangulation.is_border(h))
      return Face_point::at_source(m_triangulation.next(h));
    return result;
  }

  // ----- passing a point

  void pass(const std::size_t i, Sleeve& sleeve) const
  {
    if(!m_path.points[i].is_vertex())
    {
      if(first_face(i) != last_face(i - 1))
        sleeve.cross(first_face(i));
      return;
    }
    const Direction back = direction(i, true), ahead = direction(i, false);
    const bool is_right = m_stops[i].side == RIGHT;
    if(is_right ? is_in_corner(back, ahead) : is_in_corner(ahead, back))
      return;
    if(is_right)
    {
      sleeve.cross_around(back.halfedge, ahead.halfedge, false);
      if(ahead.is_inside)
        sleeve.cross(ahead.halfedge);
    }
    else
    {
      if(back.is_inside)
        sleeve.cross(m_triangulation.opposite(back.halfedge));
      sleeve.cross_around(back.halfedge, ahead.halfedge, true);
    }
  }

  // Whether the angle counterclockwise from one direction to the other is inside one face. If the
  // path turns back along a barrier, it is not: the path goes around the vertex.
  static bool is_in_corner(const Direction& from, const Direction& to)
  {
    return from.halfedge == to.halfedge && to.is_inside &&
           (!from.is_inside || from.angle <= to.angle);
  }

  // ----- directions

  // The direction of the path at its point `i`, back or ahead.
  Direction direction(const std::size_t i, const bool is_back) const
  {
    const Step& step = m_path.steps[is_back ? i - 1 : i];
    if(step.is_along_edge())
      return {is_back ? m_triangulation.opposite(step.edge) : step.edge, 0, false};
    const Index h = is_back ? step.to.halfedge : step.from.halfedge;
    const Plane_vector way = (is_back ? step.from : step.to)
                                 .seen_from(m_triangulation, h)
                                 .position(m_triangulation, {0, 0}, {1, 0});
    return {h, angle_of(way), true};
  }

  // counterclockwise
  double angle(const Direction& from, const Direction& to) const
  {
    if(is_in_corner(from, to))
      return to.angle - from.angle;
    if(to.is_inside && !m_triangulation.is_crossable(to.halfedge))
      return infinity;
    return angle_of_fan(m_triangulation, from.halfedge, to.halfedge) - from.angle + to.angle;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Path_steps& m_path;
  std::vector<Stop> m_stops;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_SLEEVES_H
