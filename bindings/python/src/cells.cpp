// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cells.h"

#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_cells.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace python {
namespace {

template <std::size_t n>
Array<std::int64_t> rows(const std::vector<std::array<std::size_t, n>>& values)
{
  std::vector<std::int64_t> result;
  for(const auto& row : values)
    result.insert(result.end(), row.begin(), row.end());
  return moved(std::move(result),
               {static_cast<py::ssize_t>(values.size()), static_cast<py::ssize_t>(n)});
}

} // namespace

py::tuple cells(const AG::Solver& solver,
                const Array<std::int64_t>& elements,
                const std::optional<Array<double>>& coordinates,
                const bool within_cells,
                const std::vector<double>& initial_distances,
                const std::optional<double> chord_error)
{
  const auto sources = points(elements, coordinates);
  const auto found = run(py::none(), [&](const AG::Solver_watch& watch) {
    return AG::Solver_cells(solver, sources, {within_cells, initial_distances, chord_error}, watch);
  });
  py::list borders;
  std::vector<std::array<std::size_t, 2>> sources_of_borders;
  for(const auto& border : found.borders())
  {
    borders.append(moved_points(border.coordinates));
    sources_of_borders.push_back(border.sources);
  }
  return py::make_tuple(moved(found.areas(), {static_cast<py::ssize_t>(found.areas().size())}),
                        borders, rows(sources_of_borders), rows(found.neighbors()),
                        rows(found.triangles()));
}

} // namespace python
