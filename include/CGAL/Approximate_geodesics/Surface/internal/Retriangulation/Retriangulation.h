// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_RETRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_RETRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Balanced_fans.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Edge_flips.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Flipped_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Refined_needles.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Another triangulation of the surface of a mesh, in which straight lines cross fewer faces: with
 * refined needles, balanced fans, or both. Its first vertices are those of the mesh.
 */
class Retriangulation : public Flipped_triangulation
{
public:
  // Returns the retriangulation of `mesh`, if its faces need one.
  static std::optional<Retriangulation> make(const Intrinsic_triangulation& mesh)
  {
    const bool has_needles = Refined_needles::are_useful(mesh);
    if(has_needles || Balanced_fans::are_useful(mesh))
      return Retriangulation(mesh, has_needles, most_flips(mesh));
    return std::nullopt;
  }

  // Refines needles if asked for. Throws if a face of `mesh` breaks the triangle inequality.
  Retriangulation(const Intrinsic_triangulation& mesh,
                  const bool refines_needles,
                  const std::size_t most_flips)
    : m_number_of_vertices(mesh.number_of_vertices())
  {
    mesh.check_triangle_inequality();
    Edge_flips flips(mesh);
    if(refines_needles)
      m_positions = Refined_needles::refine(flips, most_flips);
    m_has_balanced_fans = Balanced_fans::balance(flips);
    static_cast<Flipped_triangulation&>(*this) = Flipped_triangulation(mesh, flips);
  }

  // More than strips and fans of needles take, which is about one per halfedge.
  static std::size_t most_flips(const Intrinsic_triangulation& mesh)
  {
    return std::size_t(32) * mesh.number_of_halfedges();
  }

  bool has_balanced_fans() const { return m_has_balanced_fans; }
  bool has_refined_needles() const { return !m_positions.empty(); }

  // Where a vertex is in the mesh.
  Intrinsic_point position(const Index v) const
  {
    return v < m_number_of_vertices ? Intrinsic_point::at_vertex(v)
                                    : m_positions[v - m_number_of_vertices];
  }

  std::size_t memory() const
  {
    return Flipped_triangulation::memory() + m_positions.capacity() * sizeof(Intrinsic_point);
  }

private:
  Index m_number_of_vertices;               // of the mesh
  std::vector<Intrinsic_point> m_positions; // of added vertices
  bool m_has_balanced_fans = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_RETRIANGULATION_H
