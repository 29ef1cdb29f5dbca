// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_CORRIDOR_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_CORRIDOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstdint>
#include <functional>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What is known of the shortest path to a goal before an exact search: an upper bound of its
 * length, and for each node, a lower bound of the distance to the goal. In the plane, nodes whose
 * distances from both ends add up to no more than the first are those in an ellipse.
 *
 * Lengths are in units of the graph. Lower bounds are consistent: those of two nodes do not differ
 * by more than their distance.
 */
struct Corridor
{
  using Node = std::uint32_t;

  double length = std::numeric_limits<double>::infinity(); // that the path does not exceed
  std::function<double(Node)> distance_to_goal = {};       // at least; empty if nothing is known

  bool is_known() const { return bool(distance_to_goal); }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_CORRIDOR_H
