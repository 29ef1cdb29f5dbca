// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_TERRAIN_WEIGHTS_H
#define BENCHMARK_TERRAIN_WEIGHTS_H

#include "meshes/Mesh.h"

#include <cmath>
#include <limits>

using Face_weights = Mesh::Property_map<Mesh::Face_index, double>;

// Weights by slope, the tangent of the angle between the face and the horizontal plane.
inline double weight_of_slope(const Mesh& mesh, const Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  const Kernel::Vector_3 normal =
      CGAL::normal(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                   mesh.point(mesh.target(mesh.next(h))));
  const double slope = std::hypot(normal.x(), normal.y()) / std::abs(normal.z());
  return slope < 0.1 ? 1 : slope < 0.2 ? 1.5 : slope < 0.3 ? 2.5 : 4;
}

// The cost per unit of length on a terrain: it depends on the slope, except for a cheap road across
// the terrain and an impassable lake.
inline Face_weights terrain_weights(Mesh& mesh, const double side)
{
  constexpr double road = 0.5, width_of_road = 4;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Face_weights result = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 1).first;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Kernel::Point_3 p = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                             mesh.point(mesh.target(mesh.next(h))));
    const double x = p.x() / side, y = p.y() / side;
    const double from_road = std::abs(y - 0.35 - 0.1 * std::sin(7 * x)) * side;
    if(std::hypot(x - 0.6, y - 0.7) < 0.15)
      result[f] = infinity;
    else
      result[f] = from_road < width_of_road / 2 ? road : weight_of_slope(mesh, f);
  }
  return result;
}

#endif // BENCHMARK_TERRAIN_WEIGHTS_H
