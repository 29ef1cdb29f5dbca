// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The module `_native`: a direct binding of `Solver`, with arrays instead of pointers. The Python
// package, its only caller, converts and validates arguments.

#include "arrays.h"
#include "cells.h"
#include "curves.h"
#include "files.h"
#include "grids.h"
#include "locations.h"
#include "matrices.h"
#include "running.h"
#include "walks.h"

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_pairs.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace python {

using Numbers = Array<std::int64_t>;
using Coordinates = std::optional<Array<double>>;

// The cost model, its parameters, and its face data.
using Cost = std::tuple<std::uint8_t, std::vector<double>, Array<double>>;

AG::Solver_cost solver_cost(const Cost& cost)
{
  const auto& [model, parameters, of_faces] = cost;
  return {static_cast<AG::Solver_cost::Model>(model), parameters,
          std::vector<double>(of_faces.data(), of_faces.data() + of_faces.size())};
}

template <typename Integer>
std::unique_ptr<AG::Solver> make_solver(const Array<double>& vertices,
                                        const Array<Integer>& faces,
                                        const std::optional<double> epsilon,
                                        const std::optional<Array<double>>& face_weights,
                                        const std::optional<Cost>& costs,
                                        const double max_slope,
                                        const bool accept_weaker_bound,
                                        const std::size_t maximum_number_of_points,
                                        const std::optional<Numbers>& barriers,
                                        const bool may_change,
                                        const std::size_t threads,
                                        const py::object& progress)
{
  AG::Solver_options options;
  options.epsilon = epsilon;
  if(face_weights)
    options.face_weights = face_weights->data();
  if(costs)
    options.directional_cost = solver_cost(*costs);
  options.max_slope = max_slope;
  options.accept_weaker_bound = accept_weaker_bound;
  options.maximum_number_of_points = maximum_number_of_points;
  if(barriers)
  {
    options.barriers = barriers->data();
    options.number_of_barriers = static_cast<std::size_t>(barriers->shape(0));
  }
  options.may_change = may_change;
  options.number_of_threads = threads;
  return run(progress, [&](const AG::Solver_watch& watch) {
    return std::make_unique<AG::Solver>(vertices.data(),
                                        static_cast<std::size_t>(vertices.shape(0)), faces.data(),
                                        static_cast<std::size_t>(faces.shape(0)), options, watch);
  });
}

template <typename Integer>
void add_constructor(py::class_<AG::Solver>& solver)
{
  solver.def(py::init(&make_solver<Integer>), py::arg("vertices").noconvert(),
             py::arg("faces").noconvert(), py::arg("epsilon"), py::arg("face_weights").noconvert(),
             py::arg("costs"), py::arg("max_slope"), py::arg("accept_weaker_bound"),
             py::arg("maximum_number_of_points"), py::arg("barriers").noconvert(),
             py::arg("may_change"), py::arg("threads"), py::arg("progress"));
}

void set_weights(AG::Solver& solver, const Numbers& faces, const Array<double>& weights)
{
  solver.set_weights(faces.data(), weights.data(), static_cast<std::size_t>(faces.shape(0)));
}

void set_barriers(AG::Solver& solver, const Numbers& ends, const Array<bool>& is_barrier)
{
  solver.set_barriers(ends.data(), is_barrier.data(), static_cast<std::size_t>(ends.shape(0)));
}

void prepare_pairs(AG::Solver& solver,
                   const std::size_t number_of_landmarks,
                   const py::object& progress)
{
  run(progress,
      [&](const AG::Solver_watch& watch) { solver.prepare_pairs(number_of_landmarks, watch); });
}

void prepare_intervals(AG::Solver& solver, const double epsilon, const py::object& progress)
{
  run(progress, [&](const AG::Solver_watch& watch) { solver.prepare_intervals(epsilon, watch); });
}

py::tuple distances(const AG::Solver& solver,
                    const Numbers& elements,
                    const Coordinates& coordinates,
                    const double maximum_distance,
                    const bool direction_to_source,
                    const bool wants_nearest,
                    const bool wants_predecessors,
                    const py::object& progress)
{
  const auto sources = points(elements, coordinates);
  const auto size = static_cast<py::ssize_t>(solver.number_of_vertices());
  Array<double> result(size);
  Numbers nearest(wants_nearest ? size : 0), predecessors(wants_predecessors ? size : 0);
  double* const data = result.mutable_data();
  std::int64_t* const nearest_data = wants_nearest ? nearest.mutable_data() : nullptr;
  std::int64_t* const predecessor_data = wants_predecessors ? predecessors.mutable_data() : nullptr;
  run(progress, [&](const AG::Solver_watch& watch) {
    solver.find_distances(sources, data, nearest_data, predecessor_data,
                          {maximum_distance, direction_to_source}, watch);
  });
  return py::make_tuple(result, nearest, predecessors);
}

py::tuple path(const AG::Solver& solver,
               const Numbers& elements,
               const Coordinates& coordinates,
               const Numbers& target_elements,
               const Coordinates& target_coordinates,
               const bool straighten)
{
  const auto sources = points(elements, coordinates);
  const auto targets = points(target_elements, target_coordinates);
  std::vector<double> result;
  double length = 0;
  run(py::none(), [&](const AG::Solver_watch& watch) {
    length = solver.find_path(sources.at(0), targets.at(0), straighten, result, watch);
  });
  return py::make_tuple(moved_points(std::move(result)), length);
}

// The sources and the targets of pairs.
struct Pairs
{
  Pairs(const Numbers& elements,
        const Coordinates& coordinates,
        const Numbers& target_elements,
        const Coordinates& target_coordinates)
    : sources(points(elements, coordinates)), targets(points(target_elements, target_coordinates))
  {
  }

  py::ssize_t size() const { return static_cast<py::ssize_t>(sources.size()); }

  std::vector<AG::Solver_point> sources, targets;
};

// Returns distances, or the lower and the upper ends of intervals that contain them.
Array<double> pair_distances(const AG::Solver& solver,
                             const Numbers& elements,
                             const Coordinates& coordinates,
                             const Numbers& target_elements,
                             const Coordinates& target_coordinates,
                             const bool wants_intervals,
                             const double maximum_distance,
                             const std::size_t threads,
                             const py::object& progress)
{
  const Pairs pairs(elements, coordinates, target_elements, target_coordinates);
  Array<double> result(wants_intervals ? std::vector<py::ssize_t>{pairs.size(), 2}
                                       : std::vector<py::ssize_t>{pairs.size()});
  double* const data = result.mutable_data();
  const auto find =
      wants_intervals ? &AG::Solver_pairs::find_intervals : &AG::Solver_pairs::find_distances;
  run(progress, [&](const AG::Solver_watch& watch) {
    (AG::Solver_pairs(solver).*find)(pairs.sources, pairs.targets, data,
                                     {maximum_distance, false, threads}, watch);
  });
  return result;
}

py::tuple paths(const AG::Solver& solver,
                const Numbers& elements,
                const Coordinates& coordinates,
                const Numbers& target_elements,
                const Coordinates& target_coordinates,
                const bool straighten,
                const double maximum_distance,
                const std::size_t threads,
                const py::object& progress)
{
  const Pairs pairs(elements, coordinates, target_elements, target_coordinates);
  Array<double> lengths(pairs.size());
  double* const data = lengths.mutable_data();
  auto found = run(progress, [&](const AG::Solver_watch& watch) {
    return AG::Solver_pairs(solver).find_paths(pairs.sources, pairs.targets, data,
                                               {maximum_distance, straighten, threads}, watch);
  });
  py::list result;
  for(auto& path : found)
    result.append(moved_points(std::move(path)));
  return py::make_tuple(result, lengths);
}

// Returns a dense matrix if neither `k` nor the maximum distance is given.
py::object matrix(const AG::Solver& solver,
                  const Numbers& elements,
                  const Coordinates& coordinates,
                  const std::optional<std::pair<Numbers, Coordinates>>& targets,
                  const std::optional<double> maximum_distance,
                  const std::optional<std::size_t> k,
                  const bool direction_to_source,
                  const bool symmetric,
                  const std::size_t threads,
                  const py::object& progress)
{
  Matrix_request request{points(elements, coordinates), std::nullopt, {}};
  request.limits.maximum_distance =
      maximum_distance.value_or(std::numeric_limits<double>::infinity());
  request.limits.direction_to_source = direction_to_source;
  request.limits.symmetric = symmetric;
  request.limits.number_of_threads = threads;
  if(targets)
    request.targets = points(targets->first, targets->second);
  if(k)
    return sparse_matrix(solver, std::make_unique<AG::Nearest_rows<double>>(*k), request, progress);
  if(maximum_distance)
    return sparse_matrix(solver, std::make_unique<AG::Radius_rows<double>>(), request, progress);
  return dense_matrix(solver, request, progress);
}

Numbers voronoi(const AG::Solver& solver,
                const Numbers& elements,
                const Coordinates& coordinates,
                const bool direction_to_source,
                const py::object& progress)
{
  const auto sources = points(elements, coordinates);
  Numbers result(static_cast<py::ssize_t>(solver.number_of_faces()));
  std::int64_t* const data = result.mutable_data();
  AG::Solver_search_options options;
  options.direction_to_source = direction_to_source;
  run(progress, [&](const AG::Solver_watch& watch) {
    solver.find_voronoi_partition(sources, data, options, watch);
  });
  return result;
}

py::tuple farthest_points(const AG::Solver& solver,
                          const std::size_t number,
                          const Numbers& sources,
                          const py::object& progress)
{
  const auto seeds = points(sources, std::nullopt);
  std::vector<std::int64_t> result;
  double radius = 0;
  run(progress, [&](const AG::Solver_watch& watch) {
    radius = solver.find_farthest_vertices(number, seeds, result, watch);
  });
  const auto size = static_cast<py::ssize_t>(result.size());
  return py::make_tuple(moved(std::move(result), {size}), radius);
}

Array<double> gradient(const AG::Solver& solver, const Array<double>& values)
{
  Array<double> result({static_cast<py::ssize_t>(solver.number_of_faces()), py::ssize_t(3)});
  const double* const data = values.data();
  double* const vectors = result.mutable_data();
  {
    const Unlocked unlocked;
    solver.find_gradient(data, vectors);
  }
  return result;
}

py::list isolines(const AG::Solver& solver, const Array<double>& values, const double level)
{
  const double* const data = values.data();
  auto lines = [&] {
    const Unlocked unlocked;
    return solver.find_isolines(data, level);
  }();
  py::list result;
  for(auto& line : lines)
    result.append(moved_points(std::move(line)));
  return result;
}

Array<double> vertices(const AG::Solver& solver)
{
  Array<double> result({static_cast<py::ssize_t>(solver.number_of_vertices()), py::ssize_t(3)});
  solver.write_coordinates(result.mutable_data());
  return result;
}

Numbers faces(const AG::Solver& solver)
{
  Numbers result({static_cast<py::ssize_t>(solver.number_of_faces()), py::ssize_t(3)});
  solver.write_corners(result.mutable_data());
  return result;
}

// Returns the model of directional costs, if there are any.
std::optional<int> cost_model(const AG::Solver& solver)
{
  const auto& cost = solver.directional_cost();
  return cost ? std::optional<int>(cost->model) : std::nullopt;
}

// Strips the package name from messages: the traceback shows it.
void translate(const std::exception_ptr error)
{
  try
  {
    std::rethrow_exception(error);
  }
  catch(const std::invalid_argument& e)
  {
    const std::string prefix = "Approximate_geodesics: ", text = e.what();
    const bool has_prefix = text.compare(0, prefix.size(), prefix) == 0;
    PyErr_SetString(PyExc_ValueError, text.substr(has_prefix ? prefix.size() : 0).c_str());
  }
}

} // namespace python

