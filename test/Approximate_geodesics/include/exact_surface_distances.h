// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H

#include "exact_distances.h"
#include "surface_points.h"

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

// The distances from one point to others along the surface, by CGAL's exact class. Sources on edges
// are moved inside a face, as that class takes them for the point at the same distance from the
// edge's other end.
inline std::vector<double> exact_distances(const Mesh& mesh,
                                           const Surface_point& source,
                                           const std::vector<Surface_point>& targets)
{
  Exact_shortest_paths paths(mesh);
  if(const auto* v = std::get_if<Vertex>(&source))
    paths.add_source_point(*v);
  else
  {
    constexpr double step = 1e-9;
    Face_location location = location_in_face(mesh, source);
    for(double& weight : location.second)
      weight = (weight + step) / (1 + 3 * step);
    paths.add_source_point(location);
  }
  std::vector<double> result;
  for(const Surface_point& target : targets)
  {
    const Face_location location = location_in_face(mesh, target);
    const double d =
        paths.shortest_distance_to_source_points(location.first, location.second).first;
    result.push_back(d < 0 ? infinity : d);
  }
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXACT_SURFACE_DISTANCES_H
