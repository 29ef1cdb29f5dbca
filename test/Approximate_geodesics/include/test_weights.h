// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_WEIGHTS_H
#define APPROXIMATE_GEODESICS_TEST_WEIGHTS_H

#include "test_oracles.h"

#include <CGAL/Approximate_geodesics/Equally_spaced_points.h>
#include <CGAL/Approximate_geodesics/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Steiner_graph.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Equally_spaced_points;
using CGAL::Approximate_geodesics::Geometric_points;
using CGAL::Approximate_geodesics::Steiner_graph;

using Weights = std::vector<double>; // by the index of the face
using Barriers = std::vector<bool>;  // by the index of the edge

// Values by the index of a face or an edge, as a property map that refers to them.
template <typename Descriptor, typename Vector>
struct Values_by_index
{
  using key_type = Descriptor;
  using value_type = typename Vector::value_type;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(const Values_by_index& map, const Descriptor d)
  {
    return (*map.values)[d.idx()];
  }

  const Vector* values;
};

inline auto weight_map(const Weights& weights) { return Values_by_index<Face, Weights>{&weights}; }

inline auto with_weights(const Weights& weights)
{
  return CGAL::parameters::face_weight_map(weight_map(weights));
}

inline auto barrier_map(const Barriers& barriers)
{
  return Values_by_index<Edge, Barriers>{&barriers};
}

inline auto with_barriers(const Barriers& barriers)
{
  return CGAL::parameters::edge_is_constrained_map(barrier_map(barriers));
}

template <typename Placement>
Steiner_graph<Placement>
steiner_graph(const Mesh& mesh, const Weights& weights, const Placement& placement)
{
  return Steiner_graph<Placement>(Triangulation(mesh, with_weights(weights)), placement);
}

// The cost from the nearest of the sources to every vertex.
template <typename Placement>
std::vector<double> costs(const Mesh& mesh,
                          const Weights& weights,
                          const Placement& placement,
                          const std::vector<Vertex>& sources)
{
  return Basic_mesh_search<Steiner_graph<Placement>>(mesh, steiner_graph(mesh, weights, placement))
      .distances(sources);
}

// Weights that `weight(centroid)` says.
template <typename F>
Weights weights_by_place(const Mesh& mesh, F weight)
{
  Weights result(mesh.num_faces());
  for(const Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    result[f.idx()] = weight(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                            mesh.point(mesh.target(mesh.next(h)))));
  }
  return result;
}

// Weights between `low` and `high` such that their logarithms are uniform; a part of them is `0`,
// and as many infinity.
inline Weights random_weights(
    const Mesh& mesh, Random& random, const double low, const double high, const double extreme = 0)
{
  Weights result(mesh.num_faces());
  for(double& w : result)
  {
    const double kind = random.between(0, 1);
    w = low * std::pow(high / low, random.between(0, 1));
    if(kind < extreme)
      w = 0;
    else if(kind < 2 * extreme)
      w = infinity;
  }
  return result;
}

// Up to so many points on every edge, at random places that depend on the edge only. Some are very
// close to each other, or to an end.
class Random_points
{
public:
  using Index = Triangulation::Index;
  static constexpr bool makes_equal_parts = false;

  explicit Random_points(const std::size_t largest_number, const std::uint64_t seed = 1)
    : m_largest_number(largest_number), m_seed(seed)
  {
  }

  void prepare(const Triangulation& /* triangulation */) {}

  std::size_t number_of_points(const Triangulation& triangulation, const Index h) const
  {
    return random(triangulation, h).below(m_largest_number + 1);
  }

  void place(const Triangulation& triangulation,
             const Index h,
             float* const positions,
             const std::size_t number_of_points) const
  {
    Random r = random(triangulation, h);
    r.below(1);
    const auto half = static_cast<std::ptrdiff_t>(r.below(number_of_points + 1));
    const auto size = static_cast<std::ptrdiff_t>(number_of_points);
    for(std::ptrdiff_t i = 0; i < size; ++i)
    {
      const double part =
          0.49 * std::pow(10, r.between(0, 1) < 0.2 ? r.between(-6, 0) : 0) * r.between(0.01, 1);
      positions[i] = static_cast<float>(i < half ? part : -part);
    }
    std::sort(positions, positions + half);
    std::sort(positions + half, positions + size);
  }

