// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_SEGMENT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_SEGMENT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_rules.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Looks through the windows that are within reach of the point where lines start.
 */
struct Within_reach : Leave_out_nothing_in_doubt
{
  explicit Within_reach(const double length) : reach(length * (1 + 1e-6)) {}

  bool prune(const Window& w) const
  {
    const Plane_vector edge = w.left_position - w.right_position;
    const double square = dot(edge, edge);
    const double t = square > 0 ? -dot(w.right_position, edge) / square : 0;
    return length(w.right_position + (std::clamp)(t, 0., 1.) * edge) > reach;
  }

  double reach;
};

// Rules by which cones go on, as narrow as they can be.
inline Cone_rules without_end() { return Cone_rules(1e-300); }

// Does what `trace_segment()` does if the line does not start from a vertex.
template <typename F>
double trace_from_point(const Intrinsic_triangulation& mesh,
                        const Intrinsic_point& source,
                        const Intrinsic_point& target,
                        const double length,
                        const double rounding,
                        F f)
{
  const Cones_of_point cones(mesh, without_end(), source);
  const Within_reach within_reach(length + rounding);
  return target.is_vertex() ? cones.trace_within(target.vertex, length, rounding, within_reach, f)
                            : cones.trace_within(target, length, rounding, within_reach, f);
}

// Calls `f(h, t)` for every edge of the mesh that a straight line of the given length, up to
// `rounding`, between two points crosses. Returns its length; throws if there is none.
template <typename F>
double trace_segment(const Intrinsic_triangulation& mesh,
                     const Intrinsic_point& source,
                     const Intrinsic_point& target,
                     const double length,
                     const double rounding,
                     F f)
{
  if(!source.is_vertex())
    return trace_from_point(mesh, source, target, length, rounding, f);
  if(!target.is_vertex())
  {
    std::vector<std::pair<Intrinsic_point::Index, double>> crossings;
    const double result =
        trace_from_point(mesh, target, source, length, rounding,
                         [&](const auto h, const double t) { crossings.emplace_back(h, t); });
    for(auto crossing = crossings.rbegin(); crossing != crossings.rend(); ++crossing)
      f(crossing->first, crossing->second);
    return result;
  }
  const Within_reach within_reach(length + rounding);
  Line_search search(length, rounding);
  find_arc(mesh, without_end(), source.vertex, target.vertex, within_reach, search);
  check_is_found(search, mesh.unit());
  return report_line(mesh, search, target.vertex, f);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_SEGMENT_H
