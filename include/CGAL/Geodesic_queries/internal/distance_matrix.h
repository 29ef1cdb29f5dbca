// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_DISTANCE_MATRIX_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Geodesic_queries/internal/Matrix_computation.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Reads points of a graph: vertex indices or intrinsic points. Those of a mesh are read by the
// function of the same name in `Mesh_translation.h`.
template <typename Points>
std::vector<Intrinsic_point> intrinsic_points(const Intrinsic_triangulation& triangulation,
                                              const Points& points,
                                              const char* const role)
{
  std::vector<Intrinsic_point> result;
  for(const auto& point : points)
  {
    using Point = std::decay_t<decltype(point)>;
    if constexpr(std::is_integral_v<Point>)
    {
      const auto name = [&] { return std::string(role) + ' ' + std::to_string(point); };
      if constexpr(std::is_signed_v<Point>)
        if(point < 0)
          reject(name() + " is negative");
      const auto vertex = triangulation.vertex(static_cast<std::size_t>(point));
      if(vertex == Intrinsic_triangulation::null_index)
        reject(name() + " is not the index of a vertex of the mesh");
      result.push_back(Intrinsic_point::at_vertex(vertex));
    }
    else
      result.push_back(point);
    if(!result.back().is_valid(triangulation))
      reject(std::string(role) + ' ' + std::to_string(result.size() - 1) +
             " is not a point of the triangulated surface");
  }
  return result;
}

inline std::vector<Intrinsic_point> all_vertices(const Intrinsic_triangulation& triangulation)
{
  std::vector<Intrinsic_point> result;
  for(std::size_t i = 0; result.size() < triangulation.number_of_vertices(); ++i)
    if(const auto v = triangulation.vertex(i); v != Intrinsic_triangulation::null_index)
      result.push_back(Intrinsic_point::at_vertex(v));
    else
      CGAL_assertion(i < Intrinsic_triangulation::null_index); // every vertex has an index
  return result;
}

// Reads the sources of the rows, and the targets of the columns: `all()` returns the points at all
// vertices. `surface` is the triangulation, or its translation to the mesh.
template <typename Surface, typename Sources, typename All, typename NamedParameters>
Matrix_points matrix_points(const Surface& surface,
                            const Sources& sources,
                            [[maybe_unused]] const All& all,
                            const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::targets_t>)
    return {
        intrinsic_points(surface, sources, "source"),
        intrinsic_points(surface, parameters::get_parameter(np, internal_np::targets), "target"),
        true};
  else
    return {intrinsic_points(surface, sources, "source"), all(), false};
}

// Orders rows by the indices of their sources, so that nearby sources are consecutive.
inline std::vector<std::size_t> order_of_rows(const Intrinsic_triangulation& triangulation,
                                              const std::vector<Intrinsic_point>& sources)
{
  std::vector<std::size_t> result(sources.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  const auto place = [&](const std::size_t row) {
    const Intrinsic_point& p = sources[row];
    return p.is_vertex() ? p.vertex : triangulation.source(p.halfedge);
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const std::size_t a, const std::size_t b) { return place(a) < place(b); });
  return result;
}

template <typename NamedParameters>
double checked_maximum_distance(const NamedParameters& np)
{
  const double result = maximum_distance(np);
  if(!(result >= 0))
    reject("maximum_distance is " + text_of(result) + "; it must not be negative");
  return result;
}

template <typename Rows, typename Graph, typename NamedParameters>
bool wants_symmetry(const Graph& graph, const Matrix_points& points, const NamedParameters& np)
{
  static_assert(!is_given<NamedParameters, internal_np::symmetric_t> || can_be_symmetric<Rows>,
                "symmetric: only supported by sinks that keep all rows and columns: "
                "Dense_rows, Radius_rows, Npy_file");
  const auto &rows = points.sources, &columns = points.targets;
  const bool result =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::symmetric), false);
  const auto is_same = [&](const Intrinsic_point& p, const Intrinsic_point& q) {
    return p.is_same(q, graph.triangulation());
  };
  if(result && !std::equal(rows.begin(), rows.end(), columns.begin(), columns.end(), is_same))
    reject("symmetric: targets are not the same points as sources, in the same order");
  if(result && is_directed<Graph>)
    reject("symmetric: costs depend on the direction, so distances cannot be symmetric");
  return result;
}

// Returns the accessible properties of a graph; the first row depends on the others.
template <typename Graph>
std::vector<double> facts_of_graph(const Graph& graph)
{
  const Arc_lengths lengths = graph.arc_lengths();
  std::vector<double> result{static_cast<double>(graph.number_of_nodes()),
                             graph.unit(),
                             lengths.shortest,
                             lengths.mean,
                             lengths.longest,
                             static_cast<double>(leads_to_sources(graph))};
  if constexpr(has_epsilon<Graph>)
    result.push_back(graph.epsilon());
  return result;
}

template <typename Graph>
Matrix_facts facts_of_matrix(const Matrix_input<Graph>& input)
{
  const auto& [graph, points, columns, limits] = input;
  Matrix_facts result{graph.triangulation(), facts_of_graph(graph),   points.sources,
                      points.targets,        limits.maximum_distance, limits.number_of_nearest,
                      Distance_row()};
  if(!points.sources.empty())
    result.first_row = Row_search<Graph>(input).find(0);
  return result;
}

// Computes rows as the named parameters say. Returns false if their visitor stopped the
// computation.
template <typename Search, typename Rows, typename NamedParameters>
bool compute_rows(const typename Search::Input& input,
                  const Distance_matrix_plan& plan,
                  Rows& rows,
                  const NamedParameters& np)
{
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              Distance_matrix_visitor_base());
  auto& unwrapped = std::ref(visitor).get(); // of a `std::reference_wrapper`
  using Visitor = std::remove_reference_t<decltype(unwrapped)>;
  Loop loop = Loop::with_tag<Concurrency_tag<NamedParameters>>().for_size(
      plan.number_of_rows() * input.graph.number_of_nodes());
  if constexpr(is_valid<decltype(input.graph)>([](auto& g) -> decltype(g.is_parallel()) {}))
    if(input.graph.is_parallel()) // the search of a single row is parallel
      loop = Loop();
  return Matrix_computation<Search, Rows, Visitor>(input, plan, rows, unwrapped).run(loop);
}

// Returns whether the matrix was completed.
template <typename Graph, typename Rows, typename NamedParameters>
bool compute_distance_matrix(const Graph& graph,
                             Rows& rows,
                             const Matrix_points& points,
                             const NamedParameters& np)
{
  const bool is_symmetric = wants_symmetry<Rows>(graph, points, np);
  Row_limits limits{checked_maximum_distance(np), number_of_nearest(rows), {}};
  const Matrix_columns<Graph> columns(graph, points.targets);
  if(points.are_targets_given && columns.are_vertices() &&
     columns.size() < graph.triangulation().number_of_vertices())
    limits.targets = points.targets; // all vertices as targets would stop no search
  const Matrix_input<Graph> input{graph, points, columns, limits};
  const Distance_matrix_plan plan(
      order_of_rows(graph.triangulation(), points.sources), columns.size(), limits.maximum_distance,
      limits.number_of_nearest, [&] { return facts_of_matrix(input); }, is_symmetric);

  if constexpr(is_row_sink<Rows>)
    rows.start(plan);
  const bool is_done = compute_rows<Row_search<Graph>>(input, plan, rows, np);
  if constexpr(is_row_sink<Rows>)
    return rows.finish(is_done);
  else
    return is_done;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_DISTANCE_MATRIX_H
