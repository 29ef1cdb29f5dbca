// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_costs.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_mesh.h>
#include <CGAL/Approximate_geodesics/Solver/internal/make_solver_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The file format of a solver: its arrays and parameters.
 */
struct Solver_file
{
  std::vector<double> coordinates;
  std::vector<std::uint32_t> corners;
  std::optional<double> epsilon;
  std::optional<std::vector<double>> weights;
  std::optional<std::vector<std::int64_t>> barriers;
  std::optional<Solver_cost> cost;
  double max_slope = std::numeric_limits<double>::infinity();
  bool accepts_weaker_bound = false;
  std::uint64_t maximum_number_of_points = 0;

  static constexpr std::uint64_t SIGNATURE = 0x0a1a0d56534c4741; // AGLSV, and line ends
  static constexpr std::uint32_t VERSION = 3;
  static constexpr std::uint32_t VERSION_WITHOUT_MAX_SLOPE = 2;
  static constexpr const char* CONTENTS = "the solver"; // used in messages

  Solver_file() = default;

  Solver_file(const Array_mesh& mesh, const Array_costs& costs, const Bound_of_graph& bound)
    : epsilon(bound.epsilon),
      cost(costs.directional_cost()),
      max_slope(costs.max_slope()),
      accepts_weaker_bound(bound.accepts_weaker),
      maximum_number_of_points(bound.maximum_number_of_points)
  {
    for(const auto v : vertices(mesh))
      for(int i = 0; i < 3; ++i)
        coordinates.push_back(mesh.point(v)[i]);
    for(const auto f : faces(mesh))
      for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        corners.push_back(source(h, mesh));
    if(costs.has_weights())
    {
      weights.emplace();
      for(const auto f : faces(mesh))
        weights->push_back(costs.weight(f));
    }
    if(costs.has_barriers()) // perhaps all of them have been removed since the graph was built
    {
      barriers.emplace();
      for(const auto e : edges(mesh))
        if(costs.is_barrier(e))
          for(const auto v : {target(e, mesh), source(e, mesh)})
            barriers->push_back(v);
    }
  }

  void write(const Put_bytes& put) const
  {
    Binary_writer writer(put, CONTENTS);
    writer.write(SIGNATURE);
    writer.write(VERSION);
    write(writer, coordinates);
    write(writer, corners);
    writer.write(static_cast<std::uint8_t>(epsilon.has_value()));
    writer.write(epsilon.value_or(0));
    write(writer, weights);
    write(writer, barriers);
    writer.write(static_cast<std::uint8_t>(accepts_weaker_bound));
    writer.write(maximum_number_of_points);
    write(writer, cost);
    writer.write(max_slope);
    writer.finish();
  }

  void read(const Get_bytes& get)
  {
    Binary_reader reader(get, CONTENTS);
    if(reader.read<std::uint64_t>() != SIGNATURE)
      reject("the file does not contain a solver");
    const auto version = reader.read<std::uint32_t>();
    if(version != VERSION && version != VERSION_WITHOUT_MAX_SLOPE)
      reject("the file of the solver has version " + std::to_string(version) +
             "; this program reads versions " + std::to_string(VERSION_WITHOUT_MAX_SLOPE) +
             " and " + std::to_string(VERSION));
    read(reader, coordinates);
    read(reader, corners);
    const bool has_epsilon = reader.read<std::uint8_t>() != 0;
    const auto bound = reader.read<double>();
    if(has_epsilon)
      epsilon = bound;
    read(reader, weights);
    read(reader, barriers);
    accepts_weaker_bound = reader.read<std::uint8_t>() != 0;
    maximum_number_of_points = reader.read<std::uint64_t>();
    read(reader, cost);
    if(version == VERSION)
      max_slope = reader.read<double>();
    reader.finish();
  }

private:
  template <typename T>
  static void write(Binary_writer& writer, const std::vector<T>& values)
  {
    writer.write(static_cast<std::uint64_t>(values.size()));
    for(const T value : values)
      writer.write(value);
  }

  template <typename T>
  static void write(Binary_writer& writer, const std::optional<std::vector<T>>& values)
  {
    writer.write(static_cast<std::uint8_t>(values.has_value()));
    if(values)
      write(writer, *values);
  }

  static void write(Binary_writer& writer, const std::optional<Solver_cost>& cost)
  {
    writer.write(static_cast<std::uint8_t>(cost.has_value()));
    if(!cost)
      return;
    writer.write(static_cast<std::uint8_t>(cost->model));
    write(writer, cost->parameters);
    write(writer, cost->of_faces);
  }

  static void read(Binary_reader& reader, std::optional<Solver_cost>& cost)
  {
    if(reader.read<std::uint8_t>() == 0)
      return;
    cost.emplace().model = static_cast<Solver_cost::Model>(reader.read<std::uint8_t>());
    read(reader, cost->parameters);
    read(reader, cost->of_faces);
  }

  // Does not reserve memory: a damaged size must not exhaust it.
  template <typename T>
  static void read(Binary_reader& reader, std::vector<T>& values)
  {
    for(auto left = reader.read<std::uint64_t>(); left > 0; --left)
      values.push_back(reader.read<T>());
  }

  template <typename T>
  static void read(Binary_reader& reader, std::optional<std::vector<T>>& values)
  {
    if(reader.read<std::uint8_t>() != 0)
      read(reader, values.emplace());
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_FILE_H
