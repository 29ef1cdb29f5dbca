// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/fixed_bucket_width.h"
#include "oracles/test_oracles.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Array_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Heap_queues.h>
#include <CGAL/Approximate_geodesics/Queues/Radix_heap_queue.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <thread>
#include <utility>
#include <vector>

// Models of the concepts that have nothing more than these ask for.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using CGAL::Approximate_geodesics::Adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Arc_lengths;
using CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Propagation;

// A sorted set, in which a key is final when a larger one has come out.
class Set_queue
{
public:
  using Node = std::uint32_t;
  using Key = double;
  using Entry = std::pair<Key, Node>;
  using Batch = std::array<Entry, 1>;

  Set_queue(std::size_t /* number_of_nodes */, const Arc_lengths&) {}

  bool is_empty() const { return m_entries.empty(); }
  void push(const Node node, const Key key) { m_entries.insert({key, node}); }

  Batch extract_min()
  {
    const Entry result = *m_entries.begin();
    m_entries.erase(m_entries.begin());
    m_last = result.first;
    return {result};
  }

  bool is_final(const Key key) const { return key < m_last; }

  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_entries)
      f(e.second);
  }

  void clear()
  {
    m_entries.clear();
    m_last = 0;
  }

  std::size_t memory() const { return m_entries.size() * sizeof(Entry); }

private:
  std::set<Entry> m_entries;
  Key m_last = 0;
};

// A square of points, each joined to its four neighbors by arcs that are nowhere stored, and not to
// the one that its path comes from. Lengths are different in x and y.
class Implicit_square
{
public:
  using Node = std::uint32_t;

  explicit Implicit_square(const Node side) : m_side(side) {}

  std::size_t number_of_nodes() const { return std::size_t(m_side) * m_side; }
  double unit() const { return 1; }
  Arc_lengths arc_lengths() const { return {dx, (dx + dy) / 2, dy}; }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    const Node x = node % m_side, y = node / m_side;
    const auto go = [&](const Node target, const double length) {
      if(labels.predecessor(node) != target)
        f(target, length);
    };
    if(x > 0)
      go(node - 1, dx);
    if(y > 0)
      go(node - m_side, dy);
    if(x + 1 < m_side)
      go(node + 1, dx);
    if(y + 1 < m_side)
      go(node + m_side, dy);
  }

  static constexpr double dx = 0.75, dy = 2.5; // sums are exact

private:
  Node m_side;
};

// The same distances, but also arcs that are longer than the two that they replace: who goes by the
// number of arcs expands nodes twice.
class Square_with_detours : public Implicit_square
{
public:
  explicit Square_with_detours(const Node side) : Implicit_square(side), m_side(side) {}

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    if(node % m_side + 2 < m_side)
      f(node + 2, 3 * dx);
    Implicit_square::for_each_arc(node, labels, f);
  }

private:
  Node m_side;
};

// The same with all that a graph may have besides. Its run knows which nodes were expanded before,
// and how long the last arcs of paths are.
class Square_with_options : public Square_with_detours
{
public:
  using Square_with_detours::Square_with_detours;

  class Run : public AG::Geodesic_run_base<Square_with_options>
  {
  public:
    struct Payload
    {
      double length = 0;
    };

    explicit Run(const Square_with_options& graph)
      : Geodesic_run_base(graph), m_length(graph.number_of_nodes())
    {
    }

    template <typename Search>
    void start(Search& /* search */)
    {
      m_is_expanded.assign(graph().number_of_nodes(), false);
    }

    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      for(const Node* node = nodes; node != nodes + number; ++node)
      {
        ++(m_is_expanded[*node] ? graph().number_of_repetitions : graph().number_of_expansions);
        m_is_expanded[*node] = true;
        graph().for_each_arc(*node, labels, [&](const Node target, const double length) {
          candidates.make_room(1);
          candidates.append(true, *node, labels.distance(*node), target, length, Payload{length});
        });
      }
    }

    void on_label(const Node node, double /* distance */, const Payload& payload)
    {
      m_length[node] = payload.length;
    }

    double last_length(const Node node) const { return m_length[node]; }

  private:
    std::vector<bool> m_is_expanded;
    std::vector<double> m_length;
  };

  std::size_t maximum_degree() const { return 5; }
  void prefetch(Node) const { ++number_of_prefetches; }

  mutable std::size_t number_of_prefetches = 0, number_of_expansions = 0, number_of_repetitions = 0;
};

// Two threads.
struct Two_threads
{
  static std::size_t number_of_threads() { return 2; }

