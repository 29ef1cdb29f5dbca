// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/fixed_bucket_width.h"
#include "checks/random_gap.h"
#include "checks/test_random.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"
#include "peers/Published_bucket_width.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// Queues that give their entries one by one and in the order of their keys.

namespace {

using namespace geodesics_test;
using namespace CGAL::Approximate_geodesics;
using Node = std::uint32_t;

constexpr std::size_t number_of_nodes = 500;

template <typename Queue>
constexpr bool keeps_stale_entries = std::is_same_v<Queue, Radix_heap_queue>;

template <typename Queue>
Queue_entry extract_one(Queue& queue)
{
  const auto batch = queue.extract_min();
  EXPECT_EQ(batch.size(), 1u);
  return *batch.begin();
}

// A queue beside the keys that it should hold.
template <typename Queue>
class Checked_ordered_queue
{
public:
  explicit Checked_ordered_queue(const Arc_lengths& arcs) : m_queue(number_of_nodes, arcs) {}

  bool is_empty()
  {
    while(!m_queue.is_empty() && m_keys.empty())
      extract_stale();
    return m_keys.empty();
  }

  // As a search does: only if the node is absent or its key is lowered by it.
  void push(const Node node, const double key)
  {
    const auto [it, is_new] = m_keys.emplace(node, key);
    if(!is_new && it->second <= key)
      return;
    it->second = key;
    m_queue.push(node, key);
  }

  double pop()
  {
    for(;;)
    {
      EXPECT_FALSE(m_queue.is_empty());
      const auto [key, node] = extract_one(m_queue);
      EXPECT_GE(key, m_last);
      EXPECT_FALSE(m_queue.is_final(key));
      EXPECT_TRUE(m_queue.is_final(std::nextafter(key, -1)));
      m_last = key;
      const auto it = m_keys.find(node);
      if(it != m_keys.end() && it->second == key)
      {
        EXPECT_EQ(key, smallest());
        m_keys.erase(it);
        return key;
      }
      EXPECT_TRUE(keeps_stale_entries<Queue>);
    }
  }

  void check_nodes() const
  {
    std::set<Node> found;
    m_queue.for_each_node([&](const Node node) { found.insert(node); });
    for(const auto& [node, key] : m_keys)
      EXPECT_EQ(found.count(node), 1u);
    if(!keeps_stale_entries<Queue>)
    {
      EXPECT_EQ(found.size(), m_keys.size());
    }
  }

  void clear()
  {
    m_queue.clear();
    m_keys.clear();
    m_last = 0;
    EXPECT_TRUE(m_queue.is_empty());
    EXPECT_FALSE(m_queue.is_final(0));
  }

  void move_about()
  {
    Queue other(std::move(m_queue));
    m_queue = Queue();
    m_queue = std::move(other);
  }

  const Queue& queue() const { return m_queue; }

private:
  void extract_stale()
  {
    EXPECT_TRUE(keeps_stale_entries<Queue>);
    m_queue.extract_min();
  }

  double smallest() const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const auto& [node, key] : m_keys)
      result = (std::min)(result, key);
    return result;
  }

  Queue m_queue;
  std::map<Node, double> m_keys;
  double m_last = 0;
};

template <typename Queue>
class Ordered_queues : public testing::Test
{
};
using Types_of_queues = testing::Types<Array_queue,
                                       Binary_heap_queue,
                                       D_ary_heap_queue<4>,
                                       D_ary_heap_queue<7>,
                                       Fibonacci_heap_queue,
                                       Pairing_heap_queue,
                                       Radix_heap_queue,
                                       Published_bucket_queue,
                                       Basic_published_bucket_queue<Fixed_bucket_width>>;
TYPED_TEST_SUITE(Ordered_queues, Types_of_queues, );

const Arc_lengths arcs_of_several_sizes[] = {{1, 1, 1},
                                             {0.5, 1, 3},
                                             {0, 1e-3, 1},
                                             {1e-12, 1e-9, 1},
                                             {1e-310, 1e-309, 1e-308},
                                             {1e290, 1e300, 1e303}};

