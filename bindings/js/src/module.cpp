// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The WebAssembly module: a direct binding of `Solver`. The JavaScript package, its only caller,
// converts and validates arguments. An array is a pair of a pointer, which is null if there is
// none, and a size; results are given to JavaScript before a function returns.

// Searches and graphs are compiled for speed.
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>
#include <CGAL/Geodesic_costs/Directional_points.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// All that follows takes little time, and is compiled for size.
#pragma clang attribute push(__attribute__((minsize)), apply_to = function)

#include "calls.h"

// That of CGAL prints by a stream, whose locales would be a tenth of the module. It is
// called by the AABB tree and by intersections only, in cases that do not occur.
#include <CGAL/assertions.h>
#undef CGAL_error
#define CGAL_error() std::abort()

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_locator.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>

namespace javascript {

// A solver, and its locator when it is wanted.
struct Handle
{
  template <typename... Arguments>
  explicit Handle(Arguments&&... arguments) : solver(std::forward<Arguments>(arguments)...)
  {
  }

  const AG::Solver solver;
  std::optional<AG::Solver_locator> locator = std::nullopt;
};

template <typename Rows>
void give_sparse_matrix(const Rows& rows)
{
  std::vector<double> distances;
  std::vector<std::int32_t> columns, starts{0};
  distances.reserve(rows.number_of_entries());
  columns.reserve(rows.number_of_entries());
  for(std::size_t row = 0; row < rows.number_of_rows(); ++row)
  {
    const auto of_row = rows.distances(row);
    const auto columns_of_row = rows.columns(row);
    distances.insert(distances.end(), of_row.begin(), of_row.end());
    columns.insert(columns.end(), columns_of_row.begin(), columns_of_row.end());
    starts.push_back(static_cast<std::int32_t>(distances.size()));
  }
  give(distances);
  give(columns);
  give(starts);
}

} // namespace javascript

using namespace javascript;

// Memory of arguments

JS_EXPORT(allocate) void* js_allocate(const std::size_t size) { return std::malloc(size); }

JS_EXPORT(release) void js_release(void* const memory) { std::free(memory); }

// Solvers

JS_EXPORT(version) void js_version()
{
  call([] { give(std::string(APPROXIMATE_GEODESICS_VERSION)); });
}

JS_EXPORT(make_solver)
Handle* js_make_solver(const double* const vertices,
                       const std::size_t size_of_vertices,
                       const void* const faces,
                       const std::size_t size_of_faces,
                       const bool has_unsigned_faces,
                       const bool has_epsilon,
                       const double epsilon,
                       const double* const face_weights,
                       std::size_t,
                       const std::int32_t* const barriers,
                       const std::size_t size_of_barriers,
                       const int cost_model,
                       const double* const parameters,
                       const std::size_t number_of_parameters,
                       const double* const cost_of_faces,
                       const std::size_t size_of_cost,
                       const bool accept_weaker_bound,
                       const std::size_t maximum_number_of_points,
                       const bool has_progress)
{
  return call([&] {
    AG::Solver_options options;
    if(has_epsilon)
      options.epsilon = epsilon;
    options.face_weights = face_weights;
    const std::vector<std::int64_t> ends(barriers, barriers + size_of_barriers);
    options.barriers = ends.data();
    options.number_of_barriers = ends.size() / 2;
    if(cost_model >= 0)
      options.directional_cost = {static_cast<AG::Solver_cost::Model>(cost_model),
                                  {parameters, parameters + number_of_parameters},
                                  {cost_of_faces, cost_of_faces + size_of_cost}};
    options.accept_weaker_bound = accept_weaker_bound;
    options.maximum_number_of_points = maximum_number_of_points;
    const auto make = [&](const auto* const corners) {
      return std::make_unique<Handle>(vertices, size_of_vertices / 3, corners, size_of_faces / 3,
                                      options, watch(has_progress));
    };
    return (has_unsigned_faces ? make(static_cast<const std::uint32_t*>(faces))
                               : make(static_cast<const std::int32_t*>(faces)))
        .release();
  });
}

JS_EXPORT(solver_of_bytes) Handle* js_solver_of_bytes(const char* bytes, std::size_t size)
{
  return call([&] {
    auto result = std::make_unique<Handle>([&](char* const part, const std::size_t number) {
      if(number > size)
        return false;
      std::copy_n(bytes, number, part);
      bytes += number;
      size -= number;
      return true;
    });
    if(size > 0)
      throw std::invalid_argument("there are extra bytes after the solver");
    return result.release();
  });
}

JS_EXPORT(bytes) void js_bytes(const Handle& handle)
{
  call([&] {
    std::string bytes;
    handle.solver.save([&](const char* const part, const std::size_t size) {
      bytes.append(part, size);
      return true;
    });
    give(bytes);
  });
}

JS_EXPORT(destroy) void js_destroy(Handle* const handle) { delete handle; }

// Properties

JS_EXPORT(properties) void js_properties(const Handle& handle)
{
  call([&] {
    const AG::Solver& solver = handle.solver;
    const auto epsilon = solver.epsilon();
    give(std::vector<double>{static_cast<double>(solver.number_of_vertices()),
                             static_cast<double>(solver.number_of_faces()),
                             static_cast<double>(epsilon.has_value()), epsilon.value_or(0),
                             solver.error_bound(), static_cast<double>(solver.memory())});
  });
}