  template <typename F>
  void run(const std::size_t number, const F& f) const
  {
    const auto take_turns = [&](const std::size_t thread) {
      for(std::size_t i = thread; i < number; i += 2)
        f(i, thread);
    };
    std::thread other(take_turns, 1);
    take_turns(0);
    other.join();
  }
};

// A square with detours, whose run finds upper bounds first, on the square without them, and leaves
// out what is longer; two threads share the work. It overlooks the arcs to a column of nodes, and
// takes them from the bounds in the end.
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
      search.find_upper_bounds(graph().plain, [&](const Node node, const double label) {
        m_bound[node] = (std::min)(m_bound[node], (std::min)(label, search.limit()));
      });
    }

    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      candidates.append_in_parallel(
          Two_threads(), number, [&](const std::size_t i, Candidates& part) {
            const double label = labels.distance(nodes[i]);
            graph().for_each_arc(nodes[i], labels, [&](const Node target, const double length) {
              part.make_room(1);
              part.append(label + length <= m_bound[target] && target % graph().side != GAP,
                          nodes[i], label, target, length);
            });
          });
    }

    template <typename Search>
    void finish(Search& search)
    {
      for(Node node = GAP; node < graph().number_of_nodes(); node += graph().side)
        if(search.labels().distance(node) > m_bound[node] && m_bound[node] <= search.limit())
          search.lower(node, m_bound[node], node - 1);
    }

    void discard(const Node node) { m_bound[node] = std::numeric_limits<double>::infinity(); }
    void forget(const std::vector<Node>& /* nodes */) { forget_all(); }
    void forget_all()
    {
      std::fill(m_bound.begin(), m_bound.end(), std::numeric_limits<double>::infinity());
    }
    std::size_t largest_batch() const { return 100; }

  private:
    static constexpr Node GAP = 40;

    std::vector<double> m_bound;
  };

  Implicit_square plain;
  Node side;
};

template <typename Queue>
class Queues : public testing::Test
{
};
using All_queues = testing::Types<Adaptive_bucket_queue,
                                  Basic_adaptive_bucket_queue<Fixed_bucket_width>,
                                  Set_queue,
                                  AG::Array_queue,
                                  AG::Binary_heap_queue,
                                  AG::D_ary_heap_queue<4>,
                                  AG::Fibonacci_heap_queue,
                                  AG::Pairing_heap_queue,
                                  AG::Radix_heap_queue,
                                  AG::Published_bucket_queue,
                                  AG::Basic_published_bucket_queue<Fixed_bucket_width>,
                                  AG::Basic_adaptive_bucket_queue<AG::Published_bucket_width>>;
TYPED_TEST_SUITE(Queues, All_queues, );

TYPED_TEST(Queues, search_a_graph_of_implicit_arcs)
{
  const Implicit_square graph(60);
  Propagation<Implicit_square, TypeParam> search(graph);
  for(const std::uint32_t source : {0u, 61u, 1830u})
  {
    search.run_from(source);
    for(std::uint32_t n = 0; n < 3600; ++n)
    {
      const double x = std::abs(double(n % 60) - double(source % 60));
      const double y = std::abs(double(n / 60) - double(source / 60));
      ASSERT_EQ(search.distance(n), x * Implicit_square::dx + y * Implicit_square::dy);
      EXPECT_EQ(search.source(n), 0u);
    }
  }
}

// All queues give the same bits, in full runs and in those that end early.
TYPED_TEST(Queues, give_the_same_distances)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    Mesh_search reference(named.mesh);
    Propagation<Graph, TypeParam> search(reference.graph());
    for(std::size_t run = 0; run < 8; ++run)
    {
      const auto seeds =
          reference.seeds({random_vertex(named.mesh, random), random_vertex(named.mesh, random)});
      typename Propagation<Graph, TypeParam>::Stop_rule stop;
      if(run % 3 == 1)
        stop.maximum_distance = random.between(0, 40);
      if(run % 3 == 2)
        stop.targets = {reference.node(random_vertex(named.mesh, random))};
      std::vector<typename Propagation<Graph, TypeParam>::Seed> same_seeds;
      for(const auto& seed : seeds)
        same_seeds.push_back({seed.node, seed.distance, seed.source});
      search.run(same_seeds, stop);
      reference.search().run(seeds, {stop.maximum_distance, {}});
      for(Node n = 0; n < named.mesh.number_of_vertices(); ++n)
        if(stop.targets.empty() || search.is_reached(n))
        {
          ASSERT_EQ(search.distance(n), reference.search().distance(n)) << "node " << n;
        }
      for(const Node n : stop.targets)
        EXPECT_EQ(search.distance(n), reference.search().distance(n));
    }
  }
}

