// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_EXACT_CASE_H
#define BENCHMARK_EXACT_CASE_H

#include "meshes/Mesh.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// A mesh with exact distances from some of its vertices, computed by the package.
// `bench_validation` compares them with those of CGAL's exact class.
class Exact_case
{
public:
  static constexpr double ROUNDING = 1e-10; // of exact distances

  // From random vertices.
  Exact_case(const std::string& name, const std::size_t number_of_sources)
    : Exact_case(name, read_mesh(name), number_of_sources)
  {
  }

  Exact_case(const std::string& name, const Mesh& mesh, const std::vector<Vertex>& sources)
    : m_name(short_name(name)), m_mesh(mesh), m_sources(sources)
  {
    if(!CGAL::is_triangle_mesh(m_mesh))
      throw std::runtime_error("not a triangle mesh");
    find_distances();
  }

  const std::string& name() const { return m_name; }
  const Mesh& mesh() const { return m_mesh; }
  const std::vector<Vertex>& sources() const { return m_sources; }

  double distance(const std::size_t source, const Vertex v) const
  {
    return m_distances[source * m_mesh.number_of_vertices() + v.idx()];
  }

private:
  using Graph = CGAL::Approximate_geodesics::Saddle_vertex_graph;

  Exact_case(const std::string& name, const Mesh& mesh, const std::size_t number_of_sources)
    : Exact_case(name, mesh, random_sources(mesh, number_of_sources))
  {
  }

  void find_distances()
  {
    const Graph graph{CGAL::Approximate_geodesics::Intrinsic_triangulation(m_mesh)};
    const auto node = [&](const Vertex v) { return graph.triangulation().vertex(v.idx()); };
    CGAL::Approximate_geodesics::Propagation<Graph> search(graph);
    for(const Vertex source : m_sources)
    {
      search.run_from(node(source));
      for(const Vertex v : m_mesh.vertices())
        m_distances.push_back(search.distance(node(v)));
    }
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  std::vector<double> m_distances; // of all vertices, source by source
};

// From the first vertex and random ones.
inline Exact_case first_and_random_case(const std::string& name,
                                        const std::size_t number_of_sources)
{
  const Mesh mesh = read_mesh(name);
  return Exact_case(name, mesh, first_and_random(random_sources(mesh, number_of_sources)));
}

#endif // BENCHMARK_EXACT_CASE_H
