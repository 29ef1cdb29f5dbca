// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Polygon_mesh_processing/locate.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The parameters of `Solver_cells`.
 */
struct Solver_cell_options
{
  /// whether borders are also those of the cut locus.
  bool within_cells = false;

  /// a distance to add for each source; if there are none, they are `0`.
  std::vector<double> initial_distances = {};

  /// the largest distance of an arc from its polyline; if absent, a thousandth of the mean length
  /// of edges.
  std::optional<double> chord_error = std::nullopt;
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The exact cells of sources on the surface of a `Solver`: what `voronoi_borders()` or
 * `cut_locus()` finds, as plain arrays. They depend neither on the bound of the solver nor on its
 * costs and barriers. The header is not part of `Solver.h`, as programs for distances do not need
 * it.
 */
class Solver_cells
{
  using Mesh = Solver::Mesh;

public:
  /// A border between two cells, the first of which is to the left.
  struct Border
  {
    std::array<std::size_t, 2> sources; ///< their positions; they are equal on a cut locus
    std::vector<double> coordinates;    ///< those of its points, three each; the last point of a
                                        ///< closed border equals the first one
    bool is_closed;                     ///< whether it is closed
  };

  /// divides the surface of a solver among sources.
  /// \param solver is not kept
  /// \param sources the sources
  /// \param options which borders, and how exact their polylines are
  /// \param watch is called during the run
  /// \throws std::invalid_argument as `voronoi_borders()` does.
  Solver_cells(const Solver& solver,
               const std::vector<Solver_point>& sources,
               const Solver_cell_options& options = Solver_cell_options(),
               const Solver_watch& watch = Solver_watch())
  {
    internal::Solver_visitor visitor(watch);
    std::vector<Surface_point<Mesh>> points;
    for(const Solver_point& p : sources)
      points.push_back(solver.surface_point(p, "source " + std::to_string(points.size())));
    std::vector<double> initial = options.initial_distances;
    if(initial.empty())
      initial.resize(points.size(), 0);
    const auto np = parameters::initial_distances(initial);
    const auto divided = [&](const auto& given) {
      return internal::cells_of(solver.mesh(), points, options.within_cells, given);
    };
    set(solver.mesh(),
        options.chord_error ? divided(np.chord_error(*options.chord_error)) : divided(np));
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
  void set(const Mesh& mesh, const Voronoi_cells<Mesh>& cells)
  {
    m_areas = cells.areas;
    m_neighbors = cells.neighbors();
    m_triangles = cells.triangles();
    for(const auto& border : cells.borders)
    {
      m_borders.push_back({border.sources, {}, border.is_closed()});
      std::vector<double>& coordinates = m_borders.back().coordinates;
      for(const auto& location : border.points)
      {
        const auto p = Polygon_mesh_processing::construct_point(location, mesh);
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
      }
    }
  }

  std::vector<double> m_areas;
  std::vector<Border> m_borders;
  std::vector<std::array<std::size_t, 2>> m_neighbors;
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CELLS_H
