// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_TRACING_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_TRACING_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_trail.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Where a point is that a sight sees in the face ahead, and the length of the path there. Calls
// `f(position, length)`.
template <typename F>
void for_each_position(const Intrinsic_triangulation& triangulation,
                       const Intrinsic_point& point,
                       const Sight& sight,
                       const Plane_vector apex,
                       F f)
{
  for_each_face_point(triangulation, point, sight.halfedge, [&](const Face_point& p) {
    const Plane_vector position =
        p.seen_from(triangulation, sight.halfedge).position({sight.left, sight.right, apex});
    const Sight_path path = sight.path_to(position, length(position));
    if(path.length < std::numeric_limits<double>::infinity())
      f(position, path.length);
  });
}

// Looks for a line to a given point.
template <typename Bound>
struct Tracing_visitor : Sight_visitor_base
{
  using Index = Intrinsic_triangulation::Index;

  static constexpr bool wants_sights = true;
  static constexpr bool wants_faces = true;

  double bound(const Index v) const { return bounds(v); }

  void on_sight(const Sight& sight) { trail.record(sight); }

  void on_vertex(const Index v,
                 const Sight_path& path,
                 const Sight& /* sight */,
                 const Plane_vector apex,
                 const Plane_vector /* left_edge */)
  {
    if(v == end.vertex)
      line.consider(path.length, apex, first, trail.halfedges());
  }

  void on_face(const Sight& sight, const Plane_vector apex)
  {
    if(!end.is_vertex())
      for_each_position(triangulation, end, sight, apex,
                        [&](const Plane_vector position, const double way) {
                          line.consider(way, position, first, trail.halfedges());
                        });
  }

  const Intrinsic_triangulation& triangulation;
  const Bound& bounds;
  const Intrinsic_point& end;
  Sought_line& line;
  Sight first;
  Sight_trail trail;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_TRACING_VISITOR_H
