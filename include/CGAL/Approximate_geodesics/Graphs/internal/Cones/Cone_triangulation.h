// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Lines_by_direction.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The triangulation of a mesh, and the one whose faces cones cross, and whose vertices are the
 * nodes of a graph: the same, or a retriangulation of its surface.
 */
class Cone_triangulation
{
public:
  Cone_triangulation() = default;

  explicit Cone_triangulation(Intrinsic_triangulation mesh, const Loop& loop = Loop())
    : m_mesh(std::move(mesh)), m_other(Retriangulation::make(m_mesh, loop))
  {
  }

  bool has_balanced_fans() const { return m_other && m_other->has_balanced_fans(); }

  const Intrinsic_triangulation& mesh() const { return m_mesh; }

  const Intrinsic_triangulation& get() const { return m_other ? m_other->triangulation() : m_mesh; }

  // A summary of the lengths of edges.
  Arc_lengths edge_lengths() const
  {
    return m_other && m_other->has_refined_needles() ? summarize_edges(m_other->triangulation())
                                                     : summarize_arc_lengths(m_mesh.lengths());
  }

  // Where a node is in the mesh.
  Intrinsic_point position(const Index node) const
  {
    return m_other ? m_other->position(node) : Intrinsic_point::at_vertex(node);
  }

  // Calls `f(target, length)` for the arcs of `v` that `expansion` finds, which crosses this
  // triangulation, and for the edges of the mesh that are not in it. So every edge of the mesh has
  // an arc that is no longer.
  template <typename Unfolding, typename F, typename Visitor = Leave_out_detours>
  void for_each_arc(const Cone_expansion<Unfolding>& expansion,
                    const Index v,
                    F f,
                    const Visitor& visitor = Visitor()) const
  {
    expansion.expand(
        v, [&](const Straight_arc& arc) { f(arc.target, arc.length); }, visitor);
    for_each_lost_edge(v, f);
  }

  // Calls `f(target, length)` for the edges from `v` that are in the mesh only.
  template <typename F>
  void for_each_lost_edge(const Index v, F f) const
  {
    if(m_other && v < m_mesh.number_of_vertices())
      for(Index h = m_mesh.first_halfedge(v); h < m_mesh.beyond_halfedge(v); ++h)
        if(m_other->is_lost(h))
          f(m_mesh.target(h), m_mesh.length(h));
  }

  // Calls `f(h, t)` for every edge of the mesh that an arc of the graph crosses, in this order, and
  // returns its length, which differs from the given one by at most `rounding`. With `Visitor` and
  // `rules`, cones must find all arcs of the graph, as in `for_each_arc()`. If the graph was built
  // on another triangulation, looks for the arc in the mesh: by its direction there, or, if that
  // fails, among all lines within reach.
  template <typename Visitor, typename F>
  double trace(const Cone_rules& rules,
               const Index source,
               const Index target,
               const double length,
               const double rounding,
               F f) const
  {
    Arc_search arc(get(), rules, source, target, length, m_other ? rounding : 0);
    if(!m_other)
    {
      arc.find<Visitor>();
      return arc.for_each_crossing(f);
    }
    const Intrinsic_point end = position(target);
    const Cone_rules latest(1e-300); // cones end as late as possible
    const Lines_by_direction lines(m_mesh, latest, position(source));
    Line_search line(length, rounding);
    lines.consider_lines_in_faces(end, line);
    if(!line.is_found())
    {
      arc.find<Visitor>();
      if(arc.has_arc())
        lines.find_arc(*m_other, source, arc.found, end, line);
    }
    if(!line.is_found())
      lines.find_line(end, Within_reach<Leave_out_nothing_in_doubt>{{}, line.reach()}, line);
    if(!line.is_found())
      reject("the graph has an arc of length " + text_of(length * m_mesh.unit()) +
             " that is not in the mesh; was it read from a file that was changed?");
    return lines.trace(line, f);
  }

  std::size_t memory() const { return m_mesh.memory() + (m_other ? m_other->memory() : 0); }

private:
  Intrinsic_triangulation m_mesh;
  std::optional<Retriangulation> m_other;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
