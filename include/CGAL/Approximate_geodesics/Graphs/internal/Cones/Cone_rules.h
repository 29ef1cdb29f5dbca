// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RULES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RULES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>

namespace CGAL::Approximate_geodesics::internal {

/*
 * When cones end, and which arcs are left out, for a given epsilon. The search for arcs, the
 * drawing of paths and the file of a graph have to agree on this.
 */
struct Cone_rules
{
  // The share of epsilon that ends cones. The whole of it would do. This is where the largest
  // errors on scanned models stay below a fourth of epsilon.
  static constexpr double SHARE_OF_ENDS = 5. / 6;

  // The share of epsilon that a detour may take which makes an arc dispensable. A larger one means
  // fewer arcs and larger errors.
  static constexpr double SHARE_OF_DETOURS = 0.08;

  // The share of what lies between the two that a vertex may lose each time that a cone's side
  // turns to another one, and still serve in the place of that. With none at all, cones that run
  // along the rows of a lattice never end; a larger one means fewer faces crossed, and larger
  // errors.
  static constexpr double SHARE_OF_BENDS = 1. / 512;

  // The share of epsilon that ends cones where the labels of a search do not, which they do with
  // the whole of it. For a large epsilon, they end most cones, so that a small share costs little
  // time, and makes errors small.
  static double share_of_ends_beside_labels(const double epsilon)
  {
    constexpr double smallest = 0.3;
    return (std::max)(smallest, SHARE_OF_ENDS - 6 * epsilon);
  }

  explicit Cone_rules(const double bound, const double share_of_detours = SHARE_OF_DETOURS)
    : epsilon(bound),
      longest_detour(1 + SHARE_OF_ENDS * bound),
      part_saved(1 / longest_detour),
      large_part_saved(1 / (1 + share_of_detours * bound))
  {
  }

  // The rules for a part of epsilon, by which cones end farther away.
  Cone_rules farther(const double part) const { return Cone_rules(part * epsilon); }

  double epsilon;
  double longest_detour;   // as a multiple of the straight line, at which a cone may end
  double part_saved;       // of the distance of a vertex, by going over it: a cone may end ...
  double large_part_saved; // ... and an arc to the vertex is not needed
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RULES_H
