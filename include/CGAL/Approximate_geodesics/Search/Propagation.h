// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/Batch_relaxation.h>
#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*
 * The algorithm
 *
 * Dijkstra's algorithm [1] labels each node with the length of the shortest path found so far, and
 * extracts nodes from a priority queue, smallest label first. It expands each of them: it relaxes
 * all arcs from the node, that is, it lowers the labels of their targets where the path along the
 * arc is shorter. This search works in batches. The queue returns several entries with small keys
 * at a time, in any order [2], and three loops process them (`Batch_relaxation.h`):
 *
 * 1. Prefetch the arcs of the nodes, and skip stale entries: their nodes have smaller labels by
 *    now, and were or will be expanded with these.
 * 2. Scan the arcs of these nodes. The path along each arc is written to the end of a list of
 *    candidates; the end advances only if the path is shorter than the label.
 * 3. Process the candidates: lower labels, and push nodes to the queue. An earlier candidate may
 *    have made a later one useless, but few are.
 *
 * Whether an entry is stale, and whether an arc shortens a path, is unpredictable on a mesh. In a
 * single loop, a processor spends most of its time on mispredicted branches; the first two of these
 * loops have no branch that depends on a label.
 *
 * The second loop is a member function of the graph's `Run`, if it has one, which may process
 * several nodes together or in parallel, and may request larger batches.
 *
 * A node whose label decreases after its expansion is pushed again. So any order leads to the same
 * labels: the smallest sum of arc lengths from a source, over all paths, summed in the order of the
 * path. Rounding is monotone, so labels are bitwise identical. A good order saves repeated
 * expansions.
 *
 * A label is final when it is smaller than all present and future keys of the queue, which the
 * queue determines. Between the first and the second loop, a watch may report final nodes to a
 * visitor, and may stop the run, at targets or on request of the visitor. Labels that are not final
 * are then reset.
 *
 * Some graphs need upper bounds of all distances to find their arcs. Their `Run` requests a search
 * of another graph, which finds these bounds and, if there is a goal, a limit for the second one.
 *
 * With a heuristic, this is the A* algorithm [3]: the key of a node is its label plus a lower bound
 * on the distance from there to the goal.
 *
 * [1] E. W. Dijkstra. A note on two problems in connexion with graphs. 1959.
 * [2] E. V. Denardo, B. L. Fox. Shortest-route methods: 1. Reaching, pruning, and buckets. 1979.
 * [3] P. E. Hart, N. J. Nilsson, B. Raphael. A formal basis for the heuristic determination of
 *     minimum cost paths. 1968.
 */

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * Dijkstra's algorithm \cgalCite{d-ntpcg-59} on a geodesic graph, and the shortest-path tree that
 * it finds: distance, predecessor and nearest source of every node that was reached.
 *
 * An object of this class is a workspace. It is made once and used for any number of runs, one
 * after the other; the cost of a run is proportional to what it reaches, not to the size of the
 * graph. Several threads may search one graph at the same time, each with a workspace of its own.
 * Member functions that are `const` only read, with two exceptions: `source()`, and where arcs cost
 * nothing, `predecessor()`.
 *
 * Distances are `double`, in the unit of the mesh. Each is the minimum, over all paths in the
 * graph, of the arc lengths added up from the source on, and so does not depend on the queue. A
 * distance beyond the largest `double` is given as infinity.
 *
 * If an exception leaves `run()`, thrown by a visitor or because memory is exhausted, nothing
 * counts as reached, and the object may be used again. Objects can be moved, but not copied.
 *
 * \tparam GeodesicGraph a model of `GeodesicGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 */
template <typename GeodesicGraph, typename PriorityQueue = Adaptive_bucket_queue>
class Propagation
{
  static_assert(internal::Check_graph<GeodesicGraph>::is_done);
  static_assert(internal::Check_queue<PriorityQueue>::is_done);
  static_assert(!internal::tells_free_arcs<GeodesicGraph> ||
                    internal::is_defined<internal::Free_ways<GeodesicGraph>>,
                "has_free_arcs() of the graph: include <CGAL/Geodesic_costs.h>");

public:
  /// \name Types
  /// @{

  /// the graph searched.
  using Graph = GeodesicGraph;

  /// the queue used.
  using Queue = PriorityQueue;

  /// the number of a node: `std::uint32_t`.
  using Node = internal::Labels::Node;

  /// where a run starts.
  using Seed = Approximate_geodesics::Seed;

  /// an arc from a node to a point.
  using Last_arc = Approximate_geodesics::Last_arc;

  /// when a run may end early.
  using Stop_rule = Approximate_geodesics::Stop_rule;

  /// what the graph needs for a search: its `Run`, or `Geodesic_run_base`.
  using Run = internal::Run_of<Graph>;

  /// a seed, and the data that the graph's `Run` stores about the line to it.
  struct Entry
  {
    Seed seed;                     ///< the seed.
    typename Run::Payload payload; ///< the data.
  };

  /// finds the seeds with the help of the graph's `Run`, after it has started. If it is empty, the
  /// given seeds are entered; otherwise they only serve to find upper bounds of distances.
  using Find_entries = std::function<std::vector<Entry>()>;

  /// @}

  /// what `predecessor()` returns if there is none.
  static constexpr Node null_node = internal::Labels::null_node;

  /// what `source()` returns if there is none.
  static constexpr std::size_t null_source = internal::Nearest_sources::null_source;

  /// \name Creation
  /// @{

  /*!
   * makes a workspace for `graph`. Run time and memory are \cgalBigO{n} for `n` nodes.
   * \warning `graph` is referred to, not copied.
   */
  explicit Propagation(const Graph& graph)
    : m_graph(&graph),
      m_run(graph),
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
   * If a run ends early, nodes whose distance is not final count as not reached.
   *
   * \param seeds where to start; a node may occur more than once. Without seeds, nothing is
   *              reached.
   * \param stop when the run may end early
   * \param visitor a model of `GeodesicVisitor` for vertices of type `Node`
   * \param find_entries finds the seeds, for lines that are found from upper bounds
   *
   * \throws std::invalid_argument if a node does not exist, or if the distance of a seed or the
   *         maximum distance is negative or not a number.
   *
   * Run time is \cgalBigO{m} in practice for `m` arcs of the nodes reached, times the cost of an
   * operation of the queue.
   */
  template <typename Visitor = Geodesic_visitor_base>
  void run(const std::vector<Seed>& seeds,
           const Stop_rule& stop,
           Visitor&& visitor = Visitor(),
           const Find_entries& find_entries = {})
  {
    check(seeds, stop);
    forget();
    search(seeds, stop, visitor, internal::No_heuristic(), find_entries);
  }

  /// finds the distances from the nearest of the seeds to all nodes.
  void run(const std::vector<Seed>& seeds) { run(seeds, Stop_rule()); }

  /// finds the distances from `node` to all nodes.
  void run_from(const Node node) { run(std::vector<Seed>{Seed{node}}); }

  /*!
   * runs the A* algorithm \cgalCite{hnr-fbhdm-68}: as `run()` does, but expands nodes in the order
   * of their distance plus a lower bound of the remaining distance to a goal, and so reaches fewer
   * nodes before it gets there. The goal is the only target, or the only point, of the rule. If the
   * run ends early, only the distances of the goal and of the nodes on the path to it are final.
   *
   * \param seeds where to start
   * \param stop when the run may end early
   * \param heuristic a model of the concept `AStarHeuristic` of the Boost Graph Library, which is a
   *        function object called with a `Node`. It returns a lower bound of the distance from this
   *        node to the goal, in units of the graph. It should be consistent: for each arc, the
   *        value at its start is at most the length of the arc plus the value at its end. If it is
   *        not, the distance of the goal is the same, but nodes may be expanded again. Rounding
   *        errors are tolerated.
   * \param find_entries finds the seeds, for lines that are found from upper bounds
   *
   * \throws std::invalid_argument as `run()` does.
   */
  template <typename AStarHeuristic>
  void run_toward(const std::vector<Seed>& seeds,
                  const Stop_rule& stop,
                  const AStarHeuristic& heuristic,
                  const Find_entries& find_entries = {})
  {
    check(seeds, stop);
    forget();
    search(seeds, stop, Geodesic_visitor_base(), heuristic, find_entries);
    bool is_lost = false; // although the goal has an upper bound
    guard([&] {
      is_lost = m_limit < internal::infinity &&
                goal(stop, internal::No_heuristic()).distance() == internal::infinity;
    });
    if(internal::reopens_too_often(m_labels) || is_lost)
    {
      forget();
      search(seeds, stop, Geodesic_visitor_base(), internal::No_heuristic(), find_entries);
    }
  }

  /// \cond SKIP_IN_MANUAL

  // Runs as `run()` does, in the corridor of short paths to a goal, in which the graph's `Run`
  // knows how to stay: `to_goal` gives lower bounds of distances to the goal, in units of the
  // graph. Nodes on no path to the goal within the maximum distance may not be reached. The
  // function object is called by later queries, too.
  template <typename LowerBound>
  void run_within(LowerBound to_goal,
                  const std::vector<Seed>& seeds,
                  const Stop_rule& stop,
                  const Find_entries& find_entries)
  {
    check(seeds, stop);
    forget();
    m_run.limit_to(std::move(to_goal));
    search(seeds, stop, Geodesic_visitor_base(), internal::No_heuristic(), find_entries);
  }

  /// \endcond

  /*!
   * adds seeds to those of the last run, and lowers the distances of the nodes that are nearer to
   * the new ones. Results are those of a run from all seeds; but only nodes whose distances fall
   * are expanded, and occur again in `reached_nodes()`.
   *
   * \pre The last run did not end early, and arcs of the graph have not changed since.
   *
   * \throws std::invalid_argument as `run()` does.
   */
  void run_further(const std::vector<Seed>& seeds)
  {
    check(seeds, Stop_rule());
    m_sources.forget(m_labels);
    m_ways.forget();
    search(seeds, Stop_rule(), Geodesic_visitor_base(), internal::No_heuristic(), {});
  }

  /*!
   * forgets the last run, and continues one whose distances were kept elsewhere. Only the arcs from
   * open nodes, and from those whose distances fall, are followed. If all distances are lengths of
   * paths, and all arcs from the other nodes have been followed, results are those of the run that
   * is continued. `source()` returns the node that a path starts with. The graph must not have a
   * `Run` of its own, which might keep more than distances.
   *
   * \param enter_labels a function object. It is called with a function `set(node, distance,
   *        predecessor, is_open)`, which it calls for each node that has a distance, once. The
   *        predecessor can be `null_node`.
   *
   * \throws std::invalid_argument if a distance is negative, infinite, or not a number.
   *
   * The header `CGAL/Geodesic_costs.h` has to be included.
   */
  template <typename EnterLabels>
  void resume(const EnterLabels& enter_labels)
  {
    static_assert(internal::can_continue<Propagation>, "resume(): include <CGAL/Geodesic_costs.h>");
    if constexpr(internal::can_continue<Propagation>)
      internal::Continued_run<Propagation>(*this).resume(enter_labels);
  }

  /*!
   * does the same as `run(seeds)`, and takes the time that the difference from the last run is
   * worth: arcs of the graph may have changed since then, and seeds may have been added, removed or
   * moved. Only the distances of nodes that paths through changed arcs or from other seeds lead to
   * are found anew. All distances are those of `run()`, to the last bit as far as they do not
   * depend on the queue, see \ref AG_same_bits; of paths of the same length, it may find another
   * one.
   *
   * The whole graph is searched if the last run ended early, had a heuristic or a maximum distance,
   * if most of the results change, or if `graph` has no groups, see `GeodesicGraph`.
   *
   * \throws std::invalid_argument as `run()` does.
   *
   * Run time is \cgalBigO{m} in practice for `m` arcs of the nodes whose distances are found anew,
   * and of the nodes that have arcs in common with them. At the first call, memory of a byte per
   * group and a bit per node is allocated. The header `CGAL/Geodesic_costs.h` has to be included,
   * unless that of the graph does so.
   */
  void repair(const std::vector<Seed>& seeds)
  {
    static_assert(internal::can_continue<Propagation>, "repair(): include <CGAL/Geodesic_costs.h>");
    if constexpr(internal::can_continue<Propagation>)
      internal::Continued_run<Propagation>(*this).repair(seeds);
  }

  /// enables or disables statistics for subsequent runs, which they slow down slightly.
  void collect_statistics(const bool counts) { m_counts = counts; }

  /// returns whether statistics are enabled.
  bool collects_statistics() const { return m_counts; }

  /// @}

  /// \name Results of the Last Run
  /// @{

  /// returns the distance to `node`, or infinity if it was not reached.
  double distance(const Node node) const { return m_labels.distance(node) * m_graph->unit(); }

  /// returns whether `distance` is final: whether all nodes nearer than this were reached. This is
  /// so for every distance unless the run ended early.
  bool is_final(const double distance) const
  {
    // the next smaller number, as a distance may have been rounded up to this one
    const double in_graph_unit = to_graph_unit(std::nextafter(distance, 0.));
    return in_graph_unit <= m_limit && (!m_ended_early || m_queue.is_final(in_graph_unit));
  }

  /// returns whether `node` was reached.
  bool is_reached(const Node node) const { return m_labels.is_reached(node); }

  /*!
   * returns the node before `node` on a shortest path to it, or `null_node` if the path starts with
   * `node`, or `node` was not reached.
   *
   * If the graph tells the lengths of arcs that cost nothing, and the search has taken some, then
   * of the shortest paths, those are returned whose free parts are shortest. They are the same for
   * all queues, and after `repair()`. The first call after such a run searches for them, once more
   * and over all arcs, and writes to the object, as `source()` does.
   */
  Node predecessor(const Node node) const
  {
    if(!is_reached(node))
      return null_node;
    if constexpr(internal::tells_free_arcs<Graph>)
      if(has_free_ways())
        return m_ways.predecessor(node);
    return m_labels.predecessor(node);
  }

  /// \cond SKIP_IN_MANUAL

  // Distances in units of the graph, in which no digits are lost where the mesh is tiny.
  const auto& labels() const { return m_labels; }

  // The length of the parts of the path to `node` that cost nothing, as the graph tells it.
  double free_length([[maybe_unused]] const Node node) const
  {
    if constexpr(internal::tells_free_arcs<Graph>)
      if(is_reached(node) && has_free_ways())
        return m_ways.length(node);
    return 0;
  }

  /// \endcond

  /*!
   * returns the index of the source nearest to `node`, or `null_source` if `node` was not reached.
   *
   * The first call after a run allocates an index per node, and each call stores its result for
   * all nodes of the path. So run time is \cgalBigO{1}, amortized over the nodes that were reached.
   *
   * \warning Although this member function is `const`, it writes to the object: two threads must
   * not call it for the same object at the same time.
   */
  std::size_t source(const Node node) const
  {
    if constexpr(internal::tells_free_arcs<Graph>)
      if(is_reached(node) && has_free_ways())
      {
        const auto seed = m_ways.seed(node);
        return seed == m_ways.null_seed ? null_source : m_seeds[seed].source;
      }
    return m_sources.source(node, m_labels, m_seeds);
  }

  /// returns the nodes that were reached, in the order in which they were first expanded or, if a
  /// visitor watched the run, of their distances. Nodes may occur more than once.
  const std::vector<Node>& reached_nodes() const { return m_labels.order(); }

  /// returns the figures of the last run, if statistics were enabled.
  const Propagation_statistics& statistics() const { return m_statistics; }

  /// returns the queue, which may have statistics, too.
  const Queue& queue() const { return m_queue; }

  /// @}

  /// returns the graph.
  const Graph& graph() const { return *m_graph; }

  /// returns what the graph keeps of the last run.
  const Run& graph_run() const { return m_run; }

  /// returns the number of bytes that the workspace takes.
  std::size_t memory() const
  {
    return internal::memory_of(m_run, m_labels, m_queue, m_sources, m_ways, m_seeds, m_candidates) +
           (m_kept ? m_kept->memory() : 0);
  }

private:
  friend class internal::Continued_run<Propagation>;

  using Labels = internal::Labels;

  template <typename G, typename Heuristic>
  using Relaxation = internal::Batch_relaxation<G, Queue, Heuristic>;

  template <typename Watch, typename Heuristic>
  void propagate(const Stop_rule& stop, Watch watch, const Heuristic& heuristic)
  {
    Relaxation<Graph, Heuristic> batch(*m_graph, m_run, m_queue, m_labels, m_candidates, heuristic,
                                       largest_label(stop), m_counts ? &m_statistics : nullptr);
    while(!m_queue.is_empty())
    {
      if(!batch.run(watch))
        return end_early<Heuristic>(batch.size());
      if constexpr(!internal::is_heuristic<Heuristic>)
      {
        End end{*this, stop, {}};
        m_run.finish(end);
        end.enter();
      }
    }
    watch.finish();
  }

  // The interface for `start()` of the graph's `Run`, before a search.
  template <typename Heuristic>
  struct Start
  {
    // The largest label of the search, in units of the graph.
    double limit() const { return search.largest_label(stop); }

    // Whether the search starts from curves. Other seeds are only found after the start if lines
    // are found from labels.
    bool starts_from_curves() const { return finds_entries && !Run::attaches_by_labels; }

    // A lower bound on the distance to the goal, valid during the search; empty without heuristic.
    std::function<double(Node)> heuristic() const
    {
      if constexpr(internal::is_heuristic<Heuristic>)
        return [h = &to_goal](const Node node) { return (*h)(node); };
      else
        return {};
    }

    // Searches another graph with the same nodes and unit until the goal is final, and calls
    // `f(node, label)` for all labeled nodes. Limits the labels of the search by the distance of
    // the goal. Then resets the labels.
    template <typename OtherGraph, typename F>
    void find_upper_bounds(const OtherGraph& graph, F f)
    {
      constexpr double slack = 1e-6; // much more than rounding, and not much more to search
      Labels& labels = search.m_labels;
      const std::size_t size_of_order = labels.order().size();
      for(const Seed& seed : seeds)
        search.enter(seed.node, search.to_graph_unit(seed.distance), stop, to_goal);
      using Other_relaxation = Relaxation<OtherGraph, Heuristic>;
      typename Other_relaxation::Run run(graph);
      typename Other_relaxation::Candidates candidates;
      Other_relaxation batch(graph, run, search.m_queue, labels, candidates, to_goal, limit(),
                             nullptr);
      Geodesic_visitor_base no_visitor;
      internal::Watch watch(labels, search.goal(stop, to_goal), no_visitor, search.m_graph->unit(),
                            false);
      batch.run(watch, false);
      labels.append_to_order(search.m_queue); // all labeled nodes
      search.m_limit = search.goal(stop, to_goal).distance() * (1 + slack);
      for(std::size_t i = size_of_order; i < labels.order().size(); ++i)
        if(const Node node = labels.order()[i]; labels.is_reached(node)) // first occurrence
        {
          f(node, labels.distance(node));
          labels.discard(node);
        }
      labels.order().resize(size_of_order);
      search.m_queue.clear();
    }

    Propagation& search;
    const std::vector<Seed>& seeds;
    const Stop_rule& stop;
    const Heuristic& to_goal;
    bool finds_entries;
  };

  // The interface for `finish()` of the graph's `Run`, when the queue is empty. If labels are
  // lowered, the search continues.
  struct End
  {
    const Labels& labels() const { return search.m_labels; }
    double limit() const { return search.largest_label(stop); }

    // Lowers a label; the node will be expanded.
    void lower(const Node node, const double label, const Node predecessor)
    {
      search.m_labels.set(node, label, predecessor);
      lowered.push_back(node);
    }

    void enter()
    {
      if(!lowered.empty())
        search.m_queue.clear(); // its lower bound of keys exceeds theirs
      for(const Node node : lowered)
        search.m_queue.push(node, search.m_labels.distance(node));
    }

    Propagation& search;
    const Stop_rule& stop;
    std::vector<Node> lowered;
  };

  // Whether the search has taken arcs that cost nothing. Their ways are not looked for any more
  // after arcs have changed.
  bool has_free_ways() const
  {
    if constexpr(!internal::tells_free_arcs<Graph>)
      return false;
    else if(internal::number_of_changes(*m_graph) != m_number_of_changes)
      return m_ways.are_known();
    else
      return m_ways.exist(*m_graph, m_labels, m_seeds);
  }

  // Resets the labels that are not final: those of nodes in the queue and in the last batch. After
  // A*, all labels stay: only the goal may be queried, and nodes on the path to it may still be in
  // the queue, as their keys were rounded up.
  template <typename Heuristic>
  void end_early(const std::size_t size_of_batch)
  {
    m_ended_early = true;
    if constexpr(internal::is_heuristic<Heuristic>)
      m_labels.append_to_order(m_queue);
    else
    {
      auto& order = m_labels.order();
      for(std::size_t i = 0; i < size_of_batch; ++i)
      {
        discard(order.back());
        order.pop_back();
      }
      m_queue.for_each_node([this](const Node node) {
        if(m_labels.is_reached(node) && !m_queue.is_final(m_labels.distance(node)))
          discard(node);
      });
    }
  }

  void discard(const Node node)
  {
    m_labels.discard(node);
    m_run.discard(node);
  }

  // In units of the graph.
  double largest_label(const Stop_rule& stop) const
  {
    return (std::min)(m_limit, to_graph_unit(stop.maximum_distance));
  }

  // Nodes in `border` have labels already; the search starts from them, too.
  template <typename Visitor, typename Heuristic>
  void search(const std::vector<Seed>& seeds,
              const Stop_rule& stop,
              Visitor&& visitor,
              const Heuristic& heuristic,
              const Find_entries& find_entries,
              const std::vector<Node>& border = {})
  {
    guard([&] {
      prepare();
      m_is_complete = m_is_complete && !internal::is_heuristic<Heuristic> && !find_entries &&
                      stop.maximum_distance == std::numeric_limits<double>::infinity();
      for(const Node node : border)
        m_queue.push(node, m_labels.distance(node));
      Start<Heuristic> start{*this, seeds, stop, heuristic, bool(find_entries)};
      m_run.start(start);
      if constexpr(internal::needs_order<Heuristic> && internal::can_keep_order<Queue>)
        m_queue.keep_order();
      if(find_entries)
        for(const Entry& entry : find_entries())
          enter(entry, stop, heuristic);
      else
        for(const Seed& seed : seeds)
          enter(Entry{seed, {}}, stop, heuristic);
      propagate_all(stop, visitor, heuristic);
    });
  }

  template <typename Visitor, typename Heuristic>
  void propagate_all(const Stop_rule& stop, Visitor&& visitor, const Heuristic& heuristic)
  {
    propagate(stop,
              internal::Watch(m_labels, goal(stop, heuristic), visitor, m_graph->unit(), m_counts),
              heuristic);
    count_all();
    m_is_complete = m_is_complete && !m_ended_early;
    m_sources.forget_all(); // a visitor may have queried them before they were final
    m_ways.forget();
  }

  // Calls `f()`. If an exception leaves it, nothing counts as reached.
  template <typename F>
  void guard(F f)
  {
    try
    {
      f();
    }
    catch(...)
    {
      forget_all();
      throw;
    }
  }

  void forget_all()
  {
    m_sources.forget_all();
    m_ways.forget();
    m_labels.forget_all();
    m_run.forget_all();
    m_kept.reset();
    forget_seeds();
    m_is_complete = true; // nothing is reached
  }

  // Prepares for labels of the graph in its present state.
  void forget_seeds()
  {
    m_seeds.clear();
    m_number_of_changes = internal::number_of_changes(*m_graph);
  }

  void prepare()
  {
    m_queue.clear();
    m_ways.wait();
    m_statistics = Propagation_statistics();
    m_ended_early = false;
    m_limit = std::numeric_limits<double>::infinity();
  }

  template <typename Heuristic>
  void enter(Entry entry, const Stop_rule& stop, const Heuristic& heuristic)
  {
    Seed& seed = entry.seed;
    seed.distance = to_graph_unit(seed.distance);
    m_seeds.push_back(seed);
    if(enter(seed.node, seed.distance, stop, heuristic))
      m_run.on_label(seed.node, seed.distance, entry.payload);
  }

  // Labels a node where the search starts, unless it has a smaller label. Returns whether it did.
  template <typename Heuristic>
  bool enter(const Node node, const double label, const Stop_rule& stop, const Heuristic& heuristic)
  {
    if(!(label < m_labels.distance(node) && label <= largest_label(stop)))
      return false;
    m_labels.set(node, label, null_node);
    m_queue.push(node, label + heuristic(node));
    return true;
  }

  template <typename Heuristic>
  auto goal(const Stop_rule& stop, const Heuristic& heuristic) const
  {
    std::vector<std::vector<Last_arc>> points = stop.points;
    for(std::vector<Last_arc>& arcs : points)
      for(Last_arc& arc : arcs)
        arc.length = to_graph_unit(arc.length);
    return internal::Goal<Queue, Heuristic>{m_labels, m_queue, heuristic, stop.targets,
                                            std::move(points)};
  }

  void count_all()
  {
    if(!m_counts)
      return;
    m_statistics.settled_nodes = m_labels.order().size(); // sorted, so each node occurs once
    if constexpr(internal::counts_comparisons<Queue>)
      m_statistics.queue_comparisons =
          m_queue.statistics().visited_buckets + m_queue.statistics().comparisons;
  }

  void forget()
  {
    m_sources.forget(m_labels);
    m_ways.forget();
    m_run.forget(m_labels.order());
    m_labels.forget();
    forget_seeds();
    m_is_complete = true;
  }

  double to_graph_unit(const double distance) const { return distance / m_graph->unit(); }

  void check(const std::vector<Seed>& seeds, const Stop_rule& stop) const
  {
    internal::check_input(seeds, stop, m_graph->number_of_nodes(), m_graph->unit());
  }

  const Graph* m_graph;
  Run m_run;
  Labels m_labels;
  Queue m_queue;
  internal::Candidate_list<typename Run::Payload> m_candidates; // of a batch; memory is kept
  mutable internal::Nearest_sources m_sources;                  // computed on first request
  mutable internal::Free_ways_of<Graph> m_ways;                 // likewise
  std::vector<Seed> m_seeds; // of the last run, distances in units of the graph
  Propagation_statistics m_statistics;
  bool m_counts = false;
  bool m_ended_early = false;
  std::unique_ptr<internal::Kept_part> m_kept; // by `Continued_run`
  bool m_is_complete = true;                   // whether all nodes have labels that can be reached
  std::size_t m_number_of_changes = 0;         // of arcs, before the labels were found
  double m_limit = std::numeric_limits<double>::infinity(); // of labels, in units of the graph
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_H
