// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H

#include "meshes/surface_points.h"
#include "oracles/exact_distances.h"

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

namespace geodesics_test {

// A place in a face for a point that is not an isolated vertex.
inline Face_location location_in_face(const Mesh& mesh, const Surface_point& p)
{
  if(const auto* v = std::get_if<Vertex>(&p))
    return Exact_shortest_paths::face_location(*v, mesh);
  if(const auto* e = std::get_if<Edge_location>(&p)) // the exact class cannot do so at the border
    return mesh.is_border(e->first)
               ? Exact_shortest_paths::face_location(mesh.opposite(e->first), 1 - e->second, mesh)
               : Exact_shortest_paths::face_location(e->first, e->second, mesh);
  return std::get<Face_location>(p);
}

// The same, a bit inside. The exact class takes some points on edges for the ones at the same
// distance from the edge's other end.
inline Face_location location_inside_face(const Mesh& mesh, const Surface_point& p)
{
  constexpr double step = 1e-9;
  Face_location result = location_in_face(mesh, p);
  for(double& weight : result.second)
    weight = (weight + step) / (1 + 3 * step);
  return result;
}

// The distances from one point to others along the surface, by CGAL's exact class.
inline std::vector<double> exact_distances(const Mesh& mesh,
                                           const Surface_point& source,
                                           const std::vector<Surface_point>& targets)
{
  Exact_shortest_paths paths(mesh);
  if(const auto* v = std::get_if<Vertex>(&source))
    paths.add_source_point(*v);
  else
    paths.add_source_point(location_inside_face(mesh, source));
  std::vector<double> result;
  for(const Surface_point& target : targets)
  {
    const auto* v = std::get_if<Vertex>(&target);
    const Face_location location = location_inside_face(mesh, target);
    const double d =
        v != nullptr
            ? paths.shortest_distance_to_source_points(*v).first
            : paths.shortest_distance_to_source_points(location.first, location.second).first;
    result.push_back(d < 0 ? infinity : d);
  }
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H
