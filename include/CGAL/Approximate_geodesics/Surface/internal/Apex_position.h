// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_APEX_POSITION_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_APEX_POSITION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Thin_faces.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

// The shape of a face: computed from the lengths of its sides, or known more accurately if it is
// thin.

namespace CGAL::Approximate_geodesics::internal {

// The area of the triangle with these sides, by Kahan's arrangement of Heron's formula, which is
// accurate for needles too (W. Kahan, Miscalculating area and angles of a needle-like triangle).
inline double area_of_triangle(const double a, const double b, const double c)
{
  const double smaller = (std::min)(a, b), larger = (std::max)(a, b);
  const double x = (std::max)(larger, c), z = (std::min)(smaller, c);
  const double y = (std::max)(smaller, (std::min)(larger, c));
  const double product = (x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z));
  return product > 0 ? std::sqrt(product) / 4 : 0; // rounded lengths can be too long for a triangle
}

// Looks for the face to the left of `h`, whose sides have these lengths, among the thin ones. Not
// inlined: most meshes have no thin faces, and a call keeps loops fast.
BOOST_NOINLINE inline std::optional<Thin_face>
find_thin_face(const Intrinsic_triangulation& triangulation,
               const Intrinsic_triangulation::Index h,
               const double a,
               const double b,
               const double c)
{
  if(!Thin_faces::is_thin(a, b, c))
    return std::nullopt;
  return triangulation.thin_faces().find(triangulation.halfedges_of_face(h));
}

// The shape of the face to the left of `h`, whose sides have lengths `a`, `b`, and `c`, in any
// order, if it is a thin one. Its corners are the source and the target of `h`, and the third
// vertex.
inline std::optional<Thin_face> thin_face(const Intrinsic_triangulation& triangulation,
                                          const Intrinsic_triangulation::Index h,
                                          const double a,
                                          const double b,
                                          const double c)
{
  if(triangulation.thin_faces().is_empty())
    return std::nullopt;
  return find_thin_face(triangulation, h, a, b, c);
}

/*
 * The position of the third vertex of the face to the left of a halfedge, in lengths of the
 * halfedge: its distance from the source along the halfedge, its distance from the target backward,
 * and its distance to the left. The first two add up to 1; both are kept because the vertex can be
 * close to either end, or far behind both.
 *
 * In a thin face whose shape is known, the relative error of each is below 1e-12. In other faces of
 * meshes with coordinates, that holds for `across`, and for the others relative to the distance of
 * the third vertex from the respective end.
 */
struct Apex_position
{
  double along, beyond, across;
};

// `a` and `b` are the lengths of the sides at the source and at the target of `h`. The result is
// zero if the halfedge is degenerate, or nearly so.
inline Apex_position apex_position(const Intrinsic_triangulation& triangulation,
                                   const Intrinsic_triangulation::Index h,
                                   const double a,
                                   const double b)
{
  constexpr double largest = 0x1p1000; // the other sides in lengths of the halfedge
  const double base = triangulation.length(h);
  if(!(base > (a + b) / largest))
    return {0, 0, 0};
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, base, a, b))
    return {face->at_corner[0] / base / base, face->at_corner[1] / base / base,
            face->doubled_area / base / base};
  // rounded sides can differ by more than the base
  const double along = 0.5 + 0.5 * ((a - b) / base) * ((a + b) / base);
  const double beyond = 0.5 - 0.5 * ((a - b) / base) * ((a + b) / base);
  return {(std::clamp)(along, -largest, largest), (std::clamp)(beyond, -largest, largest),
          2 * (area_of_triangle(base, a, b) / base) / base};
}

// \pre `h` starts from `source`, and is not a border halfedge.
inline Apex_position apex_position(const Intrinsic_triangulation& triangulation,
                                   const Intrinsic_triangulation::Index source,
                                   const Intrinsic_triangulation::Index h)
{
  return apex_position(triangulation, h,
                       triangulation.length(triangulation.counterclockwise(source, h)),
                       triangulation.length(triangulation.next(h)));
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_APEX_POSITION_H
