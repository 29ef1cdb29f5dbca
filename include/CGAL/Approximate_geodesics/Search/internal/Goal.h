// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * What a run shall find out before it ends: the distances of nodes, and of places given by the arcs
 * that lead there.
 */
template <typename Queue, typename Estimate, typename LastArc>
class Goal
{
  using Node = Labels::Node;

public:
  Goal(const Labels& labels,
       const Queue& queue,
       const Estimate& estimate,
       std::vector<Node> targets,
       std::vector<std::vector<LastArc>> places)
    : m_labels(labels),
      m_queue(queue),
      m_estimate(estimate),
      m_targets(std::move(targets)),
      m_places(std::move(places)),
      m_is_given(!m_targets.empty() || !m_places.empty())
  {
  }

  bool is_settled(const Node node) const
  {
    return is_final(m_labels.distance(node) + m_estimate(node));
  }

  // Looks at one target at a time, so that many of them cost no more than few.
  bool is_reached()
  {
    while(!m_targets.empty() && is_settled(m_targets.back()))
      m_targets.pop_back();
    while(m_targets.empty() && !m_places.empty() && is_certain(m_places.back()))
      m_places.pop_back();
    return m_is_given && m_targets.empty() && m_places.empty();
  }

private:
  // Whether no node that is not settled can be on the shortest path to where these arcs lead.
  bool is_certain(const std::vector<LastArc>& arcs) const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for(const LastArc& arc : arcs)
      shortest = (std::min)(shortest, m_labels.distance(arc.node) + arc.length);
    return is_final(shortest);
  }

  // Whether a node with such a key is settled, and so are those before it on its path, whose keys
  // can be a bit larger where heuristics were rounded.
  bool is_final(const double key) const
  {
    constexpr double rounding = is_heuristic<Estimate> ? 1e-12 : 0;
    return m_queue.is_final(key * (1 + rounding));
  }

  const Labels& m_labels;
  const Queue& m_queue;
  const Estimate& m_estimate;
  std::vector<Node> m_targets;                // those that are not settled
  std::vector<std::vector<LastArc>> m_places; // those that are not certain
  bool m_is_given;
};

/*
 * Ends a run when its goal is reached. It can only do so when the queue goes on to larger keys:
 * then all nodes that were expanded before are settled.
 */
template <typename Goal>
class Goal_watch
{
public:
  Goal_watch(const Labels& labels, Goal goal) : m_labels(labels), m_goal(std::move(goal)) {}

  // To be called after nodes were appended to the order; returns whether they shall be expanded.
  bool go_further(const std::size_t number_appended)
  {
    const std::size_t number_of_earlier = m_labels.order().size() - number_appended;
    if(m_number_settled == number_of_earlier ||
       !m_goal.is_settled(m_labels.order()[m_number_settled]))
      return true;
    m_number_settled = number_of_earlier;
    return !m_goal.is_reached();
  }

  void finish() const {}

private:
  const Labels& m_labels;
  Goal m_goal;
  std::size_t m_number_settled = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H
