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
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Checks and converts points of the surface that users pass.

namespace CGAL::Approximate_geodesics::internal {

template <typename TriangleMesh, typename Descriptor, typename = void>
constexpr bool tells_what_is_removed = false;

template <typename TriangleMesh, typename Descriptor>
constexpr bool
    tells_what_is_removed<TriangleMesh,
                          Descriptor,
                          std::void_t<decltype(std::declval<const TriangleMesh&>().is_removed(
                              std::declval<Descriptor>()))>> = true;

// Whether a descriptor is in range and not marked as removed, as far as the mesh type can tell.
template <typename TriangleMesh, typename Descriptor, typename Size>
bool may_be_element(const Descriptor d,
                    [[maybe_unused]] const Size size,
                    [[maybe_unused]] const TriangleMesh& tmesh)
{
  if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
    if(static_cast<std::size_t>(d) >= static_cast<std::size_t>(size))
      return false;
  if constexpr(tells_what_is_removed<TriangleMesh, Descriptor>)
    return !tmesh.is_removed(d);
  else
    return true;
}

// Whether `t` is the parameter of a point along a halfedge. False for NaN.
inline bool is_parameter(const double t) { return t >= 0 && t <= 1; }

constexpr double rounding_of_weights = 1e-15; // of barycentric coordinates

// Returns barycentric coordinates whose sum is 1, with values within rounding errors snapped to
// zero, or nothing if they are negative, not finite, or have another sum.
template <typename FT>
std::optional<std::array<double, 3>> barycentric_weights(const std::array<FT, 3>& coordinates)
{
  constexpr double tolerance = 1e-9;
  std::array<double, 3> result{};
  double sum = 0;
  for(std::size_t i = 0; i < 3; ++i)
  {
    result[i] = CGAL::to_double(coordinates[i]);
    sum += result[i];
    if(!(result[i] >= -tolerance))
      return std::nullopt;
  }
  if(!(std::abs(sum - 1) <= tolerance))
    return std::nullopt;
  for(double& weight : result)
    weight = weight < rounding_of_weights ? 0 : weight;
  sum = result[0] + result[1] + result[2];
  for(double& weight : result)
    weight /= sum;
  return result;
}

// The following functions convert points. Messages about invalid ones name their role, such as
// "source", and their position in the range.

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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INTRINSIC_POINTS_H
