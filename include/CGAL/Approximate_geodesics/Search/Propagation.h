// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_statistics.h>
#include <CGAL/Approximate_geodesics/Search/internal/Goal.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/Nearest_sources.h>
#include <CGAL/Approximate_geodesics/Search/internal/Progress_watch.h>
#include <CGAL/Approximate_geodesics/Search/internal/counters.h>
#include <CGAL/Approximate_geodesics/Search/internal/has_maximum_degree.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>
#include <CGAL/assertions.h>

#include <algorithm>
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

  /// an arc from a node to a place that is not a node.
  struct Last_arc
  {
    /// the node.
    Node node;
    /// the length of the arc, in the unit of the mesh: not negative.
    double length;
  };

  /// when a run may end early.
  struct Stop_rule
  {
    /// nodes farther than this are not reached.
    double maximum_distance = std::numeric_limits<double>::infinity();
    /// the run ends as soon as all of these are settled, if there are any, ...
    std::vector<Node> targets = {};
    /// ... and the distances of all these places are certain, too. A place is given by the arcs
    /// that lead there.
    std::vector<std::vector<Last_arc>> places = {};
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
    forget();
    search(seeds, stop, visitor, internal::No_heuristic());
  }

  /// finds the distances from the nearest of the seeds to all nodes.
  void run(const std::vector<Seed>& seeds) { run(seeds, Stop_rule()); }

  /// finds the distances from `node` to all nodes.
  template <typename Integer>
  std::enable_if_t<std::is_integral_v<Integer>> run(const Integer node)
  {
    run(std::vector<Seed>{Seed{static_cast<Node>(node)}});
  }

  /*!
   * does the same in another order, which leads to a goal: nodes from where the rest of the way is
   * short come first. This is the A* algorithm \cgalCite{hnr-fbhdm-68}. If the run ends early, it
   * has reached fewer nodes than another one would; distances of others than the goal and the nodes
   * on the path there are then not certain.
   *
   * \param seeds where to start
   * \param stop when the run may end early
   * \param estimate a function object: `estimate(node)` is a lower bound of the distance from
   *        `node` to the goal, in units of the graph, and not more than the length of an arc from
   *        `node` and the estimate at its end together, but for rounding. The goal is the target,
   *        or the place.
   */
  template <typename Estimate>
  void run_toward(const std::vector<Seed>& seeds, const Stop_rule& stop, const Estimate& estimate)
  {
    check(seeds, stop);
    forget();
    search(seeds, stop, Geodesic_visitor_base(), estimate);
    if(reopens_too_often())
    {
      forget();
      search(seeds, stop, Geodesic_visitor_base(), internal::No_heuristic());
    }
  }

  /*!
   * adds seeds to those of the last run, and lowers the distances of the nodes that are nearer to
   * the new ones. Results are those of a run from all seeds; but only the nodes whose distances
   * fall are expanded, which `reached_nodes()` then has again.
   *
   * \pre The last run did not end early.
   *
   * \throws std::invalid_argument as `run()` does.
   */
  void run_further(const std::vector<Seed>& seeds)
  {
    check(seeds, Stop_rule());
    m_sources.forget(m_labels);
    search(seeds, Stop_rule(), Geodesic_visitor_base(), internal::No_heuristic());
  }

  /// says whether the runs to come shall count what they do; this makes them a bit slower.
  void collect_statistics(const bool counts) { m_counts = counts; }

  /// returns whether they shall.
  bool collects_statistics() const { return m_counts; }

  /// @}

  /// \name Results of the Last Run
  /// @{

  /// returns the distance to `node`, or infinity if it was not reached.
  double distance(const Node node) const { return m_labels.distance(node) * m_graph->unit(); }

  /// returns whether all nodes nearer than `distance` were reached: always, unless the run ended
  /// early.
  bool is_certain(const double distance) const
  {
    // the next smaller number, as a distance may have been rounded up to this one
    return !m_ended_early || m_queue.is_final(to_graph_unit(std::nextafter(distance, 0.)));
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
           m_seeds.capacity() * sizeof(Seed) + m_candidates.capacity() * sizeof(Candidate);
  }