JS_EXPORT(mesh) void js_mesh(const Handle& handle)
{
  call([&] {
    std::vector<double> vertices(3 * handle.solver.number_of_vertices());
    std::vector<std::int64_t> faces(3 * handle.solver.number_of_faces());
    handle.solver.write_coordinates(vertices.data());
    handle.solver.write_corners(faces.data());
    give(vertices);
    give(faces);
  });
}

// Queries

JS_EXPORT(distances)
void js_distances(const Handle& handle,
                  const double* const sources,
                  const std::size_t size_of_sources,
                  const double maximum_distance,
                  const bool direction_to_source,
                  const bool wants_nearest,
                  const bool wants_predecessors,
                  const bool has_progress)
{
  call([&] {
    const std::size_t size = handle.solver.number_of_vertices();
    std::vector<double> distances(size);
    std::vector<std::int64_t> nearest(wants_nearest ? size : 0);
    std::vector<std::int64_t> predecessors(wants_predecessors ? size : 0);
    handle.solver.find_distances(points(sources, size_of_sources), distances.data(),
                                 wants_nearest ? nearest.data() : nullptr,
                                 wants_predecessors ? predecessors.data() : nullptr,
                                 {maximum_distance, direction_to_source}, watch(has_progress));
    give(distances);
    if(wants_nearest)
      give(nearest);
    if(wants_predecessors)
      give(predecessors);
  });
}

JS_EXPORT(path)
double js_path(const Handle& handle,
               const double* const source,
               const std::size_t size_of_source,
               const double* const target,
               const std::size_t size_of_target,
               const bool straighten,
               const bool has_progress)
{
  return call([&] {
    std::vector<double> coordinates;
    const double length = handle.solver.find_path(points(source, size_of_source).at(0),
                                                  points(target, size_of_target).at(0), straighten,
                                                  coordinates, watch(has_progress));
    give(coordinates);
    return length;
  });
}

// Gives a dense matrix, or the distances, the columns and the row pointers of a sparse one.
JS_EXPORT(matrix)
void js_matrix(const Handle& handle,
               const double* const sources,
               const std::size_t size_of_sources,
               const double* const targets,
               const std::size_t size_of_targets,
               const bool is_sparse,
               const double maximum_distance,
               const std::size_t number_nearest,
               const bool direction_to_source,
               const bool symmetric,
               const bool has_progress)
{
  call([&] {
    const AG::Solver& solver = handle.solver;
    const auto rows = points(sources, size_of_sources);
    const auto columns = points(targets, size_of_targets);
    AG::Solver_row_options options;
    options.targets = targets != nullptr ? &columns : nullptr;
    options.maximum_distance = maximum_distance;
    options.direction_to_source = direction_to_source;
    options.symmetric = symmetric;
    const auto give_sparse = [&](auto result) {
      solver.compute_matrix(result, rows, options, watch(has_progress));
      give_sparse_matrix(result);
    };
    if(number_nearest > 0)
      return give_sparse(AG::Nearest_rows<double>(number_nearest));
    if(is_sparse)
      return give_sparse(AG::Radius_rows<double>());
    const std::size_t width = targets != nullptr ? columns.size() : solver.number_of_vertices();
    if(width > 0 && rows.size() > std::numeric_limits<std::size_t>::max() / width)
      throw std::bad_alloc();
    std::vector<double> distances(rows.size() * width);
    solver.compute_matrix(distances.data(), rows, options, watch(has_progress));
    give(distances);
  });
}

JS_EXPORT(voronoi)
void js_voronoi(const Handle& handle,
                const double* const sources,
                const std::size_t size_of_sources,
                const bool direction_to_source,
                const bool has_progress)
{
  call([&] {
    std::vector<std::int64_t> result(handle.solver.number_of_faces());
    AG::Solver_search_options options;
    options.direction_to_source = direction_to_source;
    handle.solver.find_voronoi_partition(points(sources, size_of_sources), result.data(), options,
                                         watch(has_progress));
    give(result);
  });
}

JS_EXPORT(farthest_points)
double js_farthest_points(const Handle& handle,
                          const std::size_t number,
                          const double* const sources,
                          const std::size_t size_of_sources,
                          const bool has_progress)
{
  return call([&] {
    std::vector<std::int64_t> result;
    const double radius = handle.solver.find_farthest_vertices(
        number, points(sources, size_of_sources), result, watch(has_progress));
    give(result);
    return radius;
  });
}

JS_EXPORT(gradient)
void js_gradient(const Handle& handle, const double* const values, std::size_t)
{
  call([&] {
    std::vector<double> result(3 * handle.solver.number_of_faces());
    handle.solver.find_gradient(values, result.data());
    give(result);
  });
}

JS_EXPORT(isolines)
void js_isolines(const Handle& handle, const double* const values, std::size_t, const double level)
{
  call([&] {
    for(const auto& line : handle.solver.find_isolines(values, level))
      give(line);
  });
}

// Gives faces, and four numbers per point: barycentric coordinates, and the distance.
JS_EXPORT(locate)
void js_locate(Handle& handle, const double* const places, const std::size_t size)
{
  call([&] {
    if(!handle.locator)
      handle.locator.emplace(handle.solver);
    std::vector<AG::Solver_locator::Location> locations;
    handle.locator->locate(places, size / 3, std::back_inserter(locations));
    std::vector<std::int64_t> faces;
    std::vector<double> numbers;
    for(const auto& location : locations)
    {
      faces.push_back(location.face);
      numbers.insert(numbers.end(), location.coordinates.begin(), location.coordinates.end());
      numbers.push_back(location.distance);
    }
    give(faces);
    give(numbers);
  });
}

#pragma clang attribute pop
