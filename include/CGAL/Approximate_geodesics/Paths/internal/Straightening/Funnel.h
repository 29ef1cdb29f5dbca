// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_FUNNEL_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_FUNNEL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The shortest path in a sleeve, which is laid out in the plane: a funnel grows with it, made of
 * the shortest paths to the two ends of the gate that it has got to (D. T. Lee and F. P. Preparata,
 * Euclidean shortest paths in the presence of rectilinear barriers).
 */
class Funnel
{
public:
  using Index = Intrinsic_triangulation::Index;

  // A vertex that the path touches.
  struct Bend : Gate_range
  {
    Plane_vector position;
  };

  void find(const Sleeve& sleeve)
  {
    lay_out(sleeve);
    start_funnel();
    for(std::size_t i = 0; i < m_gates.size(); ++i)
    {
      if(!sleeve.is_kept(i, true))
        add_left(i);
      if(!sleeve.is_kept(i, false))
        add_right(i);
    }
    finish_funnel();
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

  // Calls `f(point)` for every vertex that the path bends at, and every point where it crosses an
  // edge.
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
      if(is_bend && m_bends[i].beyond > gate) // another one at the same point can have passed it
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

  // The shortest paths to the left end, in the order from `m_left` up to `m_tip`, and to the right
  // end, from `m_tip` up to `m_right`, begin at the tip. The way to the tip is known.
  void start_funnel()
  {
    m_bends.clear();
    m_funnel.resize(2 * m_gates.size() + 4);
    m_tip = m_left = m_right = static_cast<std::ptrdiff_t>(m_gates.size() + 2);
    at(m_tip).position = m_start;
  }

  void add_left(const std::size_t gate)
  {
    add({{gate, gate + 1, true}, m_gates[gate].left}, m_left, m_right, -1);
  }

  void add_right(const std::size_t gate)
  {
    add({{gate, gate + 1, false}, m_gates[gate].right}, m_right, m_left, 1);
  }

  // `step` leads from the tip to the side's end. Where the path goes straight on at an end of a
  // gate, it counts as a bend: the other way round it may be shorter.
  void add(const Bend& bend,
           std::ptrdiff_t& end,
           const std::ptrdiff_t other_end,
           const std::ptrdiff_t step)
  {
    const auto side = static_cast<double>(step);
    while(end != m_tip && side * turn(at(end - step), at(end), bend) > 0)
      end -= step;
    if(end == m_tip)
      for(; m_tip != other_end && side * turn(at(m_tip), at(m_tip - step), bend) >= 0; end = m_tip)
      {
        m_tip -= step;
        m_bends.push_back(at(m_tip));
      }
    end += step;
    at(end) = bend;
  }

  // positive if the path from `a` over `b` to `c` turns left
  static double turn(const Bend& a, const Bend& b, const Bend& c)
  {
    return cross(b.position - a.position, c.position - b.position);
  }

  void finish_funnel()
  {
    add({{m_gates.size(), m_gates.size(), true}, m_end}, m_left, m_right, -1);
    for(std::ptrdiff_t i = m_tip - 1; i > m_left; --i)
      m_bends.push_back(at(i));
  }

  Bend& at(const std::ptrdiff_t i) { return m_funnel[static_cast<std::size_t>(i)]; }

  // ----- results

  // At which part of the way from left to right the path, which has got to `here`, crosses a gate
  // on the way to `goal`. If all lie in one line, as where faces have no area, it advances as
  // little as possible; ends within rounding errors are hit exactly.
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
  std::ptrdiff_t m_left = 0, m_tip = 0, m_right = 0;
  Plane_vector m_start{}, m_end{};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_FUNNEL_H
