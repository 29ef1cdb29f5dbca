// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_EXACT_SEARCH_H
#define BENCHMARK_EXACT_SEARCH_H

#include "meshes/Mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// Exact distances by CGAL's class, which takes seconds instead of milliseconds. Precondition: the
// mesh has no isolated vertices, which the class does not support.
class Exact_search
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Exact_kernel, Mesh>;
  using Mesh_points = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
  using Points = CGAL::Cartesian_converter_property_map<Exact_kernel::Point_3, Mesh_points>;
  using Paths =
      CGAL::Surface_mesh_shortest_path<Traits, CGAL::Default, CGAL::Default, CGAL::Default, Points>;

public:
  explicit Exact_search(const Mesh& mesh)
    : m_paths(mesh,
              get(boost::vertex_index, mesh),
              get(boost::halfedge_index, mesh),
              get(boost::face_index, mesh),
              Points(get(CGAL::vertex_point, mesh)))
  {
  }

  void run(const Vertex source)
  {
    m_paths.remove_all_source_points();
    m_paths.add_source_point(source);
    m_paths.build_sequence_tree();
  }

  // The class may fail on degenerate meshes.
  double distance(const Vertex v)
  {
    const double result = m_paths.shortest_distance_to_source_points(v).first;
    if(!(result >= 0))
      throw std::runtime_error("the exact class does not reach vertex " + std::to_string(v.idx()));
    return result;
  }

  std::vector<Kernel::Point_3> path(const Vertex v)
  {
    std::vector<Exact_kernel::Point_3> points;
    m_paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
    std::vector<Kernel::Point_3> result;
    for(const auto& p : points)
      result.emplace_back(p.x(), p.y(), p.z());
    return result;
  }

private:
  Paths m_paths;
};

#endif // BENCHMARK_EXACT_SEARCH_H
