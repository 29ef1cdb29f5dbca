// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_segments.h>

#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * An edge that is crossed. Its halfedge goes from left to right, and the face ahead is to its left.
 * Two that follow each other have one end in common, which the latter is turned about.
 */
struct Gate
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge;
  bool keeps_left; // whether the end in common with the gate before is the left one
  double length;
  Plane_vector angle; // the one that it is turned by, against the gate before
};

// A vertex on the side of a sleeve: an end of all gates in a range.
struct Gate_range
{
  std::size_t first, beyond;
  bool is_left; // whether it is the gates' left end
};

/*
 * The faces that a path goes through, one after the other, given by the edges that it crosses. The
 * path never crosses an edge and at once again, nor does it start by going round its first point,
 * or end by going round its last one.
 */
class Sleeve
{
public:
  using Index = Intrinsic_triangulation::Index;

  explicit Sleeve(const Intrinsic_triangulation& triangulation) : m_triangulation(&triangulation) {}

  void start_at(const Face_point& p)
  {
    m_start = p;
    m_gates.clear();
  }

  // Goes on through the face to the left of `h`. \pre The edge of `h` belongs to the last face.
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
      m_gates.push_back(gate_after(m_gates.back(), h));
  }

  // Crosses the same edges as another sleeve. \pre They followed each other there.
  void cross(const Gate* first, const Gate* const beyond)
  {
    while(first != beyond)
    {
      const std::size_t size = m_gates.size();
      cross(first->halfedge);
      ++first;
      if(m_gates.size() > size) // so none of those that follow turns back
      {
        m_gates.insert(m_gates.end(), first, beyond);
        return;
      }
    }
  }

  void end_at(const Face_point& p)
  {
    m_end = p;
    while(!m_gates.empty() &&
          move_across(m_end, m_triangulation->opposite(m_gates.back().halfedge)))
      m_gates.pop_back();
  }

  // whether an end of a gate is one of the gate before, too
  bool is_kept(const std::size_t gate, const bool is_left) const
  {
    return gate > 0 && m_gates[gate].keeps_left == is_left;
  }

  // the gates from `first` on that have an end in common
  Gate_range range(const std::size_t first, const bool is_left) const
  {
    std::size_t beyond = first + 1;
    while(beyond < m_gates.size() && is_kept(beyond, is_left))
      ++beyond;
    return {first, beyond, is_left};
  }

  // The halfedge of a gate, or its opposite, that starts from an end of the gate.
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
  // Whether `p`, a point of the face to the right of `h`, is on the edge of `h`; it is then seen
  // from the other face.
  bool move_across(Face_point& p, const Index h) const
  {
    if(!p.is_on_edge())
      return false;
    const Index opposite = m_triangulation->opposite(h);
    if(p.is_vertex())
    {
      if(p.halfedge == opposite)
        p.halfedge = m_triangulation->next(h);
      else if(p.halfedge == m_triangulation->next(opposite))
        p.halfedge = h;
      else
        return false;
      return true;
    }
    if(p.halfedge != opposite)
      return false;
    p = {h, {p.weight[1], p.weight[0], 0}};
    return true;
  }

  Gate gate_after(const Gate& gate, const Index h) const
  {
    const Index right = m_triangulation->next(gate.halfedge), left = m_triangulation->next(right);
    const bool keeps_left = h != m_triangulation->opposite(right);
    const double length = m_triangulation->length(h);
    const double rest = m_triangulation->length(keeps_left ? right : left);
    const Index corner = keeps_left ? gate.halfedge : right;
    return {h, keeps_left, length,
            corner_angle(*m_triangulation, corner, gate.length, length, rest)};
  }

  const Intrinsic_triangulation* m_triangulation;
  Face_point m_start{}, m_end{};
  std::vector<Gate> m_gates;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_SLEEVE_H
