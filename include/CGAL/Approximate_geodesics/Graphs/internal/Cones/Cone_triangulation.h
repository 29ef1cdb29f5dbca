// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_line.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The triangulation whose faces cones cross, and whose vertices are the nodes of a graph: that of
 * the mesh, or a retriangulation of its surface. The graph stores that of the mesh, too, and passes
 * it as an argument.
 */
class Cone_triangulation
{
public:
  Cone_triangulation() = default;

  explicit Cone_triangulation(const Intrinsic_triangulation& mesh)
    : m_other(Retriangulation::make(mesh))
  {
  }

  bool has_balanced_fans() const { return m_other && m_other->has_balanced_fans(); }

  const Intrinsic_triangulation& get(const Intrinsic_triangulation& mesh) const
  {
    return m_other ? m_other->triangulation() : mesh;
  }

  // A summary of the lengths of edges. Nodes in needles are far closer to each other than most
  // edges are long, so the mean is that of the shortest edge of each node.
  Arc_lengths edge_lengths(const Intrinsic_triangulation& mesh) const
  {
    if(!m_other || !m_other->has_refined_needles())
      return summarize_arc_lengths(mesh.lengths());
    const Intrinsic_triangulation& t = m_other->triangulation();
    Arc_lengths result = summarize_arc_lengths(t.lengths());
    double sum = 0;
    for(Index v = 0; v < t.number_of_vertices(); ++v)
      if(t.degree(v) > 0)
        sum += *std::min_element(t.lengths().begin() + t.first_halfedge(v),
                                 t.lengths().begin() + t.beyond_halfedge(v));
    result.mean = sum / t.number_of_vertices();
    return result;
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
  void for_each_arc(const Intrinsic_triangulation& mesh,
                    const Cone_expansion<Unfolding>& expansion,
                    const Index v,
                    F f,
                    const Visitor& visitor = Visitor()) const
  {
    expansion.expand(
        v, [&](const Straight_arc& arc) { f(arc.target, arc.length); }, visitor);
    if(m_other && v < mesh.number_of_vertices())
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
        if(m_other->is_lost(h))
          f(mesh.target(h), mesh.length(h));
  }

  // Does what `trace_arc()` does, with edges of the mesh. The error of the length is at most
  // `rounding`. With `Visitor` and `rules`, cones must find all arcs of the graph, as in
  // `for_each_arc()`.
  template <typename Visitor, typename F>
  double trace(const Intrinsic_triangulation& mesh,
               const Cone_rules& rules,
               const Index source,
               const Index target,
               const double length,
               const double rounding,
               F f) const
  {
    if(!m_other)
      return trace_arc<Visitor>(mesh, rules, source, target, length, f);
    return trace_arc_in_mesh<Visitor>(mesh, *m_other, rules, source, target, length, rounding, f);
  }

  std::size_t memory() const { return m_other ? m_other->memory() : 0; }

private:
  std::optional<Retriangulation> m_other;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
