// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_ORACLES_H
#define APPROXIMATE_GEODESICS_TEST_ORACLES_H

#include "meshes/test_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace geodesics_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

using Graph = CGAL::Approximate_geodesics::Edge_graph;
using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;
using Search = CGAL::Approximate_geodesics::Propagation<Graph>;
using Node = Search::Node;

// Results per vertex of the mesh, by index.
struct Field
{
  std::vector<double> distance;
  std::vector<Vertex> predecessor; // null where there is none
};

inline bool have_same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

// Lengths by the index of the edge, computed without the package.
inline std::vector<double> edge_lengths(const Mesh& mesh)
{
  std::vector<double> result(mesh.num_edges());
  for(const Edge e : mesh.edges())
    result[e.idx()] = std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), //
                                                       mesh.point(mesh.vertex(e, 1))));
  return result;
}

// The distances that Boost.Graph finds on the mesh itself.
inline std::vector<double>
boost_distances(const Mesh& mesh, const std::vector<double>& lengths, const Vertex source)
{
  std::vector<double> result(mesh.num_vertices(), infinity);
  if(mesh.is_isolated(source)) // which the traversal of out-edges cannot start from
  {
    result[source.idx()] = 0;
    return result;
  }
  boost::dijkstra_shortest_paths(
      mesh, source,
      boost::distance_map(
          boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)))
          .weight_map(
              boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)))
          .distance_inf(infinity)
          .distance_combine(std::plus<double>()));
  return result;
}

inline std::vector<double> minimum(std::vector<double> a, const std::vector<double>& b)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i] = (std::min)(a[i], b[i]);
  return a;
}

inline double largest_finite(const std::vector<double>& values)
{
  double result = 0;
  for(const double x : values)
    result = x < infinity ? (std::max)(result, x) : result;
  return result;
}

/*
 * A proof, without any reference, that distances are those from the nearest source: no edge can
 * lower one of them, and each is the sum along the path that its predecessors form. All sums are
 * rounded the same way, so all comparisons are exact.
 */
class Certificate
{
public:
  Certificate(const Mesh& mesh, const std::vector<double>& lengths, const Field& field)
    : m_mesh(mesh), m_lengths(lengths), m_field(field), m_is_rooted(mesh.num_vertices(), false)
  {
  }

  testing::AssertionResult check(const std::vector<Vertex>& sources)
  {
    for(const Vertex s : sources)
    {
      if(distance(s) != 0)
        return testing::AssertionFailure() << "source " << s << " has distance " << distance(s);
      m_is_rooted[s.idx()] = true;
    }
    for(const Edge e : m_mesh.edges())
      for(const Halfedge h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
        if(!(distance(m_mesh.target(h)) <= distance(m_mesh.source(h)) + m_lengths[e.idx()]))
          return testing::AssertionFailure() << h << " lowers the distance of its target";
    for(const Vertex v : m_mesh.vertices())
      if(!is_justified(v))
        return testing::AssertionFailure() << "no path has the length given for " << v;
    return testing::AssertionSuccess();
  }

private:
  double distance(const Vertex v) const { return m_field.distance[v.idx()]; }

  // whether the predecessors of `v` lead to a source, and every step has the length of an edge
  bool is_justified(const Vertex v)
  {
    if(distance(v) == infinity)
      return m_field.predecessor[v.idx()] == Mesh::null_vertex();
    Vertex u = v;
    for(std::size_t steps = 0; !m_is_rooted[u.idx()]; ++steps)
    {
      if(!is_tight(u) || steps == m_mesh.num_vertices()) // edges of length zero could form a cycle
        return false;
      u = m_field.predecessor[u.idx()];
    }
    for(u = v; !m_is_rooted[u.idx()]; u = m_field.predecessor[u.idx()])
      m_is_rooted[u.idx()] = true;
    return true;
  }

  bool is_tight(const Vertex v) const
  {
    const Vertex p = m_field.predecessor[v.idx()];
    if(p == Mesh::null_vertex())
      return false;
    for(const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_mesh.source(h) == p && distance(v) == distance(p) + m_lengths[m_mesh.edge(h).idx()])
        return true;
    return false;
  }

  const Mesh& m_mesh;
  const std::vector<double>& m_lengths;
  const Field& m_field;
  std::vector<bool> m_is_rooted;
};

inline testing::AssertionResult is_optimal(const Mesh& mesh,
                                           const std::vector<double>& lengths,
                                           const Field& field,
                                           const std::vector<Vertex>& sources)
{
  return Certificate(mesh, lengths, field).check(sources);
}

// A mesh with its graph and a workspace, and results by the vertices of the mesh.
template <typename GeodesicGraph>
class Basic_mesh_search
{
public:
  using Search = CGAL::Approximate_geodesics::Propagation<GeodesicGraph>;

  template <typename... NamedParameters>
  explicit Basic_mesh_search(const Mesh& mesh, const NamedParameters&... np)
    : Basic_mesh_search(mesh, GeodesicGraph(Triangulation(mesh, np...), np...))
  {
  }

  Basic_mesh_search(const Mesh& mesh, GeodesicGraph graph)
    : m_mesh(mesh), m_graph(std::move(graph)), m_search(m_graph)
  {
  }

  Node node(const Vertex v) const { return m_graph.triangulation().vertex(v.idx()); }
  Vertex vertex(const Node n) const { return Vertex(m_graph.triangulation().index(n)); }

  std::vector<typename Search::Seed> seeds(const std::vector<Vertex>& sources) const
  {
    std::vector<typename Search::Seed> result;
    for(const Vertex v : sources)
      result.push_back({node(v), 0, result.size()});
    return result;
  }

  Field run(const std::vector<Vertex>& sources, const typename Search::Stop_rule& stop = {})
  {
    m_search.run(seeds(sources), stop);
    return field();
  }

  std::vector<double> distances(const std::vector<Vertex>& sources)
  {
    return run(sources).distance;
  }

  Field field() const
  {
    Field result{std::vector<double>(m_mesh.num_vertices(), infinity),
                 std::vector<Vertex>(m_mesh.num_vertices(), Mesh::null_vertex())};
    for(const Vertex v : m_mesh.vertices())
    {
      result.distance[v.idx()] = m_search.distance(node(v));
      const Node predecessor = m_search.predecessor(node(v));
      if(predecessor < m_mesh.num_vertices()) // neither none nor a point on an edge
        result.predecessor[v.idx()] = vertex(predecessor);
    }
    return result;
  }

  const Mesh& mesh() const { return m_mesh; }
  const GeodesicGraph& graph() const { return m_graph; }
  Search& search() { return m_search; }
  const Search& search() const { return m_search; }

private:
  const Mesh& m_mesh;
  GeodesicGraph m_graph;
  Search m_search;
};

using Mesh_search = Basic_mesh_search<Graph>;

// Those that a search has found, by the number of the node.
template <typename Search>
std::vector<double> distances_of_nodes(const Search& search)
{
  std::vector<double> result;
  for(Node n = 0; n < search.graph().number_of_nodes(); ++n)
    result.push_back(search.distance(n));
  return result;
}

inline Vertex random_vertex(const Mesh& mesh, Random& random)
{
  return *std::next(mesh.vertices().begin(),
                    static_cast<std::ptrdiff_t>(random.below(mesh.number_of_vertices())));
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_ORACLES_H
