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
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Balanced_fans.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The triangulation whose faces cones cross: that of the mesh, or, where a vertex of that has very
 * many neighbors, one with balanced fans. Those who have it keep the mesh's, too, and hand it in.
 */
class Cone_triangulation
{
  using Index = Intrinsic_triangulation::Index;

public:
  Cone_triangulation() = default;

  explicit Cone_triangulation(const Intrinsic_triangulation& mesh)
  {
    if(Balanced_fans::are_useful(mesh))
      m_fans.emplace(mesh);
  }

  bool has_balanced_fans() const { return m_fans.has_value(); }

  const Intrinsic_triangulation& get(const Intrinsic_triangulation& mesh) const
  {
    return m_fans ? m_fans->triangulation() : mesh;
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
    if(m_fans)
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
        if(m_fans->is_lost(h))
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
    return m_fans ? trace_arc_of_fans<Visitor>(mesh, *m_fans, rules, source, target, length, f)
                  : trace_arc<Visitor>(mesh, rules, source, target, length, f);
  }

  std::size_t memory() const { return m_fans ? m_fans->memory() : 0; }

private:
  std::optional<Balanced_fans> m_fans;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_TRIANGULATION_H