TYPED_TEST(Ordered_queues, agree_with_a_sorted_container)
{
  for(const Arc_lengths& arcs : arcs_of_several_sizes)
  {
    SCOPED_TRACE(arcs.longest);
    Random random(test_seed());
    Checked_ordered_queue<TypeParam> queue(arcs);
    for(std::size_t run = 0; run < 5; ++run)
    {
      std::size_t pushes_left = 1000;
      for(Node n = 0; n < 20; ++n)
        queue.push(n, 3 * random_gap(arcs, random)); // sources, in any order
      while(!queue.is_empty())
      {
        const double last = queue.pop();
        for(std::size_t i = random.below(4); i > 0 && pushes_left > 0; --i, --pushes_left)
          queue.push(static_cast<Node>(random.below(number_of_nodes)),
                     last + random_gap(arcs, random));
        if(pushes_left % 200 == 0)
          queue.check_nodes();
        if(run % 3 == 2 && pushes_left < 700)
          break; // an early stop
      }
      queue.check_nodes();
      queue.clear();
    }
  }
}

TYPED_TEST(Ordered_queues, take_equal_keys)
{
  Checked_ordered_queue<TypeParam> queue({1, 1, 1});
  for(Node n = 0; n < 100; ++n)
    queue.push(n, n % 2 == 0 ? 0.0 : 1.0);
  for(Node n = 0; n < 100; ++n)
    EXPECT_EQ(queue.pop(), n < 50 ? 0.0 : 1.0);
  EXPECT_TRUE(queue.is_empty());
}

TYPED_TEST(Ordered_queues, take_keys_of_all_magnitudes)
{
  Checked_ordered_queue<TypeParam> queue({1, 1, 1});
  const std::vector<double> keys = {-0.0, 5e-324, 1e-310, 1e-200, 1, 1e15, 1e200, 1.7e308};
  for(std::size_t i = keys.size(); i > 0; --i)
    queue.push(static_cast<Node>(i), keys[i - 1]);
  for(const double key : keys)
    EXPECT_EQ(queue.pop(), key);
  EXPECT_TRUE(queue.is_empty());
}

// The key of each node falls again and again, those of others between them.
TYPED_TEST(Ordered_queues, lower_keys)
{
  Checked_ordered_queue<TypeParam> queue({1, 10, 100});
  Random random(test_seed());
  for(Node n = 0; n < number_of_nodes; ++n)
    queue.push(n, 400);
  for(std::size_t i = 0; i < 3000; ++i)
    queue.push(static_cast<Node>(random.below(number_of_nodes)), random.between(0, 400));
  queue.check_nodes();
  for(Node n = 0; n < number_of_nodes; ++n)
    queue.pop();
  EXPECT_TRUE(queue.is_empty());
}

TYPED_TEST(Ordered_queues, are_moved_with_their_entries)
{
  Checked_ordered_queue<TypeParam> queue({1, 1, 1});
  for(Node n = 0; n < 100; ++n)
    queue.push(n, 50 + double(n * 37 % 100) / 7);
  queue.pop();
  queue.move_about();
  for(Node n = 40; n < 70; ++n)
    queue.push(n, 55 + double(n * 41 % 100) / 9); // lowers some
  while(!queue.is_empty())
    queue.pop();
  queue.clear();
}

TYPED_TEST(Ordered_queues, take_memory_in_proportion)
{
  Checked_ordered_queue<TypeParam> queue({1, 1, 1});
  const std::size_t memory_when_empty = queue.queue().memory();
  EXPECT_LT(memory_when_empty, 200000u);
  for(Node n = 0; n < number_of_nodes; ++n)
    queue.push(n, 0.05 * n);
  EXPECT_GE(queue.queue().memory(), number_of_nodes * sizeof(Queue_entry));
  EXPECT_LE(queue.queue().memory(), memory_when_empty + 100 * number_of_nodes);
}

// As many sources as a user likes, from far to near: chains of nodes of some heaps get as long.
TYPED_TEST(Ordered_queues, do_not_recur_deeply)
{
  constexpr std::size_t many = 1000000;
  constexpr std::size_t pushed = std::is_same_v<TypeParam, Array_queue> ? 1000 : many;
  {
    TypeParam queue(many, Arc_lengths{1, 1, 1});
    for(std::size_t n = 0; n < pushed; ++n)
      queue.push(static_cast<Node>(n), double(many - n));
    if(!std::is_same_v<TypeParam, Published_bucket_queue>)
    {
      EXPECT_EQ(extract_one(queue).node, pushed - 1);
    }
    queue.clear();
    EXPECT_TRUE(queue.is_empty());
    for(std::size_t n = 0; n < pushed; ++n)
      queue.push(static_cast<Node>(n), double(many - n));
  } // destroyed with its entries
}

