// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <array>
#include <cstdint>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * A point of a `Solver`: a vertex, or a point of a face.
 */
struct Solver_point
{
  /// returns the point at a vertex.
  static Solver_point at_vertex(const std::int64_t vertex) { return {vertex, true, {}}; }

  /// returns the point of a face with the given barycentric coordinates: the weights of its
  /// vertices, in their order in the array of faces. They are not negative, and their sum is `1`.
  static Solver_point in_face(const std::int64_t face, const std::array<double, 3>& coordinates)
  {
    return {face, false, coordinates};
  }

  std::int64_t element;              ///< the number of the vertex or of the face
  bool is_vertex;                    ///< whether it is a vertex
  std::array<double, 3> coordinates; ///< barycentric coordinates in the face
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_POINT_H
