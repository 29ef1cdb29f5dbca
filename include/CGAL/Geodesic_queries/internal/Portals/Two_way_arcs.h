// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_TWO_WAY_ARCS_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_TWO_WAY_ARCS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Geodesic_queries/internal/for_each_arc.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs of a graph, each of them in both directions: a `GeodesicGraph` whose distances there and
 * back are the same. A graph with `asymmetry()` may leave out an arc in one direction. Of several
 * arcs between two nodes, the shortest one is kept.
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
      m_first[i] += m_first[i - 1];
    m_target.resize(m_first.back());
    m_length.resize(m_first.back());
    for_each_end(graph, [this](const Node node, const Node target, const double length) {
      const std::size_t i = m_first[std::size_t(node) + 1]++;
      m_target[i] = target;
      m_length[i] = length;
    });
    m_first.pop_back();
    remove_longer_arcs();
    summarize();
  }

  // The arcs between the nodes of a part. `place` are the numbers that nodes get, `null_node` if
  // they are not in it.
  Two_way_arcs(const Two_way_arcs& all,
               const std::vector<Node>& part,
               const std::vector<Node>& place)
    : m_unit(all.m_unit)
  {
    m_first.reserve(part.size() + 1);
    for(const Node node : part)
    {
      check_for_interruption_at(node);
      m_first.push_back(m_target.size());
      all.for_each_arc(node, place, [&](const Node target, const double length) {
        if(place[target] == Labels::null_node)
          return;
        m_target.push_back(place[target]);
        m_length.push_back(length);
      });
    }
    m_first.push_back(m_target.size());
    summarize();
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
  // Calls `f(node, other, length)` for both ends of each arc.
  template <typename Graph, typename F>
  static void for_each_end(const Graph& graph, const F& f)
  {
    internal::for_each_arc(graph, [&](const Node node, const Node target, const double length) {
      f(node, target, length);
      f(target, node, length);
    });
  }

  void remove_longer_arcs()
  {
    std::vector<std::pair<Node, double>> arcs;
    std::size_t size = 0;
    for(Node node = 0; node < number_of_nodes(); ++node)
    {
      check_for_interruption_at(node);
      arcs.clear();
      for_each_arc(node, arcs, [&](const Node target, const double length) {
        arcs.emplace_back(target, length);
      });
      std::sort(arcs.begin(), arcs.end());
      m_first[node] = size;
      for(std::size_t i = 0; i < arcs.size(); ++i)
        if(arcs[i].first != node && (i == 0 || arcs[i].first != arcs[i - 1].first))
        {
          m_target[size] = arcs[i].first;
          m_length[size++] = arcs[i].second;
        }
    }
    m_first.back() = size;
    m_target.resize(size);
    m_length.resize(size);
    m_target.shrink_to_fit();
    m_length.shrink_to_fit();
  }

  void summarize()
  {
    for(std::size_t i = 1; i < m_first.size(); ++i)
      m_maximum_degree = (std::max)(m_maximum_degree, m_first[i] - m_first[i - 1]);
    m_arc_lengths = summarize_arc_lengths(m_length);
  }

  std::vector<std::size_t> m_first;
  std::vector<Node> m_target;
  std::vector<double> m_length;
  Arc_lengths m_arc_lengths;
  std::size_t m_maximum_degree = 0;
  double m_unit;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_TWO_WAY_ARCS_H
