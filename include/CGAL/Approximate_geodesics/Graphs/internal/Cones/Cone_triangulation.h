// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_rules.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_line.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_segment.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Balanced_fans.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Refined_needles.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The triangulation whose faces cones cross, and whose vertices are the nodes of a graph: that of
 * the mesh; or one with refined needles, if it has many of them; or one with balanced fans, if a
 * vertex has very many neighbors. Those who have it keep the mesh's, too, and hand it in.
 */
class Cone_triangulation
{
  using Index = Intrinsic_triangulation::Index;

public:
  Cone_triangulation() = default;

  explicit Cone_triangulation(const Intrinsic_triangulation& mesh)
  {
    if(Refined_needles::are_useful(mesh))
    {
      m_needles.emplace(mesh);
      // by rounding, a new face may have no shape
      if(m_needles->triangulation().face_without_shape() == Intrinsic_triangulation::null_index)
        return;
      m_needles.reset();
    }
    if(Balanced_fans::are_useful(mesh))
      m_fans.emplace(mesh);
  }

  bool has_balanced_fans() const { return m_fans.has_value(); }

  const Intrinsic_triangulation& get(const Intrinsic_triangulation& mesh) const
  {
    if(m_needles)
      return m_needles->triangulation();
    return m_fans ? m_fans->triangulation() : mesh;
  }

  bool has_refined_needles() const { return m_needles.has_value(); }

  // Where a node is in the mesh.
  Intrinsic_point position(const Intrinsic_triangulation& mesh, const Index node) const
  {
    return node < mesh.number_of_vertices() ? Intrinsic_point::at_vertex(node)
                                            : m_needles->position(node);
  }

  // Calls `f(target, length)` for the arcs of `v` that `expansion` finds, which crosses this
  // triangulation, and for the edges of the mesh that are none of it. So every edge of the mesh has
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
    if((m_fans || m_needles) && v < mesh.number_of_vertices())
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
        if(m_fans ? m_fans->is_lost(h) : m_needles->is_lost(h))
          f(mesh.target(h), mesh.length(h));
  }

  // Does what `trace_arc()` does, with edges of the mesh.
  template <typename Visitor, typename F>
  double trace(const Intrinsic_triangulation& mesh,
               const Cone_rules& rules,
               const Index source,
               const Index target,
               const double length,
               F f) const
  {
    if(m_needles)
      return trace_segment(mesh, position(mesh, source), position(mesh, target), length, f);
    return m_fans ? trace_arc_of_fans<Visitor>(mesh, *m_fans, rules, source, target, length, f)
                  : trace_arc<Visitor>(mesh, rules, source, target, length, f);
  }

  std::size_t memory() const
  {
    return (m_fans ? m_fans->memory() : 0) + (m_needles ? m_needles->memory() : 0);
  }

private:
  std::optional<Balanced_fans> m_fans;
  std::optional<Refined_needles> m_needles;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
