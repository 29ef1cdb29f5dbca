// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_CELLS_H
#define APPROXIMATE_GEODESICS_TEST_CELLS_H

#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Grid_cell;
using CGAL::Approximate_geodesics::Grid_graph;
using CGAL::Approximate_geodesics::Grid_point;
using CGAL::Approximate_geodesics::Grid_shape;

// One value per cell, row by row.
using Cell_values = std::vector<double>;

constexpr double no_way = std::numeric_limits<double>::infinity();
constexpr double slack_of_costs = 1e-9; // for rounding

// Returns `f(x, y)` of all centers.
template <typename F>
Cell_values values_of_cells(const Grid_shape& shape, const F& f)
{
  Cell_values result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const Grid_point p = shape.center(shape.cell(i));
    result.push_back(f(p.x, p.y));
  }
  return result;
}

inline Cell_values equal_cells(const Grid_shape& shape, const double value = 1)
{
  return Cell_values(shape.number_of_cells(), value);
}

// On a mesh, paths lead between two cells that touch at a corner. Opens such cells.
inline void open_diagonals(const Grid_shape& shape, Cell_values& friction)
{
  for(std::size_t i = 0; i + shape.columns + 1 < friction.size(); ++i)
    if(shape.cell(i).column + 1 < shape.columns)
      for(const std::size_t k : {i, i + 1, i + shape.columns, i + shape.columns + 1})
        if(std::isinf(friction[i]) == std::isinf(friction[i + shape.columns + 1]) &&
           std::isinf(friction[i + 1]) == std::isinf(friction[i + shape.columns]) &&
           std::isinf(friction[i]) != std::isinf(friction[i + 1]))
          friction[k] = 1;
}

// Returns friction that differs by a factor of up to 55, with cells that are free, and others that
// cannot be entered.
inline Cell_values random_friction(Random& random, const Grid_shape& shape)
{
  Cell_values result;
  const double ratio = random.between(0, 4); // its logarithm
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(random.below(6) == 0    ? no_way
                     : random.below(30) == 0 ? 0
                                             : std::exp(random.between(0, ratio)));
  result[0] = 1;
  for(std::size_t i = 0; i < 3; ++i) // what is opened may make another diagonal
    open_diagonals(shape, result);
  return result;
}

// Returns the distances of all centers in a graph.
inline Cell_values distances_of_cells(const Grid_graph& graph, const Grid_cell& source)
{
  CGAL::Approximate_geodesics::Propagation search(graph);
  search.run_from(graph.node(source));
  Cell_values result;
  for(std::size_t i = 0; i < graph.shape().number_of_cells(); ++i)
    result.push_back(search.distance(static_cast<Grid_graph::Node>(i)));
  return result;
}

// Returns what the function finds.
template <typename Friction, typename... NamedParameters>
Cell_values costs_of_cells(const Grid_shape& shape,
                           const Friction& friction,
                           const Grid_cell& source,
                           const NamedParameters&... np)
{
  Cell_values result;
  CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(result), source,
                                               np...);
  return result;
}

inline double straight_distance(const Grid_point& p, const Grid_point& q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_CELLS_H
