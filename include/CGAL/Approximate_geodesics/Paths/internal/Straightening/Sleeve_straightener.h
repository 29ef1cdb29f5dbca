// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * How a sleeve could pass a vertex on the other side: through the faces around it that it does not
 * go through.
 */
class Opposite_fan
{
public:
  using Index = Intrinsic_triangulation::Index;

  Opposite_fan(const Sleeve& sleeve, const Gate_range& gates)
    : m_sleeve(sleeve),
      m_triangulation(sleeve.triangulation()),
      m_gates(gates),
      m_first(sleeve.halfedge_from(gates.first, gates.is_left)),
      m_last(sleeve.halfedge_from(gates.beyond - 1, gates.is_left)),
      m_vertex(m_triangulation.source(m_first))
  {
  }

  // Whether the path can pass there, and has an angle below pi. It comes from `back` and leads
  // `ahead`, seen from the vertex in a plane where the first and the last gate have the given
  // directions from left to right.
  bool is_convex(const Plane_vector back,
                 const Plane_vector first,
                 const Plane_vector last,
                 const Plane_vector ahead) const
  {
    if(winds_around())
      return true;
    const double to_back = length(back), to_ahead = length(ahead);
    if(!(to_back > 0 && to_ahead > 0)) // at a vertex in the same place
      return false;
    const double side = m_gates.is_left ? 1 : -1;
    const Plane_vector before{side * dot(back, first) / to_back, cross(back, first) / to_back};
    const Plane_vector after{side * dot(last, ahead) / to_ahead, cross(last, ahead) / to_ahead};
    return m_gates.is_left ? is_fan_convex(m_last, after, m_first, before)
                           : is_fan_convex(m_first, before, m_last, after);
  }

  // Leads a sleeve, which has got to the first gate, there. The last gate is behind it then.
  void pass(Sleeve& sleeve) const
  {
    if(winds_around())
    {
      const std::size_t first_of_last_turn = m_gates.beyond - m_triangulation.degree(m_vertex);
      for(std::size_t i = m_gates.first; i < first_of_last_turn; ++i)
        sleeve.cross(m_sleeve.gates()[i].halfedge);
    }
    else if(m_gates.is_left)
      sleeve.cross_clockwise(m_first, m_last);
    else
      sleeve.cross_counterclockwise(m_first, m_last);
  }

private:
  // whether the sleeve goes all the way round, and farther
  bool winds_around() const
  {
    return m_gates.beyond - m_gates.first > m_triangulation.degree(m_vertex);
  }

  // Whether the angle of the fan counterclockwise from `first` to `beyond` is below pi, where the
  // path takes something off its first and its last corner.
  bool is_fan_convex(const Index first,
                     const Plane_vector off_first,
                     const Index beyond,
                     const Plane_vector off_last) const
  {
    Angle_sum sum;
    return for_each_corner(m_triangulation, first, beyond, [&](const Index h) {
      const bool is_last = m_triangulation.counterclockwise(m_vertex, h) == beyond;
      if(h == first && is_last) // one corner, and the path goes round all the others
        return true;
      Plane_vector angle = corner_angle(m_triangulation, h);
      if(h == first)
        angle = turned_right(angle, off_first);
      if(is_last)
        angle = turned_right(angle, off_last);
      sum.add(angle);
      return sum.is_convex();
    });
  }

  const Sleeve& m_sleeve;
  const Intrinsic_triangulation& m_triangulation;
  const Gate_range m_gates;
  const Index m_first, m_last, m_vertex; // the halfedges start from the vertex
};

/*
 * Makes the shortest path in a sleeve locally shortest, by leading the sleeve past vertices on
 * their other side.
 *
 * Where the path bends at a vertex, it has an angle of at least pi on the side of the sleeve. If
 * the one on the other side is below pi, it gets shorter there (S.-Q. Xin and G.-J. Wang,
 * Efficiently determining a locally exact shortest path on polyhedral surfaces; N. Sharp and
 * K. Crane, You can find geodesic paths in triangle meshes by just flipping edges).
 *
 * When there is no such bend left, the path is locally shortest, and often another one that passes
 * some vertex on the other side is shorter. Only vertices where both angles are below pi come into
 * question. They are few, and all are tried.
 */
class Sleeve_straightener
{
public:
  explicit Sleeve_straightener(const Intrinsic_triangulation& triangulation)
    : m_sleeve(triangulation), m_new_sleeve(triangulation), m_known_sleeve(triangulation)
  {
  }

  void tighten(const Sleeve& sleeve)
  {
    m_sleeve = sleeve;
    m_work = 0;
    m_largest_work = (sleeve.gates().size() + 100) * (sleeve.gates().size() + 1000);
    lay_out(m_sleeve, m_string);
    pass_bends();
    while(try_other_sides())
      ;
  }

