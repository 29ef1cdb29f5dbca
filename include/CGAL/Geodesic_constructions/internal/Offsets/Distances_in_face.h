// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_IN_FACE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_IN_FACE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Distances_on_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Distances of points of a face. The last straight lines of the paths to its corners start from
 * points of its plane. Where these are nearly the same, all paths across the face start from there,
 * and what differs is interpolated. Where paths from different points meet, the smallest distance
 * counts. In units of the triangulation.
 */
class Distances_in_face
{
public:
  // Without a face.
  Distances_in_face() = default;

  // The face is that to the left of `h`.
  template <typename DistancesOnEdges>
  Distances_in_face(const Intrinsic_triangulation& triangulation,
                    const DistancesOnEdges& on_edges,
                    const Index h)
  {
    const Face_layout layout(triangulation, h);
    double nearest = infinity, longest = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index side = layout.halfedge(i),
                  other = triangulation.opposite(layout.halfedge((i + 2) % 3));
      const Distances_on_edge::End end = on_edges.end(side);
      m_corners[i] = {layout.corner(i), end.distance, end.straight,
                      direction(layout.edge(i, (i + 1) % 3), layout.edge(i, (i + 2) % 3), end.slope,
                                on_edges.end(other).slope)};
      nearest = (std::min)(nearest, m_corners[i].distance);
      longest = (std::max)(longest, triangulation.length(side));
    }
    if(nearest > longest) // or else there may be sources in the face
      choose_model(longest);
  }

  // An estimate of the largest error of `at()`, and no bound; infinity where a direction is not
  // known.
  double estimated_error() const { return m_estimated_error; }

  // The distance of the point with these weights of the corners.
  double at(const std::array<double, 3>& weight) const
  {
    Plane_vector p{0, 0};
    for(std::size_t i = 0; i < 3; ++i)
      p = p + weight[i] * m_corners[i].position;
    double sum = 0, smallest = infinity;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double distance = m_corners[i].distance_of(p);
      sum += weight[i] * distance;
      smallest = (std::min)(smallest, distance);
    }
    return m_is_smallest ? smallest : sum;
  }

private:
  struct Corner
  {
    Plane_vector position;
    double distance, straight; // the length of the last line; infinity if lines are parallel
    Plane_vector direction;    // of the line, where it arrives

    // The distance of another point if its line starts where that to the corner does.
    double distance_of(const Plane_vector p) const
    {
      const Plane_vector way = p - position;
      if(!(straight < infinity))
        return distance + dot(way, direction);
      const double old = straight, end = length(way + straight * direction);
      const double difference_of_squares = 2 * straight * dot(way, direction) + dot(way, way);
      return end + old == 0 ? distance : distance + difference_of_squares / (end + old); // or NaN
    }
  };

  // The direction in which the line arrives at a corner, from the slopes along its two sides; not a
  // number if the face has no area.
  static Plane_vector direction(const Plane_vector side,
                                const Plane_vector other,
                                const double slope,
                                const double other_slope)
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double a = length(side), b = length(other);
    const double sine = a * b > 0 ? cross(side, other) / (a * b) : 0;
    if(sine == 0)
      return {unknown, unknown};
    const double cosine = dot(side, other) / (a * b);
    const Plane_vector turned{slope, (other_slope - cosine * slope) / sine};
    const double l = length(turned);
    return l > 0 ? turned_left(1 / l * turned, 1 / a * side) : Plane_vector{unknown, unknown};
  }

  void choose_model(const double longest)
  {
    constexpr double rounding = 1e-9;
    double smallest = infinity, largest = 0;
    for(const Corner& c : m_corners)
      for(const Corner& other : m_corners)
      {
        const double difference = c.distance_of(other.position) - other.distance;
        if(!(std::abs(difference) < infinity))
          return; // a direction is not known
        smallest = (std::min)(smallest, difference);
        largest = (std::max)(largest, std::abs(difference));
      }
    m_is_smallest = smallest >= -rounding * longest;
    m_estimated_error = largest;
  }

  std::array<Corner, 3> m_corners = {};
  bool m_is_smallest = false;
  double m_estimated_error = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_IN_FACE_H
