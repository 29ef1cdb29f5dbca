// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Paired_sides.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Array_mesh = Triangle_soup_mesh<std::vector<Simple_cartesian<double>::Point_3>,
                                      std::vector<std::array<std::uint32_t, 3>>>;

/*
 * The arrays of a mesh, copied from those of a program. They keep the numbering and the first
 * corner of each face, to which barycentric coordinates refer.
 */
class Mesh_arrays
{
public:
  // Returns the mesh, which refers to this object.
  Array_mesh mesh() const { return {m_points, m_triangles}; }

  template <typename Integer>
  void assign(const double* const coordinates,
              const std::size_t number_of_vertices,
              const Integer* const corners,
              const std::size_t number_of_faces)
  {
    check_size_of_mesh(number_of_vertices, number_of_faces);
    reserve_huge_pages(m_points, number_of_vertices);
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      add_vertex(coordinates + 3 * v);
    reserve_huge_pages(m_triangles, number_of_faces);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      add_face(corners + 3 * f);
  }

private:
  void add_vertex(const double* const p)
  {
    const std::size_t v = m_points.size();
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      reject("vertex " + std::to_string(v) + " is not finite: (" + text_of(p[0]) + ", " +
             text_of(p[1]) + ", " + text_of(p[2]) + ")");
    check_for_interruption_at(v);
    m_points.emplace_back(p[0], p[1], p[2]);
  }

  // Only vertices that exist fit 32 bits.
  template <typename Integer>
  void add_face(const Integer* const corners)
  {
    const std::size_t f = m_triangles.size();
    check_for_interruption_at(f);
    check_corners_exist(f, corners, m_points.size());
    m_triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                           static_cast<std::uint32_t>(corners[1]),
                           static_cast<std::uint32_t>(corners[2])});
  }

  std::vector<Simple_cartesian<double>::Point_3> m_points;
  std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
