// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>

#include "checks/fixed_bucket_width.h"
#include "oracles/Implicit_square.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

// What the concept `GeodesicRun` promises to the run of a graph.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Propagation;

constexpr double unreached = std::numeric_limits<double>::infinity();

// A loop with any number of threads.
struct Threads
{
  std::size_t number = 1;

  std::size_t number_of_threads() const { return number; }

  template <typename F>
  void run(const std::size_t size, const F& f) const
  {
    std::vector<std::thread> threads;
    for(std::size_t thread = 0; thread < number; ++thread)
      threads.emplace_back([&, thread] {
        for(std::size_t i = thread; i < size; i += number)
          f(i, thread);
      });
    for(std::thread& t : threads)
      t.join();
  }
};

// A square whose run records what it is told: the labels, the last arcs of paths, and the calls.
class Recorded_square : public Square_with_detours
{
public:
  using Square_with_detours::Square_with_detours;

  class Run : public AG::Geodesic_run_base<Recorded_square>
  {
  public:
    struct Payload
    {
      double length = 0;
    };

    explicit Run(const Recorded_square& graph)
      : Geodesic_run_base(graph),
        m_label(graph.number_of_nodes(), unreached),
        m_length(graph.number_of_nodes())
    {
    }

    template <typename Search>
    void start(Search& search)
    {
      m_is_expanded.assign(graph().number_of_nodes(), false);
      number_of_expansions = number_of_repetitions = number_of_finishes = size_of_batch = 0;
      heuristic_of_1000 = search.heuristic() ? search.heuristic()(1000) : unreached;
    }

    // Also appends for each node what is no arc, and would shorten paths to the first one.
    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      size_of_batch = (std::max)(size_of_batch, number);
      for(const Node* node = nodes; node != nodes + number; ++node)
      {
        ++(m_is_expanded[*node] ? number_of_repetitions : number_of_expansions);
        m_is_expanded[*node] = true;
      }
      candidates.append_in_parallel(
          graph().threads, number, [&](const std::size_t i, Candidates& part) {
            const double label = labels.distance(nodes[i]);
            part.make_room(1);
            part.append(false, nodes[i], label, 0, -label, Payload{-1});
            graph().for_each_arc(nodes[i], labels, [&](const Node target, const double length) {
              part.make_room(1);
              part.append(true, nodes[i], label, target, length, Payload{length});
            });
          });
    }

    void on_label(const Node node, const double distance, const Payload& payload)
    {
      m_label[node] = distance;
      m_length[node] = payload.length;
    }

    template <typename Search>
    void finish(Search& /* search */)
    {
      ++number_of_finishes;
    }

    void discard(const Node node) { m_label[node] = unreached; }
    void forget(const std::vector<Node>& nodes)
    {
      for(const Node node : nodes)
        discard(node);
    }
    void forget_all() { m_label.assign(m_label.size(), unreached); }
    std::size_t largest_batch() const { return graph().largest_batch; }

    double label(const Node node) const { return m_label[node]; }
    double last_length(const Node node) const { return m_length[node]; }

    std::size_t number_of_expansions = 0, number_of_repetitions = 0, number_of_finishes = 0;
    std::size_t size_of_batch = 0; // the largest one
    double heuristic_of_1000 = 0;

  private:
    std::vector<bool> m_is_expanded;
    std::vector<double> m_label, m_length;
  };

  std::size_t maximum_degree() const { return 5; }
  void prefetch(Node) const { ++number_of_prefetches; }

  Threads threads;
  std::size_t largest_batch = 0;
  mutable std::size_t number_of_prefetches = 0;
};

// A square with detours, whose run finds upper bounds first, on the square without them, and leaves
// out what is longer. It overlooks the arcs to a column of nodes, and takes them from the bounds in
// the end.
class Square_with_bounds : public Square_with_detours
{
public:
  explicit Square_with_bounds(const Node s) : Square_with_detours(s), plain(s), side(s) {}

  class Run : public AG::Geodesic_run_base<Square_with_bounds>
  {
  public:
    explicit Run(const Square_with_bounds& graph)
      : Geodesic_run_base(graph), m_bound(graph.number_of_nodes())
    {
      forget_all();
    }

    template <typename Search>
    void start(Search& search)
    {
      limit_before = search.limit();
      search.find_upper_bounds(graph().plain, [&](const Node node, const double label) {
        m_bound[node] = (std::min)(m_bound[node], (std::min)(label, search.limit()));
      });
      limit_at_start = search.limit();
    }

    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      for(const Node* node = nodes; node != nodes + number; ++node)
        graph().for_each_arc(*node, labels, [&](const Node target, const double length) {
          const double label = labels.distance(*node);
          candidates.make_room(1);
          candidates.append(label + length <= m_bound[target] && target % graph().side != GAP,
                            *node, label, target, length);
        });
    }

