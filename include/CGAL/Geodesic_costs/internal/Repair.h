// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_REPAIR_H
#define CGAL_GEODESIC_COSTS_INTERNAL_REPAIR_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>
#include <CGAL/Geodesic_costs/Arc_changes.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Returns whether all changes are listed since there were so many.
template <typename Graph>
bool are_changes_known([[maybe_unused]] const Graph& graph,
                       [[maybe_unused]] const std::size_t number_before)
{
  if constexpr(boost::is_detected_v<Changes_of_arcs, Graph>)
    return graph.arc_changes().are_known_since(number_before);
  else
    return true;
}

/*
 * Prepares the labels of a search for another one, after arcs or seeds have changed.
 *
 * A label is kept if the path that it belongs to is not longer than before. Others are raised to
 * infinity: those of the nodes where such a path takes a changed arc, or starts from a seed that is
 * gone, and those of all nodes below them in the forest of predecessors. A child is in a group of
 * its predecessor, so it is found there.
 *
 * Then the labels that are left are upper bounds of the distances, as they are lengths of paths,
 * and only the arcs of some nodes can lower a label: of those that are in a group with a raised
 * node, or in one with arcs that have become shorter. A search from these nodes ends with the
 * smallest labels, whatever they were before.
 *
 * `Graph` is a graph with groups, or what stands for it.
 */
template <typename Graph>
class Repair final : public Kept_part
{
  using Node = Labels::Node;
  using Group = std::size_t;

public:
  // Raises the labels that other seeds, and the changes of arcs since there were `number_before`,
  // make invalid. All seeds have their distances in units of the graph. Returns false if so many
  // labels are invalid that a repair is not worthwhile. Memory is allocated at the first call.
  bool raise_labels(const Graph& graph,
                    Labels& labels,
                    const std::vector<Seed>& seeds_before,
                    std::vector<Seed> seeds,
                    [[maybe_unused]] const std::size_t number_before)
  {
    m_state.resize(graph.number_of_groups());
    m_is_marked.resize(labels.number_of_nodes());
    if(!replace_seeds(seeds_before, std::move(seeds), graph, labels))
      return false;
    if constexpr(boost::is_detected_v<Changes_of_arcs, Graph>)
      graph.arc_changes().for_each_since(
          number_before, [&](const Arc_changes::Change& change) { add(change, graph, labels); });
    return spread(graph, labels);
  }

  // Returns the nodes with labels whose arcs can lower others.
  const std::vector<Node>& border(const Graph& graph, const Labels& labels)
  {
    m_nodes.clear();
    for(const Group group : m_touched)
      graph.for_each_node_of_group(group, [&](const Node node) {
        if(labels.is_reached(node))
          mark(node);
      });
    unmark();
    return m_nodes;
  }

  // Removes nodes from the order of the labels: those that are not reached any more, and, if it has
  // grown long, repeated ones.
  void tidy(Labels& labels)
  {
    const bool has_repeated = labels.order().size() > 2 * labels.number_of_nodes();
    if(!has_repeated && std::all_of(m_raised.begin(), m_raised.end(),
                                    [&](const Node node) { return labels.is_reached(node); }))
      return;
    m_nodes.clear();
    auto& order = labels.order();
    order.erase(std::remove_if(order.begin(), order.end(),
                               [&](const Node node) {
                                 return !labels.is_reached(node) || (has_repeated && !mark(node));
                               }),
                order.end());
    unmark();
  }

  // Must be called at the end.
  void finish()
  {
    for(const Group group : m_touched)
      m_state[group] = 0;
    m_touched.clear();
    m_waiting.clear();
    m_raised.clear();
    m_number_raised = 0;
  }

  std::size_t memory() const override
  {
    return memory_of(m_state, m_is_marked, m_touched, m_waiting, m_raised, m_nodes);
  }

private:
  // A repair takes longer than a search if it raises more than about one in so many labels.
  static constexpr std::size_t LARGEST_PART = 2;

  static constexpr std::uint8_t IS_TOUCHED = 1, WAITS = 2; // states of groups

