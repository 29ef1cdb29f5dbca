// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <optional>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Traces an arc of a graph that was built on another triangulation in the mesh: finds the arc in
 * that triangulation, by the rules of the graph, and then in the mesh, by its direction. If that
 * fails, it searches all lines within reach.
 */
class Line_in_mesh
{
public:
  // The line from `source` to `target` of the given length, up to `rounding`. Those that cross no
  // edge are considered at once.
  Line_in_mesh(const Intrinsic_triangulation& mesh,
               const Intrinsic_point& source,
               const Intrinsic_point& target,
               const double length,
               const double rounding)
    : m_mesh(mesh),
      m_target(target),
      m_lines(mesh, Cone_rules(1e-300), source), // cones end as late as possible
      m_search(length, rounding)
  {
    m_lines.consider_lines_in_faces(target, m_search);
  }

  bool is_found() const { return m_search.is_found(); }

  // Looks for an arc that was found in the other triangulation.
  void find(const Retriangulation& other, const Index source, const Straight_arc& arc)
  {
    std::optional<Direction_in_mesh> direction = other.direction(source, arc.start);
    if(!direction)
      return;
    direction->angle += angle_of(arc.position);
    for(double tolerance = 1e-11; tolerance < 1e-3 && !is_found(); tolerance *= 100)
      m_lines.find_line(m_target, *direction, tolerance, arc.length, m_search);
  }

  // Looks for any line.
  void find()
  {
    m_lines.find_line(m_target, Within_reach<Leave_out_nothing_in_doubt>{{}, m_search.reach()},
                      m_search);
  }

  // Calls `f(h, t)` for the edges of the mesh that the line crosses. Returns its length; throws if
  // it was not found.
  template <typename F>
  double for_each_crossing(F f) const
  {
    if(!is_found())
      reject("the graph has an arc of length " + text_of(m_search.length * m_mesh.unit()) +
             " that is not in the mesh; was it read from a file that was changed?");
    return m_lines.trace(m_search, f);
  }

private:
  const Intrinsic_triangulation& m_mesh;
  Intrinsic_point m_target;
  Cones_of_point m_lines;
  Line_search m_search;
};

// Does what `trace_arc()` does for a graph that was built on another triangulation. The error of
// the length is at most `rounding`.
template <typename Visitor, typename F>
double trace_arc_in_mesh(const Intrinsic_triangulation& mesh,
                         const Retriangulation& other,
                         const Cone_rules& rules,
                         const Index source,
                         const Index target,
                         const double length,
                         const double rounding,
                         F f)
{
  Line_in_mesh line(mesh, other.position(source), other.position(target), length, rounding);
  if(!line.is_found())
  {
    const Intrinsic_triangulation& t = other.triangulation();
    Line_search arc(length, rounding);
    find_arc_of_graph<Visitor>(t, rules, source, target, arc);
    if(arc.found.target == target)
      line.find(other, source, arc.found);
  }
  if(!line.is_found())
    line.find();
  return line.for_each_crossing(f);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H