private:
  // A path that ends with an arc just looked at.
  struct Candidate
  {
    double distance;
    Node node;
    Node predecessor;
  };

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
    for(const std::vector<Last_arc>& arcs : stop.places)
      for(const Last_arc& arc : arcs)
        check(arc.node, "target");
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

  double to_graph_unit(const double distance) const { return distance / m_graph->unit(); }

  void forget()
  {
    m_sources.forget(m_labels);
    m_labels.forget();
    m_seeds.clear();
  }

  template <typename Visitor, typename Estimate>
  void search(const std::vector<Seed>& seeds,
              const Stop_rule& stop,
              Visitor&& visitor,
              const Estimate& estimate)
  {
    try
    {
      prepare(seeds, stop, estimate);
      if(m_counts)
        count_and_propagate(stop, visitor, estimate);
      else if(!internal::is_idle_visitor<Visitor>)
        propagate(stop, watch(stop, visitor, estimate), estimate, internal::No_counter());
      else if(!stop.targets.empty() || !stop.places.empty())
        propagate(stop, internal::Goal_watch(m_labels, goal(stop, estimate)), estimate,
                  internal::No_counter());
      else
        propagate(stop, internal::No_watch(), estimate, internal::No_counter());
      m_sources.forget_all(); // a visitor may have asked, too early
    }
    catch(...)
    {
      m_sources.forget_all();
      m_labels.forget_all();
      m_seeds.clear();
      throw;
    }
  }

  template <typename Estimate>
  void prepare(const std::vector<Seed>& seeds, const Stop_rule& stop, const Estimate& estimate)
  {
    m_queue.clear();
    m_statistics = Propagation_statistics();
    m_ended_early = false;
    const double limit = to_graph_unit(stop.maximum_distance);
    for(Seed seed : seeds)
    {
      seed.distance = to_graph_unit(seed.distance);
      m_seeds.push_back(seed);
      if(seed.distance < m_labels.distance(seed.node) && seed.distance <= limit)
      {
        m_labels.set(seed.node, seed.distance, null_node);
        m_queue.push(seed.node, seed.distance + estimate(seed.node));
      }
    }
  }

  template <typename Estimate>
  auto goal(const Stop_rule& stop, const Estimate& estimate) const
  {
    std::vector<std::vector<Last_arc>> places = stop.places;
    for(std::vector<Last_arc>& arcs : places)
      for(Last_arc& arc : arcs)
        arc.length = to_graph_unit(arc.length);
    return internal::Goal<Queue, Estimate, Last_arc>(m_labels, m_queue, estimate, stop.targets,
                                                     std::move(places));
  }

  template <typename Visitor, typename Estimate>
  auto watch(const Stop_rule& stop, Visitor& visitor, const Estimate& estimate)
  {
    using Goal = decltype(goal(stop, estimate));
    return internal::Progress_watch<Graph, Goal, Visitor>(*m_graph, m_labels, goal(stop, estimate),
                                                          visitor);
  }

  template <typename Visitor, typename Estimate>
  void count_and_propagate(const Stop_rule& stop, Visitor& visitor, const Estimate& estimate)
  {
    propagate(stop, watch(stop, visitor, estimate), estimate, internal::Counter{m_statistics});
    m_statistics.settled_nodes = m_labels.order().size(); // a watched order has no repetitions
    if constexpr(internal::counts_comparisons<Queue>)
      m_statistics.queue_comparisons =
          m_queue.statistics().visited_buckets + m_queue.statistics().comparisons;
  }

  // The algorithm. A batch of entries is worked through in three loops, the longest of which has no
  // branch that depends on a distance. Such branches are hard to predict, and in one loop most of
  // the time would go into wrong predictions.
  template <typename Watch, typename Estimate, typename Counter>
  void propagate(const Stop_rule& stop, Watch watch, const Estimate& estimate, Counter counter)
  {
    const double limit = to_graph_unit(stop.maximum_distance);
    while(!m_queue.is_empty() && !(internal::is_heuristic<Estimate> && reopens_too_often()))
    {
      const std::size_t size = append_to_order(m_queue.extract_min(), estimate, counter);
      if(!watch.go_further(size))
        return discard_uncertain(size, estimate);
      find_candidates(size, counter);
      take_candidates(limit, estimate, counter);
    }
    watch.finish();
  }

  // Whether nodes are expanded again and again. An estimate can bring that about: beside it, very
  // short arcs vanish by rounding, so that keys do not order their nodes any more.
  bool reopens_too_often() const
  {
    constexpr std::size_t most_expansions_per_node = 3;
    return m_labels.order().size() / most_expansions_per_node > m_graph->number_of_nodes();
  }

  // An entry whose node has got a smaller distance since has been expanded with that, or will be.
  // Returns the number of the others, whose nodes are now the last of the order.
  template <typename Estimate, typename Counter>
  std::size_t
  append_to_order(const typename Queue::Batch& batch, const Estimate& estimate, Counter& counter)
  {
    auto& order = m_labels.order();
    const std::size_t first = order.size();
    order.resize(first + batch.size());
    Node* end = order.data() + first;
    if constexpr(internal::is_heuristic<Estimate>)
      m_smallest_key = std::numeric_limits<double>::infinity();
    for(const auto& [key, node] : batch)
    {
      if constexpr(internal::is_heuristic<Estimate>)
        m_smallest_key = (std::min)(m_smallest_key, key);
      m_graph->prefetch(node);
      *end = node;
      const bool is_stale = internal::is_larger(key, m_labels.distance(node), node, estimate);
      end += static_cast<std::ptrdiff_t>(!is_stale);
      counter.on_stale_pops(is_stale ? 1 : 0);
    }
    order.resize(static_cast<std::size_t>(end - order.data()));
    return order.size() - first;
  }

  // Looks at the arcs of the last so many nodes of the order. Every arc is noted down; if it does
  // not lead to a shorter path, the next one overwrites it.
  template <typename Counter>
  void find_candidates(const std::size_t number_of_nodes, Counter& counter)
  {
    const auto& order = m_labels.order();
    const double* const distances = m_labels.distances(); // kept in a register
    m_number_of_candidates = 0;
    for(std::size_t i = order.size() - number_of_nodes; i < order.size(); ++i)
    {
      counter.on_expansion();
      const Node node = order[i];
      const double distance = distances[node];
      Candidate* end = end_of_candidates();
      m_graph->for_each_arc(node, m_labels,
                            Arc_visitor<Counter>{*this, distances, distance, node, end, counter});
      m_number_of_candidates = static_cast<std::size_t>(end - m_candidates.data());
      if constexpr(!internal::has_maximum_degree<Graph>)
        m_labels.set_expanded(node);
    }
  }

  // Notes down where the arcs of a node lead.
  template <typename Counter>
  struct Arc_visitor
  {
    void operator()(const Node target, const double length) const
    {
      if constexpr(!internal::has_maximum_degree<Graph>)
        end = propagation.with_room_at(end);
      end = append(end, target, length);
    }

    // arcs to consecutive nodes
    void operator()(const Node first, const double* const lengths, const std::size_t number) const
    {
      if constexpr(!internal::has_maximum_degree<Graph>)
        for(std::size_t i = 0; i < number; ++i)
          (*this)(first + static_cast<Node>(i), lengths[i]);
      else
      {
        Candidate* beyond = end; // kept in a register
        for(std::size_t i = 0; i < number; ++i)
          beyond = append(beyond, first + static_cast<Node>(i), lengths[i]);
        end = beyond;
      }
    }

    Candidate* append(Candidate* const place, const Node target, const double length) const
    {
      counter.on_relaxation();
      CGAL_assertion(place < propagation.m_candidates.data() + propagation.m_candidates.size());
      *place = {distance + length, target, node};
      return place + static_cast<std::ptrdiff_t>(place->distance < distances[target]);
    }

    Propagation& propagation;
    const double* distances; // labels
    double distance;
    Node node;
    Candidate*& end;
    Counter& counter;
  };

  // Returns where the next candidates go. There is room for those of a node, if the graph says how
  // many these may be.
  Candidate* end_of_candidates()
  {
    std::size_t room = 1;
    if constexpr(internal::has_maximum_degree<Graph>)
      room = m_graph->maximum_degree();
    if(m_candidates.size() < m_number_of_candidates + room)
      m_candidates.resize(2 * (m_number_of_candidates + room));
    return m_candidates.data() + m_number_of_candidates;
  }

  // Makes room for one more, which may move those that are there.
  Candidate* with_room_at(const Candidate* end)
  {
    m_number_of_candidates = static_cast<std::size_t>(end - m_candidates.data());
    return end_of_candidates();
  }

  template <typename Estimate, typename Counter>
  void take_candidates(const double limit, const Estimate& estimate, Counter& counter)
  {
    for(std::size_t i = 0; i < m_number_of_candidates; ++i)
    {
      const Candidate c = m_candidates[i];
      if(c.distance < m_labels.distance(c.node) && c.distance <= limit) // still, after the earlier
      {
        counter.on_improvement();
        m_labels.set(c.node, c.distance, c.predecessor);
        m_queue.push(c.node, key(c, estimate));
      }
    }
  }

  // An estimate falls along an arc by no more than the length of that, but for rounding; and keys
  // must not fall.
  template <typename Estimate>
  double key(const Candidate& c, const Estimate& estimate) const
  {
    if constexpr(internal::is_heuristic<Estimate>)
      return (std::max)(c.distance + estimate(c.node), m_smallest_key);
    else
      return c.distance;
  }

  // The run ends before the queue is empty: what is still in it, or came out last, is not final. If
  // the run was led to its goal, nothing else is asked for, and the path there may have nodes whose
  // keys were rounded up and are still in the queue; so everything stays.
  template <typename Estimate>
  void discard_uncertain(const std::size_t size_of_batch, const Estimate& /* estimate */)
  {
    m_ended_early = true;
    if constexpr(internal::is_heuristic<Estimate>)
      m_queue.for_each_node([this](const Node node) { m_labels.order().push_back(node); });
    else
    {
      m_labels.discard_last_of_order(size_of_batch);
      m_queue.for_each_node([this](const Node node) {
        if(m_labels.is_reached(node) && !m_queue.is_final(m_labels.distance(node)))
          m_labels.discard(node);
      });
    }
  }

  const Graph* m_graph;
  internal::Labels m_labels;
  Queue m_queue;
  std::vector<Candidate> m_candidates; // of the current batch
  std::size_t m_number_of_candidates = 0;
  mutable internal::Nearest_sources<Seed> m_sources; // found when first asked for
  std::vector<Seed> m_seeds; // of the last run, distances in units of the graph
  double m_smallest_key = 0; // of the current batch, if there is an estimate
  Propagation_statistics m_statistics;
  bool m_counts = false;
  bool m_ended_early = false;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H
