// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A straight line, and the halfedges that it crosses.
struct Sight_line
{
  double length = 0;
  Plane_vector end = {0, 0};
  Sight start = {}; // through the first halfedge
  std::vector<Intrinsic_triangulation::Index> halfedges = {};
};

// Looks for a line.
struct Sight_search : Sought_line<Sight_line>
{
  using Index = Intrinsic_triangulation::Index;

  Sight_search(const double line_length, const double rounding_of_length)
    : Sought_line{line_length, rounding_of_length, {}}
  {
  }

  bool is_found(const double tolerance = 1e-12) const { return Sought_line::is_found(tolerance); }

  // Calls `f(h, t)` for the halfedges of the line found, at the part `t` of the way from source to
  // target. Returns its length.
  template <typename F>
  double for_each_crossing(const Face_steps& steps, F f) const
  {
    struct Edge
    {
      Plane_vector right() const { return left + edge; }
      Plane_vector left, edge;
    };
    const auto cross_face = [&](Edge& e, const Index h, const Index next) {
      const Face_step& step = steps[h];
      const bool goes_right = next == step.right;
      if(goes_right)
        e.left = e.left + step.left_edge(e.edge);
      e.edge = goes_right ? step.right_edge(e.edge) : step.left_edge(e.edge);
    };
    for_each_crossed_edge(found.halfedges, Edge{found.start.left, found.start.edge}, found.end,
                          cross_face, f);
    return found.length;
  }
};

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

// Considers the lines to a given point, for a search. Sights are followed depth first: the
// halfedges that belong to one are the first so many of those that were recorded last.
template <typename Bound>
struct Tracing_visitor : Sight_visitor_base
{
  using Index = Intrinsic_triangulation::Index;

  static constexpr bool wants_sights = true;
  static constexpr bool wants_faces = true;

  double bound(const Index v) const { return bounds(v); }

  void on_sight(const Sight& sight)
  {
    halfedges.resize(sight.depth);
    halfedges.push_back(sight.halfedge);
  }

  void on_vertex(const Index v,
                 const Sight_path& path,
                 const Sight& /* sight */,
                 const Plane_vector apex,
                 const Plane_vector /* left_edge */)
  {
    if(v == end.vertex)
      consider(path.length, apex);
  }

  void on_face(const Sight& sight, const Plane_vector apex)
  {
    if(!end.is_vertex())
      for_each_position(
          triangulation, end, sight, apex,
          [&](const Plane_vector position, const double way) { consider(way, position); });
  }

  void consider(const double length, const Plane_vector position)
  {
    search.consider(length, [&] { return Sight_line{length, position, first, halfedges}; });
  }

  const Intrinsic_triangulation& triangulation;
  const Bound& bounds;
  const Intrinsic_point& end;
  Sight_search& search;
  Sight first;
  std::vector<Index> halfedges;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SIGHT_SEARCH_H
