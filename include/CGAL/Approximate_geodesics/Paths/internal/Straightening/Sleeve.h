// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * An edge that a path crosses. Its halfedge goes from left to right, and the next face is to its
 * left. Consecutive gates have a vertex in common.
 */
struct Gate
{
  Index halfedge;
  bool keeps_left; // whether the vertex in common with the previous gate is the left one
  double length;
  Plane_vector angle; // at that vertex, from the previous gate
};

// A vertex on the boundary of a sleeve: the left or the right end of all gates in a range.
struct Gate_range
{
  std::size_t first, beyond;
  bool is_left;
};

/*
 * The sequence of faces that a path passes, given by the edges between them. It is reduced: no edge
 * is crossed twice in succession, and no edge that contains the first point is crossed first, or
 * one that contains the last point, last.
 */
class Sleeve
{
public:
  explicit Sleeve(const Intrinsic_triangulation& triangulation) : m_triangulation(&triangulation) {}

  void start_at(const Face_point& p)
  {
    m_start = p;
    m_gates.clear();
  }

  // Appends the face to the left of `h`. \pre The edge of `h` belongs to the last face.
  void cross(const Index h)
  {
    if(m_gates.empty())
    {
      if(!move_across(m_start, h))
        m_gates.push_back({h, false, m_triangulation->length(h), {1, 0}});
    }
    else if(h == m_triangulation->opposite(m_gates.back().halfedge))
      m_gates.pop_back();
    else
    {
      const Gate& gate = m_gates.back();
      const Index right = m_triangulation->next(gate.halfedge), left = m_triangulation->next(right);
      const bool keeps_left = h != m_triangulation->opposite(right);
      const double length = m_triangulation->length(h);
      const double rest = m_triangulation->length(keeps_left ? right : left);
      const Index corner = keeps_left ? gate.halfedge : right;
      m_gates.push_back({h, keeps_left, length,
                         corner_angle(*m_triangulation, corner, gate.length, length, rest)});
    }
  }

  // Crosses the same edges as another sleeve. \pre They are consecutive gates there.
  void cross(const Gate* first, const Gate* const beyond)
  {
    while(first != beyond)
    {
      const std::size_t size = m_gates.size();
      cross(first->halfedge);
      ++first;
      if(m_gates.size() > size) // so none of the next ones turns back
      {
        m_gates.insert(m_gates.end(), first, beyond);
        return;
      }
    }
  }

  // Crosses the edges between two halfedges with the same source, clockwise or counterclockwise,
  // and all others around it if the halfedges are the same. \pre The last face is on that side of
  // `first`.
  void cross_around(const Index first, const Index last, const bool is_clockwise)
  {
    const Intrinsic_triangulation& t = *m_triangulation;
    const Index v = t.source(first);
    const auto next = [&](const Index h) {
      return is_clockwise ? t.clockwise(v, h) : t.counterclockwise(v, h);
    };
    for(Index h = next(first); h != last; h = next(h))
      cross(is_clockwise ? t.opposite(h) : h);
  }

  void end_at(const Face_point& p)
  {
    m_end = p;
    while(!m_gates.empty() &&
          move_across(m_end, m_triangulation->opposite(m_gates.back().halfedge)))
      m_gates.pop_back();
  }

  // whether an end of a gate is also one of the previous gate
  bool is_kept(const std::size_t gate, const bool is_left) const
  {
    return gate > 0 && m_gates[gate].keeps_left == is_left;
  }

  // the gates from `first` on that have this end in common
  Gate_range range(const std::size_t first, const bool is_left) const
  {
    std::size_t beyond = first + 1;
    while(beyond < m_gates.size() && is_kept(beyond, is_left))
      ++beyond;
    return {first, beyond, is_left};
  }

  // The halfedge of a gate that starts from this end.
  Index halfedge_from(const std::size_t gate, const bool is_left) const
  {
    const Index h = m_gates[gate].halfedge;
    return is_left ? h : m_triangulation->opposite(h);
  }

  Index vertex(const Gate_range& range) const
  {
    return m_triangulation->source(halfedge_from(range.first, range.is_left));
  }

