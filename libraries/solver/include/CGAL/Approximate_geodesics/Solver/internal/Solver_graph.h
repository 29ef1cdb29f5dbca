// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_visitor.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A type-erased sink: the computation is instantiated once per graph, not once per pair of graph
 * and sink.
 */
class Any_rows
{
public:
  struct Block : Dense_rows<double>::Block, Sparse_block<double>
  {
  };

  // The sinks are referred to, not copied.
  explicit Any_rows(Dense_rows<double>& rows) : m_rows(&rows) {}
  explicit Any_rows(Radius_rows<double>& rows) : m_rows(&rows) {}
  explicit Any_rows(Nearest_rows<double>& rows)
    : m_rows(&rows), m_number_of_nearest(rows.number_of_nearest())
  {
  }

  static constexpr bool can_be_symmetric = true; // except for nearest rows, see start()

  std::size_t number_of_nearest() const { return m_number_of_nearest; }

  void start(const Distance_matrix_plan& plan)
  {
    if(plan.is_symmetric() && m_number_of_nearest > 0)
      reject(
          "symmetric: not supported for the nearest columns, because nearest neighbors are not a "
          "symmetric relation");
    std::visit([&](auto* const rows) { rows->start(plan); }, m_rows);
  }

  void collect(Block& block, const std::size_t row, const Distance_row& distances)
  {
    std::visit([&](auto* const rows) { rows->collect(block, row, distances); }, m_rows);
  }

  void add(const std::size_t number, Block& block)
  {
    std::visit([&](auto* const rows) { rows->add(number, block); }, m_rows);
  }

  bool finish(const bool is_done)
  {
    return std::visit([&](auto* const rows) { return rows->finish(is_done); }, m_rows);
  }

private:
  std::variant<Dense_rows<double>*, Radius_rows<double>*, Nearest_rows<double>*> m_rows;
  std::size_t m_number_of_nearest = 0;
};

/*
 * The type-erased interface of the graphs of a solver, and the reversed graph, for distances to the
 * sources. All member functions are thread-safe.
 */
class Solver_graph
{
public:
  using Points = std::vector<Intrinsic_point>;

  virtual ~Solver_graph() = default;

  virtual const Intrinsic_triangulation& triangulation() const = 0;

  // The relative error bound of paths; infinity if it is unknown.
  virtual double error_bound() const = 0;

  std::size_t memory() const
  {
    const std::lock_guard lock(m_mutex);
    return own_memory() + (m_reversed == nullptr ? 0 : m_reversed->own_memory());
  }

  // Returns the graph, or the reversed one, which is built on demand. Undirected graphs are their
  // own reversal.
  const Solver_graph& in_direction(const bool to_source) const
  {
    if(!to_source)
      return *this;
    const std::lock_guard lock(m_mutex);
    if(m_reversed == nullptr)
      m_reversed = reversed();
    return m_reversed == nullptr ? *this : *m_reversed;
  }

  // Change weights and barriers. No other thread may use the graph meanwhile. Throw
  // std::invalid_argument if the graph has none.
  virtual void set_weights(const std::vector<Weight_change>& changes) = 0;
  virtual void set_barriers(const std::vector<Barrier_change>& changes) = 0;

  // Makes landmarks, which guide searches for pairs until weights or barriers change. No other
  // thread may use the graph meanwhile. Throws std::invalid_argument if their number is 0.
  virtual void prepare_pairs(std::size_t number_of_landmarks) = 0;

  // Makes labels, from which intervals of pairs of vertices are read until weights or barriers
  // change. No other thread may use the graph meanwhile. Throws std::invalid_argument if the graph
  // cannot have them.
  virtual void prepare_intervals(double epsilon) = 0;

  // Writes the distance of each vertex, by its index in the mesh. Pointers that are not null also
  // receive the position of its nearest source, and the node of the vertex before it, or -1.
  virtual void find_distances(std::vector<Source_point> sources,
                              double maximum_distance,
                              double* distances,
                              std::int64_t* nearest_sources,
                              std::int64_t* predecessors,
                              Solver_visitor& visitor) const = 0;

  // Returns the path from the target to the source. It has no points if the target is not reached.
  virtual Path find_path(const Intrinsic_point& source,
                         const Intrinsic_point& target,
                         const Vertex_positions& positions,
                         Solver_visitor& visitor) const = 0;

  // The following functions find the distance, an interval that contains the distance on the
  // surface, or the path of each pair. Paths lead from sources to targets, and have no points if
  // these are not reached.

  virtual std::vector<double> find_distances(const std::vector<Point_pair>& pairs,
                                             double maximum_distance,
                                             Solver_visitor& visitor) const = 0;

  virtual std::vector<std::pair<double, double>>
  find_intervals(const std::vector<Point_pair>& pairs,
                 double maximum_distance,
                 Solver_visitor& visitor) const = 0;

  virtual std::vector<Path> find_paths(const std::vector<Point_pair>& pairs,
                                       double maximum_distance,
                                       bool straighten,
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

  // Writes the graph if it is expensive to build.
  virtual void save(const Put_bytes& put) const = 0;

private:
  virtual std::size_t own_memory() const = 0;

  // Returns null if the graph is undirected.
  virtual std::unique_ptr<Solver_graph> reversed() const = 0;

  mutable std::unique_ptr<Solver_graph> m_reversed;
  mutable std::mutex m_mutex;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_H
