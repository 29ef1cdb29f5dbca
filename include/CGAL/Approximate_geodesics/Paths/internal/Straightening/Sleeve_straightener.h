// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Path_sleeves.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The other side of a vertex that a sleeve passes: the faces around it that the sleeve does not go
 * through.
 */
class Opposite_fan
{
public:
  // `path` is the shortest path in `sleeve`.
  Opposite_fan(const Sleeve& sleeve, const Funnel& path, const Gate_range& gates)
    : m_sleeve(sleeve),
      m_path(path),
      m_triangulation(sleeve.triangulation()),
      m_gates(gates),
      m_first(sleeve.halfedge_from(gates.first, gates.is_left)),
      m_last(sleeve.halfedge_from(gates.beyond - 1, gates.is_left)),
      m_vertex(m_triangulation.source(m_first))
  {
  }

  // Whether the path can pass there, and has an angle below pi, between the position before its
  // bend `i` and the one after bend `j - 1`.
  bool is_convex(const std::size_t i, const std::size_t j) const
  {
    if(winds_around())
      return true;
    const Plane_vector p = m_path.position(m_gates.first, m_gates.is_left);
    const Plane_vector back = m_path.position(i) - p, ahead = m_path.position(j + 1) - p;
    const double to_back = length(back), to_ahead = length(ahead);
    if(!(to_back > 0 && to_ahead > 0)) // another vertex is at the same place
      return false;
    const Plane_vector first = m_path.direction(m_gates.first);
    const Plane_vector last = m_path.direction(m_gates.beyond - 1);
    const double side = m_gates.is_left ? 1 : -1;
    const Plane_vector before{side * dot(back, first) / to_back, cross(back, first) / to_back};
    const Plane_vector after{side * dot(last, ahead) / to_ahead, cross(last, ahead) / to_ahead};
    return m_gates.is_left ? is_fan_convex(m_last, after, m_first, before)
                           : is_fan_convex(m_first, before, m_last, after);
  }

  // Continues a sleeve that ends before the first gate, to where it would be after the last gate.
  void pass(Sleeve& sleeve) const
  {
    if(winds_around())
    {
      const std::size_t first_of_last_turn = m_gates.beyond - m_triangulation.degree(m_vertex);
      for(std::size_t i = m_gates.first; i < first_of_last_turn; ++i)
        sleeve.cross(m_sleeve.gates()[i].halfedge);
    }
    else
      sleeve.cross_around(m_first, m_last, m_gates.is_left);
  }

private:
  // whether the sleeve makes more than a full turn around the vertex
  bool winds_around() const
  {
    return m_gates.beyond - m_gates.first > m_triangulation.degree(m_vertex);
  }