  const Intrinsic_triangulation& triangulation() const { return *m_triangulation; }
  const Face_point& start() const { return m_start; }
  const Face_point& end() const { return m_end; }
  const std::vector<Gate>& gates() const { return m_gates; }

private:
  // Whether `p`, a point of the face to the right of `h`, lies on the edge of `h`. If so, it
  // becomes a point of the face to the left.
  bool move_across(Face_point& p, const Index h) const
  {
    const Index opposite = m_triangulation->opposite(h);
    if(p.is_vertex() && p.halfedge == m_triangulation->next(opposite))
      p.halfedge = h;
    else if(!p.is_on_edge() || p.halfedge != opposite)
      return false;
    else if(p.is_vertex())
      p.halfedge = m_triangulation->next(h);
    else
      p = p.seen_from_opposite(h);
    return true;
  }

  const Intrinsic_triangulation* m_triangulation;
  Face_point m_start{}, m_end{};
  std::vector<Gate> m_gates;
};

/*
 * The shortest path in a sleeve that is laid out in the plane. The funnel consists of the shortest
 * paths to both ends of the current gate, and is updated gate by gate (D. T. Lee and
 * F. P. Preparata, Euclidean shortest paths in the presence of rectilinear barriers).
 */
class Funnel
{
public:
  // A vertex that the path touches.
  struct Bend : Gate_range
  {
    Plane_vector position;
  };

  void find(const Sleeve& sleeve)
  {
    lay_out(sleeve);
    m_bends.clear();
    m_funnel.resize(2 * m_gates.size() + 4);
    m_tip = m_left = m_right = static_cast<std::ptrdiff_t>(m_gates.size() + 2);
    at(m_tip).position = m_start;
    for(std::size_t i = 0; i < m_gates.size(); ++i)
      for(const bool is_left : {true, false})
        if(!sleeve.is_kept(i, is_left))
          add(i, position(i, is_left), is_left);
    add(m_gates.size(), m_end, true);
    for(std::ptrdiff_t i = m_tip - 1; i > m_left; --i)
      m_bends.push_back(at(i));
    for(Bend& bend : m_bends)
      bend.beyond = sleeve.range(bend.first, bend.is_left).beyond;
  }

  double length() const
  {
    double result = 0;
    for(std::size_t i = 0; i <= m_bends.size(); ++i)
      result += internal::length(position(i + 1) - position(i));
    return result;
  }

  // from the start to the end
  const std::vector<Bend>& bends() const { return m_bends; }

  // of the start, the bends and the end
  Plane_vector position(const std::size_t i) const
  {
    if(i == 0)
      return m_start;
    return i <= m_bends.size() ? m_bends[i - 1].position : m_end;
  }

  // of an end of a gate
  Plane_vector position(const std::size_t gate, const bool is_left) const
  {
    return is_left ? m_gates[gate].left : m_gates[gate].right;
  }

  // of a gate, from left to right
  Plane_vector direction(const std::size_t gate) const { return m_gates[gate].direction; }

  // Calls `f(point)` for every bend of the path, and every point where it crosses an edge.
  template <typename F>
  void for_each_point(const Sleeve& sleeve, F f) const
  {
    std::size_t gate = 0;
    for(std::size_t i = 0; i <= m_bends.size(); ++i)
    {
      const bool is_bend = i < m_bends.size();
      const Plane_vector goal = position(i + 1);
      Plane_vector here = position(i);
      for(; gate < (is_bend ? m_bends[i].first : m_gates.size()); ++gate)
      {
        const Laid_gate& g = m_gates[gate];
        const double t = crossing(g, here, goal);
        here = g.left + t * (g.right - g.left);
        f(Intrinsic_point::on_edge(sleeve.gates()[gate].halfedge, t));
      }
      if(is_bend && m_bends[i].beyond > gate) // not passed with another one at the same point
      {
        f(Intrinsic_point::at_vertex(sleeve.vertex(m_bends[i])));
        gate = m_bends[i].beyond;
      }
    }
  }

private:
  struct Laid_gate
  {
    Plane_vector left, right, direction;
  };

  // ----- layout

  void lay_out(const Sleeve& sleeve)
  {
    const Intrinsic_triangulation& triangulation = sleeve.triangulation();
    const auto& gates = sleeve.gates();
    m_gates.resize(gates.size());
    if(gates.empty())
    {
      m_start = {0, 0};
      m_end = {distance(triangulation, sleeve.start(), sleeve.end()), 0};
      return;
    }
    Laid_gate gate{{0, 0}, {gates.front().length, 0}, {1, 0}};
    m_gates.front() = gate;
    for(std::size_t i = 1; i < gates.size(); ++i)
    {
      if(gates[i].keeps_left)
      {
        gate.direction = turned_left(gate.direction, gates[i].angle);
        gate.right = gate.left + gates[i].length * gate.direction;
      }
      else
      {
        gate.direction = turned_right(gate.direction, gates[i].angle);
        gate.left = gate.right - gates[i].length * gate.direction;
      }
      m_gates[i] = gate;
    }
    const Index behind = triangulation.opposite(gates.front().halfedge);
    const Index ahead = gates.back().halfedge;
    m_start = sleeve.start()
                  .seen_from(triangulation, behind)
                  .position(triangulation, m_gates.front().right, {-1, 0});
    m_end = sleeve.end()
                .seen_from(triangulation, ahead)
                .position(triangulation, gate.left, gate.direction);
  }

