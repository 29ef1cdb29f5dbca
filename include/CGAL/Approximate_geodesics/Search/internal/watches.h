// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_WATCHES_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_WATCHES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/concept_checks.h>

#include <boost/type_traits/detected_or.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
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

// Sorts a part of the order by distance, with each node once. Returns where it ends then.
inline std::size_t sort_order(Labels& labels, const std::size_t first, const std::size_t end)
{
  auto& order = labels.order();
  const auto position = [&](const std::size_t i) {
    return order.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::sort(position(first), position(end), [&](const Labels::Node a, const Labels::Node b) {
    return std::make_pair(labels.distance(a), a) < std::make_pair(labels.distance(b), b);
  });
  const auto repetitions = std::unique(position(first), position(end));
  const auto number = static_cast<std::size_t>(position(end) - repetitions);
  order.erase(repetitions, position(end));
  return end - number;
}

template <typename Visitor>
constexpr bool is_idle_visitor = std::is_same_v<std::decay_t<Visitor>, Geodesic_visitor_base>;

template <typename Visitor>
using Is_told_of_nodes = std::bool_constant<std::decay_t<Visitor>::is_told_of_nodes>;

// Whether a visitor is told of nodes, which have to be sorted for that.
template <typename Visitor>
constexpr bool is_told_of_nodes =
    !is_idle_visitor<Visitor> &&
    boost::detected_or_t<std::true_type, Is_told_of_nodes, Visitor>::value;

/*
 * Follows a run, between the loops that work through a batch of entries: tells the visitor of nodes
 * as soon as they are final, and ends the run when its goal is met or the visitor ends it.
 *
 * The nodes expanded since the last time become final all at once: as soon as the queue goes on to
 * larger keys. So it is enough to ask for the first of them.
 */
template <typename Goal, typename Visitor>
class Watch
{
public:
  // Distances that the visitor is told are in units of the graph times `unit`. The order is sorted,
  // with each node once, if it is to be counted.
  Watch(Labels& labels, Goal goal, Visitor& visitor, const double unit, const bool counts)
    : m_labels(labels),
      m_goal(std::move(goal)),
      m_visitor(visitor),
      m_unit(unit),
      m_sorts(counts || is_told_of_nodes<Visitor>),
      m_is_needed(m_goal.is_given() || m_sorts || !is_idle_visitor<Visitor>)
  {
  }

  // To be called after so many nodes were appended to the order. Returns whether these shall be
  // expanded, or else the run ends.
  bool go_further(const std::size_t number_appended)
  {
    if(!m_is_needed)
      return true;
    const std::size_t number_of_earlier = m_labels.order().size() - number_appended;
    if(m_number_final == number_of_earlier || !m_goal.is_final(m_labels.order()[m_number_final]))
      return true;
    settle(number_of_earlier);
    return !m_goal.is_met() && m_visitor.go_further();
  }

  // To be called when the queue is empty.
  void finish() { settle(m_labels.order().size()); }

private:
  // The nodes of the order up to `end` are final.
  void settle(const std::size_t end)
  {
    [[maybe_unused]] std::size_t i = m_number_final;
    m_number_final = m_sorts ? sort_order(m_labels, m_number_final, end) : end;
    if constexpr(is_told_of_nodes<Visitor>)
      for(; i < m_number_final; ++i)
      {
        const Labels::Node node = m_labels.order()[i];
        m_visitor.on_settled(node, m_labels.distance(node) * m_unit);
      }
    m_visitor.on_progress(m_number_final, m_labels.number_of_nodes());
  }

  Labels& m_labels;
  Goal m_goal;
  Visitor& m_visitor;
  double m_unit;
  bool m_sorts;
  bool m_is_needed;
  std::size_t m_number_final = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_WATCHES_H
