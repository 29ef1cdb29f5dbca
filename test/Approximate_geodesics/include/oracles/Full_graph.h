// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H
#define APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H

#include "oracles/test_oracles.h"
#include "paths/dijkstra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesics_test {

/*
 * What a Steiner graph without barriers stands for, spelled out: all nodes at the border of a face
 * are joined to each other, and a search compares all of these arcs. Of the graph, only the places
 * of the nodes are used, and which edges form a face; lengths come from the points of the mesh.
 */
class Full_graph
{
public:
  template <typename Graph>
  Full_graph(const Mesh& mesh, const Graph& graph)
  {
    const Triangulation& t = graph.triangulation();
    m_places.reserve(graph.number_of_nodes());
    for(Node n = 0; n < t.number_of_vertices(); ++n)
      m_places.push_back(place(mesh.point(Vertex(t.index(n)))));
    std::vector<std::vector<Node>> nodes_of_edge(t.number_of_halfedges());
    for(Node n = t.number_of_vertices(); n < graph.number_of_nodes(); ++n)
    {
      const Node h = graph.position(n).halfedge;
      nodes_of_edge[(std::min)(h, t.opposite(h))].push_back(n);
      m_places.push_back(
          between(m_places[t.source(h)], m_places[t.target(h)], graph.position(n).t));
    }
    m_faces_of_node.resize(graph.number_of_nodes());
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      if(!t.is_border(h) && h < t.next(h) && h < t.next(t.next(h)))
        add_face(t, h, nodes_of_edge);
  }

  std::vector<double> distances(const Node source) const
  {
    return textbook_distances<double>(m_places.size(), source, [&](const auto node, const auto& f) {
      for(const std::size_t face : m_faces_of_node[node])
        for(const Node other : m_faces[face].nodes)
          f(other, cost(face, static_cast<Node>(node), other));
    });
  }

  // that of the arc from one node of a face to another
  double cost(const std::size_t face, const Node a, const Node b) const
  {
    long double squared = 0;
    for(std::size_t i = 0; i < 3; ++i)
      squared += (m_places[a][i] - m_places[b][i]) * (m_places[a][i] - m_places[b][i]);
    return static_cast<double>(m_faces[face].weight * std::sqrt(squared));
  }

private:
  using Intrinsic_point = std::array<long double, 3>; // coordinates cancel when points are close

  struct Weighted_face
  {
    double weight;
    std::vector<Node> nodes;
  };

  static Intrinsic_point place(const Point& p) { return {p.x(), p.y(), p.z()}; }

  static Intrinsic_point
  between(const Intrinsic_point& p, const Intrinsic_point& q, const long double part)
  {
    Intrinsic_point result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = (1 - part) * p[i] + part * q[i];
    return result;
  }

  void add_face(const Triangulation& t,
                const Node h,
                const std::vector<std::vector<Node>>& nodes_of_edge)
  {
    if(t.weight(h) == infinity)
      return;
    Weighted_face face{t.weight(h) * t.weight_unit(), {}};
    for(const Node side : {h, t.next(h), t.next(t.next(h))})
    {
      const std::vector<Node>& points = nodes_of_edge[(std::min)(side, t.opposite(side))];
      face.nodes.push_back(t.source(side));
      face.nodes.insert(face.nodes.end(), points.begin(), points.end());
    }
    for(const Node n : face.nodes)
      m_faces_of_node[n].push_back(m_faces.size());
    m_faces.push_back(face);
  }

  std::vector<Intrinsic_point> m_places; // per node
  std::vector<std::vector<std::size_t>> m_faces_of_node;
  std::vector<Weighted_face> m_faces;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H
