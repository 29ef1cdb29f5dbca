// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H
#define APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H

#include "oracles/test_oracles.h"
#include "paths/dijkstra.h"

#include <CGAL/Geodesic_costs/internal/Steiner/Narrow_arcs.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace geodesics_test {

/*
 * What a Steiner graph without barriers stands for, spelled out: all nodes at the border of a face
 * are joined to each other, but for narrow arcs, and a search compares all of these arcs. Of the
 * graph, only the places of the nodes are used, and which edges form a face; lengths come from the
 * points of the mesh.
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
    using Placement = std::decay_t<decltype(graph.placement())>;
    if constexpr(CGAL::Approximate_geodesics::internal::is_valid<const Placement&>(
                     [](auto& p) -> decltype(p.tangent_of_narrow_arcs()) {}))
      m_smallest_angle =
          std::atan(static_cast<long double>(graph.placement().tangent_of_narrow_arcs()));
    m_faces_of_node.resize(graph.number_of_nodes());
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      if(!t.is_border(h) && h < t.next(h) && h < t.next(t.next(h)))
        add_face(t, h, nodes_of_edge);
  }

  std::vector<double> distances(const Node source) const
  {
    return textbook_distances<double>(m_places.size(), source, [&](const auto node, const auto& g) {
      for(const auto& [f, i] : m_faces_of_node[node])
        for(std::size_t k = 0; k < m_faces[f].nodes.size(); ++k)
          if(!is_narrow(m_faces[f], i, k))
          {
            const Node other = m_faces[f].nodes[k].node;
            g(other, cost(f, static_cast<Node>(node), other));
          }
    });
  }

  // that of the arc from one node of a face to another
  double cost(const std::size_t face, const Node a, const Node b) const
  {
    return static_cast<double>(m_faces[face].weight * distance(a, b));
  }

private:
  using Intrinsic_point = std::array<long double, 3>; // coordinates cancel when points are close

  // A node at the border of a face, its side, and those before and behind it there. A vertex is on
  // the side that it starts.
  struct Border_node
  {
    Node node;
    std::size_t side;
    Node before, behind;
  };

  struct Weighted_face
  {
    double weight;
    std::array<Node, 3> corners;
    std::array<std::size_t, 3> sizes; // numbers of points on the sides
    std::vector<Border_node> nodes;
  };

  long double distance(const Node a, const Node b) const
  {
    long double squared = 0;
    for(std::size_t i = 0; i < 3; ++i)
      squared += (m_places[a][i] - m_places[b][i]) * (m_places[a][i] - m_places[b][i]);
    return std::sqrt(squared);
  }

  // The definition of the report.
  bool is_narrow(const Weighted_face& face, const std::size_t i, const std::size_t k) const
  {
    const Border_node &a = face.nodes[i], &b = face.nodes[k];
    if(m_smallest_angle == 0 || a.side == b.side || is_corner(face, a) || is_corner(face, b))
      return false;
    if((a.side + 1) % 3 != b.side)
      return is_narrow(face, k, i);
    constexpr std::size_t smallest =
        CGAL::Approximate_geodesics::internal::Narrow_arcs::SMALLEST_SIZE;
    if((std::min)(face.sizes[a.side], face.sizes[b.side]) < smallest)
      return false;
    const Node v = face.corners[b.side]; // the end of the side of `a`, the start of that of `b`
    const long double ratio =
        smallest_ratio(v, face.corners[a.side], face.corners[(b.side + 1) % 3]);
    return distance(v, a.behind) >= ratio * distance(v, b.behind) ||
           distance(v, b.before) >= ratio * distance(v, a.before);
  }

  static bool is_corner(const Weighted_face& face, const Border_node& n)
  {
    return n.node == face.corners[n.side];
  }

  // of the distances from the corner, from which on an angle is small
  long double smallest_ratio(const Node corner, const Node p, const Node q) const
  {
    const long double a = distance(corner, p), b = distance(corner, q), c = distance(p, q);
    const long double angle = std::acos((a * a + b * b - c * c) / (2 * a * b));
    return (std::max)(1.0L, std::sin(angle + m_smallest_angle) / std::sin(m_smallest_angle));
  }

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
    Weighted_face face{t.weight(h) * t.weight_unit(), {}, {}, {}};
    std::size_t side = 0;
    for(const Node g : {h, t.next(h), t.next(t.next(h))})
    {
      std::vector<Node> points = nodes_of_edge[(std::min)(g, t.opposite(g))];
      const Node start = t.source(g);
      std::sort(points.begin(), points.end(), [&](const Node a, const Node b) {
        return distance(start, a) < distance(start, b);
      });
      face.corners[side] = start;
      face.sizes[side] = points.size();
      points.insert(points.begin(), start);
      points.push_back(t.target(g));
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        face.nodes.push_back({points[i], side, i > 0 ? points[i - 1] : start, points[i + 1]});
      ++side;
    }
    for(std::size_t i = 0; i < face.nodes.size(); ++i)
      m_faces_of_node[face.nodes[i].node].emplace_back(m_faces.size(), i);
    m_faces.push_back(face);
  }

  std::vector<Intrinsic_point> m_places;                                         // per node
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> m_faces_of_node; // and places there
  std::vector<Weighted_face> m_faces;
  long double m_smallest_angle = 0; // of arcs, where arcs are left out
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FULL_GRAPH_H
