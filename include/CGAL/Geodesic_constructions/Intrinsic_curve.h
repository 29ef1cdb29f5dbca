// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTRINSIC_CURVE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTRINSIC_CURVE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * A set of points of a triangulated surface that counts as one source: polylines, and whole faces.
 */
struct Intrinsic_curve
{
  /// the polylines. Two consecutive points are in the same face, and joined by a straight line. A
  /// polyline whose last point is its first one is closed; it may be a single point.
  std::vector<std::vector<Intrinsic_point>> polylines = {};

  /// a halfedge of each face that belongs to the source. The border of these faces has to be among
  /// the polylines.
  std::vector<Intrinsic_point::Index> faces = {};

  /// the initial distance, in the unit of the mesh: finite and not negative.
  double distance = 0;
};

namespace internal {

// A straight piece of a curve in the face to the left of a halfedge, from which both ends are seen.
struct Curve_segment
{
  Face_point from, to;
  std::size_t curve = 0;

  // The point at the part `t` of the way.
  Face_point face_point(const double t) const
  {
    if(!(t > 0 && t < 1))
      return t < 0.5 ? from : to;
    Face_point result = from;
    for(std::size_t i = 0; i < 3; ++i)
      result.weight[i] = (1 - t) * from.weight[i] + t * to.weight[i];
    return result;
  }

  Intrinsic_point point(const Intrinsic_triangulation& triangulation, const double t) const
  {
    const std::array<double, 3> weight = face_point(t).weight;
    const auto halfedges = triangulation.halfedges_of_face(from.halfedge);
    for(std::size_t i = 0; i < 3; ++i)
      if(weight[(i + 1) % 3] == 0 && weight[(i + 2) % 3] == 0)
        return Intrinsic_point::at_vertex(triangulation.source(halfedges[i]));
    for(std::size_t i = 0; i < 3; ++i)
      if(weight[(i + 2) % 3] == 0)
        return Intrinsic_point::on_edge(halfedges[i], (std::min)(1., weight[(i + 1) % 3]))
            .reduced(triangulation);
    return Intrinsic_point::in_face(from.halfedge, (std::min)(weight[1], 1 - weight[2]), weight[2]);
  }
};

// A point of a curve, and the directions between which lines from there are needed. They lead into
// the face to the left of a halfedge, in its layout.
struct Curve_sample
{
  Intrinsic_point point;
  Index halfedge;
  Plane_vector right, left;
};

// Whether both points are on the edge of the halfedge that they are seen from.
inline bool is_along_halfedge(const Face_point& p, const Face_point& q)
{
  return p.halfedge == q.halfedge && p.is_on_edge() && q.is_on_edge();
}

// Calls `f(segment)` for the straight line between two points of a face: for each face that it is
// part of, which are two if it is on an edge. Returns whether there is such a line.
template <typename F>
bool for_each_segment(const Intrinsic_triangulation& triangulation,
                      const Intrinsic_point& p,
                      const Intrinsic_point& q,
                      F f)
{
  const Segment line = shortest_segment(triangulation, p, q);
  if(!(line.length < infinity))
    return false;
  Face_point from = line.from, to = line.to;
  if(!triangulation.is_border(from.halfedge))
    for(int i = 0; i < 3 && !is_along_halfedge(from, to); ++i)
    {
      from = from.seen_from(triangulation, triangulation.next(from.halfedge));
      to = to.seen_from(triangulation, from.halfedge);
    }
  if(!triangulation.is_border(from.halfedge))
    f(Curve_segment{from, to.seen_from(triangulation, from.halfedge)});
  if(!is_along_halfedge(from, to))
    return true;
  const Index opposite = triangulation.opposite(from.halfedge);
  if(!triangulation.is_border(opposite))
    f(Curve_segment{from.seen_from_opposite(opposite), to.seen_from_opposite(opposite)});
  return true;
}

/*
 * A segment and its face, laid out in the plane: the segment lies on the x axis, from the origin
 * on.
 */
class Segment_layout
{
public:
  Segment_layout(const Intrinsic_triangulation& triangulation, const Curve_segment& segment)
    : m_layout(triangulation, segment.from.halfedge), m_from(segment.from)
  {
    // from the differences of weights, as the ends may be close to each other
    std::size_t c = 0;
    const std::array<double, 3> step = steps_between(segment.from, segment.to, c);
    const std::size_t second = (c + 1) % 3, third = (c + 2) % 3;
    const Plane_vector vector =
        step[second] * m_layout.edge(c, second) + step[third] * m_layout.edge(c, third);
    m_length = internal::length(vector);
    m_direction = m_length > 0 ? 1 / m_length * vector : Plane_vector{1, 0};
    for(std::size_t i = 0; i < 3; ++i)
      m_corners[i] = turned_right(m_layout.vector_to_corner(i, m_from), m_direction);
  }