  // Calls `f(point)` for the points of the path, except for its ends.
  template <typename F>
  void for_each_point(F f) const
  {
    m_string.for_each_point(m_sleeve, f);
  }

private:
  static constexpr double ROUNDING = 1e-13; // of a length

  void lay_out(const Sleeve& sleeve, Funnel& string)
  {
    string.find(sleeve);
    m_work += sleeve.gates().size() + 1;
  }

  bool has_time() const { return m_work < m_largest_work; }

  // Whether the path has an angle below pi on the other side of a vertex, between what is before
  // the first and from the last of some bends on.
  bool is_convex(const Gate_range& vertex, const std::size_t first, const std::size_t beyond) const
  {
    const Plane_vector p = m_string.position(vertex.first, vertex.is_left);
    return Opposite_fan(m_sleeve, vertex)
        .is_convex(m_string.position(first) - p, m_string.direction(vertex.first),
                   m_string.direction(vertex.beyond - 1), m_string.position(beyond + 1) - p);
  }

  // ----- bends

  // Passes bends on their other side as long as that makes the path shorter.
  void pass_bends()
  {
    while(has_time() && find_sleeve_past_bends())
    {
      lay_out(m_new_sleeve, m_new_string);
      if(m_new_string.length() > m_string.length() * (1 + ROUNDING))
        return;
      std::swap(m_sleeve, m_new_sleeve);
      std::swap(m_string, m_new_string);
    }
  }

  // Changes as many bends at the same time as do not get in the way of each other. Returns whether
  // there are any.
  bool find_sleeve_past_bends()
  {
    const auto& bends = m_string.bends();
    std::size_t gate = 0; // where the new sleeve has got to
    bool is_changed = false;
    for(std::size_t i = 0; i < bends.size(); ++i)
      if(bends[i].first >= gate && is_convex(bends[i], i, i + 1))
      {
        if(!is_changed)
          m_new_sleeve.start_at(m_sleeve.start());
        is_changed = true;
        copy_gates(gate, bends[i].first);
        Opposite_fan(m_sleeve, bends[i]).pass(m_new_sleeve);
        gate = bends[i].beyond;
      }
    if(is_changed)
      finish_new_sleeve(gate);
    return is_changed;
  }

  void copy_gates(const std::size_t first, const std::size_t beyond)
  {
    const Gate* const gates = m_sleeve.gates().data();
    m_new_sleeve.cross(gates + first, gates + beyond);
  }

  void finish_new_sleeve(const std::size_t gate)
  {
    copy_gates(gate, m_sleeve.gates().size());
    m_new_sleeve.end_at(m_sleeve.end());
  }

  // ----- other vertices

  // Returns whether the path got shorter.
  bool try_other_sides()
  {
    bool is_shorter = false;
    for(std::size_t gate = 0; gate < m_sleeve.gates().size() && has_time(); ++gate)
      for(const bool is_left : {true, false})
        if(gate < m_sleeve.gates().size() && !m_sleeve.is_kept(gate, is_left) &&
           is_promising(m_sleeve.range(gate, is_left)))
          is_shorter = try_other_side(m_sleeve.range(gate, is_left)) || is_shorter;
    return is_shorter;
  }

  // Whether the path does not bend at a vertex, and the angle on the other side is below pi.
  bool is_promising(const Gate_range& vertex) const
  {
    const auto& bends = m_string.bends();
    const auto first = std::partition_point(
        bends.begin(), bends.end(), [&](const auto& b) { return b.beyond <= vertex.first; });
    const auto beyond =
        std::find_if(first, bends.end(), [&](const auto& b) { return b.first >= vertex.beyond; });
    return std::none_of(first, beyond,
                        [&](const auto& b) { return b.is_left == vertex.is_left; }) &&
           is_convex(vertex, static_cast<std::size_t>(first - bends.begin()),
                     static_cast<std::size_t>(beyond - bends.begin()));
  }

  bool try_other_side(const Gate_range& vertex)
  {
    const double known_length = m_string.length();
    m_new_sleeve.start_at(m_sleeve.start());
    copy_gates(0, vertex.first);
    Opposite_fan(m_sleeve, vertex).pass(m_new_sleeve);
    finish_new_sleeve(vertex.beyond);

    m_known_sleeve = m_sleeve;
    std::swap(m_sleeve, m_new_sleeve);
    lay_out(m_sleeve, m_string);
    pass_bends();
    if(m_string.length() < known_length * (1 - 10 * ROUNDING))
      return true;
    std::swap(m_sleeve, m_known_sleeve);
    lay_out(m_sleeve, m_string);
    return false;
  }

  Sleeve m_sleeve, m_new_sleeve, m_known_sleeve;
  Funnel m_string, m_new_string;              // in the first two of them
  std::size_t m_work = 0, m_largest_work = 0; // in gates laid out
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H
