// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_DENSE_REFERENCE_H
#define BENCHMARK_DENSE_REFERENCE_H

#include "meshes/Mesh.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Reference costs from dense graphs, because exact costs on weighted faces are not available. Paths
// of all graphs are paths on the mesh, so the minimum of their costs is used.
class Dense_reference
{
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;

public:
  static constexpr std::size_t NUMBER_OF_POINTS = 64;
  static constexpr double EPSILON = 0.005;

  Dense_reference(const Mesh& mesh, const Triangulation& triangulation, std::vector<Vertex> sources)
    : m_mesh(mesh),
      m_sources(std::move(sources)),
      m_costs(m_sources.size() * mesh.number_of_vertices(), std::numeric_limits<double>::infinity())
  {
    namespace AG = CGAL::Approximate_geodesics;
    lower_costs(AG::Steiner_graph<AG::Fixed_number_of_points>(
        triangulation, AG::Fixed_number_of_points(NUMBER_OF_POINTS)));
    lower_costs(AG::Steiner_graph<>(triangulation, AG::Geometric_points(EPSILON)));
  }

  static std::string description()
  {
    return "the cheaper of " + std::to_string(NUMBER_OF_POINTS) +
           " equally spaced points and geometric ones for " + Table::text_of(EPSILON, 3);
  }

  const Mesh& mesh() const { return m_mesh; }
  const std::vector<Vertex>& sources() const { return m_sources; }

  double distance(const std::size_t source, const Vertex v) const
  {
    return m_costs[source * m_mesh.number_of_vertices() + v.idx()];
  }

private:
  template <typename Graph>
  void lower_costs(const Graph& graph)
  {
    CGAL::Approximate_geodesics::Propagation<Graph> search(graph);
    auto cost = m_costs.begin();
    for(const Vertex source : m_sources)
    {
      search.run_from(graph.triangulation().vertex(source.idx()));
      for(const Vertex v : m_mesh.vertices())
      {
        *cost = (std::min)(*cost, search.distance(graph.triangulation().vertex(v.idx())));
        ++cost;
      }
    }
  }

  const Mesh& m_mesh;
  std::vector<Vertex> m_sources;
  std::vector<double> m_costs; // of all vertices, source by source
};

#endif // BENCHMARK_DENSE_REFERENCE_H