  double length() const { return m_length; }

  // The halfedge from corner `i` to the next one.
  Index halfedge(const std::size_t i) const { return m_layout.halfedge(i); }
  Index vertex(const std::size_t i) const { return m_layout.vertex(i); }
  Plane_vector corner(const std::size_t i) const { return m_corners[i]; }

  Plane_vector edge(const std::size_t i, const std::size_t j) const
  {
    return turned_right(m_layout.edge(i, j), m_direction);
  }

  // A vector in the layout of the face by the halfedge of the ends.
  Plane_vector in_face_layout(const Plane_vector v) const { return turned_left(v, m_direction); }

  // The position of another point of the face.
  Plane_vector position(const Face_point& p) const { return p.position(m_corners); }

  // Which part of the way along the segment is nearest to a point.
  double nearest_part(const Plane_vector x) const
  {
    constexpr double rounding = 1e-14; // ends are vertices of the curve
    const double t = m_length > 0 ? x.x / m_length : 0;
    return t < rounding ? 0 : t > 1 - rounding ? 1 : t;
  }

private:
  Face_layout m_layout;
  Face_point m_from;
  double m_length;
  Plane_vector m_direction;
  std::array<Plane_vector, 3> m_corners;
};

// Whether angles between lines from a point are accurate: none of its faces is a needle or a cap.
inline bool has_accurate_angles(const Intrinsic_triangulation& triangulation,
                                const Intrinsic_point& p)
{
  constexpr double smallest_height = 1e-6; // over the longest side, as a part of it
  bool result = true;
  p.for_each_face(triangulation, [&](const Index h) {
    const Face_layout layout(triangulation, h);
    const Plane_vector a = layout.edge(0, 1), b = layout.edge(0, 2), c = layout.edge(1, 2);
    const double longest = (std::max)({dot(a, a), dot(b, b), dot(c, c)});
    result = result && cross(a, b) > smallest_height * longest;
  });
  return result;
}

// Whether a curve goes straight on at a point of an edge, up to rounding.
inline bool is_straight(const Intrinsic_triangulation& triangulation,
                        const Intrinsic_point& before,
                        const Intrinsic_point& p,
                        const Intrinsic_point& after)
{
  constexpr double rounding = 1e-11;
  if(!p.is_on_edge() || !has_accurate_angles(triangulation, p))
    return false;
  // in the direction of the point's halfedge
  const auto direction_to = [&](const Intrinsic_point& q) {
    Plane_vector result{0, 0};
    for_each_segment(triangulation, p, q, [&](const Curve_segment& segment) {
      const Segment_layout layout(triangulation, segment);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Index h = layout.halfedge(i);
        const Plane_vector edge = layout.edge(i, (i + 1) % 3);
        if(const double l = length(edge);
           l > 0 && (h == p.halfedge || triangulation.opposite(h) == p.halfedge))
          result = (h == p.halfedge ? 1 : -1) / l * Plane_vector{edge.x, -edge.y};
      }
    });
    return result;
  };
  const Plane_vector back = direction_to(before), ahead = direction_to(after);
  return dot(back, ahead) < 0 && std::abs(cross(back, ahead)) <= rounding;
}

/*
 * The segments of curves, sorted by the faces that contain them.
 */
class Segments_by_face
{
public:
  Segments_by_face() = default;