TEST(Published_bucket_width, grows_by_steps)
{
  Published_bucket_width policy({1e-5, 1, 10});
  EXPECT_EQ(policy.width(), 0.1);
  Bucket_statistics run;
  run.used_buckets = 10;
  run.entries = 640;
  policy.update(run); // just not too many
  EXPECT_EQ(policy.width(), 0.1);
  run.entries = 641;
  policy.update(run);
  EXPECT_EQ(policy.width(), 10. / 200);
  policy.update(run);
  EXPECT_EQ(policy.width(), 10. / 300);
  run.entries = 10;
  policy.update(run);
  EXPECT_EQ(policy.width(), 10. / 300); // never wider again
}

TEST(Published_bucket_width, has_a_bound)
{
  Bucket_statistics run;
  run.used_buckets = 1;
  run.entries = 1000;
  const auto narrowest = [&](const Arc_lengths& arcs) {
    Published_bucket_width policy(arcs);
    for(std::size_t i = 0; i < 100000; ++i)
      policy.update(run);
    return policy.width();
  };
  EXPECT_EQ(narrowest({0.03, 1, 10}), 0.0003);
  EXPECT_EQ(narrowest({10, 10, 10}), 0.1); // the first width
  EXPECT_EQ(narrowest({0, 1, 10}), 10 * 1e-6);
  EXPECT_GT(narrowest({0, 0, 0}), 0);
  EXPECT_TRUE(std::isfinite(1 / narrowest({0, 0, 5e-324})));
}

// Buckets of width 1; by hand: bucket 0 gives nothing, 1 gives three entries, after searches among
// 2, 2 and 1 of them, 2 nothing, and 3 gives one of the two that were entered last.
TEST(Published_bucket_queue, has_the_statistics_of_a_run_by_hand)
{
  Basic_published_bucket_queue<Fixed_bucket_width> queue(10, {1, 1, 10});
  queue.push(0, 1.5);
  queue.push(1, 3.5);
  queue.push(1, 1.25); // moves to the other bucket
  EXPECT_EQ(extract_one(queue).node, 1u);
  queue.push(2, 1.75);
  EXPECT_EQ(extract_one(queue).node, 0u);
  EXPECT_EQ(extract_one(queue).node, 2u);
  queue.push(3, 3.75);
  queue.push(4, 3.25);
  EXPECT_EQ(extract_one(queue).node, 4u);

  const Bucket_statistics s = queue.statistics();
  EXPECT_EQ(s.width, 1);
  EXPECT_EQ(s.entries, 4u);
  EXPECT_EQ(s.used_buckets, 2u);
  EXPECT_EQ(s.visited_buckets, 4u);
  EXPECT_EQ(s.comparisons, 1u + 1 + 0 + 1);
  EXPECT_EQ(s.late_entries, 0u);
  EXPECT_EQ(s.mean_occupancy(), 2);
  EXPECT_EQ(s.standard_deviation_of_occupancy(), 1);
  queue.clear();
  EXPECT_EQ(queue.statistics().entries, 0u);
}

TEST(Published_bucket_queue, has_a_limited_number_of_buckets)
{
  Basic_published_bucket_queue<Fixed_bucket_width> queue(1000, {1, 1, 1});
  for(Node n = 0; n < 1000; ++n)
    queue.push(n, 1e12 * (1000 - n)); // all in the last bucket
  EXPECT_LT(queue.memory(), 2 * (16 * 1000 + 5000) * sizeof(std::vector<Queue_entry>));
  for(Node n = 1000; n > 0; --n)
    ASSERT_EQ(extract_one(queue).node, n - 1);
}

// Keys that differ in every bit in turn: an entry moves through as many buckets as there are.
TEST(Radix_heap_queue, moves_entries_down_bit_by_bit)
{
  Radix_heap_queue queue;
  std::vector<double> keys;
  for(int e = 0; e < 52; ++e)
    keys.push_back(2 - std::pow(2., -e));
  for(std::size_t i = 0; i < keys.size(); ++i)
    queue.push(static_cast<Node>(i), keys[keys.size() - 1 - i]);
  for(const double key : keys)
    EXPECT_EQ(extract_one(queue).key, key);
  EXPECT_TRUE(queue.is_empty());
}

} // namespace