TYPED_TEST(Queues, end_early_with_final_distances_only)
{
  const Implicit_square graph(60);
  using Square_search = Propagation<Implicit_square, TypeParam>;
  Square_search full(graph), part(graph);
  full.run({{1830, 0, 0}});
  typename Square_search::Stop_rule stop;
  stop.targets = {1845, 1810};
  part.run({{1830, 0, 0}}, stop);
  std::size_t number_reached = 0;
  for(std::uint32_t n = 0; n < 3600; ++n)
    if(part.is_reached(n))
    {
      ++number_reached;
      EXPECT_EQ(part.distance(n), full.distance(n));
    }
  EXPECT_EQ(part.distance(1810), 20 * Implicit_square::dx);
  EXPECT_LT(number_reached, 1000u);
  EXPECT_GT(number_reached, 30u);
}

// The class takes any of them, too.
template <typename Queue>
class Queues_of_the_class : public testing::Test
{
};
using Two_queues = testing::Types<Set_queue, AG::Binary_heap_queue>;
TYPED_TEST_SUITE(Queues_of_the_class, Two_queues, );

TYPED_TEST(Queues_of_the_class, give_the_same_distances)
{
  Mesh mesh = to_mesh(flat_grid(20, 30));
  AG::Surface_mesh_shortest_path<Mesh> expected(mesh);
  AG::Surface_mesh_shortest_path<Mesh, Graph, TypeParam> shortest_paths(mesh);
  const auto distance = mesh.add_property_map<Vertex, double>("distance").first;
  for(const Vertex source : {Vertex(0), Vertex(333)})
  {
    expected.remove_all_source_points();
    shortest_paths.remove_all_source_points();
    expected.add_source_point(source);
    shortest_paths.add_source_point(source);
    CGAL::approximate_geodesic_distances(mesh, distance, source);
    for(const Vertex v : mesh.vertices())
    {
      const double d = expected.shortest_distance_to_source_points(v).first;
      EXPECT_EQ(shortest_paths.shortest_distance_to_source_points(v).first, d);
      EXPECT_EQ(distance[v], d);
    }
    std::vector<Point> path;
    EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), source, Vertex(77)),
              distance[Vertex(77)]);
    EXPECT_GT(path.size(), 1u);
  }
}

// Buckets as wide as all arcs are long together: nodes come out in the order in which they came in.
class One_bucket
{
public:
  explicit One_bucket(const Arc_lengths&) {}

  double width() const { return 1e6; }
  void update(const AG::Bucket_statistics&) {}
};

TEST(Options_of_graphs, are_used)
{
  const Square_with_options graph(60);
  Propagation<Square_with_options, Basic_adaptive_bucket_queue<One_bucket>> search(graph);
  search.collect_statistics(true);
  search.run_from(1830);
  const AG::Propagation_statistics& s = search.statistics();
  EXPECT_EQ(graph.number_of_expansions, 3600u);
  EXPECT_EQ(graph.number_of_repetitions, s.repeated_pops());
  EXPECT_GT(graph.number_of_repetitions, 0u); // or nothing was tested
  EXPECT_EQ(graph.number_of_prefetches, s.pops);

  const Implicit_square plain_graph(60);
  Propagation<Implicit_square> plain(plain_graph);
  plain.run_from(1830);
  for(std::uint32_t n = 0; n < 3600; ++n)
  {
    ASSERT_EQ(search.distance(n), plain.distance(n));
    if(const auto from = search.predecessor(n); from != search.null_node)
    {
      EXPECT_EQ(search.graph_run().last_length(n), search.distance(n) - search.distance(from));
    }
  }
}

// From the left of the column that is overlooked; anywhere, runs that end early leave nothing.
TEST(Options_of_graphs, find_bounds_first)
{
  const Square_with_bounds graph(60);
  const Implicit_square plain_graph(60);
  Propagation<Square_with_bounds> search(graph);
  Propagation<Implicit_square> plain(plain_graph);
  for(const std::uint32_t source : {1830u, 0u, 3577u})
  {
    search.run_from(source);
    plain.run_from(source);
    for(std::uint32_t n = 0; n < 3600; ++n)
      ASSERT_EQ(search.distance(n), plain.distance(n));
    for(const double limit : {0., 7., 30.})
    {
      search.run({{source}}, {limit, {}, {}});
      plain.run({{source}}, {limit, {}, {}});
      for(std::uint32_t n = 0; n < 3600; ++n)
        ASSERT_EQ(search.distance(n), plain.distance(n));
    }
    search.run({{source}}, {100, {source + 5}, {}});
    EXPECT_EQ(search.distance(source + 5), 5 * Implicit_square::dx);
  }
}

} // namespace
