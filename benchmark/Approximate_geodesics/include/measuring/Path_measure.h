// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PATH_MEASURE_H
#define BENCHMARK_PATH_MEASURE_H

#include "meshes/Mesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Measures the lengths of paths on a mesh, independent of the algorithm that has found them. The
// mesh is referred to, not copied.
class Path_measure
{
public:
  using Point = Kernel::Point_3;

  explicit Path_measure(const Mesh& mesh) : m_mesh(mesh) {}

  // Infinite if the path leaves the mesh.
  double length(const std::vector<Point>& points)
  {
    if(m_tree.empty())
      m_tree.insert(faces(m_mesh).first, faces(m_mesh).second, m_mesh);
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      if(!is_on_mesh(points[i]) || !is_on_mesh(CGAL::midpoint(points[i - 1], points[i])))
        return std::numeric_limits<double>::infinity();
      result += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
    }
    return result;
  }

private:
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

  bool is_on_mesh(const Point& point) const
  {
    const CGAL::Bbox_3 box = m_tree.bbox();
    const double size = box.xmax() - box.xmin() + box.ymax() - box.ymin() + box.zmax() - box.zmin();
    return std::sqrt(m_tree.squared_distance(point)) <= 1e-12 * size;
  }

  const Mesh& m_mesh;
  Tree m_tree; // of the faces, built on demand
};

#endif // BENCHMARK_PATH_MEASURE_H
