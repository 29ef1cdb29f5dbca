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

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * What a solver asks of a graph, whichever it is. Several threads may call all of it at the same
 * time.
 */
class Solver_graph
{
public:
  using Points = std::vector<Intrinsic_point>;

  virtual ~Solver_graph() = default;

  virtual const Intrinsic_triangulation& triangulation() const = 0;

  // Paths are at most so much longer than possible, as a part of that; infinity if nobody knows.
  virtual double error_bound() const = 0;

  virtual std::size_t memory() const = 0;

  // Writes the distance of each vertex, by its index in the mesh, and the position of its nearest
  // source, or -1, unless there is no room for that.
  virtual void find_distances(std::vector<Source_point> sources,
                              double maximum_distance,
                              double* distances,
                              std::int64_t* nearest_sources,
                              Solver_visitor& visitor) const = 0;

  // The path from the target to the source, without points if there is none.
  virtual Path find_path(const Intrinsic_point& source,
                         const Intrinsic_point& target,
                         const Vertex_positions& positions,
                         Solver_visitor& visitor) const = 0;

  // The targets are all vertices if there is no list of them.
  virtual void compute_rows(Any_rows& rows,
                            const Points& sources,
                            const Points* targets,
                            double maximum_distance,
                            bool is_symmetric,
                            Solver_visitor& visitor) const = 0;

  // Appends vertices, by their indices, and returns how far the others are from them at most.
  virtual double find_farthest_vertices(const Points& sources,
                                        std::size_t number,
                                        std::vector<std::int64_t>& vertices,
                                        Solver_visitor& visitor) const = 0;

  // The graph for the ways back; null if it is this one.
  virtual std::unique_ptr<Solver_graph> reversed() const = 0;

  // Writes what takes long to find again.
  virtual void save(std::ostream& out) const = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H
