// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The data for laying out the face to the left of a halfedge whose edge is laid out: not as two
 * points, but as one point and the vector to the other. Vectors of the edges ahead follow from that
 * vector alone, by a rotation and a scaling. So the direction of each is accurate, however far away
 * and however short it is; that of the difference of two points would not be.
 */
struct Face_step : Unfolded_face
{
  static Face_step
  of(const Intrinsic_triangulation& triangulation, const Index source, const Index h)
  {
    Apex_position position{0, 0, 0};
    const Unfolded_face face = Unfolded_face::of(triangulation, source, h, &position);
    return {face, position.beyond};
  }

  double beyond; // of the apex: from the target of the halfedge backward

  bool has_face() const { return apex != null_index; }

  Plane_vector right_edge(const Plane_vector edge) const
  {
    return {beyond * edge.x + across * edge.y, beyond * edge.y - across * edge.x};
  }
};

// The angle at the source of a halfedge in the face to its left, as a unit vector. At an edge of
// length zero, it is a right angle.
inline Plane_vector unit_corner(const Face_step& step)
{
  const Plane_vector corner{step.along, step.across};
  const double l = length(corner);
  return l > 0 && l < 1e300 ? 1 / l * corner : Plane_vector{0, 1};
}

using Face_steps = Unfolded_faces<Face_step>;

/*
 * The direction from which a straight line arrives at a vertex: along a halfedge that ends at the
 * vertex, or through the face to the left of a halfedge that it has crossed. The direction back is
 * a number from 0 to 2 that grows with the angle, from 0 to pi, to the left of the side from the
 * vertex to the source of the halfedge.
 *
 * The direction is unknown where the face is so thin at the vertex that rounding errors of
 * positions could change it. Then paths may go on in all directions: this costs time, and changes
 * no distance.
 */
struct Arrival
{
  Index halfedge = null_index;
  float direction = 0;

  static constexpr float ALONG_HALFEDGE = -1;
  static constexpr float UNKNOWN = -2;
  static constexpr float ON_CURVE = -3;
  static constexpr double ROUNDING = 1e-6; // of the angle

  static Arrival along(const Index halfedge) { return {halfedge, ALONG_HALFEDGE}; }

  // `way` is that from the tip to the vertex, and `side` that from the source of the halfedge.
  static Arrival across(const Index halfedge, const Plane_vector way, const Plane_vector side)
  {
    const double x = dot(side, way), y = cross(side, way);
    if(!(y > 0)) // along the side, up to rounding
      return {halfedge, x < 0 ? 2.f : 0.f};
    const double sum = std::abs(x) + y;
    return {halfedge, static_cast<float>(x < 0 ? 1 - x / sum : y / sum)};
  }

  static Arrival in_unknown_direction(const Index halfedge) { return {halfedge, UNKNOWN}; }

  // at a vertex of a curve where a search starts: the lines from there are known
  static Arrival on_curve(const Index halfedge) { return {halfedge, ON_CURVE}; }

  // whether the vertex is where lines start from
  bool is_none() const { return halfedge == null_index; }
  bool is_unknown() const { return direction == UNKNOWN; }
  bool is_on_curve() const { return direction == ON_CURVE; }
  bool has_direction() const { return direction >= 0; }
  bool is_along_halfedge() const { return direction == ALONG_HALFEDGE; }

  // the direction back, as a unit vector, where the side is the x axis
  Plane_vector way_back() const
  {
    const double d = direction;
    const Plane_vector result = d > 1 ? Plane_vector{1 - d, 2 - d} : Plane_vector{1 - d, d};
    return 1 / length(result) * result;
  }
};

// The ray that bounds a sight on one side: through a vertex, or on the boundary of a sector.
struct Sight_ray
{
  // Vertices at smaller angles from a ray are on it. On flat meshes, this is far more than sums of
  // rounding errors along a row of vertices; on thin faces, it is far less than their angles.
  static constexpr double TOLERANCE = 1e-11;
  // A bound on rounding errors, relative to the tolerance.
  static constexpr double ROUNDING = 0.1;

  Plane_vector direction = {0, 0}; // the position of the vertex
  double margin = 0;               // the length of the direction, times the tolerance
  double bound = infinity;         // of the label of the vertex, with a margin for rounding

  Sight_ray() = default;
  Sight_ray(const Plane_vector d, const double length_of_d, const double bound_of_vertex = infinity)
    : direction(d), margin(TOLERANCE * length_of_d), bound(bound_of_vertex)
  {
  }

  // that of the vertex from the tip
  double distance() const { return 1 / TOLERANCE * margin; }

