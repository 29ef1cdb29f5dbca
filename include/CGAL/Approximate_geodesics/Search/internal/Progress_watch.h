// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PROGRESS_WATCH_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PROGRESS_WATCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

template <typename Visitor>
constexpr bool is_idle_visitor = std::is_same_v<std::decay_t<Visitor>, Geodesic_visitor_base>;

// For runs that nobody watches and that have no targets.
struct No_watch
{
  bool go_further(std::size_t /* number_appended */) const { return true; }
  void finish() const {}
};

/*
 * Tells the visitor which nodes are settled, and ends a run when the goal is reached.
 *
 * A node that came out of the queue is settled when the queue says that its distance is final, not
 * before. The nodes expanded since the last time are final all at once: as soon as the queue
 * goes on to larger keys. The last ones in the order are those that just came out.
 */
template <typename Graph, typename Goal, typename Visitor>
class Progress_watch
{
  using Node = Labels::Node;

public:
  Progress_watch(const Graph& graph, Labels& labels, Goal goal, Visitor& visitor)
    : m_graph(graph), m_labels(labels), m_goal(std::move(goal)), m_visitor(visitor)
  {
  }

  // To be called after nodes were appended to the order; returns whether they shall be expanded.
  bool go_further(const std::size_t number_appended)
  {
    const std::size_t number_of_earlier = m_labels.order().size() - number_appended;
    if(m_number_settled == number_of_earlier ||
       !m_goal.is_settled(m_labels.order()[m_number_settled]))
      return true;
    settle(number_of_earlier);
    return !m_goal.is_reached() && m_visitor.go_further();
  }

  // To be called when the queue is empty.
  void finish() { settle(m_labels.order().size()); }

private:
  // Settles the nodes of the order up to `end`: by distance, and each of them once.
  void settle(const std::size_t end)
  {
    auto& order = m_labels.order();
    const auto position = [&](const std::size_t i) {
      return order.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::sort(position(m_number_settled), position(end), [this](const Node a, const Node b) {
      return std::make_pair(m_labels.distance(a), a) < std::make_pair(m_labels.distance(b), b);
    });
    const auto repetitions = std::unique(position(m_number_settled), position(end));
    const auto number_of_repetitions = position(end) - repetitions;
    order.erase(repetitions, position(end));

    const std::size_t beyond = end - static_cast<std::size_t>(number_of_repetitions);
    while(m_number_settled < beyond)
    {
      const Node node = order[m_number_settled++];
      m_visitor.on_settled(node, m_labels.distance(node) * m_graph.unit());
    }
    m_visitor.on_progress(m_number_settled, m_labels.number_of_nodes());
  }

  const Graph& m_graph;
  Labels& m_labels;
  Goal m_goal;
  Visitor& m_visitor;
  std::size_t m_number_settled = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PROGRESS_WATCH_H
