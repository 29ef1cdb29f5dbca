// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_ONE_WAY_GRAPH_H
#define APPROXIMATE_GEODESICS_TEST_ONE_WAY_GRAPH_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesics_test {

// A graph of a user's own: the edges of a mesh, some of which go one way only, or cost more one way
// than the other. Paths start and end at some vertices, but do not lead through them.
class One_way_graph
{
public:
  using Node = std::uint32_t;
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;

  static constexpr bool arcs_are_edges = true;

  // `asymmetry` is what the graph says, which need not be true.
  template <typename Choices>
  One_way_graph(Triangulation triangulation, const double asymmetry, Choices& choices)
    : m_triangulation(std::move(triangulation)), m_asymmetry(asymmetry)
  {
    for(Node h = 0; h < m_triangulation.number_of_halfedges(); ++h)
    {
      const std::size_t kind = choices.below(8);
      m_factor.push_back(kind == 0 ? 0 : kind < 4 ? 1 : 1 + 0.5 * double(choices.below(8)));
    }
    for(Node v = 0; v < number_of_nodes(); ++v)
      m_is_dead_end.push_back(choices.below(6) == 0);
  }

  const Triangulation& triangulation() const { return m_triangulation; }
  double asymmetry() const { return m_asymmetry; }
  std::size_t number_of_nodes() const { return m_triangulation.number_of_vertices(); }
  double unit() const { return m_triangulation.unit(); }

  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const
  {
    return CGAL::Approximate_geodesics::summarize_arc_lengths(m_triangulation.lengths());
  }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    constexpr Node none = Triangulation::null_index;
    if(m_is_dead_end[node] && labels.predecessor(node) != none)
      return;
    for(Node h = m_triangulation.first_halfedge(node); h < m_triangulation.beyond_halfedge(node);
        ++h)
      if(m_factor[h] > 0)
        f(m_triangulation.target(h), m_factor[h] * m_triangulation.length(h));
  }

  CGAL::Approximate_geodesics::Lines_in_faces
  attach(const CGAL::Approximate_geodesics::Intrinsic_point& point) const
  {
    return {m_triangulation, point};
  }

private:
  Triangulation m_triangulation;
  double m_asymmetry;
  std::vector<double> m_factor; // of the length, per halfedge; 0 if there is no arc
  std::vector<bool> m_is_dead_end;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_ONE_WAY_GRAPH_H
