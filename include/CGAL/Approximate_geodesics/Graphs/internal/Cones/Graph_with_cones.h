// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_GRAPH_WITH_CONES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_GRAPH_WITH_CONES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_place.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * How discrete geodesic graphs join places that are not nodes: by the straight lines that are found
 * from there as they are from vertices.
 */
template <typename Graph>
class Graph_with_cones
{
  using Node = Intrinsic_triangulation::Index;

public:
  template <typename F>
  void for_each_arc(const Intrinsic_point& place, F f) const
  {
    Cones_of_place(graph().triangulation(), graph().epsilon(), place).for_each_arc(f);
  }

  template <typename Places, typename F>
  void for_each_line(const Intrinsic_point& place, const Places& places, F f) const
  {
    Cones_of_place(graph().triangulation(), graph().epsilon(), place).for_each_line(places, f);
  }

  template <typename F>
  double for_each_crossing(const Intrinsic_point& source,
                           const Node target,
                           const double length,
                           F f) const
  {
    return Cones_of_place(graph().triangulation(), graph().epsilon(), source)
        .trace_arc(target, length, f);
  }

  template <typename F>
  double for_each_crossing(const Intrinsic_point& source,
                           const Intrinsic_point& target,
                           const double length,
                           F f) const
  {
    return Cones_of_place(graph().triangulation(), graph().epsilon(), source)
        .trace_line(target, length, f);
  }

private:
  const Graph& graph() const { return static_cast<const Graph&>(*this); }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_GRAPH_WITH_CONES_H