  // Raises what a change makes invalid, and lists the nodes that have shorter arcs.
  void add(const Arc_changes::Change& change, const Graph& graph, Labels& labels)
  {
    if(change.is_shorter)
      touch(change.group);
    if(!change.is_longer)
      return;
    m_nodes.clear();
    graph.for_each_node_of_group(change.group, [&](const Node node) { mark(node); });
    for(const Node node : m_nodes)
      if(labels.is_reached(node))
      {
        const Node predecessor = labels.predecessor(node);
        if(predecessor != Labels::null_node && m_is_marked[predecessor])
          m_raised.push_back(node);
      }
    unmark();
    for(; m_number_raised < m_raised.size(); ++m_number_raised)
      raise(m_raised[m_number_raised], graph, labels);
  }

  // Raises the seeds of the last search that are not among the new ones. Returns false if most are
  // gone.
  bool replace_seeds(const std::vector<Seed>& before,
                     std::vector<Seed> now,
                     const Graph& graph,
                     Labels& labels)
  {
    std::sort(now.begin(), now.end(), [](const Seed& a, const Seed& b) {
      return std::make_pair(a.node, a.distance) < std::make_pair(b.node, b.distance);
    });
    std::size_t number_of_roots = 0;
    for(const Seed& seed : before)
      if(is_root(seed.node, labels))
      {
        ++number_of_roots;
        if(!is_at_least_as_near(now, seed.node, labels.distance(seed.node)))
          m_raised.push_back(seed.node);
      }
    if(2 * (m_raised.size() - m_number_raised) > number_of_roots)
      return false;
    for(; m_number_raised < m_raised.size(); ++m_number_raised)
      raise(m_raised[m_number_raised], graph, labels);
    return true;
  }

  // Raises all nodes below those that were raised. Returns false if there are many.
  bool spread(const Graph& graph, Labels& labels)
  {
    const std::size_t most = labels.order().size() / LARGEST_PART;
    for(std::size_t i = 0; i < m_waiting.size(); ++i)
    {
      m_state[m_waiting[i]] &= ~WAITS;
      graph.for_each_node_of_group(m_waiting[i], [&](const Node node) {
        if(labels.is_reached(node) && labels.predecessor(node) != Labels::null_node &&
           !labels.is_reached(labels.predecessor(node)))
        {
          m_raised.push_back(node);
          raise(node, graph, labels);
        }
      });
      if(m_raised.size() > most)
        return false;
    }
    return true;
  }

  static bool is_root(const Node node, const Labels& labels)
  {
    return labels.is_reached(node) && labels.predecessor(node) == Labels::null_node;
  }

  // Whether seeds, which are sorted, are at `node` with at most this distance.
  static bool
  is_at_least_as_near(const std::vector<Seed>& seeds, const Node node, const double distance)
  {
    const auto seed =
        std::lower_bound(seeds.begin(), seeds.end(), node,
                         [](const Seed& s, const Node other) { return s.node < other; });
    return seed != seeds.end() && seed->node == node && seed->distance <= distance;
  }

  void raise(const Node node, const Graph& graph, Labels& labels)
  {
    labels.discard(node);
    graph.for_each_group(node, [this](const Group group) {
      touch(group);
      if((m_state[group] & WAITS) == 0)
      {
        m_state[group] |= WAITS;
        m_waiting.push_back(group);
      }
    });
  }

  void touch(const Group group)
  {
    if(m_state[group] == 0)
    {
      m_state[group] = IS_TOUCHED;
      m_touched.push_back(group);
    }
  }

  // Lists a node. Returns whether it was not.
  bool mark(const Node node)
  {
    if(m_is_marked[node])
      return false;
    m_is_marked[node] = true;
    m_nodes.push_back(node);
    return true;
  }

  void unmark()
  {
    for(const Node node : m_nodes)
      m_is_marked[node] = false;
  }

  std::vector<std::uint8_t> m_state; // per group
  std::vector<bool> m_is_marked;     // per node
  std::vector<Group> m_touched;      // groups with raised nodes or shorter arcs
  std::vector<Group> m_waiting;      // groups with raised nodes, for the children of these
  std::vector<Node> m_raised;
  std::size_t m_number_raised = 0; // of those in the list, by `add()` and `replace_seeds()`
  std::vector<Node> m_nodes;       // those that are marked
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_REPAIR_H
