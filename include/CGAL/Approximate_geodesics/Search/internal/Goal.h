// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Propagation_rules.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What a run shall find out before it ends: the distances of nodes, and of points given by the arcs
 * that lead to them.
 */
template <typename Queue, typename Heuristic>
class Goal
{
  using Node = Labels::Node;
  using Arcs = std::vector<Last_arc>; // their lengths in units of the graph

public:
  Goal(const Labels& labels,
       const Queue& queue,
       const Heuristic& heuristic,
       std::vector<Node> targets,
       std::vector<Arcs> points)
    : m_labels(labels),
      m_queue(queue),
      m_heuristic(heuristic),
      m_targets(std::move(targets)),
      m_points(std::move(points)),
      m_is_given(!m_targets.empty() || !m_points.empty())
  {
  }

  // whether there are any
  bool is_given() const { return m_is_given; }

  bool is_final(const Node node) const
  {
    return is_final_key(m_labels.distance(node) + m_heuristic(node));
  }

  // Whether all these distances are final. Looks at one target at a time, so that many of them cost
  // no more than few.
  bool is_met()
  {
    while(!m_targets.empty() && is_final(m_targets.back()))
      m_targets.pop_back();
    while(m_targets.empty() && !m_points.empty() && is_final(m_points.back()))
      m_points.pop_back();
    return m_is_given && m_targets.empty() && m_points.empty();
  }

  // How far the farthest of the targets and points is that are not known to be final; infinity if
  // there are none.
  double distance() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double result = m_targets.empty() && m_points.empty() ? infinity : 0;
    for(const Node target : m_targets)
      result = (std::max)(result, m_labels.distance(target));
    for(const Arcs& arcs : m_points)
      result = (std::max)(result, shortest(arcs));
    return result;
  }

private:
  double shortest(const Arcs& arcs) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const Last_arc& arc : arcs)
      result = (std::min)(result, m_labels.distance(arc.node) + arc.length);
    return result;
  }

  // Whether all nodes on the shortest path to where these arcs lead are final.
  bool is_final(const Arcs& arcs) const { return is_final_key(shortest(arcs)); }

  // Whether a node with such a key is final, and so are the nodes before it on its path, whose keys
  // can be slightly larger if a heuristic was rounded.
  bool is_final_key(const double key) const
  {
    constexpr double rounding = is_heuristic<Heuristic> ? 1e-12 : 0;
    return m_queue.is_final(key * (1 + rounding));
  }

  const Labels& m_labels;
  const Queue& m_queue;
  const Heuristic& m_heuristic;
  std::vector<Node> m_targets; // those that are not final
  std::vector<Arcs> m_points;  // those that are not final
  bool m_is_given;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_GOAL_H
