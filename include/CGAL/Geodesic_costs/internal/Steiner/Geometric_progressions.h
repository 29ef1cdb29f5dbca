// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Shape parameters of faces and vertex stars, which the placement of points depends on.

/*
 * The face to the left of a halfedge, and its corner at the source of the halfedge.
 */
class Face_shape
{
public:
  // \pre `h` is not a border halfedge.
  Face_shape(const Intrinsic_triangulation& triangulation, const Index h)
    : m_first(triangulation.length(h)),
      m_opposite(triangulation.length(triangulation.next(h))),
      m_second(triangulation.length(triangulation.next(triangulation.next(h)))),
      m_area(area_of_triangle(m_first, m_opposite, m_second))
  {
    if(const auto face = thin_face(triangulation, h, m_first, m_opposite, m_second))
      m_area = face->doubled_area / 2;
  }

  // Returns the sine of the angle at the corner, or 1 if it is obtuse: the distance of a point of
  // one of the two edges there from the other edge, relative to its distance from the corner.
  double sine_of_corner() const { return sine(m_first, m_second, m_opposite); }

  // Returns the same for the corner at the target of the halfedge.
  double sine_of_next_corner() const { return sine(m_first, m_opposite, m_second); }

  // Returns the distance from the corner to the opposite edge.
  double distance_to_opposite_edge() const
  {
    if(is_obtuse(m_opposite, m_first, m_second))
      return m_first;
    if(is_obtuse(m_opposite, m_second, m_first))
      return m_second;
    return m_opposite > 0 ? 2 * (m_area / m_opposite) : (std::min)(m_first, m_second);
  }

private:
  // Returns whether the angle between the sides `a` and `b` is obtuse.
  static bool is_obtuse(const double a, const double b, const double opposite)
  {
    return opposite * opposite >= a * a + b * b;
  }

  double sine(const double a, const double b, const double opposite) const
  {
    if(!(a > 0 && b > 0) || is_obtuse(a, b, opposite))
      return 1;
    return 2 * (m_area / a) / b;
  }

  double m_first, m_opposite, m_second; // lengths
  double m_area;
};

/*
 * The union of the faces around a vertex.
 */
class Star
{
public:
  // the smallest radius that is returned, relative to the longest edge at the vertex
  static constexpr double SMALLEST_RADIUS = 1e-9;

  Star(const Intrinsic_triangulation& triangulation, const Index v)
  {
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      m_longest_edge = (std::max)(m_longest_edge, triangulation.length(h));
      if(triangulation.is_border(h))
        continue;
      const double distance = Face_shape(triangulation, h).distance_to_opposite_edge();
      m_radius = (std::min)(m_radius, distance);
      if(distance < m_radius_of_open && !std::isinf(triangulation.weight(h)))
      {
        m_radius_of_open = distance;
        m_narrowest = h;
      }
    }
  }

  // Returns the distance from the vertex to the border of the star; infinity if there is no face.
  double radius() const { return (std::max)(m_radius, SMALLEST_RADIUS * m_longest_edge); }

  // Returns whether the radius is smaller than `radius()` because of a face that paths may enter.
  bool is_degenerate() const { return m_radius_of_open < SMALLEST_RADIUS * m_longest_edge; }

  // Returns the halfedge from the vertex whose face determines the radius; it is not forbidden.
  Index narrowest_face() const { return m_narrowest; }

private:
  double m_radius = infinity;
  double m_radius_of_open = infinity; // of faces not forbidden
  double m_longest_edge = 0;
  Index m_narrowest = null_index;
};

