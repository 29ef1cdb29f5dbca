// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_APPEND_DETOUR_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_APPEND_DETOUR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/append_point.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Appends what follows `from` on the shortest path along edges to `end`, but for `end`: in place of
// a line that cannot be found again, as can happen where faces are thinner than numbers can tell.
// Takes time and memory in proportion to the whole mesh.
template <typename EdgeGraph>
void append_detour(const EdgeGraph& edges,
                   const Intrinsic_point& from,
                   const Intrinsic_point& end,
                   Path& path)
{
  using Search = Propagation<EdgeGraph>;
  std::vector<Seed> seeds;
  Lines_in_faces(edges.triangulation(), end).for_each_node([&](const auto v, const double length) {
    seeds.push_back({v, length * edges.unit()});
  });
  Search search(edges);
  search.run(seeds);

  double shortest = std::numeric_limits<double>::infinity();
  auto node = Search::null_node;
  Lines_in_faces(edges.triangulation(), from).for_each_node([&](const auto v, const double length) {
    const double sum = search.distance(v) / edges.unit() + length;
    if(sum < shortest)
      std::tie(shortest, node) = std::make_pair(sum, v);
  });
  path.length += shortest;
  for(; node != Search::null_node; node = search.predecessor(node))
    append(Intrinsic_point::at_vertex(node), edges.triangulation(), path);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_APPEND_DETOUR_H
