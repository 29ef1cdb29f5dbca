// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_WITHIN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_WITHIN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/lines_in_faces.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * What graphs have in common whose arcs run straight across one face, or along an edge.
 */
template <typename Graph>
class Graph_within_faces
{
public:
  template <typename Places, typename F>
  void for_each_line(const Intrinsic_point& place, const Places& places, F f) const
  {
    for_each_line_in_face(static_cast<const Graph&>(*this).triangulation(), place, places, f);
  }

  // Nothing is crossed.
  template <typename Source, typename Target, typename F>
  double for_each_crossing(const Source& /* source */,
                           const Target& /* target */,
                           const double length,
                           F /* f */) const
  {
    return length;
  }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_WITHIN_FACES_H
