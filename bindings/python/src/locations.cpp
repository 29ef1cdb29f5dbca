// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "locations.h"

#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_locator.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace python {

Locator::Locator(const AG::Solver& solver)
  : m_locator(
        run(py::none(), [&](const auto&) { return std::make_unique<AG::Solver_locator>(solver); }))
{
}

Locator::~Locator() = default;

py::tuple Locator::locate(const Array<double>& points) const
{
  const py::ssize_t size = points.shape(0);
  Array<std::int64_t> faces(size);
  Array<double> coordinates({size, py::ssize_t(3)}), distances(size);
  const double* const from = points.data();
  std::int64_t* to_faces = faces.mutable_data();
  double *to_coordinates = coordinates.mutable_data(), *to_distances = distances.mutable_data();
  const auto write = [&](const AG::Solver_locator::Location& location) {
    *to_faces++ = location.face;
    to_coordinates =
        std::copy(location.coordinates.begin(), location.coordinates.end(), to_coordinates);
    *to_distances++ = location.distance;
  };
  run(py::none(), [&](const AG::Solver_watch& watch) {
    m_locator->locate(from, static_cast<std::size_t>(size),
                      boost::make_function_output_iterator(write), watch);
  });
  return py::make_tuple(faces, coordinates, distances);
}

} // namespace python
