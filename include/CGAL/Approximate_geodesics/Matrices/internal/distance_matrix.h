// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_DISTANCE_MATRIX_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_DISTANCE_MATRIX_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_visitor_base.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_columns.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_computation.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Row_search.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/identity_of_matrix.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/matrix_points.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

inline bool are_the_same(const std::vector<Intrinsic_point>& a,
                         const std::vector<Intrinsic_point>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Intrinsic_point& p, const Intrinsic_point& q) {
                      return p.vertex == q.vertex && p.halfedge == q.halfedge && p.t == q.t &&
                             p.s == q.s;
                    });
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
  const double result = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_distance),
                                   std::numeric_limits<double>::infinity()));
  if(!(result >= 0))
    reject("maximum_distance is " + text_of(result) + "; it must not be negative");
  return result;
}

template <typename Graph>
using Is_parallel = decltype(std::declval<const Graph&>().is_parallel());

// Parallelizes over rows, unless the search of a single row is parallel.
template <typename NamedParameters, typename Graph>
Loop loop_over_rows([[maybe_unused]] const Graph& graph, const NamedParameters& /* np */)
{
  if constexpr(boost::is_detected_v<Is_parallel, Graph>)
    if(graph.is_parallel())
      return Loop();
  return Loop::with_tag<Concurrency_tag<NamedParameters>>();
}

template <typename NamedParameters>
auto matrix_visitor([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    return parameters::get_parameter(np, internal_np::visitor);
  else
    return Distance_matrix_visitor_base();
}

template <typename Visitor>
Visitor& unwrapped(Visitor& visitor)
{
  return visitor;
}

template <typename Visitor>
Visitor& unwrapped(std::reference_wrapper<Visitor>& visitor)
{
  return visitor.get();
}

template <typename Rows, typename NamedParameters>
bool wants_symmetry(const Matrix_points& points, const NamedParameters& np)
{
  static_assert(!is_given<NamedParameters, internal_np::symmetric_t> || can_be_symmetric<Rows>,
                "symmetric: only supported by sinks that keep all rows and columns: "
                "Dense_rows, Radius_rows, Npy_file");
  const bool result =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::symmetric), false);
  if(result && !are_the_same(points.sources, points.targets))
    reject("symmetric: targets are not the same points as sources, in the same order");
  return result;
}

// Returns whether the matrix was completed.
template <typename Graph, typename Rows, typename NamedParameters>
bool compute_distance_matrix(const Graph& graph,
                             Rows& rows,
                             const Matrix_points& points,
                             const NamedParameters& np)
{
  const bool is_symmetric = wants_symmetry<Rows>(points, np);
  if(is_symmetric && is_directed<Graph>)
    reject("symmetric: costs depend on the direction, so distances cannot be symmetric");
  Row_limits limits{checked_maximum_distance(np), number_of_nearest(rows), {}};
  const Matrix_columns<Graph> columns(graph, points.targets);
  if(points.are_targets_given && columns.are_vertices() &&
     columns.size() < graph.triangulation().number_of_vertices())
    limits.targets = points.targets; // all vertices as targets would stop no search
  const Distance_matrix_plan plan(
      order_of_rows(graph.triangulation(), points.sources), columns.size(), limits.maximum_distance,
      limits.number_of_nearest, [&] { return identity_of_matrix(graph, points, columns, limits); },
      is_symmetric);

  auto visitor = matrix_visitor(np);
  if constexpr(is_row_sink<Rows>)
    rows.start(plan);
  Matrix_computation<Graph, Rows, std::remove_reference_t<decltype(unwrapped(visitor))>>
      computation(graph, points.sources, columns, limits, plan, rows, unwrapped(visitor));
  const bool is_done = computation.run(loop_over_rows(graph, np));
  if constexpr(is_row_sink<Rows>)
    return rows.finish(is_done);
  else
    return is_done;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_DISTANCE_MATRIX_H
