// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INTRINSIC_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INTRINSIC_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <string>
#include <vector>

// Converts input points. Messages about invalid points name their role, such as "source", and their
// position in the range.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

template <typename Translation, typename Point>
Intrinsic_point
intrinsic_point(const Translation& translation, const Point& point, const char* const role)
{
  return name_in_message([&] { return std::string(role); },
                         [&] { return translation.intrinsic_point(point); });
}

// Converts a single point or a range of points.
template <typename Translation, typename Points>
std::vector<Intrinsic_point>
intrinsic_points(const Translation& translation, const Points& points, const char* const role)
{
  std::vector<Intrinsic_point> result;
  if constexpr(is_surface_point<typename Translation::Triangle_mesh, Points>)
    result.push_back(intrinsic_point(translation, points, role));
  else
    for(const auto& point : points)
      result.push_back(name_in_message([&] { return name_in_list(role, result.size()); },
                                       [&] { return translation.intrinsic_point(point); }));
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INTRINSIC_POINTS_H
