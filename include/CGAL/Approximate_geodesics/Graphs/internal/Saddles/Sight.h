// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Winding.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Part of all that is seen: the first times that a sight is divided, only one of its two parts is
 * followed, according to the digits of a number.
 */
struct Sight_part
{
  std::size_t number = 0;
  std::size_t number_of_parts = 1; // a power of two

  // Which side is followed where a sight is divided for the `i`th time: a positive number for the
  // right one, a negative one for the left one, 0 for both.
  int side(const std::uint32_t i) const
  {
    constexpr std::uint32_t digits = std::numeric_limits<std::size_t>::digits;
    if(i >= digits || (number_of_parts >> i) <= 1)
      return 0;
    return (number >> i & 1) != 0 ? 1 : -1;
  }
};

// What closes a sight on one side: the direction of a vertex, or the boundary of a sector.
struct Sight_ray
{
  // Vertices at smaller angles from a ray are on it. Where the way over the vertex P on the ray is
  // the real one, it is longer than the line from s to the other vertex C by the part
  // angle^2 |sP| / (2 |PC|): less than 1e-12, unless the edge is a millionth of the way or shorter,
  // and less than the angle in any case.
  static constexpr double TOLERANCE = 1e-9;

  Plane_vector direction = {0, 0};
  double margin = 0; // the length of the direction, times the tolerance

  Sight_ray() = default;
  Sight_ray(const Plane_vector d, const double length_of_d)
    : direction(d), margin(TOLERANCE * length_of_d)
  {
  }
};

/*
 * What is seen from a tip through an edge, between two rays; the tip is the origin of a plane that
 * all faces on the way are unfolded into.
 */
struct Sight
{
  using Index = Intrinsic_triangulation::Index;

  // What sums of lengths may be wrong by, as a part of them.
  static constexpr double ROUNDING = 1e-12;

  // Edges shorter than this, in units of the triangulation, have no direction.
  static constexpr double SHORTEST_EDGE = 1e-100;

  Index halfedge = 0;         // that of the edge whose face lies ahead, to its left
  Crossing milestone;         // one of the halfedges on the way
  std::uint32_t depth = 0;    // the number of faces on the way
  std::uint32_t splits = 0;   // how often the sight was divided in two parts
  Plane_vector left = {0, 0}; // the position of the source of the halfedge
  Plane_vector edge = {0, 0}; // from there to its target
  double left_distance = 0, right_distance = 0; // of source and target
  double left_bound = 0, right_bound = 0;       // of their labels, and a bit more, for rounding
  Sight_ray left_ray, right_ray;

  /*
   * Whether all that is seen can be reached on a shorter way, over an end of the edge. With s the
   * label of the tip, and y a point of the edge between its ends a and b, the way through y is
   * longer than that over a, by
   *   s + |y| - (bound(a) + |ay|)  >=  s + |b| - (bound(a) + |ab|),
   * as |y| - |ay| is smallest at b. If the two are equal, both ways stay. Through an edge without
   * length, nothing is seen: paths may bend at its ends.
   */
  bool is_useless(const double label_of_tip) const
  {
    constexpr double factor = 1 + ROUNDING;
    const double excess =
        label_of_tip + (std::max)(right_distance - left_bound, left_distance - right_bound);
    const double squared_length = dot(edge, edge);
    return (excess > 0 && excess * excess > factor * squared_length) ||
           !(squared_length > SHORTEST_EDGE * SHORTEST_EDGE);
  }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_H
