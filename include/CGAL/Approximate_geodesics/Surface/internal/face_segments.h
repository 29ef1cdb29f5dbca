// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_SEGMENTS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_SEGMENTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>

#include <limits>

// Straight lines between points of the same face.

namespace CGAL::Approximate_geodesics::internal {

/*
 * A straight line through a face, or along an edge.
 */
struct Segment
{
  using Index = Intrinsic_triangulation::Index;

  Face_point from, to; // seen from halfedges of the same face
  double length = std::numeric_limits<double>::infinity();
};

class Segment_finder
{
public:
  using Index = Intrinsic_triangulation::Index;

  explicit Segment_finder(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  // The shortest of the segments between two points; of infinite length if no face and no edge has
  // both.
  Segment segment(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    if(!p.is_vertex())
      return shortest_to(p, q);
    if(!q.is_vertex())
    {
      const Segment s = shortest_to(q, p);
      return {s.to, s.from, s.length};
    }
    return shortest_edge(p.vertex, q.vertex);
  }

private:
  Segment shortest_edge(const Index v, const Index w) const
  {
    Segment result{};
    if(v == w)
      result.length = 0;
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
      if(m_triangulation.target(h) == w && m_triangulation.length(h) < result.length)
        result = {Face_point::at_source(h), {h, {0, 1, 0}}, m_triangulation.length(h)};
    return result;
  }

  // \pre `p` is not a vertex.
  Segment shortest_to(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    Segment result{};
    if(p.is_in_face())
      improve(Face_point::in_face(p), q, result);
    else
    {
      improve(Face_point::on_edge(p.halfedge, p.t), q, result);
      improve({m_triangulation.opposite(p.halfedge), {p.t, 1 - p.t, 0}}, q, result);
    }
    return result;
  }

  // Looks for `q` in the face that `p` is seen in.
  void improve(const Face_point& p, const Intrinsic_point& q, Segment& shortest) const
  {
    if(!m_triangulation.is_border(p.halfedge))
      for_each_face_point(m_triangulation, q, p.halfedge, [&](const Face_point& r) {
        const double length = distance(m_triangulation, p, r);
        if(length < shortest.length)
          shortest = {p, r, length};
      });
  }

  const Intrinsic_triangulation& m_triangulation;
};

// The sum of the straight lines from each point to the next; infinity if two of them share no face.
template <typename Points>
double length_of_segments(const Intrinsic_triangulation& triangulation, const Points& points)
{
  const Segment_finder finder(triangulation);
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += finder.segment(points[i - 1], points[i]).length;
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_SEGMENTS_H
