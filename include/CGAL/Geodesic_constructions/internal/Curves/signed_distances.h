// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SIGNED_DISTANCES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SIGNED_DISTANCES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Curve_sides.h>
#include <CGAL/Geodesic_constructions/search_from_curves.h>

#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The distances of all vertices after a `Surface_search`, by their numbers: negative to the left of
// the curves that it has started from, and infinity where it has not come.
template <typename SurfaceSearch>
std::vector<double> signed_distances(const SurfaceSearch& search)
{
  const Intrinsic_triangulation& t = search.graph().triangulation();
  const std::vector<Intrinsic_curve>& curves = curves_of(search);
  if(curves.empty())
    reject("signed distances need curves as sources, and not points");
  const Curve_sides sides(t, curves);
  std::vector<double> result;
  result.reserve(t.number_of_vertices());
  for(Index v = 0; v < t.number_of_vertices(); ++v)
  {
    const double distance = search.search().distance(v);
    const bool is_reached = distance < infinity;
    if(is_reached && sides.is_unknown(v))
      reject("the side of vertex " + std::to_string(t.index(v)) +
             " is unknown, as faces between it and the curves are nearly degenerate");
    result.push_back(is_reached && sides[v] == Curve_sides::LEFT ? 0 - distance : distance);
  }
  return result;
}

// The definition of what `Mesh_search` declares.
template <typename SurfaceSearch>
struct Signed_distances
{
  static std::vector<double> of(const SurfaceSearch& search) { return signed_distances(search); }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SIGNED_DISTANCES_H
