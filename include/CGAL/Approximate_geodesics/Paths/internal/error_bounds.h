// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_ERROR_BOUNDS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_ERROR_BOUNDS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// A bound on the relative rounding error of sums of lengths.
constexpr double rounding_of_distances = 1e-12;

template <typename Graph>
using Epsilon_of = decltype(std::declval<const Graph&>().epsilon());

template <typename Graph>
using Cost_to_corner =
    decltype(std::declval<const Graph&>().cost_to_corner(std::declval<Intrinsic_point>()));

// Returns the error bound of a graph; infinity if it has none.
template <typename Graph>
double error_bound([[maybe_unused]] const Graph& graph)
{
  if constexpr(boost::is_detected_v<Epsilon_of, Graph>)
    return graph.epsilon();
  else
    return std::numeric_limits<double>::infinity();
}

// Returns the finite cost from a point to a corner of its face, which extends the error bound of
// some graphs; 0 for other graphs.
template <typename Graph>
double cost_to_corner([[maybe_unused]] const Graph& graph,
                      [[maybe_unused]] const Intrinsic_point& point)
{
  double result = 0;
  if constexpr(boost::is_detected_v<Cost_to_corner, Graph>)
    result = graph.unit() * graph.cost_to_corner(point);
  return std::isinf(result) ? 0 : result;
}

// Returns a lower bound on the exact distance if a search with the error bound `epsilon` has found
// `distance`. `cost_to_corner` is the cost from its ends to the nearest vertices.
inline double
smallest_distance(const double distance, const double epsilon, const double cost_to_corner = 0)
{
  if(std::isinf(epsilon))
    return std::isinf(distance) ? distance : 0;
  const double detour = cost_to_corner > 0 ? (2 + epsilon) * cost_to_corner : 0;
  return (std::max)(distance - detour, 0.) / (1 + epsilon) * (1 - rounding_of_distances);
}

// Returns an interval that contains the distance of a point from the source of a search.
template <typename SurfaceSearch>
std::pair<double, double> distance_interval(const SurfaceSearch& search,
                                            const Intrinsic_point& point,
                                            const double maximum_distance)
{
  const auto& graph = search.graph();
  const double distance = search.distance(point), epsilon = error_bound(graph);
  const double costs =
      cost_to_corner(graph, search.sources().front().point) + cost_to_corner(graph, point);
  const double rounding = epsilon > 0 ? 2.4e-7 : rounding_of_distances; // stored arcs are `float`
  return {smallest_distance((std::min)(distance, maximum_distance), epsilon, costs) *
              (1 - rounding),
          distance * (1 + rounding)};
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_ERROR_BOUNDS_H