  // Whether the angle counterclockwise from `first` to `beyond` is below pi, less the angles
  // between the path and these two halfedges.
  bool is_fan_convex(const Index first,
                     const Plane_vector off_first,
                     const Index beyond,
                     const Plane_vector off_last) const
  {
    Angle_sum sum;
    return for_each_corner(m_triangulation, first, beyond, [&](const Index h) {
      const bool is_last = m_triangulation.counterclockwise(m_vertex, h) == beyond;
      if(h == first && is_last) // one corner: the path goes around all the others
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
  const Funnel& m_path;
  const Intrinsic_triangulation& m_triangulation;
  const Gate_range m_gates;
  const Index m_first, m_last, m_vertex; // the halfedges start from the vertex
};

/*
 * Makes the shortest path in a sleeve locally shortest: changes the sleeve so that it passes
 * vertices on their other side.
 *
 * Where the path bends at a vertex, its angle on the side of the sleeve is at least pi. If the
 * angle on the other side is below pi, the path is shorter there (S.-Q. Xin and G.-J. Wang,
 * Efficiently determining a locally exact shortest path on polyhedral surfaces; N. Sharp and K.
 * Crane, You can find geodesic paths in triangle meshes by just flipping edges).
 *
 * Without such bends, the path is locally shortest. A path that passes some vertex on the other
 * side is often shorter still. This is possible only where both angles are below pi; these vertices
 * are few, and all are tried.
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
    lay_out(m_sleeve, m_path);
    pass_bends();
    while(try_other_sides())
      ;
  }

  // Calls `f(point)` for the points of the path, except for its ends.
  template <typename F>
  void for_each_point(F f) const
  {
    m_path.for_each_point(m_sleeve, f);
  }

private:
  static constexpr double ROUNDING = 1e-13; // of a length

  void lay_out(const Sleeve& sleeve, Funnel& path)
  {
    path.find(sleeve);
    m_work += sleeve.gates().size() + 1;
  }

  bool has_time() const { return m_work < m_largest_work; }

  Opposite_fan opposite_fan(const Gate_range& vertex) const { return {m_sleeve, m_path, vertex}; }

  // ----- bends

  // Moves bends to their other side as long as that makes the path shorter.
  void pass_bends()
  {
    while(has_time() && find_sleeve_past_bends())
    {
      lay_out(m_new_sleeve, m_new_path);
      if(m_new_path.length() > m_path.length() * (1 + ROUNDING))
        return;
      std::swap(m_sleeve, m_new_sleeve);
      std::swap(m_path, m_new_path);
    }
  }

  // Makes a sleeve past the other side of as many bends as have no gate in common. Returns whether
  // there are any.
  bool find_sleeve_past_bends()
  {
    const auto& bends = m_path.bends();
    std::size_t gate = 0; // the next one of the old sleeve
    bool is_changed = false;
    for(std::size_t i = 0; i < bends.size(); ++i)
      if(bends[i].first >= gate && opposite_fan(bends[i]).is_convex(i, i + 1))
      {
        if(!is_changed)
          m_new_sleeve.start_at(m_sleeve.start());
        is_changed = true;
        copy_gates(gate, bends[i].first);
        opposite_fan(bends[i]).pass(m_new_sleeve);
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

  // Whether the path does not bend at the vertex, and its angle on the other side is below pi.
  bool is_promising(const Gate_range& vertex) const
  {
    const auto& bends = m_path.bends();
    const auto first = std::partition_point(
        bends.begin(), bends.end(), [&](const auto& b) { return b.beyond <= vertex.first; });
    const auto beyond =
        std::find_if(first, bends.end(), [&](const auto& b) { return b.first >= vertex.beyond; });
    return std::none_of(first, beyond,
                        [&](const auto& b) { return b.is_left == vertex.is_left; }) &&
           opposite_fan(vertex).is_convex(static_cast<std::size_t>(first - bends.begin()),
                                          static_cast<std::size_t>(beyond - bends.begin()));
  }

  bool try_other_side(const Gate_range& vertex)
  {
    const double known_length = m_path.length();
    m_new_sleeve.start_at(m_sleeve.start());
    copy_gates(0, vertex.first);
    opposite_fan(vertex).pass(m_new_sleeve);
    finish_new_sleeve(vertex.beyond);

    m_known_sleeve = m_sleeve;
    std::swap(m_sleeve, m_new_sleeve);
    lay_out(m_sleeve, m_path);
    pass_bends();
    if(m_path.length() < known_length * (1 - 10 * ROUNDING))
      return true;
    std::swap(m_sleeve, m_known_sleeve);
    lay_out(m_sleeve, m_path);
    return false;
  }

  Sleeve m_sleeve, m_new_sleeve, m_known_sleeve;
  Funnel m_path, m_new_path;                  // in the first two of them
  std::size_t m_work = 0, m_largest_work = 0; // in gates laid out
};

// The points of the path that is left when the sleeves of a path are tightened, one after the
// other. Crossings at the end of an edge are at its vertex, where there may be several of them.
inline std::vector<Intrinsic_point> tightened_points(const Intrinsic_triangulation& triangulation,
                                                     const Path_steps& path)
{
  std::vector<Intrinsic_point> result;
  const auto append = [&](const Intrinsic_point& p) {
    const Intrinsic_point q = p.reduced(triangulation);
    if(result.empty() || !q.is_vertex() || q.vertex != result.back().vertex)
      result.push_back(q);
  };
  append(path.points.front());
  Sleeve_straightener straightener(triangulation);
  Path_sleeves(triangulation, path)
      .for_each_sleeve([&](const Sleeve& sleeve, const Intrinsic_point& end) {
        straightener.tighten(sleeve);
        straightener.for_each_point(append);
        append(end);
      });
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_STRAIGHTENER_H
