// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_HEAT_SEARCH_H
#define BENCHMARK_HEAT_SEARCH_H

#include "meshes/Mesh.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

// The heat method of CGAL, with the defaults of its free function. The constructor factorizes two
// matrices, which are shared by all sources.
class Heat_search
{
public:
  explicit Heat_search(Mesh& mesh)
    : m_distances(mesh.add_property_map<Vertex, double>("v:heat").first), m_method(mesh)
  {
  }

  void run(const Vertex source)
  {
    m_method.clear_sources();
    m_method.add_source(source);
    m_method.estimate_geodesic_distances(m_distances);
  }

  double distance(const Vertex v) const { return m_distances[v]; }

private:
  using Mode = CGAL::Heat_method_3::Intrinsic_Delaunay;

  Mesh::Property_map<Vertex, double> m_distances;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> m_method;
};

#endif // BENCHMARK_HEAT_SEARCH_H