  // The ray after a nearer apex has replaced an end of the edge: through that end if it is on the
  // ray, and farther than the vertex.
  Sight_ray before_fold(const Plane_vector end,
                        const double distance_of_end,
                        const double distance_of_apex) const
  {
    const bool is_farther = distance_of_end > distance_of_apex && is_on(end, distance_of_end) &&
                            TOLERANCE * distance_of_end > margin;
    return is_farther ? Sight_ray(end, distance_of_end) : *this;
  }

  bool is_on(const Plane_vector p, const double distance) const
  {
    return dot(direction, p) > 0 && std::abs(cross(direction, p)) <= margin * distance;
  }

  // The boundary of a sector hides no point, like a vertex at the tip.
  static Sight_ray boundary(const Plane_vector unit_vector, const double size)
  {
    constexpr double tiny = 0x1p-100;
    return {tiny * size * unit_vector, tiny * size};
  }
};

// A path from the tip.
struct Sight_path
{
  double length = infinity;
  Plane_vector last_line = {0, 0}; // straight to the end

  bool exists() const { return length < infinity; }

  // Whether the last line is so short that paths on the two sides of the vertex where it starts
  // arrive from different directions, with the same length.
  bool has_unknown_direction() const
  {
    return Sight_ray::TOLERANCE * length > Arrival::ROUNDING * internal::length(last_line);
  }
};

/*
 * What is seen from a tip through an edge, between two rays; the tip is the origin of a plane that
 * all faces on the way are unfolded into.
 */
struct Sight
{
  // A bound on the relative errors of sums of lengths.
  static constexpr double ROUNDING = 1e-12;

  // Edges shorter than this, in units of the triangulation, have no direction.
  static constexpr double SHORTEST_EDGE = 1e-100;

  Index halfedge = 0;                         // that of the edge whose face lies ahead, to its left
  Index milestone = 0;                        // one of the halfedges on the way
  std::uint32_t depth = 0;                    // the number of faces on the way
  std::uint32_t number_of_milestones = 0;     // among them
  Plane_vector left = {0, 0}, right = {0, 0}; // the positions of source and target
  Plane_vector edge = {0, 0};                 // from one to the other
  double left_distance = 0, right_distance = 0; // of source and target
  double left_bound = 0, right_bound = 0;       // of their labels, with a margin for rounding
  // Sees all between the ends of the edge, unless other rays are given.
  Sight_ray left_ray = {left, left_distance}, right_ray = {right, right_distance};
  Index left_end = null_index, right_end = null_index; // source and target

  // A lower bound on the distances of all points of the edge, by the triangle inequality. Where the
  // edge is far longer than they are, rounding errors of its length would matter.
  double smallest_distance() const
  {
    const double sum = (left_distance + right_distance) * (1 - ROUNDING);
    return (std::max)(0., (sum - length(edge)) / 2);
  }

  // The position of the apex of the face ahead: that of an end of the edge, plus the vector from
  // there. If the other end is far nearer to the tip, the apex may be, too, and rounding errors of
  // the farther end would matter.
  Plane_vector apex(const Plane_vector left_edge, const Face_step& step) const
  {
    constexpr double most = 16; // not on ordinary meshes
    if(BOOST_UNLIKELY(left_distance > most * right_distance))
      return right - step.right_edge(edge);
    return left + left_edge;
  }

  /*
   * The path to a point ahead, at this distance: a straight line; or none, of infinite length, if
   * the point is not seen. If it is on a ray, up to rounding errors, the path follows the ray to
   * the edge, and goes on from there:
   * - where the point is beyond the ray and farther than the edge. The difference is tiny;
   * - where it is nearer than the edge on both rays: there, a face is folded back.
   * A point beyond a ray, and between its two crossings of an edge that is almost along the sight,
   * is seen: rounding decides on which side it is, and no other sight may see it.
   */
  Sight_path path_to(const Plane_vector point, const double distance) const
  {
    const double beyond_left = cross(left_ray.direction, point),
                 beyond_right = cross(point, right_ray.direction),
                 left_margin = left_ray.margin * distance,
                 right_margin = right_ray.margin * distance;
    if(!(beyond_left <= left_margin && beyond_right <= right_margin))
      return {};
    constexpr double rounding = Sight_ray::ROUNDING;
    const bool is_on_left = beyond_left > -rounding * left_margin,
               is_on_right = beyond_right > -rounding * right_margin;
    const Sight_path line{distance, point};
    if(!is_on_left && !is_on_right)
      return line;
    if(is_behind(point))
      return {};
    const Plane_vector left_crossing = crossing(left_ray, 0),
                       right_crossing = crossing(right_ray, 1);
    const double nearest = (std::min)(length(left_crossing), length(right_crossing));
    const bool is_before_edge =
        distance < (1 + ROUNDING) * nearest && dot(left_crossing, right_crossing) > 0;
    Sight_path result;
    const auto follow = [&](const Sight_ray& ray, const double beyond,
                            const Plane_vector crossing) {
      const double to_crossing = length(crossing);
      const bool is_hidden = beyond >= 0 && distance > to_crossing && dot(ray.direction, point) > 0;
      const Plane_vector rest = point - crossing;
      const double way = (std::max)(distance, to_crossing + length(rest));
      if((is_before_edge || is_hidden) && way < result.length)
        result = {way, rest};
    };
    if(is_on_left)
      follow(left_ray, beyond_left, left_crossing);
    if(is_on_right)
      follow(right_ray, beyond_right, right_crossing);
    return result.exists() ? result : line;
  }

