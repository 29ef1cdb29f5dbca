// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_MATRICES_H
#define APPROXIMATE_GEODESICS_PYTHON_MATRICES_H

// Distance matrices as arrays: a dense array, or the three arrays of compressed sparse rows.

#include "arrays.h"
#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {

// The sources, the targets and the limits of a matrix.
struct Matrix_request
{
  std::vector<AG::Solver_point> sources;
  std::optional<std::vector<AG::Solver_point>> targets;
  AG::Solver_row_options limits;

  AG::Solver_row_options options() const
  {
    AG::Solver_row_options result = limits;
    result.targets = targets ? &*targets : nullptr;
    return result;
  }

  std::size_t number_of_columns(const AG::Solver& solver) const
  {
    return targets ? targets->size() : solver.number_of_vertices();
  }
};

inline Array<double>
dense_matrix(const AG::Solver& solver, const Matrix_request& request, const py::object& progress)
{
  Array<double> result(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(request.sources.size()),
                               static_cast<py::ssize_t>(request.number_of_columns(solver))});
  double* const data = result.mutable_data();
  run(progress, [&](const AG::Solver_watch& watch) {
    solver.compute_matrix(data, request.sources, request.options(), watch);
  });
  return result;
}

// The row pointers of the matrix. SciPy copies the other arrays if the integer type is wider than
// necessary.
template <typename T, typename Rows>
Array<T> starts_of_rows(const Rows& rows)
{
  std::vector<T> starts{0};
  for(std::size_t row = 0; row < rows.number_of_rows(); ++row)
    starts.push_back(static_cast<T>(starts.back() + static_cast<T>(rows.distances(row).size())));
  const auto size = static_cast<py::ssize_t>(starts.size());
  return moved(std::move(starts), {size});
}

template <typename T>
Array<T> shown(const T* const data, const std::size_t size, const py::capsule& owner)
{
  return Array<T>({static_cast<py::ssize_t>(size)}, data, owner);
}

// Returns distances, columns, and row pointers.
template <typename Rows>
py::tuple sparse_matrix(const AG::Solver& solver,
                        std::unique_ptr<Rows> rows,
                        const Matrix_request& request,
                        const py::object& progress)
{
  run(progress, [&](const AG::Solver_watch& watch) {
    solver.compute_matrix(*rows, request.sources, request.options(), watch);
  });
  const Rows& r = *rows;
  const bool is_empty = r.number_of_rows() == 0;
  const double* const distances = is_empty ? nullptr : r.distances(0).begin();
  // same representation: indices fit signed integers
  const auto* const columns =
      is_empty ? nullptr : reinterpret_cast<const std::int32_t*>(r.columns(0).begin());
  const std::size_t size = r.number_of_entries();
  const py::capsule owner = capsule(std::move(rows));
  py::object starts;
  if(size <= static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()))
    starts = starts_of_rows<std::int32_t>(r);
  else
    starts = starts_of_rows<std::int64_t>(r);
  return py::make_tuple(shown(distances, size, owner), shown(columns, size, owner), starts);
}

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_MATRICES_H
