// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/voronoi_borders.h>
#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Polygon_mesh_processing/locate.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * The exact cells of sources on the surface of a `Solver`: what `voronoi_borders()` or
 * `cut_locus()` finds, as plain arrays. They depend neither on the bound of the solver nor on its
 * costs and barriers. The header is not part of `Solver.h`, as programs for distances do not need
 * it.
 */
class Solver_cells
{
  using Mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;

public:
  /// A border between two cells, the first of which is to the left.
  struct Border
  {
    std::array<std::size_t, 2> sources; ///< their positions; they are equal on a cut locus
    std::vector<double> coordinates;    ///< those of its points, three each; the last point of a
                                        ///< closed border equals the first one
    bool is_closed;                     ///< whether it is closed
  };

  /// divides the surface of a solver among sources. If `within_cells` is `true`, borders are also
  /// those of the cut locus.
  /// \throws std::invalid_argument as `voronoi_borders()` does.
  Solver_cells(const Solver& solver,
               const std::vector<Solver_point>& sources,
               const bool within_cells = false,
               const Solver_watch& watch = Solver_watch())
  {
    internal::Solver_visitor visitor(watch);
    std::vector<Surface_point<Mesh>> points;
    for(const Solver_point& p : sources)
      points.push_back(solver.surface_point(p, "source " + std::to_string(points.size())));
    const Mesh& mesh = solver.mesh();
    const auto cells = within_cells ? cut_locus(mesh, points) : voronoi_borders(mesh, points);
    m_areas = cells.areas;
    m_neighbors = cells.neighbors();
    m_triangles = cells.triangles();
    for(const auto& border : cells.borders)
    {
      m_borders.push_back({border.sources, {}, border.is_closed()});
      for(const auto& location : border.points)
      {
        const auto p = Polygon_mesh_processing::construct_point(location, mesh);
        m_borders.back().coordinates.insert(m_borders.back().coordinates.end(),
                                            {p.x(), p.y(), p.z()});
      }
    }
    visitor.finish();
  }

  /// returns the area of the cell of each source.
  const std::vector<double>& areas() const { return m_areas; }

  /// returns the borders, in no particular order.
  const std::vector<Border>& borders() const { return m_borders; }

  /// returns the pairs of sources whose cells have a border in common, sorted.
  const std::vector<std::array<std::size_t, 2>>& neighbors() const { return m_neighbors; }

  /// returns the triangles of the dual triangulation, counterclockwise.
  const std::vector<std::array<std::size_t, 3>>& triangles() const { return m_triangles; }

private:
  std::vector<double> m_areas;
  std::vector<Border> m_borders;
  std::vector<std::array<std::size_t, 2>> m_neighbors;
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H
