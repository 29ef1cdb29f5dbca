// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_LAYOUT_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_LAYOUT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Place.h>
#include <CGAL/Approximate_geodesics/internal/Corner.h>
#include <CGAL/Approximate_geodesics/internal/Unfolding.h>
#include <CGAL/assertions.h>

#include <array>
#include <cmath>
#include <limits>

// Points of one face, and straight lines between them.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// `a` turned by the angle from the x axis to the unit vector `r`
inline Plane_vector turned_left(const Plane_vector a, const Plane_vector r)
{
  return {a.x * r.x - a.y * r.y, a.x * r.y + a.y * r.x};
}

// ... and the other way
inline Plane_vector turned_right(const Plane_vector a, const Plane_vector r)
{
  return turned_left(a, {r.x, -r.y});
}

// The unit vector at the angle between two sides of a triangle. At an edge of length zero the angle
// is taken to be right, so that a line through the edge goes straight on.
inline Plane_vector angle_between(const double a, const double b, const double opposite)
{
  if(!(a > 0 && b > 0))
    return {0, 1};
  return {1 - Corner(a, b, opposite).opening() / 2, 2 * (area_of_triangle(a, b, opposite) / a) / b};
}

// The angle at the source of `h` in the face to its left.
inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation,
                                 const Intrinsic_triangulation::Index h)
{
  const auto g = triangulation.next(h);
  return angle_between(triangulation.length(h), triangulation.length(triangulation.next(g)),
                       triangulation.length(g));
}

/*
 * A point of the face to the left of a halfedge. A vertex is seen from a halfedge that starts from
 * it, and a point of an edge from that edge.
 */
struct Face_point
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge;
  std::array<double, 3> weight; // of its source, its target, and the third vertex

  static Face_point at_source(const Index h) { return {h, {1, 0, 0}}; }
  static Face_point on_edge(const Index h, const double t) { return {h, {1 - t, t, 0}}; }
  static Face_point in_face(const Place& p) { return {p.halfedge, {1 - p.t - p.s, p.t, p.s}}; }

  bool is_vertex() const { return weight[1] == 0 && weight[2] == 0; }
  bool is_on_edge() const { return weight[2] == 0; }

  // the same point as seen from another halfedge of the face
  Face_point seen_from(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    Face_point result = *this;
    for(int i = 0; i < 2 && result.halfedge != h; ++i)
      result = {triangulation.next(result.halfedge),
                {result.weight[1], result.weight[2], result.weight[0]}};
    CGAL_assertion(result.halfedge == h);
    return result;
  }

  // where it is, if the source of the halfedge is laid out, and the halfedge's direction is given
  Plane_vector position(const Intrinsic_triangulation& triangulation,
                        const Plane_vector source,
                        const Plane_vector direction) const
  {
    Plane_vector result = source + weight[1] * triangulation.length(halfedge) * direction;
    if(weight[2] > 0)
    {
      const auto third = triangulation.next(triangulation.next(halfedge));
      result = result + weight[2] * triangulation.length(third) *
                            turned_left(direction, corner_angle(triangulation, halfedge));
    }
    return result;
  }
};

// The distance of two points of a face. That of two points of an edge is accurate, as it is for any
// two points of a needle.
inline double
distance(const Intrinsic_triangulation& triangulation, const Face_point& p, const Face_point& q)
{
  const Face_point r = q.seen_from(triangulation, p.halfedge);
  std::array<double, 3> step{};
  for(std::size_t i = 0; i < 3; ++i)
    step[i] = r.weight[i] - p.weight[i];
  // Their sum is zero: two of them point away from the third vertex and towards it.
  std::size_t i = 0;
  while(i < 2 && step[(i + 1) % 3] * step[(i + 2) % 3] > 0)
    ++i;
  std::array<double, 3> length{}; // of the edges that start from the vertices 0, 1, 2
  length[0] = triangulation.length(p.halfedge);
  length[1] = length[2] = length[0];
  if(p.weight[2] != 0 || r.weight[2] != 0) // there may be no face to the left
  {
    const auto next = triangulation.next(p.halfedge);
    length[1] = triangulation.length(next);
    length[2] = triangulation.length(triangulation.next(next));
  }
  const double a = length[i], opposite = length[(i + 1) % 3], b = length[(i + 2) % 3];
  return Corner(a, b, opposite)
      .distance(std::abs(step[(i + 1) % 3]) * a, std::abs(step[(i + 2) % 3]) * b);
}

// the vertex, if a point of an edge is at one
inline Place simplified(const Intrinsic_triangulation& triangulation, const Place& p)
{
  if(!p.is_on_edge() || (p.t > 0 && p.t < 1))
    return p;
  return Place::at_vertex(p.t > 0 ? triangulation.target(p.halfedge)
                                  : triangulation.source(p.halfedge));
}

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

  // The shortest of the segments between two places; of infinite length if no face and no edge has
  // both.
  Segment segment(const Place& p, const Place& q) const
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
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
      if(m_triangulation.target(h) == w && m_triangulation.length(h) < result.length)
        result = {Face_point::at_source(h), {h, {0, 1, 0}}, m_triangulation.length(h)};
    return result;
  }

  // \pre `p` is not a vertex.
  Segment shortest_to(const Place& p, const Place& q) const
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
  void improve(const Face_point& p, const Place& q, Segment& shortest) const
  {
    if(m_triangulation.is_border(p.halfedge))
      return;
    Index h = p.halfedge;
    for(int i = 0; i < 3; ++i, h = m_triangulation.next(h))
      if(is_seen_from(h, q))
      {
        const Face_point view = view_from(h, q);
        const double length = distance(m_triangulation, p, view);
        if(length < shortest.length)
          shortest = {p, view, length};
      }
  }

  bool is_seen_from(const Index h, const Place& q) const
  {
    if(q.is_vertex())
      return m_triangulation.source(h) == q.vertex;
    return h == q.halfedge || (q.is_on_edge() && h == m_triangulation.opposite(q.halfedge));
  }

  Face_point view_from(const Index h, const Place& q) const
  {
    if(q.is_vertex())
      return Face_point::at_source(h);
    if(q.is_in_face())
      return Face_point::in_face(q);
    return h == q.halfedge ? Face_point::on_edge(h, q.t) : Face_point{h, {q.t, 1 - q.t, 0}};
  }

  const Intrinsic_triangulation& m_triangulation;
};

// The sum of the straight lines from each point to the next; infinity if two of them share no face.
template <typename Places>
double length_of_segments(const Intrinsic_triangulation& triangulation, const Places& points)
{
  const Segment_finder finder(triangulation);
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += finder.segment(points[i - 1], points[i]).length;
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_LAYOUT_H