    template <typename Search>
    void finish(Search& search)
    {
      limit_at_end = search.limit();
      for(Node node = GAP; node < graph().number_of_nodes(); node += graph().side)
        if(search.labels().distance(node) > m_bound[node] && m_bound[node] <= search.limit())
          search.lower(node, m_bound[node], node - 1);
    }

    void discard(const Node node) { m_bound[node] = unreached; }
    void forget(const std::vector<Node>& /* nodes */) { forget_all(); }
    void forget_all() { std::fill(m_bound.begin(), m_bound.end(), unreached); }

    double limit_before = 0, limit_at_start = 0, limit_at_end = 0;

  private:
    static constexpr Node GAP = 40;

    std::vector<double> m_bound;
  };

  Implicit_square plain;
  Node side;
};

// A square whose run wants to be called at certain labels, until all nodes are expanded.
class Square_with_requests : public Implicit_square
{
public:
  static constexpr double interval = 7;

  using Implicit_square::Implicit_square;

  class Run : public AG::Geodesic_run_base<Square_with_requests>
  {
  public:
    using Geodesic_run_base::Geodesic_run_base;

    template <typename Search>
    void start(Search& /* search */)
    {
      m_number_left = graph().number_of_nodes();
      number_of_calls = 0;
      m_next = interval;
    }

    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      for(std::size_t i = 0; i < number; ++i)
        EXPECT_LE(labels.distance(nodes[i]), m_next);
      candidates.append_arcs(graph(), nodes, number, labels);
      m_number_left -= number;
      number_of_calls += number == 0 ? 1 : 0;
      m_next += number == 0 ? interval : 0;
      if(m_number_left > 0)
        candidates.call_again(0, m_next);
    }

    std::size_t number_of_calls = 0; // without nodes

  private:
    std::size_t m_number_left = 0;
    double m_next = 0;
  };
};

// Buckets as wide as all arcs are long together: nodes come out in the order in which they came in.
class One_bucket
{
public:
  explicit One_bucket(const AG::Arc_lengths&) {}

  double width() const { return 1e6; }
  void update(const AG::Bucket_statistics&) {}
};

// Stops a run by an exception.
struct Throwing_visitor : AG::Geodesic_visitor_base
{
  void on_settled(std::uint32_t /* node */, const double distance) const
  {
    if(distance > 20)
      throw std::runtime_error("stop");
  }
};

using Batch_search =
    Propagation<Recorded_square, AG::Basic_adaptive_bucket_queue<Fixed_bucket_width>>;

template <typename Search>
void expect_known_labels(const Search& search)
{
  for(std::uint32_t n = 0; n < search.graph().number_of_nodes(); ++n)
    ASSERT_EQ(search.graph_run().label(n), search.labels().distance(n)) << "node " << n;
}

TEST(Graph_run, expands_nodes_and_knows_last_arcs)
{
  const Recorded_square graph(60);
  Propagation<Recorded_square, AG::Basic_adaptive_bucket_queue<One_bucket>> search(graph);
  search.collect_statistics(true);
  search.run_from(1830);
  const AG::Propagation_statistics& s = search.statistics();
  const Recorded_square::Run& run = search.graph_run();
  EXPECT_EQ(run.number_of_expansions, 3600u);
  EXPECT_EQ(run.number_of_repetitions, s.repeated_pops());
  EXPECT_GT(run.number_of_repetitions, 0u); // or nothing was tested
  EXPECT_EQ(run.number_of_finishes, 1u);
  EXPECT_EQ(graph.number_of_prefetches, s.pops);

  const Implicit_square plain_graph(60);
  Propagation<Implicit_square> plain(plain_graph);
  plain.run_from(1830);
  for(std::uint32_t n = 0; n < 3600; ++n)
  {
    ASSERT_EQ(search.distance(n), plain.distance(n));
    const auto from = search.predecessor(n);
    const double length = n == 1830 ? 0 : search.distance(n) - search.distance(from);
    EXPECT_EQ(run.last_length(n), length);
  }
}

// After full runs, those that end early, that fail, that are continued, and the next ones.
TEST(Graph_run, knows_all_labels)
{
  const Recorded_square graph(60);
  Batch_search search(graph);
  search.run({{1830, 1, 0}, {7, 30, 1}});
  expect_known_labels(search);
  for(const double limit : {0., 7., 30.})
  {
    search.run({{61}}, {limit, {}, {}});
    expect_known_labels(search);
  }
  search.run({{1830}}, {100, {1845, 1810}, {}});
  EXPECT_EQ(search.graph_run().number_of_finishes, 0u);
  expect_known_labels(search);
  search.run({{0}});
  search.run_further({{3599}});
  expect_known_labels(search);
  EXPECT_THROW(search.run({{1830}}, Batch_search::Stop_rule(), Throwing_visitor()),
               std::runtime_error);
  EXPECT_FALSE(search.is_reached(1830));
  expect_known_labels(search);
  search.run_from(1830);
  expect_known_labels(search);
}

