// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sources and targets of a distance matrix.
 */
struct Matrix_points
{
  std::vector<Intrinsic_point> sources; // by row
  std::vector<Intrinsic_point> targets; // by column
  bool are_targets_given;               // otherwise all vertices
};

// `read(points, role)` converts points, and `all()` returns the points at all vertices.
template <typename Read, typename All, typename Sources, typename NamedParameters>
Matrix_points matrix_points(const Read& read,
                            [[maybe_unused]] const All& all,
                            const Sources& sources,
                            const NamedParameters& np)
{
  constexpr bool has_targets = is_given<NamedParameters, internal_np::targets_t>;
  std::vector<Intrinsic_point> rows = read(sources, "source");
  if constexpr(has_targets)
    return {std::move(rows), read(parameters::get_parameter(np, internal_np::targets), "target"),
            has_targets};
  else
    return {std::move(rows), all(), has_targets};
}

// Reads the points of a mesh.

template <typename TriangleMesh, typename Graph, typename Sources, typename NamedParameters>
Matrix_points matrix_points_on_mesh(const TriangleMesh& tmesh,
                                    const Graph& graph,
                                    const Sources& sources,
                                    const NamedParameters& np)
{
  const Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
  const auto read = [&](const auto& points, const char* const role) {
    return intrinsic_points(translation, points, role);
  };
  return matrix_points(
      read, [&] { return read(vertices(tmesh), "target"); }, sources, np);
}

// Reads a point of a graph: a vertex index or an intrinsic point.

template <typename Point>
Intrinsic_point
intrinsic_point(const Intrinsic_triangulation& triangulation, const Point& point, const char* kind)
{
  if constexpr(std::is_integral_v<Point>)
  {
    if constexpr(std::is_signed_v<Point>)
      if(point < 0)
        reject(std::string(kind) + ' ' + std::to_string(point) + " is negative");
    const auto vertex = triangulation.vertex(static_cast<std::size_t>(point));
    if(vertex == Intrinsic_triangulation::null_index)
      reject(std::string(kind) + ' ' + std::to_string(point) +
             " is not the index of a vertex of the mesh");
    return Intrinsic_point::at_vertex(vertex);
  }
  else
    return point;
}

template <typename Points>
std::vector<Intrinsic_point> intrinsic_points(const Intrinsic_triangulation& triangulation,
                                              const Points& points,
                                              const char* const kind)
{
  std::vector<Intrinsic_point> result;
  for(const auto& point : points)
  {
    result.push_back(intrinsic_point(triangulation, point, kind));
    if(!result.back().is_valid(triangulation))
      reject(std::string(kind) + ' ' + std::to_string(result.size() - 1) +
             " is not a point of the triangulated surface");
  }
  return result;
}

inline std::vector<Intrinsic_point> all_vertices(const Intrinsic_triangulation& triangulation)
{
  std::vector<Intrinsic_point> result;
  for(Intrinsic_triangulation::Index v = 0; v < triangulation.number_of_vertices(); ++v)
    result.push_back(Intrinsic_point::at_vertex(v));
  std::sort(result.begin(), result.end(), [&](const auto& p, const auto& q) {
    return triangulation.index(p.vertex) < triangulation.index(q.vertex);
  });
  return result;
}

template <typename Sources, typename NamedParameters>
Matrix_points matrix_points_on_graph(const Intrinsic_triangulation& triangulation,
                                     const Sources& sources,
                                     const NamedParameters& np)
{
  return matrix_points(
      [&](const auto& points, const char* const role) {
        return intrinsic_points(triangulation, points, role);
      },
      [&] { return all_vertices(triangulation); }, sources, np);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_POINTS_H
