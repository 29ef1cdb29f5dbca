// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_BOOST_DIJKSTRA_H
#define BENCHMARK_BOOST_DIJKSTRA_H

#include "meshes/Mesh.h"

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

// The alternative for users of CGAL without the package: Boost's algorithm on the mesh itself.
// Distances and lengths are properties of the mesh.
class Boost_dijkstra
{
public:
  using Distance_map = Mesh::Property_map<Vertex, double>;

  explicit Boost_dijkstra(Mesh& mesh)
    : m_mesh(mesh),
      m_lengths(mesh.add_property_map<Mesh::Edge_index, double>("e:length").first),
      m_distances(mesh.add_property_map<Vertex, double>("v:distance").first)
  {
    compute_lengths();
  }

  void compute_lengths()
  {
    for(const auto e : m_mesh.edges())
      m_lengths[e] = std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.vertex(e, 0)),
                                                      m_mesh.point(m_mesh.vertex(e, 1))));
  }

  void run(const Vertex source)
  {
    boost::dijkstra_shortest_paths(m_mesh, source,
                                   boost::weight_map(m_lengths)
                                       .distance_map(m_distances)
                                       .vertex_index_map(get(boost::vertex_index, m_mesh))
                                       .predecessor_map(boost::dummy_property_map()));
  }

  const Distance_map& distances() const { return m_distances; }

private:
  Mesh& m_mesh;
  Mesh::Property_map<Mesh::Edge_index, double> m_lengths;
  Distance_map m_distances;
};

// Timings of wrong results are meaningless.
template <typename Search>
void check_distances(const Mesh& mesh,
                     const Search& search,
                     const Boost_dijkstra::Distance_map& expected)
{
  for(const Vertex v : mesh.vertices())
  {
    const auto n = search.graph().triangulation().vertex(v);
    // fused multiply-add may round lengths differently in the two programs
    const bool agree = search.is_reached(n)
                           ? std::abs(search.distance(n) - expected[v]) <= 1e-12 * expected[v]
                           : expected[v] == (std::numeric_limits<double>::max)();
    if(!agree)
      throw std::runtime_error("the distances of vertex " + std::to_string(v) + " differ");
  }
}

#endif // BENCHMARK_BOOST_DIJKSTRA_H
