// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BOUNDED_LABELS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BOUNDED_LABELS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Labels for graphs that find their arcs with the help of upper bounds: for each node, a number
 * that its distance does not exceed, or above which the distance is of no interest, and how the
 * path arrives that the label stands for.
 */
template <typename Arrival>
class Bounded_labels : public Labels
{
public:
  explicit Bounded_labels(const std::size_t number_of_nodes)
    : Labels(number_of_nodes), m_bound(number_of_nodes, infinity), m_arrival(number_of_nodes)
  {
  }

  double bound(const Node node) const { return m_bound[node]; }

  // of a node that was reached
  const Arrival& arrival(const Node node) const { return m_arrival[node]; }

  // To be called after `set()`.
  void set_arrival(const Node node, const Arrival& arrival)
  {
    m_arrival[node] = arrival;
    m_bound[node] = (std::min)(m_bound[node], distance(node));
  }

  // Makes upper bounds of the labels of the nodes in the order from `first` on, and takes the
  // labels back. No path to the goal is of interest that is longer than `limit`.
  template <typename Heuristic>
  void
  turn_into_bounds(const std::size_t first, const double limit, const Heuristic& distance_to_goal)
  {
    for(std::size_t i = first; i < order().size(); ++i)
    {
      const Node node = order()[i];
      if(!is_reached(node)) // it occurs twice
        continue;
      m_bound[node] = (std::min)({m_bound[node], distance(node), limit - distance_to_goal(node)});
      m_bounded.push_back(node);
      Labels::discard(node);
    }
    order().resize(first);
  }

  // Calls `f(node)` for nodes that have a bound below `limit`, and no label, or one above it.
  template <typename F>
  void for_each_lost_node(const double limit, F f) const
  {
    constexpr double factor = 1 + 1e-12; // for rounding
    for(const Node node : m_bounded)
      if(distance(node) > m_bound[node] * factor && m_bound[node] < limit)
        f(node);
  }

  // Lowers the labels of all nodes that paths over these nodes lead to by as much as theirs were,
  // as the lines to them are the same, and appends these nodes. Takes time in proportion to the
  // number of all nodes times the number of arcs on the longest of these paths.
  void lower_successors(std::vector<std::pair<Node, double>>& lowered)
  {
    std::vector<double> difference(number_of_nodes(), 0);
    for(const auto& [node, by] : lowered)
      if(by < infinity)
        difference[node] = by;
    for(bool goes_on = true; goes_on;)
    {
      goes_on = false;
      for(const Node node : m_bounded)
      {
        if(!is_reached(node) || predecessor(node) == null_node || difference[node] > 0)
          continue;
        const double by = difference[predecessor(node)];
        if(!(by > 0 && distance(node) - by >= distance(predecessor(node))))
          continue;
        set(node, distance(node) - by, predecessor(node));
        difference[node] = by;
        lowered.emplace_back(node, by);
        goes_on = true;
      }
    }
  }

  void discard(const Node node)
  {
    Labels::discard(node);
    m_bound[node] = infinity;
  }

  void discard_last_of_order(std::size_t number)
  {
    for(; number > 0; --number)
    {
      discard(order().back());
      order().pop_back();
    }
  }

  void forget()
  {
    if(order().size() + m_bounded.size() > number_of_nodes() / 4) // streaming beats jumping
      return forget_all();
    for(const std::vector<Node>* nodes : {&order(), &m_bounded})
      for(const Node node : *nodes)
        discard(node);
    order().clear();
    m_bounded.clear();
  }

  void forget_all()
  {
    Labels::forget_all();
    std::fill(m_bound.begin(), m_bound.end(), infinity);
    m_bounded.clear();
  }

  std::size_t memory() const
  {
    return Labels::memory() + m_bound.capacity() * sizeof(double) +
           m_arrival.capacity() * sizeof(Arrival) + m_bounded.capacity() * sizeof(Node);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<double> m_bound;
  std::vector<Arrival> m_arrival; // meaningful where the distance is finite
  std::vector<Node> m_bounded;    // those whose bounds were found before their labels
};

// The seeds of a run are those that it is given.
struct Same_seeds
{
};

// The labels of a search as a graph that needs bounds sees them.
template <typename Labels, typename Heuristic>
class Limited_labels
{
  using Node = internal::Labels::Node;

public:
  Limited_labels(const Labels& labels, const double limit, const Heuristic& distance_to_goal)
    : m_labels(labels), m_limit(limit), m_distance_to_goal(distance_to_goal)
  {
  }

  std::size_t number_of_nodes() const { return m_labels.number_of_nodes(); }
  double distance(const Node node) const { return m_labels.distance(node); }
  bool is_reached(const Node node) const { return m_labels.is_reached(node); }
  Node predecessor(const Node node) const { return m_labels.predecessor(node); }
  const auto& arrival(const Node node) const { return m_labels.arrival(node); }

  double bound(const Node node) const
  {
    const double result = m_labels.bound(node);
    return result < std::numeric_limits<double>::infinity() ? result
                                                            : m_limit - m_distance_to_goal(node);
  }

private:
  const Labels& m_labels;
  const double m_limit;
  const Heuristic& m_distance_to_goal;
};

template <typename Graph>
using Labels_of =
    std::conditional_t<needs_bounds<Graph>, Bounded_labels<Arrival_of<Graph>>, Labels>;

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BOUNDED_LABELS_H