  double epsilon(const Triangulation& /* triangulation */) const { return infinity; }
  std::size_t memory() const { return 0; }

private:
  Random random(const Triangulation& triangulation, const Index h) const
  {
    return Random(m_seed + 1000003 * (std::min)(h, triangulation.opposite(h)));
  }

  std::size_t m_largest_number;
  std::uint64_t m_seed;
};

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
      const Node h = graph.place(n).halfedge;
      nodes_of_edge[(std::min)(h, t.opposite(h))].push_back(n);
      m_places.push_back(between(m_places[t.source(h)], m_places[t.target(h)], graph.place(n).t));
    }
    m_faces_of_node.resize(graph.number_of_nodes());
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      if(!t.is_border(h) && h < t.next(h) && h < t.next(t.next(h)))
        add_face(t, h, nodes_of_edge);
  }

  std::vector<double> distances(const Node source) const
  {
    std::vector<double> result(m_places.size(), infinity);
    std::vector<bool> is_settled(m_places.size(), false);
    using Entry = std::pair<double, Node>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    result[source] = 0;
    queue.push({0, source});
    while(!queue.empty())
    {
      const auto [distance, node] = queue.top();
      queue.pop();
      if(is_settled[node])
        continue;
      is_settled[node] = true;
      for(const std::size_t f : m_faces_of_node[node])
        for(const Node other : m_faces[f].nodes)
        {
          const double through = distance + cost(f, node, other);
          if(through < result[other])
          {
            result[other] = through;
            queue.push({through, other});
          }
        }
    }
    return result;
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
  using Place = std::array<long double, 3>; // coordinates cancel when points are close

  struct Weighted_face
  {
    double weight;
    std::vector<Node> nodes;
  };

  static Place place(const Point& p) { return {p.x(), p.y(), p.z()}; }

  static Place between(const Place& p, const Place& q, const long double part)
  {
    Place result;
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

  std::vector<Place> m_places; // per node
  std::vector<std::vector<std::size_t>> m_faces_of_node;
  std::vector<Weighted_face> m_faces;
};

// Expects the same numbers up to rounding, and infinity at the same places. Where points are very
// close to each other, places themselves are rounded.
inline void expect_about_the_same(const std::vector<double>& found,
                                  const std::vector<double>& expected,
                                  const double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  constexpr double rounding_of_places = 1e-15;
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < found.size(); ++i)
    if(found[i] != expected[i] &&
       !(std::abs(found[i] - expected[i]) <= tolerance * expected[i] + rounding_of_places) &&
       ++wrong <= 3)
      ADD_FAILURE() << "at " << i << ": " << found[i] << " instead of " << expected[i]
                    << ", relative error " << found[i] / expected[i] - 1;
  EXPECT_EQ(wrong, 0u);
}

// Expects that costs are between the exact ones and `1 + epsilon` times those.
inline void expect_within_bound(const std::vector<double>& found,
                                const std::vector<double>& exact,
                                const double epsilon)
{
  constexpr double rounding = 1e-12;
  ASSERT_EQ(found.size(), exact.size());
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < exact.size(); ++i)
  {
    const double limit = epsilon < infinity ? exact[i] * (1 + epsilon) * (1 + rounding) : infinity;
    if(!(found[i] >= exact[i] * (1 - rounding) && found[i] <= limit) && ++wrong <= 3)
      ADD_FAILURE() << "at " << i << ": " << found[i] << " where " << exact[i]
                    << " is exact, relative error " << found[i] / exact[i] - 1;
  }
  EXPECT_EQ(wrong, 0u);
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_WEIGHTS_H