  // ----- funnel

  // Appends an end of a gate to one side. `step` leads there from the tip.
  void add(const std::size_t gate, const Plane_vector position, const bool is_left)
  {
    const Bend bend{{gate, gate + 1, is_left}, position};
    std::ptrdiff_t& end = is_left ? m_left : m_right;
    const std::ptrdiff_t other_end = is_left ? m_right : m_left, step = is_left ? -1 : 1;
    while(end != m_tip && !is_bend(at(end - step), at(end), bend))
      end -= step;
    if(end == m_tip)
      for(; m_tip != other_end && is_bend(at(m_tip), at(m_tip - step), bend); end = m_tip)
      {
        m_tip -= step;
        m_bends.push_back(at(m_tip));
      }
    end += step;
    at(end) = bend;
  }

  // Whether the shortest path from `a` to `c` passes `b`, in a turn around it. If it goes straight
  // through `b`, that is a bend too: the path past its other side may be shorter.
  //
  // If `c` lies on the way from `a` to `b`, as in flat faces, rounding decides how the path turns,
  // and the gates tell whether it makes a full turn or none.
  bool is_bend(const Bend& a, const Bend& b, const Bend& c) const
  {
    constexpr double rounding = 1e-12;
    const Plane_vector back = a.position - b.position, ahead = c.position - b.position;
    const double turn = (b.is_left ? 1 : -1) * cross(ahead, back), cosine = dot(back, ahead);
    if(cosine > 0 && std::abs(turn) <= rounding * cosine)
      return makes_full_turn(back, b, c);
    return turn >= 0;
  }

  // Whether there are gates between `b` and `c` that start from `b` in other directions than
  // `back`. In a full turn, one of two that follow each other does, as angles of faces are at most
  // pi.
  bool makes_full_turn(const Plane_vector back, const Bend& b, const Bend& c) const
  {
    constexpr double cosine_of_other_directions = 0.5;
    const std::size_t beyond = (std::min)(c.first + 1, m_gates.size());
    const double limit = cosine_of_other_directions * internal::length(back);
    for(std::size_t i = b.first; i < beyond; ++i)
    {
      const Plane_vector moved = position(i, b.is_left) - b.position;
      if(moved.x != 0 || moved.y != 0) // `b` is no end of later gates
        break;
      if((b.is_left ? 1 : -1) * dot(back, m_gates[i].direction) < limit)
        return true;
    }
    return false;
  }

  Bend& at(const std::ptrdiff_t i) { return m_funnel[static_cast<std::size_t>(i)]; }

  // ----- results

  // Where the line from `here` to `goal` crosses a gate: 0 at its left end, 1 at its right one,
  // both within rounding errors. If all points are collinear, as in degenerate faces, the path
  // advances as little as possible.
  static double crossing(const Laid_gate& gate, const Plane_vector here, const Plane_vector goal)
  {
    constexpr double smallest_angle = 1e-9, rounding = 1e-12;
    const Plane_vector way = goal - here, edge = gate.right - gate.left;
    const double to_left = (std::max)(0., cross(way, gate.left - here));
    const double to_right = (std::max)(0., cross(gate.right - here, way));
    const double sum = to_left + to_right, squared_length = dot(edge, edge);
    if(sum > smallest_angle * std::sqrt(dot(way, way) * squared_length))
    {
      if(to_left <= rounding * sum)
        return 0;
      return to_right <= rounding * sum ? 1 : to_left / sum;
    }
    if(!(squared_length > 0))
      return 0;
    return (std::clamp)(dot(here - gate.left, edge) / squared_length, 0., 1.);
  }

  std::vector<Laid_gate> m_gates;
  std::vector<Bend> m_funnel, m_bends;
  // The two paths of the funnel begin at the tip, to which the shortest path is known. They are
  // stored from `m_tip` down to `m_left` and up to `m_right`.
  std::ptrdiff_t m_left = 0, m_tip = 0, m_right = 0;
  Plane_vector m_start{}, m_end{};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H
