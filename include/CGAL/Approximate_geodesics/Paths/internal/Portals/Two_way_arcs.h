// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_TWO_WAY_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_TWO_WAY_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs of a graph, each of them in both directions: a `GeodesicGraph` whose distances there and
 * back are the same. A graph with `asymmetry()` may leave out an arc in one direction.
 */
class Two_way_arcs
{
public:
  using Node = Labels::Node;

  template <typename Graph>
  explicit Two_way_arcs(const Graph& graph)
    : m_first(graph.number_of_nodes() + 2), m_unit(graph.unit())
  {
    for_each_end(graph,
                 [this](const Node node, Node, double) { ++m_first[std::size_t(node) + 2]; });
    for(std::size_t i = 2; i < m_first.size(); ++i)
    {
      m_maximum_degree = (std::max)(m_maximum_degree, m_first[i]);
      m_first[i] += m_first[i - 1];
    }
    m_target.resize(m_first.back());
    m_length.resize(m_first.back());
    for_each_end(graph, [this](const Node node, const Node target, const double length) {
      const std::size_t i = m_first[std::size_t(node) + 1]++;
      m_target[i] = target;
      m_length[i] = length;
    });
    m_first.pop_back();
    m_arc_lengths = summarize_arc_lengths(m_length);
  }

  std::size_t number_of_nodes() const { return m_first.size() - 1; }
  double unit() const { return m_unit; }
  const Arc_lengths& arc_lengths() const { return m_arc_lengths; }
  std::size_t maximum_degree() const { return m_maximum_degree; }

  template <typename AnyLabels, typename F>
  void for_each_arc(const Node node, const AnyLabels& /* labels */, F f) const
  {
    const std::size_t beyond = m_first[std::size_t(node) + 1];
    for(std::size_t i = m_first[node]; i < beyond; ++i)
      f(m_target[i], m_length[i]);
  }

  template <typename F>
  void for_each_neighbor(const Node node, const F& f) const
  {
    const std::size_t beyond = m_first[std::size_t(node) + 1];
    for(std::size_t i = m_first[node]; i < beyond; ++i)
      f(m_target[i]);
  }

  void prefetch(const Node node) const
  {
    internal::prefetch(m_target.data(), m_first[node]);
    internal::prefetch(m_length.data(), m_first[node]);
  }

private:
  // Calls `f(node, other, length)` for both ends of each arc. The arcs of a node are those of a
  // search that starts there.
  template <typename Graph, typename F>
  static void for_each_end(const Graph& graph, const F& f)
  {
    Labels labels(graph.number_of_nodes());
    for(Node node = 0; node < graph.number_of_nodes(); ++node)
    {
      check_for_interruption_at(node);
      labels.set(node, 0, Labels::null_node);
      const auto add = [&](const Node target, const double length) {
        f(node, target, length);
        f(target, node, length);
      };
      graph.for_each_arc(node, labels, Each_arc<decltype(add)>{add});
      labels.set(node, infinity, Labels::null_node);
    }
  }

  // Takes arcs one by one, or several to consecutive nodes.
  template <typename F>
  struct Each_arc
  {
    void operator()(const Node target, const double length) const { f(target, length); }

    void operator()(const Node first, const double* const lengths, const std::size_t number) const
    {
      for(std::size_t i = 0; i < number; ++i)
        f(first + static_cast<Node>(i), lengths[i]);
    }

    const F& f;
  };

  std::vector<std::size_t> m_first;
  std::vector<Node> m_target;
  std::vector<double> m_length;
  Arc_lengths m_arc_lengths;
  std::size_t m_maximum_degree = 0;
  double m_unit;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_TWO_WAY_ARCS_H
