// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_ADJACENCY_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_ADJACENCY_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Vertex_adjacency.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The graph of the vertices and edges of a mesh, without a triangulation below it: a model of
 * `GeodesicGraph` for a search that is the only one. Its arcs are those of `Edge_graph`, in the
 * same order; nodes have other numbers.
 */
class Adjacency_graph
{
public:
  using Node = Vertex_adjacency::Index;

  // Lengths are those of halfedges, in the given unit.
  Adjacency_graph(Vertex_adjacency adjacency, std::vector<double> lengths, const double unit)
    : m_adjacency(std::move(adjacency)),
      m_length(std::move(lengths)),
      m_arc_lengths(summarize_arc_lengths(m_length)),
      m_unit(unit)
  {
    for(Node v = 0; v < m_adjacency.number_of_vertices(); ++v)
      m_maximum_degree = (std::max)(m_maximum_degree, std::size_t(m_adjacency.degree(v)));
  }

  std::size_t number_of_nodes() const { return m_adjacency.number_of_vertices(); }
  double unit() const { return m_unit; }
  const Arc_lengths& arc_lengths() const { return m_arc_lengths; }
  std::size_t maximum_degree() const { return m_maximum_degree; }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& /* labels */, F f) const
  {
    const Node* target = m_adjacency.target_of_halfedge.data(); // `f` cannot change these pointers
    const double* length = m_length.data();
    const Node beyond = m_adjacency.beyond_halfedge(node);
    for(Node h = m_adjacency.first_halfedge(node); h < beyond; ++h)
      f(target[h], length[h]);
  }

  void prefetch(const Node node) const
  {
    constexpr Node doubles_per_cache_line = 8;
    const Node h = m_adjacency.first_halfedge(node);
    internal::prefetch(m_adjacency.target_of_halfedge.data(), h);
    internal::prefetch(m_length.data(), h);
    internal::prefetch(m_length.data(), h + doubles_per_cache_line);
  }

private:
  Vertex_adjacency m_adjacency;
  std::vector<double> m_length;
  Arc_lengths m_arc_lengths;
  double m_unit;
  std::size_t m_maximum_degree = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_ADJACENCY_GRAPH_H
