// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Finds, in a mesh, lines that were found in a triangulation with balanced fans: by their start,
 * their direction there, and their length.
 */
class Line_in_mesh
{
  using Index = Intrinsic_triangulation::Index;

  static constexpr Index null_index = Intrinsic_triangulation::null_index;

public:
  Line_in_mesh(const Intrinsic_triangulation& mesh, const Retriangulation& fans)
    : m_mesh(mesh), m_fans(fans)
  {
  }

  // Looks for `arc`, which starts from `source`, among the lines of the mesh in its direction.
  void find(const Index source, const Straight_arc& arc, Line_search& search) const
  {
    Index h = arc.start;
    const double angle = angle_from_edge_of_mesh(source, h, arc.position);
    for(double tolerance = 1e-11; tolerance < 1e-3 && !search.is_found(); tolerance *= 100)
      look(source, m_fans.number_in_mesh(h), angle, tolerance, arc, search);
  }

private:
  // Windows that a line with this direction and length may go through.
  struct Along_line : Leave_out_nothing_in_doubt
  {
    bool prune(const Window& w) const
    {
      const Plane_vector edge = w.left_position - w.right_position;
      return cross(direction, w.left_position) < -tolerance * length(w.left_position) ||
             cross(w.right_position, direction) < -tolerance * length(w.right_position) ||
             cross(w.right_position, edge) > 1.01 * reach * cross(direction, edge);
    }

    Plane_vector direction; // of length 1
    double reach;
    double tolerance;
  };

  // Turns `h` clockwise to a halfedge of the mesh. Returns the angle from there to `position`,
  // which is seen where `h` was along x.
  double angle_from_edge_of_mesh(const Index source, Index& h, const Plane_vector position) const
  {
    const Intrinsic_triangulation& t = m_fans.triangulation();
    double result = std::atan2(position.y, position.x);
    while(t.is_flipped(h))
    {
      h = t.clockwise(source, h);
      result += corner(t, h);
    }
    return result;
  }

  static double corner(const Intrinsic_triangulation& t, const Index h)
  {
    const Plane_vector angle = corner_angle(t, h);
    return std::atan2(angle.y, angle.x);
  }

  // Goes round from `h` by the given angle, and looks across the face there, or the two next to it
  // if it may be either of them.
  void look(const Index source,
            Index h,
            double angle,
            const double tolerance,
            const Straight_arc& arc,
            Line_search& search) const
  {
    for(Index n = m_mesh.degree(source); n > 0 && !m_mesh.is_border(h); --n)
    {
      const double corner = Line_in_mesh::corner(m_mesh, h);
      if(angle >= -tolerance && angle <= corner + tolerance)
        look_across(source, h, {std::cos(angle), std::sin(angle)}, tolerance, arc, search);
      angle -= corner;
      if(angle < -tolerance)
        return;
      h = m_mesh.counterclockwise(source, h);
    }
  }

  void look_across(const Index source,
                   const Index h,
                   const Plane_vector direction,
                   const double tolerance,
                   const Straight_arc& arc,
                   Line_search& search) const
  {
    const Unfolding_on_demand unfolding(m_mesh);
    const Unfolded_face face = unfolding.face(h);
    const Index left_side = m_mesh.counterclockwise(source, h);
    const double right_distance = m_mesh.length(h), left_distance = m_mesh.length(left_side);
    if(face.right == null_index || !(right_distance > 0 && left_distance > 0))
      return;
    const Plane_vector right{right_distance, 0};
    const Window window{
        face.right, face.apex,     m_mesh.target(h), face.position_of_apex({0, 0}, right),
        right,      left_distance, right_distance,   0};
    const Cone_rules no_end(1e-300); // cones are as narrow as they can be
    Cone_expansion<Unfolding_on_demand>(m_mesh, unfolding, no_end)
        .expand_through(
            window, h,
            [&](const Straight_arc& line) {
              if(line.target == arc.target)
                search.consider(line);
            },
            Remembering<Along_line>{{{}, direction, arc.length, tolerance}, search.tree});
  }

  const Intrinsic_triangulation& m_mesh;
  const Retriangulation& m_fans;
};

// Does what `trace_arc()` does for a graph that was built on a triangulation with balanced fans:
// calls `f(h, t)` for edges of the mesh.
template <typename Visitor, typename F>
double trace_arc_of_fans(const Intrinsic_triangulation& mesh,
                         const Retriangulation& fans,
                         const Cone_rules& rules,
                         const Intrinsic_triangulation::Index source,
                         const Intrinsic_triangulation::Index target,
                         const double length,
                         F f)
{
  Line_search search{length};
  for(auto h = mesh.first_halfedge(source); h < mesh.beyond_halfedge(source); ++h)
    if(mesh.target(h) == target)
      search.consider({target, mesh.length(h), {mesh.length(h), 0}, h, 0});
  if(search.is_found())
    return search.found.length;

  Line_search found{length};
  find_arc(fans.triangulation(), rules, source, target, Visitor(), found);
  search_in_doubt(fans.triangulation(), rules, source, target, found);
  if(found.found.target == target)
    Line_in_mesh(mesh, fans).find(source, found.found, search);
  search_in_doubt(mesh, rules, source, target, search);
  return report_line(mesh, search, target, f);
}

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

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_TRACE_LINE_H
