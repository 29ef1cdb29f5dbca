// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_ARRAYS_H
#define APPROXIMATE_GEODESICS_PYTHON_ARRAYS_H

// Conversions between NumPy arrays and C++ arrays without copies: arguments are read in place, and
// returned arrays own their results.

#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;
namespace AG = CGAL::Approximate_geodesics;

// With `noconvert()`, only contiguous arrays of this type are accepted, and they are never copied.
template <typename T>
using Array = py::array_t<T, py::array::c_style>;

// Transfers the ownership of an object to arrays that refer to its parts.
template <typename T>
py::capsule capsule(std::unique_ptr<T> owned)
{
  py::capsule result(owned.get(), [](void* const p) { delete static_cast<T*>(p); });
  owned.release();
  return result;
}

template <typename T>
Array<T> moved(std::vector<T> values, std::vector<py::ssize_t> shape)
{
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = owned->data();
  return Array<T>(std::move(shape), data, capsule(std::move(owned)));
}

// Coordinates as an array of points.
inline Array<double> moved_points(std::vector<double> coordinates)
{
  const auto rows = static_cast<py::ssize_t>(coordinates.size() / 3);
  return moved(std::move(coordinates), {rows, 3});
}

// Converts vertices; pairs of the vertices of edges, and parameters on them; or faces, and
// barycentric coordinates in them.
inline std::vector<AG::Solver_point> points(const Array<std::int64_t>& elements,
                                            const std::optional<Array<double>>& coordinates)
{
  std::vector<AG::Solver_point> result;
  result.reserve(static_cast<std::size_t>(elements.shape(0)));
  for(py::ssize_t i = 0; i < elements.shape(0); ++i)
    if(elements.ndim() == 2)
      result.push_back(
          AG::Solver_point::on_edge(elements.at(i, 0), elements.at(i, 1), coordinates->at(i)));
    else if(coordinates)
      result.push_back(AG::Solver_point::in_face(
          elements.at(i), {coordinates->at(i, 0), coordinates->at(i, 1), coordinates->at(i, 2)}));
    else
      result.push_back(AG::Solver_point::at_vertex(elements.at(i)));
  return result;
}

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_ARRAYS_H