  // Where a ray crosses the edge; at the part `otherwise` of the way from left to right if the ray
  // is along the edge.
  Plane_vector crossing(const Sight_ray& ray, const double otherwise) const
  {
    const double beyond_left = cross(ray.direction, left),
                 beyond_right = cross(right, ray.direction);
    const double sum = beyond_left + beyond_right;
    const double part = sum > 0 ? (std::clamp)(beyond_left / sum, 0., 1.) : otherwise;
    return part < 0.5 ? left + part * edge : right - (1 - part) * edge;
  }

  /*
   * Whether all that is seen can be reached on a shorter path over an end of the edge. With s the
   * label of the tip, and y a point of the edge between its ends a and b, the way through y is
   * longer than that over a, by
   *   s + |y| - (bound(a) + |ay|)  >=  s + |b| - (bound(a) + |ab|),
   * as |y| - |ay| is smallest at b. If the two are equal, both ways stay. Through an edge without
   * length, nothing is seen: paths may bend at its ends.
   */
  BOOST_FORCEINLINE bool is_useless(const double label_of_tip) const
  {
    constexpr double factor = 1 + ROUNDING;
    const double excess =
        label_of_tip + (std::max)(right_distance - left_bound, left_distance - right_bound);
    const double squared_length = dot(edge, edge);
    return (excess > 0 && excess * excess > factor * squared_length) ||
           !(squared_length > SHORTEST_EDGE * SHORTEST_EDGE);
  }

  /*
   * Whether all that is seen can be reached on a shorter path over the vertex on one of the rays.
   * It can if this holds where the other ray crosses the edge: that is the point from which the way
   * to the vertex is longest, compared with the line from the tip. With v the vertex, x = r u this
   * point, u a unit vector, and c = bound(v) - label, the path is shorter if |x| - |vx| > c. That
   * is r > c, and (r - c)^2 > |vx|^2, or 2 r (uv - c) > |v|^2 - c^2, which is multiplied by the
   * divisor of r here. The margin is for rounding errors, and for points that are on the other ray
   * up to the tolerance.
   *
   * Many sights are far narrower than the edge, so that this ends some that `is_useless()` does
   * not; but it takes longer.
   */
  bool is_beaten(const double label_of_tip) const
  {
    return is_beaten_over(left_ray, right_ray, label_of_tip) ||
           is_beaten_over(right_ray, left_ray, label_of_tip);
  }

  bool is_beaten_over(const Sight_ray& ray, const Sight_ray& other, const double label_of_tip) const
  {
    const double c = (std::max)(0., ray.bound - label_of_tip), distance = ray.distance();
    const double area = cross(edge, left), divisor = cross(edge, other.direction);
    const double size =
        (std::abs(edge.x) + std::abs(edge.y)) * (std::max)(left_distance, right_distance);
    const double excess = 2 * area * (dot(ray.direction, other.direction) - c * other.distance()) -
                          (distance - c) * (distance + c) * divisor;
    return area > 0 && divisor > 0 && distance > c && excess > 4 * other.margin * size * distance;
  }

  // How a path arrives at the apex of the face ahead. Rounding errors of positions are in
  // proportion to the largest of them. A direction is known to `Arrival::ROUNDING` if the last line
  // and the height of the face are so much longer.
  Arrival
  arrival(const Sight_path& path, const Plane_vector apex, const Plane_vector left_edge) const
  {
    constexpr double smallest_part = 1e-9;
    const double shortest =
        smallest_part * (std::max)({left_distance, right_distance, length(apex)});
    const double height_by_edge = std::abs(cross(edge, left_edge));
    if(!(height_by_edge > shortest * length(edge) && length(path.last_line) > shortest) ||
       path.has_unknown_direction())
      return Arrival::in_unknown_direction(halfedge);
    return Arrival::across(halfedge, path.last_line, left_edge);
  }

  // Whether a point on the line of both rays is on the other side of the tip: the corner of a face
  // without area that is folded back. A sight without width does not see it.
  bool is_behind(const Plane_vector p) const
  {
    return dot(left_ray.direction, p) < 0 && dot(right_ray.direction, p) < 0;
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H
