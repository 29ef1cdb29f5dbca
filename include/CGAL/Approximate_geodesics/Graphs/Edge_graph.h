// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_EDGE_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_EDGE_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * The graph of the vertices and edges of a mesh.
 *
 * It is the smallest and fastest of the graphs, and has no error bound: a path along edges can be
 * longer than the geodesic by any factor where faces are badly shaped, and is about 5 % longer on
 * average on scanned models. It takes no memory beyond the triangulation's, whose halfedge groups
 * are its adjacency arrays.
 *
 * An object of this class never changes after its construction and may be used by several threads.
 *
 * \cgalModels{SurfaceGraph}
 */
class Edge_graph
{
public:
  /// the number of a node; that of the vertex it stands for.
  using Node = Intrinsic_triangulation::Index;

  /// all points of paths are vertices.
  static constexpr bool arcs_are_edges = true;

  /// the graph of an empty mesh.
  Edge_graph() = default;

  /// the graph of the edges of `triangulation`. It has no parameters of its own; `epsilon` and
  /// those of `Steiner_graph` are rejected at compile time. \throws std::invalid_argument if
  /// `triangulation` has weights or barriers.
  ///
  /// Run time is \cgalBigO{n}.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Edge_graph(Intrinsic_triangulation triangulation,
                      const NamedParameters& np = parameters::default_values())
    : m_triangulation(internal::without_weights(std::move(triangulation), np, "Edge_graph")),
      m_arc_lengths(summarize_arc_lengths(m_triangulation.lengths()))
  {
    static_assert(!internal::is_given<NamedParameters, internal_np::epsilon_t>,
                  "epsilon: the edge graph has no error bound; use Discrete_geodesic_graph");
    for(Node v = 0; v < number_of_nodes(); ++v)
      m_maximum_degree = (std::max)(m_maximum_degree, std::size_t(m_triangulation.degree(v)));
  }

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns by how much, relatively, distances there are larger than those back: `0`.
  static constexpr double asymmetry() { return 0; }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_triangulation.number_of_vertices(); }

  /// returns the unit of lengths, that of the triangulation.
  double unit() const { return m_triangulation.unit(); }

  /// returns a summary of the lengths of the arcs.
  const Arc_lengths& arc_lengths() const { return m_arc_lengths; }

  /// returns the largest number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_maximum_degree; }

  /// calls `f(target, length)` for every arc that starts from `node`. They do not depend on the
  /// labels.
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& /* labels */, F f) const
  {
    const Node* target = m_triangulation.targets().data(); // `f` cannot change these pointers
    const double* length = m_triangulation.lengths().data();
    const Node beyond = m_triangulation.beyond_halfedge(node);
    for(Node h = m_triangulation.first_halfedge(node); h < beyond; ++h)
      f(target[h], length[h]);
  }

  /// attaches a point of the surface by straight lines to the corners of its face, or of both faces
  /// if it lies on an edge.
  Lines_in_faces attach(const Intrinsic_point& point) const { return {m_triangulation, point}; }

  /// prefetches the arcs of `node`.
  void prefetch(const Node node) const
  {
    m_triangulation.prefetch(m_triangulation.first_halfedge(node));
  }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const { return m_triangulation.memory(); }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_triangulation.is_valid(); }

private:
  Intrinsic_triangulation m_triangulation;
  Arc_lengths m_arc_lengths;
  std::size_t m_maximum_degree = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_EDGE_GRAPH_H
