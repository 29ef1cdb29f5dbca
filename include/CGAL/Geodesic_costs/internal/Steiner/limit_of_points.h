// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_LIMIT_OF_POINTS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_LIMIT_OF_POINTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// The maximum number of points on an edge, and whether faces that need more are accepted, with few
// points and a weaker bound.
struct Limit_of_points
{
  std::size_t number;
  bool is_soft;
};

inline std::size_t checked_limit(const double number, const char* const name)
{
  constexpr double largest = 4294967296; // one more than a graph may have nodes
  if(!(number >= 1) || number != std::floor(number) || number > largest)
    reject(std::string(name) + " is " + text_of(number) + "; it must be an integer from 1 to 2^32");
  return static_cast<std::size_t>((std::min)(number, largest - 1));
}

// Reads the parameters of placements with a bound.
template <typename NamedParameters>
Limit_of_points limit_of_points(const NamedParameters& np, const std::size_t by_default)
{
  static_assert(!is_any_given<NamedParameters, internal_np::number_of_points_per_edge_t,
                              internal_np::nb_points_per_distance_unit_t>,
                "Geometric_points and Directional_points read epsilon, which determines the number "
                "of points: for a number of your own, use Fixed_number_of_points or "
                "Points_at_interval");
  const double number = CGAL::to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::maximum_number_of_points_per_edge),
      double(by_default)));
  return {checked_limit(number, "maximum_number_of_points_per_edge"),
          parameters::choose_parameter(
              parameters::get_parameter(np, internal_np::accept_weaker_bound), false)};
}

// Returns the maximum number of points on all edges, or 0 if it is not given.
template <typename NamedParameters>
std::size_t maximum_number_of_points([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::maximum_number_of_points_t>)
    return checked_limit(
        CGAL::to_double(parameters::get_parameter(np, internal_np::maximum_number_of_points)),
        "maximum_number_of_points");
  else
    return 0;
}

// Returns the maximum number of points on all edges together: `given`, or the default if that is 0.
// The default is enough for small bounds on large meshes, and on small meshes it limits a search to
// some seconds. A point takes about 50 bytes in a graph and a search together.
inline std::size_t maximum_number_of_points(const Intrinsic_triangulation& triangulation,
                                            const std::size_t given)
{
  constexpr double smallest = 1e6, per_edge = 1000, largest = 1e8;
  const double by_default =
      (std::clamp)(per_edge * (triangulation.number_of_halfedges() / 2), smallest, largest);
  return given > 0 ? given : static_cast<std::size_t>(by_default);
}

// Returns a number of points for a message. Sums of these are doubles, which do not overflow.
inline std::string text_of_points(const double number)
{
  constexpr double far_too_many = 1e12;
  return number < far_too_many ? std::to_string(static_cast<long long>(number))
                               : std::string("more than 10^12");
}

// Returns whether there are more than `limit` points on the edges that paths may cross. They are
// only counted, which takes time proportional to the number of edges.
template <typename Placement>
bool has_more_points(const Intrinsic_triangulation& triangulation,
                     const Placement& placement,
                     const std::size_t limit)
{
  double sum = 0;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(h < triangulation.opposite(h) && triangulation.length(h) > 0)
      sum += double(placement.number_of_points(triangulation, h)) *
             (triangulation.is_barrier(h) ? 2 : 1);
  return sum > double(limit);
}

// Throws an error: `number` points are needed in all, `most` of them on the edge of a halfedge, and
// there may be `limit`, or fewer than the graph can have nodes.
template <typename Placement>
[[noreturn]] void refuse_points(const Intrinsic_triangulation& triangulation,
                                const Placement& placement,
                                const double number,
                                const Index halfedge_with_most,
                                const std::size_t most,
                                const std::size_t limit)
{
  std::string reason = "can have at most 2^32 - 1 nodes";
  if(number > double(limit))
  {
    reason = "maximum_number_of_points is " + std::to_string(limit);
    if constexpr(is_valid<const Placement&>([](auto& p) -> decltype(p.accepts_weaker_bound()) {}))
      if(!placement.accepts_weaker_bound())
        reason += "; fewer are enough for a larger epsilon, or with accept_weaker_bound(true)";
  }
  const auto index = [&](const Index h) {
    return std::to_string(triangulation.index(triangulation.target(h)));
  };
  throw std::length_error("Approximate_geodesics: the graph needs " + text_of_points(number) +
                          " points on edges, " + text_of_points(double(most)) +
                          " of them between vertices " +
                          index(triangulation.opposite(halfedge_with_most)) + " and " +
                          index(halfedge_with_most) + ", and " + reason);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_LIMIT_OF_POINTS_H
