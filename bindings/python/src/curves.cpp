// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "curves.h"

#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_curves.h>

#include <pybind11/stl.h>

#include <utility>

namespace python {
namespace {

// `make_source(curves)` returns a curve or a region.
template <typename MakeSource>
Array<double> distances_from(const AG::Solver& solver,
                             const MakeSource& make_source,
                             const bool is_signed,
                             const py::object& progress)
{
  Array<double> result(static_cast<py::ssize_t>(solver.number_of_vertices()));
  double* const data = result.mutable_data();
  run(progress, [&](const AG::Solver_watch& watch) {
    const AG::Solver_curves curves(solver);
    curves.find_distances(make_source(curves), data, is_signed, watch);
  });
  return result;
}

} // namespace

Array<double> distances_from_curve(const AG::Solver& solver,
                                   const Array<std::int64_t>& elements,
                                   const std::optional<Array<double>>& coordinates,
                                   const bool is_closed,
                                   const bool is_signed,
                                   const py::object& progress)
{
  const auto places = points(elements, coordinates);
  return distances_from(
      solver, [&](const AG::Solver_curves& curves) { return curves.curve(places, is_closed); },
      is_signed, progress);
}

Array<double> distances_from_region(const AG::Solver& solver,
                                    const std::vector<std::int64_t>& faces,
                                    const py::object& progress)
{
  return distances_from(
      solver, [&](const AG::Solver_curves& curves) { return curves.region(faces); }, false,
      progress);
}

py::list offsets_of_curve(const AG::Solver& solver,
                          const Array<std::int64_t>& elements,
                          const std::optional<Array<double>>& coordinates,
                          const bool is_closed,
                          const std::vector<double>& distances,
                          const py::object& progress)
{
  const auto places = points(elements, coordinates);
  auto offsets = run(progress, [&](const AG::Solver_watch& watch) {
    const AG::Solver_curves curves(solver);
    return curves.offsets(curves.curve(places, is_closed), distances, watch);
  });
  py::list result;
  for(auto& offset : offsets)
    result.append(py::make_tuple(offset.distance, moved_points(std::move(offset.coordinates))));
  return result;
}

} // namespace python