  // The triangulation is referred to, not copied.
  Segments_by_face(const Intrinsic_triangulation& triangulation,
                   const std::vector<Intrinsic_curve>& curves)
    : m_triangulation(&triangulation)
  {
    for(std::size_t i = 0; i < curves.size(); ++i)
      for(const auto& polyline : curves[i].polylines)
        for(std::size_t j = 0; j + 1 < (std::max)(polyline.size(), std::size_t(2)); ++j)
          add(polyline[j], polyline.size() == 1 ? polyline[j] : polyline[j + 1], i);
    m_numbers.sort();
  }

  bool is_empty() const { return m_numbers.is_empty(); }

  const Curve_segment& operator[](const std::size_t i) const { return m_segments[i]; }

  // Calls `f(i)` for the segments in the face to the left of `h`, or on its sides.
  template <typename F>
  void for_each_in_face(const Index h, F f) const
  {
    if(!is_empty())
      m_numbers.for_each(*m_triangulation, h, f);
  }

  // Calls `f(i, foot, t)` for them, and the part `t` of the way that is nearest to a point.
  template <typename F>
  void for_each_foot(const Index h, const Intrinsic_point& point, F f) const
  {
    for_each_in_face(h, [&](const std::size_t i) {
      const Curve_segment& segment = m_segments[i];
      const Segment_layout layout(*m_triangulation, segment);
      for_each_face_point(*m_triangulation, point, segment.from.halfedge, [&](const Face_point& p) {
        const double t = layout.nearest_part(
            layout.position(p.seen_from(*m_triangulation, segment.from.halfedge)));
        f(i, segment.point(*m_triangulation, t), t);
      });
    });
  }

private:
  void add(const Intrinsic_point& p, const Intrinsic_point& q, const std::size_t curve)
  {
    if(p.is_same(q, *m_triangulation) && p.is_vertex()) // it is a node
      return;
    for_each_segment(*m_triangulation, p, q, [&](Curve_segment segment) {
      segment.curve = curve;
      m_numbers.add(*m_triangulation, segment.from.halfedge, m_segments.size());
      m_segments.push_back(segment);
    });
  }

  const Intrinsic_triangulation* m_triangulation = nullptr;
  std::vector<Curve_segment> m_segments;
  Numbers_by_face m_numbers;
};

// The overload for `Lines_of_point`.
template <typename F>
void for_each_foot(const Segments_by_face& segments,
                   const Index h,
                   const Intrinsic_point& from,
                   const F& f)
{
  segments.for_each_foot(h, from, f);
}

// Calls `f(v, corner, foot, p)` for the corners of the faces that paths may enter and that contain
// the segment between two points, with the nearest point `foot` of it, which is `p`: also if that
// is an end, as ends where a curve is straight are not attached.
template <typename F>
void for_each_corner_beside(const Intrinsic_triangulation& triangulation,
                            const Intrinsic_point& from,
                            const Intrinsic_point& to,
                            F f)
{
  for_each_segment(triangulation, from, to, [&](const Curve_segment& segment) {
    if(!triangulation.is_open(segment.from.halfedge))
      return;
    const Segment_layout layout(triangulation, segment);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double t = layout.nearest_part(layout.corner(i));
      f(layout.vertex(i), Face_point::at_source(layout.halfedge(i)), segment.face_point(t),
        segment.point(triangulation, t));
    }
  });
}

// Calls `f(i, position, t)` for the point of each segment in the face to the left of `h` that is
// nearest to the origin, at the part `t` of the way, if the corners are at these positions.
template <typename F>
void for_each_position(const Intrinsic_triangulation& triangulation,
                       const Segments_by_face& segments,
                       const Index h,
                       const std::array<Plane_vector, 3>& corners,
                       F f)
{
  segments.for_each_in_face(h, [&](const std::size_t i) {
    const Plane_vector p = segments[i].from.seen_from(triangulation, h).position(corners);
    const Plane_vector step = segments[i].to.seen_from(triangulation, h).position(corners) - p;
    const double square = dot(step, step);
    const double t = square > 0 ? (std::clamp)(-dot(p, step) / square, 0., 1.) : 0;
    f(i, p + t * step, t);
  });
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTRINSIC_CURVE_H