PYBIND11_MODULE(_native, module)
{
  namespace py = pybind11;
  using CGAL::Approximate_geodesics::Solver;

  py::register_local_exception_translator(&python::translate);
  module.def("read_mesh", &python::read_mesh);

  module.attr("version") = APPROXIMATE_GEODESICS_VERSION;

  py::class_<python::Locator>(module, "Locator")
      .def(py::init<const Solver&>(), py::keep_alive<1, 2>())
      .def("locate", &python::Locator::locate);

  python::add_grid(module);

  module.def("distances_from_curve", &python::distances_from_curve);
  module.def("distances_from_region", &python::distances_from_region);
  module.def("offsets_of_curve", &python::offsets_of_curve);

  py::class_<python::Walks>(module, "Walks")
      .def(py::init<const Solver&>(), py::keep_alive<1, 2>())
      .def("trace", &python::Walks::trace)
      .def("logarithmic_map", &python::Walks::logarithmic_map)
      .def("transport", &python::Walks::transport)
      .def("extend_vectors", &python::Walks::extend_vectors)
      .def("mean", &python::Walks::mean)
      .def("shorten_loop", &python::Walks::shorten_loop)
      .def("shorten_curve", &python::Walks::shorten_curve)
      .def("shortest_loop_through", &python::Walks::shortest_loop_through)
      .def("frames", &python::Walks::frames);

  py::class_<Solver> solver(module, "Solver");
  python::add_constructor<std::int32_t>(solver);
  python::add_constructor<std::int64_t>(solver);
  solver.def_static("load", &python::load)
      .def_static("from_bytes", &python::from_bytes)
      .def("save", &python::save)
      .def("to_bytes", &python::to_bytes)
      .def("set_weights", &python::set_weights)
      .def("set_barriers", &python::set_barriers)
      .def("prepare_pairs", &python::prepare_pairs)
      .def("prepare_intervals", &python::prepare_intervals)
      .def("distances", &python::distances)
      .def("path", &python::path)
      .def("pair_distances", &python::pair_distances)
      .def("paths", &python::paths)
      .def("matrix", &python::matrix)
      .def("voronoi", &python::voronoi)
      .def("cells", &python::cells)
      .def("farthest_points", &python::farthest_points)
      .def("gradient", &python::gradient)
      .def("isolines", &python::isolines)
      .def_property_readonly("vertices", &python::vertices)
      .def_property_readonly("faces", &python::faces)
      .def_property_readonly("number_of_vertices", &Solver::number_of_vertices)
      .def_property_readonly("number_of_faces", &Solver::number_of_faces)
      .def_property_readonly("epsilon", &Solver::epsilon)
      .def_property_readonly("error_bound", &Solver::error_bound)
      .def_property_readonly("has_face_weights", &Solver::has_face_weights)
      .def_property_readonly("cost_model", &python::cost_model)
      .def_property_readonly("max_slope", &Solver::max_slope)
      .def_property_readonly("has_barriers", &Solver::has_barriers)
      .def_property_readonly("threads", &Solver::number_of_threads)
      .def_property_readonly("memory", &Solver::memory);
}
