// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PROPAGATION_H
#define CGAL_APPROXIMATE_GEODESICS_PROPAGATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Propagation_statistics.h>
#include <CGAL/Approximate_geodesics/internal/Labels.h>
#include <CGAL/Approximate_geodesics/internal/Nearest_sources.h>
#include <CGAL/Approximate_geodesics/internal/Progress_watch.h>
#include <CGAL/Approximate_geodesics/internal/counters.h>
#include <CGAL/Approximate_geodesics/internal/messages.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * Dijkstra's algorithm \cgalCite{d-ntpcg-59} on a geodesic graph, and the shortest-path tree that
 * it leaves: distance, predecessor and nearest source of every node that was reached.
 *
 * An object of this class is a workspace. It is made once and used for any number of runs, one
 * after the other; the cost of a run is proportional to what it reaches, not to the size of the
 * graph. One graph may be searched by several threads at the same time, each with a workspace of
 * its own.
 *
 * Distances are in the unit of the mesh and `double`. They are the minimum, over all paths in the
 * graph, of the lengths of the arcs added up from the source on; so they do not depend on the
 * queue. A distance beyond the largest `double` is given as infinity.
 *
 * If an exception leaves `run()`, thrown by a visitor or for want of memory, the object is as
 * if nothing had been reached, and may be used again.
 *
 * \tparam GeodesicGraph a model of `GeodesicGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 */
template <typename GeodesicGraph, typename PriorityQueue = Adaptive_bucket_queue>
class Propagation
{
public:
  /// \name Types
  /// @{

  /// the graph searched.
  using Graph = GeodesicGraph;

  /// the queue used.
  using Queue = PriorityQueue;

  /// the number of a node.
  using Node = typename Graph::Node;

  /// where a run starts: a node, its initial distance, and the index of the source it belongs to.
  struct Seed
  {
    /// the node.
    Node node;
    /// its initial distance, in the unit of the mesh: finite and not negative.
    double distance = 0;
    /// the index of its source: what `source()` returns for the nodes nearest to this seed.
    std::size_t source = 0;
  };

  /// when a run may end early.
  struct Stop_rule
  {
    /// nodes farther than this are not reached.
    double maximum_distance = std::numeric_limits<double>::infinity();
    /// the run ends as soon as all of these are settled, if there are any.
    std::vector<Node> targets = {};
  };

  /// @}

  /// what `predecessor()` returns if there is none.
  static constexpr Node null_node = internal::Labels::null_node;

  /// what `source()` returns if there is none.
  static constexpr std::size_t null_source = (std::numeric_limits<std::size_t>::max)();

  /// \name Creation
  /// @{

  /*!
   * makes a workspace for `graph`. Run time and memory are \cgalBigO{n} for `n` nodes.
   * \warning `graph` is referred to, not copied.
   */
  explicit Propagation(const Graph& graph)
    : m_graph(&graph),
      m_labels(graph.number_of_nodes()),
      m_queue(graph.number_of_nodes(), graph.arc_lengths())
  {
  }

  /// a workspace for a temporary graph would outlive it.
  explicit Propagation(const Graph&& graph) = delete;

  /// @}

  /// \name Runs
  /// @{

  /*!
   * forgets the last run, and finds the distance from the nearest of the seeds to all nodes that
   * the rule allows to be reached.
   *
   * When a run ends early, nodes whose distance is not certain yet count as not reached.
   *
   * \param seeds where to start; a node may occur more than once. Nothing is reached from none.
   * \param stop when the run may end early
   * \param visitor a model of `GeodesicVisitor` for vertices of type `Node`
   *
   * \throws std::invalid_argument if a node does not exist, or a seed's distance or the maximum
   *         distance is negative or not a number.
   *
   * Run time is \cgalBigO{m} in practice for `m` arcs of the nodes reached, times the cost of an
   * operation of the queue.
   */
  template <typename Visitor = Geodesic_visitor_base>
  void run(const std::vector<Seed>& seeds, const Stop_rule& stop, Visitor&& visitor = Visitor())
  {
    check(seeds, stop);
    try
    {
      prepare(seeds, stop);
      if(m_counts)
        count_and_run(stop, visitor);
      else if(stop.targets.empty() && internal::is_idle_visitor<Visitor>)
        propagate(stop, internal::No_watch(), internal::No_counter());
      else
        propagate(stop, watch(stop, visitor), internal::No_counter());
      m_sources.forget_all(); // a visitor may have asked, too early
    }
    catch(...)
    {
      m_sources.forget_all();
      m_labels.forget_all();
      throw;
    }
  }

  /// finds the distances from the nearest of the seeds to all nodes.
  void run(const std::vector<Seed>& seeds) { run(seeds, Stop_rule()); }

  /// finds the distances from `node` to all nodes.
  template <typename Integer>
  std::enable_if_t<std::is_integral_v<Integer>> run(const Integer node)
  {
    run(std::vector<Seed>{Seed{static_cast<Node>(node)}});
  }

  /// says whether the runs to come shall count what they do; this makes them a bit slower.
  void collect_statistics(const bool counts) { m_counts = counts; }

  /// @}

  /// \name Results of the Last Run
  /// @{

  /// returns the distance to `node`, or infinity if it was not reached.
  double distance(const Node node) const
  {
    return m_labels.distance(node) * m_graph->triangulation().unit();
  }

  /// returns whether `node` was reached.
  bool is_reached(const Node node) const { return m_labels.is_reached(node); }

  /// returns the node before `node` on a shortest path to it, or `null_node` if the path starts
  /// with `node`, or it was not reached.
  Node predecessor(const Node node) const
  {
    return is_reached(node) ? m_labels.predecessor(node) : null_node;
  }

  /// returns the index of the source nearest to `node`, or `null_source` if it was not reached.
  /// Run time is \cgalBigO{1}, amortized over the nodes that were reached.
  std::size_t source(const Node node) const { return m_sources.source(node, m_labels, m_seeds); }

  /// returns the nodes that were reached, in the order in which they were first expanded or, if
  /// the run was watched by a visitor, of their distances. Nodes may occur more than once.
  const std::vector<Node>& reached_nodes() const { return m_labels.order(); }

  /// returns the figures of the last run, if it was asked to count.
  const Propagation_statistics& statistics() const { return m_statistics; }

  /// returns the queue, which has figures of its own.
  const Queue& queue() const { return m_queue; }

  /// @}

  /// returns the graph.
  const Graph& graph() const { return *m_graph; }

  /// returns the number of bytes that the workspace takes.
  std::size_t memory() const
  {
    return m_labels.memory() + m_queue.memory() + m_sources.memory() +
           m_seeds.capacity() * sizeof(Seed);
  }

private:
  static constexpr std::size_t PREFETCH_DISTANCE = 4; // 2 to 8 make no difference, 0 costs 15 %

  void check(const std::vector<Seed>& seeds, const Stop_rule& stop) const
  {
    for(const Seed& seed : seeds)
    {
      check(seed.node, "source");
      const double distance = to_graph_unit(seed.distance); // overflows if the mesh is tiny
      if(!(distance >= 0) || std::isinf(distance))
        internal::reject("the distance that source node " + std::to_string(seed.node) +
                         " starts with is " + internal::text_of(seed.distance) +
                         "; it must be a finite number that is not negative, nor out of proportion "
                         "to the mesh");
    }
    for(const Node target : stop.targets)
      check(target, "target");
    if(!(stop.maximum_distance >= 0))
      internal::reject("the maximum distance is " + internal::text_of(stop.maximum_distance) +
                       "; it must be a number that is not negative");
  }

  void check(const Node node, const char* role) const
  {
    if(node >= m_graph->number_of_nodes())
      internal::reject(std::string(role) + " node " + std::to_string(node) +
                       " does not exist: there are " + std::to_string(m_graph->number_of_nodes()) +
                       " nodes");
  }

  double to_graph_unit(const double distance) const
  {
    return distance / m_graph->triangulation().unit();
  }

  void prepare(const std::vector<Seed>& seeds, const Stop_rule& stop)
  {
    m_sources.forget(m_labels);
    m_labels.forget();
    m_queue.clear();
    m_statistics = Propagation_statistics();
    m_seeds = seeds;

    const double limit = to_graph_unit(stop.maximum_distance);
    for(Seed& seed : m_seeds)
    {
      seed.distance = to_graph_unit(seed.distance);
      if(seed.distance < m_labels.distance(seed.node) && seed.distance <= limit)
      {
        m_labels.set(seed.node, seed.distance, null_node);
        m_queue.push(seed.node, seed.distance);
      }
    }
  }

  template <typename Visitor>
  auto watch(const Stop_rule& stop, Visitor& visitor)
  {
    return internal::Progress_watch<Graph, Queue, Visitor>(*m_graph, m_labels, m_queue,
                                                           stop.targets, visitor);
  }

  template <typename Visitor>
  void count_and_run(const Stop_rule& stop, Visitor& visitor)
  {
    propagate(stop, watch(stop, visitor), internal::Counter{m_statistics});
    m_statistics.settled_nodes = m_labels.order().size(); // a watched order has no repetitions
  }

  // The algorithm. A node comes out of the queue with the key it was entered with; if its distance
  // is smaller by then, it has been expanded with that one, or will be.
  template <typename Watch, typename Counter>
  void propagate(const Stop_rule& stop, Watch watch, Counter counter)
  {
    const double limit = to_graph_unit(stop.maximum_distance);
    while(!m_queue.is_empty())
    {
      prefetch();
      const auto [key, node] = m_queue.extract_min();
      const double distance = m_labels.distance(node);
      if(distance < key)
      {
        counter.on_stale_pop();
        continue;
      }
      m_labels.append_to_order(node);
      if(!watch.go_further())
        return discard_uncertain();
      counter.on_expansion();
      expand(node, distance, limit, counter);
    }
    watch.finish();
  }

  template <typename Counter>
  void expand(const Node node, const double distance, const double limit, Counter& counter)
  {
    const double* const distances = m_labels.distances(); // kept in a register
    m_graph->for_each_arc(node, m_labels, [&, distances](const Node target, const double length) {
      counter.on_relaxation();
      const double candidate = distance + length;
      if(candidate < distances[target] && candidate <= limit)
      {
        counter.on_improvement();
        m_labels.set(target, candidate, node);
        m_queue.push(target, candidate);
      }
    });
  }

  void prefetch() const
  {
    const Node soon = m_queue.upcoming(PREFETCH_DISTANCE);
    if(soon != Queue::no_node)
      m_graph->prefetch(soon);
  }

  // The run ends before the queue is empty: what is still in it, or came out last, is not final.
  void discard_uncertain()
  {
    m_labels.discard_last_of_order();
    m_queue.for_each_node([this](const Node node) {
      if(m_labels.is_reached(node) && !m_queue.is_final(m_labels.distance(node)))
        m_labels.discard(node);
    });
  }

  const Graph* m_graph;
  internal::Labels m_labels;
  Queue m_queue;
  mutable internal::Nearest_sources<Seed> m_sources; // found when first asked for
  std::vector<Seed> m_seeds; // of the last run, distances in units of the graph
  Propagation_statistics m_statistics;
  bool m_counts = false;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PROPAGATION_H