// Returns whether all faces around a vertex have the same weight, so that paths near it are
// straight. Forbidden faces do not count.
inline bool are_weights_uniform(const Intrinsic_triangulation& triangulation, const Index v)
{
  double smallest = infinity, largest = 0;
  if(triangulation.has_weights())
    for(auto h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      if(const double weight = triangulation.weight(h); !std::isinf(weight))
      {
        smallest = (std::min)(smallest, weight);
        largest = (std::max)(largest, weight);
      }
  return largest == 0 || smallest == largest;
}

/*
 * The points of an edge of length 1 in two geometric progressions, one from either end, which start
 * at a given distance from the end and meet where their spacings are equal.
 */
class Geometric_progressions
{
public:
  // The parameters of an end: where its progression starts, the sine of the angle there (see
  // `Face_shape`), and the logarithm of the largest ratio of the distances of neighbors.
  struct End
  {
    double start;
    double sine;
    double log_of_ratio;
  };

  // \pre `first.start + second.start < 1`
  Geometric_progressions(const End& first, const End& second)
    : m_first_start(first.start), m_second_start(second.start)
  {
    m_meeting_point =
        (std::clamp)(second.sine / (first.sine + second.sine), first.start, 1 - second.start);
    m_first_number = number_of_steps(m_meeting_point, first);
    m_second_number = number_of_steps(1 - m_meeting_point, second);
  }

  std::size_t number_of_points() const
  {
    return static_cast<std::size_t>(m_first_number + m_second_number) + 1;
  }

  // Writes the positions of the points, as `Points_on_edges` defines them.
  void place(float* positions) const
  {
    const auto first = static_cast<std::size_t>(m_first_number);
    const auto second = static_cast<std::size_t>(m_second_number);
    for(std::size_t i = 0; i < first; ++i)
      positions[i] = position(term(m_first_start, m_meeting_point, i, first));
    positions[first] = position(m_meeting_point);
    for(std::size_t i = 0; i < second; ++i)
    {
      const double part = term(m_second_start, 1 - m_meeting_point, i, second);
      positions[first + second - i] =
          part < 0.5 ? static_cast<float>(-part) : static_cast<float>(1 - part);
    }
  }

private:
  static double number_of_steps(const double end, const End& e)
  {
    constexpr double tolerance = 1e-9;
    constexpr double too_many = 1e18; // still fits an integer
    return (std::clamp)(std::ceil(std::log(end / e.start) / e.log_of_ratio - tolerance), 0.,
                        too_many);
  }

  static double
  term(const double start, const double end, const std::size_t i, const std::size_t number)
  {
    return start * std::pow(end / start, double(i) / double(number));
  }

  static float position(const double part_from_first)
  {
    return static_cast<float>(part_from_first <= 0.5 ? part_from_first : part_from_first - 1);
  }

  double m_first_start, m_second_start;
  double m_meeting_point;
  double m_first_number, m_second_number; // of steps
};

/*
 * The progressions on all edges of a triangulation, which are so dense that crossing the faces on
 * both sides costs at most `1 + epsilon` times as much as on the surface.
 *
 * Thin faces need many points. If weaker bounds are accepted, a face that needs more than the limit
 * is given up: it gets few points, and a bound of its own. Thin forbidden faces are given up, too.
 */
class Measured_progressions
{
public:
  using End = Geometric_progressions::End;

  // a face with an angle whose sine is smaller is thin
  static constexpr double SMALLEST_SINE = 0.02;

  // the largest number of points of a progression in faces that are given up, times the root of
  // epsilon
  static constexpr double LARGEST_NUMBER_IF_GIVEN_UP = 20;

  // the smallest distance from the end where progressions start, relative to the edge
  static constexpr double SMALLEST_START = 1e-36;

  Measured_progressions() = default;

  // The progressions at vertices start at the distances `start`. Throws std::length_error if a face
  // needs too many points, and weaker bounds are not accepted. Points are also on barriers if these
  // may be lifted.
  Measured_progressions(const Intrinsic_triangulation& triangulation,
                        std::vector<double> start,
                        const double epsilon,
                        const Limit_of_points& limit,
                        const bool barriers_may_be_lifted)
    : m_start(std::move(start)),
      m_root(std::sqrt(epsilon)),
      m_number_if_given_up((std::clamp)(
          0.5 * double(limit.number) - 1, 1., (std::max)(LARGEST_NUMBER_IF_GIVEN_UP / m_root, 1.)))
  {
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(std::isinf(triangulation.weight(h)) && !triangulation.is_border(h) &&
         Face_shape(triangulation, h).sine_of_corner() < SMALLEST_SINE)
        give_up(triangulation, h);
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(h < triangulation.opposite(h) &&
         (triangulation.is_crossable(h) || (barriers_may_be_lifted && triangulation.is_barrier(h))))
        keep_limit(triangulation, h, limit);
  }

  double start(const Index v) const { return m_start[v]; }

  // \pre The edge of `h` can be crossed, and is longer than zero.
  Geometric_progressions on_edge(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const std::array<End, 2> ends = this->ends(triangulation, h);
    return {ends[0], ends[1]};
  }

  // Returns the bound for crossing the faces that are given up: 0 if there are none, infinity if
  // one has no area.
  double epsilon_of_given_up(const Intrinsic_triangulation& triangulation) const
  {
    double result = 0;
    for(Index h = 0; h < m_is_given_up.size(); ++h)
      if(m_is_given_up[h] && triangulation.is_crossable(h) && triangulation.length(h) > 0 &&
         !std::isinf(triangulation.weight(h)))
        result = (std::max)(result, epsilon_beside(triangulation, h));
    return result;
  }

  // Throws an error since the face to the left of `h` needs more points than the limit.
  [[noreturn]] static void refuse(const Intrinsic_triangulation& triangulation,
                                  const Index h,
                                  const std::size_t number,
                                  const std::size_t largest)
  {
    triangulation.check_triangle_inequality(); // throws a more precise error
    throw std::length_error(
        "Approximate_geodesics: for this epsilon, " + triangulation.name_of_face(h) + " needs " +
        text_of_points(double(number)) +
        " points on an edge, and maximum_number_of_points_per_edge is " + std::to_string(largest) +
        "; accept_weaker_bound(true) accepts the face with few points and a weaker bound, which "
        "Steiner_graph::epsilon() returns");
  }

  std::size_t memory() const { return memory_of(m_start, m_is_given_up); }

private:
  // rounded positions can increase the distance of two neighbors
  static constexpr double ROUNDING_OF_LOGARITHM = 2.5e-7;
  static constexpr double SMALLEST_LOGARITHM = 2 * ROUNDING_OF_LOGARITHM;

  // a sine that is not 0, but needs more points than any limit
  static constexpr double almost_zero = 1e-200;

  // ----- faces to give up

  bool is_given_up(const Index h) const { return !m_is_given_up.empty() && m_is_given_up[h]; }

  void give_up(const Intrinsic_triangulation& triangulation, const Index h)
  {
    m_is_given_up.resize(triangulation.number_of_halfedges(), false);
    for(const Index side : triangulation.halfedges_of_face(h))
      m_is_given_up[side] = true;
  }

  void keep_limit(const Intrinsic_triangulation& triangulation,
                  const Index h,
                  const Limit_of_points& limit)
  {
    if(!(triangulation.length(h) > 0))
      return;
    for(std::size_t i = 0; i < 2; ++i)
    {
      const std::size_t number = on_edge(triangulation, h).number_of_points();
      if(number <= limit.number)
        return;
      const Index to_blame = thinner_side(triangulation, h);
      if(!limit.is_soft && !std::isinf(triangulation.weight(to_blame)))
        refuse(triangulation, to_blame, number, limit.number);
      give_up(triangulation, to_blame);
    }
  }

  // Of `h` and its opposite, returns the one with the face that needs more points, among faces that
  // are not given up.
  Index thinner_side(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const Index opposite = triangulation.opposite(h);
    if(is_given_up(h) || is_given_up(opposite))
      return is_given_up(h) ? opposite : h;
    const auto sine = [&](const Index side) {
      const Face_shape face(triangulation, side);
      return (std::min)(face.sine_of_corner(), face.sine_of_next_corner());
    };
    return sine(opposite) < sine(h) ? opposite : h;
  }

  // ----- progressions

  // Returns the parameters at the source of `h` and at its target.
  std::array<End, 2> ends(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const Index opposite = triangulation.opposite(h);
    const Face_shape left(triangulation, h), right(triangulation, opposite);
    const double length = triangulation.length(h);
    const double at_source = start_on_edge(triangulation.target(opposite), length);
    const double at_target = start_on_edge(triangulation.target(h), length);
    const bool is_left = is_given_up(h), is_right = is_given_up(opposite);
    return {denser(end(at_source, left.sine_of_corner(), is_left), is_left,
                   end(at_source, right.sine_of_next_corner(), is_right), is_right),
            denser(end(at_target, left.sine_of_next_corner(), is_left), is_left,
                   end(at_target, right.sine_of_corner(), is_right), is_right)};
  }

  double start_on_edge(const Index v, const double length) const
  {
    constexpr double largest_start = 0.49;
    return (std::clamp)(m_start[v] / length, SMALLEST_START, largest_start);
  }

  // Returns the parameters that a face with this sine requires at an end of an edge.
  End end(const double start, const double sine, const bool is_given_up) const
  {
    End result{start, (std::max)(sine, is_given_up ? SMALLEST_SINE : almost_zero), 0};
    const double log_of_ratio = 2 * std::asinh(result.sine * m_root);
    const bool is_too_small = log_of_ratio < SMALLEST_LOGARITHM; // rounded positions would coincide
    result.log_of_ratio = is_too_small ? almost_zero : log_of_ratio - ROUNDING_OF_LOGARITHM;
    if(is_given_up)
      result.log_of_ratio =
          (std::max)(result.log_of_ratio, -std::log(start) / m_number_if_given_up);
    return result;
  }

  // Combines the requirements of two faces. If one is given up, progressions meet where the other
  // one requires it, so that its bound still holds.
  static End denser(const End& left,
                    const bool is_left_given_up,
                    const End& right,
                    const bool is_right_given_up)
  {
    End result = left;
    result.log_of_ratio = (std::min)(left.log_of_ratio, right.log_of_ratio);
    if(is_left_given_up == is_right_given_up)
      result.sine = (std::min)(left.sine, right.sine);
    else if(is_left_given_up)
      result.sine = right.sine;
    return result;
  }

  // ----- the bound of faces with few points

  // Returns the bound for the face to the left of `h` that follows from points on the edge of `h`.
  double epsilon_beside(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const Face_shape face(triangulation, h);
    const std::array<double, 2> sines{face.sine_of_corner(), face.sine_of_next_corner()};
    const std::array<End, 2> ends = this->ends(triangulation, h);
    double largest_shift = 0, largest_ratio = 0; // relative to the sines that points are made for
    for(std::size_t i = 0; i < 2; ++i)
    {
      if(sines[i] == 0)
        return infinity;
      const double log_of_ratio = ends[i].log_of_ratio + ROUNDING_OF_LOGARITHM;
      largest_shift = (std::max)(largest_shift, std::sinh(log_of_ratio / 2) / ends[i].sine);
      largest_ratio = (std::max)(largest_ratio, ends[i].sine / sines[i]);
    }
    const double shift = largest_shift * largest_ratio;
    return 2 * shift * (shift / (1 + std::hypot(1., std::sqrt(2.) * shift)));
  }

  std::vector<double> m_start;     // per vertex: the distance from it
  std::vector<bool> m_is_given_up; // per halfedge, whether the face to its left is; or empty
  double m_root = 0;               // the square root of epsilon
  double m_number_if_given_up = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H
