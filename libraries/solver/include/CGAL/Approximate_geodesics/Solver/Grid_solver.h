// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_GRID_SOLVER_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_GRID_SOLVER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_visitor.h>
#include <CGAL/Approximate_geodesics/Solver/internal/make_grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/search_on_grid.h>
#include <CGAL/Geodesic_grids/isolines_on_grid.h>
#include <CGAL/Geodesic_queries/internal/Workspaces.h>
#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * Costs and paths on a regular grid of cells, which are plain arrays: `Grid_graph` for bindings to
 * other languages. Values of cells are given row by row.
 *
 * All member functions are `const`, and several threads may call them at the same time.
 */
class Grid_solver
{
public:
  /*!
   * builds the graph. It copies what it needs, and keeps no pointer.
   *
   * \throws std::invalid_argument, std::length_error as the constructor of `Grid_graph` does.
   * \throws std::invalid_argument also if costs or a limit are of the slope and there are no
   * heights, if there is a bound `epsilon` with heights or costs, or if numbers of the costs are
   * wrong.
   */
  explicit Grid_solver(const Grid_shape& shape,
                       const Grid_solver_options& options = Grid_solver_options(),
                       const Solver_watch& watch = Solver_watch())
    : m_graph([&] {
        internal::Solver_visitor visitor(watch);
        Grid_graph result = internal::make_grid_graph(shape, options);
        visitor.finish();
        return result;
      }()),
      m_searches(m_graph)
  {
  }

  Grid_solver(const Grid_solver&) = delete;
  Grid_solver& operator=(const Grid_solver&) = delete;

  /// returns the graph.
  const Grid_graph& graph() const { return m_graph; }

  /// returns the size of the graph and of the unused workspaces, in bytes.
  std::size_t memory() const
  {
    const auto of_searches = [](const internal::Workspaces<Propagation<Grid_graph>>& searches) {
      return searches.sum([](const Propagation<Grid_graph>& search) { return search.memory(); });
    };
    const std::lock_guard lock(m_mutex);
    return m_graph.memory() + of_searches(m_searches) +
           (m_reversed ? m_reversed->graph.memory() + of_searches(m_reversed->searches) : 0);
  }

  /*!
   * finds the cost of each cell from the nearest source.
   *
   * \param sources the sources
   * \param costs receives one number per cell, infinity if it is not reached
   * \param nearest_sources if not null, receives the position among the sources of the nearest one
   *        of each cell, or `-1` if it is not reached
   * \param predecessors if not null, receives the previous cell whose center is on the path, by its
   *        place in the order of values: the cell itself if there is none, or `-1` if it is not
   *        reached
   * \param options the range and the direction of the search
   * \param watch is called during the run
   *
   * \throws std::invalid_argument if a source does not exist, or the maximum distance is negative
   * or not a number.
   */
  void find_distances(const std::vector<Grid_cell>& sources,
                      double* const costs,
                      std::int64_t* const nearest_sources = nullptr,
                      std::int64_t* const predecessors = nullptr,
                      const Solver_search_options& options = Solver_search_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    const auto search = searches(options.direction_to_source).borrow();
    search->run(internal::seeds_of_cells(m_graph, sources), Stop_rule{options.maximum_distance});
    for(std::size_t i = 0; i < m_graph.shape().number_of_cells(); ++i)
    {
      const auto node = static_cast<Grid_graph::Node>(i);
      const bool is_reached = search->is_reached(node);
      costs[i] = search->distance(node);
      if(nearest_sources != nullptr)
        nearest_sources[i] = is_reached ? static_cast<std::int64_t>(search->source(node)) : -1;
      if(predecessors != nullptr)
        predecessors[i] = is_reached ? static_cast<std::int64_t>(previous_cell(*search, node)) : -1;
    }
    visitor.finish();
  }

  /*!
   * finds a cheapest path between two cells, by an A* search, and returns its cost.
   *
   * \param source the cell where the path begins
   * \param target the cell where it ends
   * \param points receives the points of the path; none if there is no path
   * \param watch is called during the run
   *
   * \return the cost, or infinity if there is no path.
   */
  double find_path(const Grid_cell& source,
                   const Grid_cell& target,
                   std::vector<Grid_point>& points,
                   const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    const Grid_graph::Node end = internal::name_in_message([] { return std::string("target"); },
                                                           [&] { return m_graph.node(target); });
    const auto search = m_searches.borrow();
    points = internal::find_path_on_grid(
        *search, internal::seeds_of_cells(m_graph, std::vector<Grid_cell>{source}),
        internal::infinity, end);
    visitor.finish();
    return search->distance(end);
  }

  /// returns the lines where a function, given by one value per cell, has a value: see
  /// `isolines_on_grid()`. Values are costs, or others without `Grid_shape::no_data`; where there
  /// is no value, it is infinite or NaN.
  std::vector<std::vector<Grid_point>> find_isolines(const double* const values,
                                                     const double isovalue) const
  {
    std::vector<std::vector<Grid_point>> result;
    Grid_shape shape = m_graph.shape();
    shape.no_data.reset(); // that of friction can be a cost
    isolines_on_grid(shape, CGAL::make_range(values, values + shape.number_of_cells()), isovalue,
                     std::back_inserter(result));
    return result;
  }

private:
  using Searches = internal::Workspaces<Propagation<Grid_graph>>;

  struct Reversed
  {
    explicit Reversed(const Grid_graph& other) : graph(other.reversed()), searches(graph) {}

    Grid_graph graph;
    Searches searches;
  };

  // Returns the workspaces of the graph, or of the reversed one, which is made on demand.
  Searches& searches(const bool is_to_source) const
  {
    if(!is_to_source || !m_graph.has_directions())
      return m_searches;
    const std::lock_guard lock(m_mutex);
    if(m_reversed == nullptr)
      m_reversed = std::make_unique<Reversed>(m_graph);
    return m_reversed->searches;
  }

  // Returns the previous center on the path to a node.
  Grid_graph::Node previous_cell(const Propagation<Grid_graph>& search,
                                 const Grid_graph::Node node) const
  {
    Grid_graph::Node result = search.predecessor(node);
    while(result != search.null_node && result >= m_graph.shape().number_of_cells())
      result = search.predecessor(result);
    return result == search.null_node ? node : result;
  }

  Grid_graph m_graph;
  mutable Searches m_searches;
  mutable std::unique_ptr<Reversed> m_reversed;
  mutable std::mutex m_mutex;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_GRID_SOLVER_H