TEST(Graph_run, has_the_same_results_with_any_number_of_threads)
{
  Recorded_square graph(60), parallel_graph(60);
  Batch_search search(graph), parallel(parallel_graph);
  for(const std::size_t number : {2u, 3u, 7u})
    for(const bool counts : {false, true})
    {
      parallel_graph.threads.number = number;
      search.collect_statistics(counts);
      parallel.collect_statistics(counts);
      search.run({{1830}, {95}});
      parallel.run({{1830}, {95}});
      EXPECT_EQ(parallel.reached_nodes(), search.reached_nodes());
      EXPECT_EQ(parallel.statistics().relaxations, search.statistics().relaxations);
      EXPECT_EQ(search.statistics().relaxations > 3600, counts);
      EXPECT_LT(search.statistics().relaxations, 3600 * graph.maximum_degree());
      for(std::uint32_t n = 0; n < 3600; ++n)
      {
        ASSERT_EQ(parallel.distance(n), search.distance(n));
        ASSERT_EQ(parallel.predecessor(n), search.predecessor(n));
      }
    }
}

TEST(Graph_run, gets_larger_batches_if_it_asks_for_them)
{
  Recorded_square graph(60);
  Batch_search search(graph);
  std::vector<Batch_search::Seed> seeds;
  for(std::uint32_t n = 0; n < 3600; n += 7)
    seeds.push_back({n});
  search.run(seeds);
  const std::size_t usual = search.graph_run().size_of_batch;
  for(const std::size_t largest : {std::size_t(3), 2 * usual})
  {
    graph.largest_batch = largest;
    search.run(seeds);
    EXPECT_EQ(search.graph_run().size_of_batch, largest);
  }
}

template <typename Queue>
std::size_t number_of_requested_calls(const Square_with_requests& graph)
{
  Propagation<Square_with_requests, Queue> search(graph);
  search.run_from(0);
  const auto last = static_cast<Square_with_requests::Node>(graph.number_of_nodes() - 1);
  const double requests = search.distance(last) / Square_with_requests::interval;
  EXPECT_GT(requests, 5); // or nothing was tested
  EXPECT_EQ(search.graph_run().number_of_calls, static_cast<std::size_t>(requests));
  return search.graph_run().number_of_calls;
}

// Stale entries of nodes, and of requests, are no request.
TEST(Graph_run, is_called_without_nodes_on_request_only)
{
  const Square_with_requests graph(40);
  const std::size_t number = number_of_requested_calls<AG::Binary_heap_queue>(graph);
  EXPECT_EQ(number_of_requested_calls<AG::Array_queue>(graph), number);
  EXPECT_EQ(number_of_requested_calls<AG::Radix_heap_queue>(graph), number);
}

TEST(Graph_run, knows_the_heuristic)
{
  const Recorded_square graph(60);
  Propagation<Recorded_square, AG::Binary_heap_queue> search(graph);
  search.run_toward({{0}}, {unreached, {30}, {}}, [](const std::uint32_t node) {
    return node <= 30 ? (30 - node) * Implicit_square::dx : 0.25;
  });
  EXPECT_EQ(search.distance(30), 30 * Implicit_square::dx);
  EXPECT_EQ(search.graph_run().heuristic_of_1000, 0.25);
  search.run_from(0);
  EXPECT_EQ(search.graph_run().heuristic_of_1000, unreached);
}

// From the left of the column that is overlooked; anywhere, runs that end early leave nothing.
TEST(Graph_run, finds_bounds_first)
{
  const Square_with_bounds graph(60);
  const Implicit_square plain_graph(60);
  Propagation<Square_with_bounds> search(graph);
  Propagation<Implicit_square> plain(plain_graph);
  const Square_with_bounds::Run& run = search.graph_run();
  for(const std::uint32_t source : {1830u, 0u, 3577u})
  {
    search.run_from(source);
    plain.run_from(source);
    EXPECT_EQ(run.limit_at_start, unreached);
    for(std::uint32_t n = 0; n < 3600; ++n)
      ASSERT_EQ(search.distance(n), plain.distance(n));
    for(const double limit : {0., 7., 30.})
    {
      search.run({{source}}, {limit, {}, {}});
      plain.run({{source}}, {limit, {}, {}});
      EXPECT_EQ(run.limit_before, limit);
      EXPECT_EQ(run.limit_at_start, limit);
      EXPECT_EQ(run.limit_at_end, limit);
      for(std::uint32_t n = 0; n < 3600; ++n)
        ASSERT_EQ(search.distance(n), plain.distance(n));
    }
    const double distance = 5 * Implicit_square::dx;
    search.run({{source}}, {100, {source + 5}, {}});
    EXPECT_EQ(search.distance(source + 5), distance);
    EXPECT_EQ(run.limit_before, 100);
    EXPECT_GE(run.limit_at_start, distance);
    EXPECT_LE(run.limit_at_start, 1.001 * distance);
    for(const std::uint32_t n : search.reached_nodes()) // not those that only the bounds have found
      EXPECT_TRUE(search.is_reached(n));
  }
}

} // namespace
