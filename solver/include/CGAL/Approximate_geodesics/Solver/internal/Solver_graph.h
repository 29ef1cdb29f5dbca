// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Any_rows.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_visitor.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The type-erased interface of the graphs of a solver. All member functions are thread-safe.
 */
class Solver_graph
{
public:
  using Points = std::vector<Intrinsic_point>;

  virtual ~Solver_graph() = default;

  virtual const Intrinsic_triangulation& triangulation() const = 0;

  // The relative error bound of paths; infinity if it is unknown.
  virtual double error_bound() const = 0;

  virtual std::size_t memory() const = 0;

  // Writes the distance of each vertex, by its index in the mesh, and, if `nearest_sources` is not
  // null, the position of its nearest source, or -1.
  virtual void find_distances(std::vector<Source_point> sources,
                              double maximum_distance,
                              double* distances,
                              std::int64_t* nearest_sources,
                              Solver_visitor& visitor) const = 0;

  // Returns the path from the target to the source. It has no points if the target is not reached.
  virtual Path find_path(const Intrinsic_point& source,
                         const Intrinsic_point& target,
                         const Vertex_positions& positions,
                         Solver_visitor& visitor) const = 0;

  // If `targets` is null, all vertices are targets.
  virtual void compute_rows(Any_rows& rows,
                            const Points& sources,
                            const Points* targets,
                            double maximum_distance,
                            bool is_symmetric,
                            Solver_visitor& visitor) const = 0;

  // Appends the indices of chosen vertices, and returns the largest distance of a vertex from them.
  virtual double find_farthest_vertices(const Points& sources,
                                        std::size_t number,
                                        std::vector<std::int64_t>& vertices,
                                        Solver_visitor& visitor) const = 0;

  // Returns the reversed graph, or null if the graph is undirected.
  virtual std::unique_ptr<Solver_graph> reversed() const = 0;

  // Writes the graph if it is expensive to build.
  virtual void save(std::ostream& out) const = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H
