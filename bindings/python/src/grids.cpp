// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grids.h"

#include "arrays.h"
#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Grid_solver.h>

#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace python {
namespace {

using Values = std::optional<Array<double>>;

// The cost model, its parameters, and its numbers of cells.
using Cost = std::tuple<std::uint8_t, std::vector<double>, Array<double>>;

std::vector<double> copied(const Array<double>& values)
{
  return {values.data(), values.data() + values.size()};
}

// Returns `f()`. Messages name cells by columns and rows, and arrays have them the other way round.
template <typename F>
auto with_rows_first(F f)
{
  try
  {
    return f();
  }
  catch(const std::invalid_argument& e)
  {
    static const std::regex cell(R"(cell \((\d+), (\d+)\))");
    throw std::invalid_argument(std::regex_replace(std::string(e.what()), cell, "cell ($2, $1)"));
  }
}

std::unique_ptr<AG::Grid_solver> make_grid(const std::pair<std::size_t, std::size_t>& rows_columns,
                                           const std::pair<double, double>& cell_size,
                                           const std::optional<double> no_data,
                                           const std::optional<double> first_latitude,
                                           const std::pair<double, double>& ellipsoid,
                                           const bool is_periodic,
                                           const Values& friction,
                                           const Values& heights,
                                           const std::optional<double> epsilon,
                                           const std::optional<Cost>& cost,
                                           const Values& slope_costs,
                                           const double max_slope,
                                           const py::object& progress)
{
  AG::Grid_shape shape{
      rows_columns.second, rows_columns.first, cell_size.first, cell_size.second, no_data,
      first_latitude};
  shape.ellipsoid = {ellipsoid.first, ellipsoid.second};
  shape.is_periodic = is_periodic;
  AG::Grid_solver_options options;
  options.friction = friction ? friction->data() : nullptr;
  options.heights = heights ? heights->data() : nullptr;
  options.epsilon = epsilon;
  if(cost)
    options.cost = {static_cast<AG::Solver_cost::Model>(std::get<0>(*cost)), std::get<1>(*cost),
                    copied(std::get<2>(*cost))};
  if(slope_costs)
    options.slope_costs = copied(*slope_costs);
  options.max_slope = max_slope;
  return with_rows_first([&] {
    return run(progress, [&](const AG::Solver_watch& watch) {
      return std::make_unique<AG::Grid_solver>(shape, options, watch);
    });
  });
}

// Cells are rows of two numbers: a row and a column of the grid. Those below 0 become too large.
AG::Grid_cell cell(const Array<std::int64_t>& cells, const py::ssize_t i)
{
  return {static_cast<std::size_t>(cells.at(i, 1)), static_cast<std::size_t>(cells.at(i, 0))};
}

py::tuple distances(const AG::Grid_solver& grid,
                    const Array<std::int64_t>& sources,
                    const double maximum_distance,
                    const bool direction_to_source,
                    const bool wants_nearest,
                    const bool wants_predecessors,
                    const py::object& progress)
{
  std::vector<AG::Grid_cell> cells;
  for(py::ssize_t i = 0; i < sources.shape(0); ++i)
    cells.push_back(cell(sources, i));
  const AG::Grid_shape& shape = grid.graph().shape();
  const std::vector<py::ssize_t> size{static_cast<py::ssize_t>(shape.rows),
                                      static_cast<py::ssize_t>(shape.columns)},
      none{0, 0};
  Array<double> result(size);
  Array<std::int64_t> nearest(wants_nearest ? size : none),
      predecessors(wants_predecessors ? size : none);
  double* const data = result.mutable_data();
  std::int64_t* const nearest_data = wants_nearest ? nearest.mutable_data() : nullptr;
  std::int64_t* const predecessor_data = wants_predecessors ? predecessors.mutable_data() : nullptr;
  with_rows_first([&] {
    run(progress, [&](const AG::Solver_watch& watch) {
      grid.find_distances(cells, data, nearest_data, predecessor_data,
                          {maximum_distance, direction_to_source}, watch);
    });
  });
  return py::make_tuple(result, nearest, predecessors);
}

// Returns points as rows and columns, in which centers are integers.
Array<double> in_cells(const std::vector<AG::Grid_point>& points, const AG::Grid_shape& shape)
{
  std::vector<double> result;
  for(const AG::Grid_point& p : points)
  {
    result.push_back(p.y / shape.cell_height - 0.5);
    result.push_back(p.x / shape.cell_width - 0.5);
  }
  return moved(std::move(result), {static_cast<py::ssize_t>(points.size()), 2});
}

py::tuple path(const AG::Grid_solver& grid, const Array<std::int64_t>& ends)
{
  std::vector<AG::Grid_point> points;
  double cost = 0;
  with_rows_first([&] {
    run(py::none(), [&](const AG::Solver_watch& watch) {
      cost = grid.find_path(cell(ends, 0), cell(ends, 1), points, watch);
    });
  });
  return py::make_tuple(in_cells(points, grid.graph().shape()), cost);
}

py::list isolines(const AG::Grid_solver& grid, const Array<double>& values, const double level)
{
  const double* const data = values.data();
  const auto lines = [&] {
    const Unlocked unlocked;
    return grid.find_isolines(data, level);
  }();
  py::list result;
  for(const auto& line : lines)
    result.append(in_cells(line, grid.graph().shape()));
  return result;
}

// Returns which cells can be entered.
Array<bool> can_enter(const AG::Grid_solver& grid)
{
  const AG::Grid_shape& shape = grid.graph().shape();
  Array<bool> result(std::vector<py::ssize_t>{static_cast<py::ssize_t>(shape.rows),
                                              static_cast<py::ssize_t>(shape.columns)});
  bool* const data = result.mutable_data();
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    data[i] = std::isfinite(grid.graph().friction(shape.cell(i)));
  return result;
}

} // namespace

void add_grid(py::module_& module)
{
  using AG::Grid_solver;
  py::class_<Grid_solver>(module, "Grid")
      .def(py::init(&make_grid), py::arg("rows_columns"), py::arg("cell_size"), py::arg("no_data"),
           py::arg("first_latitude"), py::arg("ellipsoid"), py::arg("is_periodic"),
           py::arg("friction").noconvert(), py::arg("heights").noconvert(), py::arg("epsilon"),
           py::arg("cost"), py::arg("slope_costs").noconvert(), py::arg("max_slope"),
           py::arg("progress"))
      .def("distances", &distances)
      .def("path", &path)
      .def("isolines", &isolines)
      .def("can_enter", &can_enter)
      .def_property_readonly(
          "error_on_equal_cells",
          [](const Grid_solver& grid) { return grid.graph().error_on_equal_cells(); })
      .def_property_readonly("error_of_slopes",
                             [](const Grid_solver& grid) { return grid.graph().error_of_slopes(); })
      .def_property_readonly("memory", &Grid_solver::memory);
}

} // namespace python
