// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/fixed_bucket_width.h"
#include "checks/random_gap.h"
#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::Adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Arc_lengths;
using CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue;
using Fixed_queue = Basic_adaptive_bucket_queue<Fixed_bucket_width>;
using Node = Fixed_queue::Node;

// A queue beside a sorted container that receives the same entries.
template <typename Queue>
class Checked_queue
{
public:
  explicit Checked_queue(const Arc_lengths& arcs) : m_queue(0, arcs) {}

  void push(const double key)
  {
    m_queue.push(m_number_of_nodes, key);
    m_expected.emplace(key, m_number_of_nodes++);
  }

  // Takes an entry out of both, and returns its key.
  double pop()
  {
    if(m_batch.empty())
      extract();
    const double key = m_batch.back();
    m_batch.pop_back();
    return key;
  }

  void clear()
  {
    m_queue.clear();
    m_expected.clear();
    m_batch.clear();
  }

  void check_nodes() const
  {
    std::set<Node> nodes;
    m_queue.for_each_node([&](const Node node) { nodes.insert(node); });
    for(const auto& [key, node] : m_expected)
      EXPECT_EQ(nodes.count(node), 1u) << "node " << node;
    for(const Node node : nodes)
      EXPECT_LT(node, m_number_of_nodes);
  }

  bool is_empty() const
  {
    EXPECT_EQ(m_queue.is_empty(), m_expected.empty());
    return m_queue.is_empty() && m_batch.empty();
  }

  Queue& queue() { return m_queue; }

private:
  void extract()
  {
    const double smallest = m_expected.begin()->first;
    const auto batch = m_queue.extract_min();
    EXPECT_GT(batch.size(), 0u);
    EXPECT_LE(batch.size(), Queue::LARGEST_BATCH);
    EXPECT_FALSE(m_queue.is_final(smallest)) << "a smaller key was left behind";
    const double width = m_queue.statistics().width;
    for(const auto& [key, node] : batch)
    {
      if(key / width < 0x1p61) // buckets that far away need not be told apart
      {
        // one bucket, and some rounding where buckets are as narrow as that
        EXPECT_LE(key - smallest, width + 4 * std::abs(key) * 0x1p-52);
      }
      erase(key, node);
      m_batch.insert(m_batch.begin(), key);
    }
  }

  void erase(const double key, const Node node)
  {
    const auto [first, beyond] = m_expected.equal_range(key);
    const auto it =
        std::find_if(first, beyond, [&](const auto& entry) { return entry.second == node; });
    if(it != beyond)
      m_expected.erase(it);
    else
      ADD_FAILURE() << "node " << node << " was not entered with key " << key;
  }

  Queue m_queue;
  std::multimap<double, Node> m_expected;
  std::vector<double> m_batch; // what came out and was not popped, the next one at the end
  Node m_number_of_nodes = 0;
};

template <typename Queue>
void run_random_program(Checked_queue<Queue>& queue, const Arc_lengths& arcs, Random& random)
{
  double last = 0;
  std::size_t pushes_left = 3000;
  for(std::size_t i = 0; i < 10; ++i, --pushes_left)
    queue.push(random_gap(arcs, random));
  while(!queue.is_empty())
  {
    last = queue.pop();
    for(std::size_t i = random.below(3); i > 0 && pushes_left > 0; --i, --pushes_left)
      queue.push(last + random_gap(arcs, random));
    if(pushes_left % 500 == 0)
      queue.check_nodes();
    if(pushes_left < 1000 && random.below(1000) == 0)
      return; // an early stop
  }
}

template <typename Queue>
void run_random_programs(const Arc_lengths& arcs)
{
  SCOPED_TRACE(testing::Message() << "arcs " << arcs.shortest << " .. " << arcs.longest);
  Random random(test_seed());
  Checked_queue<Queue> queue(arcs);
  for(std::size_t run = 0; run < 12; ++run)
  {
    run_random_program(queue, arcs, random);
    queue.clear();
    EXPECT_TRUE(queue.is_empty());
    queue.check_nodes();
  }
}

const Arc_lengths arcs_of_many_kinds[] = {{1, 1, 1},           {0.5, 1, 3},      {0, 1e-3, 1},
                                          {1e-12, 1e-9, 1},    {0, 0, 0},        {1, 1, 1000},
                                          {1e-300, 1e-299, 2}, {1e-5, 1, 100000}};

TEST(Queue, agrees_with_a_sorted_container)
{
  for(const Arc_lengths& arcs : arcs_of_many_kinds)
    run_random_programs<Adaptive_bucket_queue>(arcs);
}

TEST(Queue, agrees_with_a_sorted_container_under_another_policy)
{
  for(const Arc_lengths& arcs : arcs_of_many_kinds)
    if(arcs.mean > 0)
      run_random_programs<Fixed_queue>(arcs);
}

TEST(Queue, takes_equal_keys)
{
  Checked_queue<Adaptive_bucket_queue> queue({1, 1, 1});
  for(std::size_t i = 0; i < 1000; ++i)
    queue.push(i % 2 == 0 ? 0.0 : 1.0);
  for(std::size_t i = 0; i < 1000; ++i)
    EXPECT_EQ(queue.pop(), i < 500 ? 0.0 : 1.0);
  EXPECT_TRUE(queue.is_empty());
}

TEST(Queue, keeps_keys_beyond_the_circle)
{
  Checked_queue<Fixed_queue> queue({1, 1, 4}); // a circle of at most 8 buckets of width 1
  for(const double key : {1e300, 1e6, 3.0, 1e6, 1e12, 0.0, 2e6})
    queue.push(key);
  queue.check_nodes();
  for(const double key : {0.0, 3.0, 1e6, 1e6, 2e6, 1e12, 1e300})
    EXPECT_EQ(queue.pop(), key);
  EXPECT_TRUE(queue.is_empty());
  EXPECT_LT(queue.queue().statistics().visited_buckets, 100u); // it does not step through the gap
}

// A bucket that is fed while it is drained becomes a heap; entries then come out in order.
TEST(Queue, sorts_a_bucket_that_keeps_growing)
{
  Random random(test_seed());
  Checked_queue<Fixed_queue> queue({1e-9, 1, 1});
  queue.push(0);
  double last = 0;
  bool is_sorted = true;
  for(std::size_t i = 0; i < 5000; ++i)
  {
    const double key = queue.pop();
    is_sorted = is_sorted && (i < 1000 || key >= last);
    last = key;
    queue.push((std::min)(key + random.between(0, 1e-4), 0.999));
    if(i % 3 == 0)
      queue.push((std::min)(key + random.between(0, 1e-3), 0.999));
  }
  EXPECT_TRUE(is_sorted);
  EXPECT_GT(queue.queue().statistics().comparisons, 0u);
  queue.check_nodes();
  while(!queue.is_empty())
    queue.pop();
}

TEST(Queue, says_which_keys_are_final)
{
  Fixed_queue queue(0, {1, 1, 4});
  queue.push(0, 0.5);
  queue.push(1, 2.25);
  EXPECT_FALSE(queue.is_final(0));
  queue.extract_min();
  EXPECT_FALSE(queue.is_final(0.5)); // a smaller one may still come into the bucket
  EXPECT_FALSE(queue.is_final(0));
  queue.extract_min();
  EXPECT_TRUE(queue.is_final(0.5));
  EXPECT_TRUE(queue.is_final(1.99));
  EXPECT_FALSE(queue.is_final(2));
  EXPECT_FALSE(queue.is_final(1e300));
  queue.clear();
  EXPECT_FALSE(queue.is_final(0));
}

std::vector<Node> nodes_of(const Fixed_queue::Batch& batch)
{
  std::vector<Node> result;
  for(const auto& [key, node] : batch)
    result.push_back(node);
  return result;
}

// A batch comes from one bucket, and stays as it is while the search pushes.
TEST(Queue, hands_out_batches)
{
  Fixed_queue queue(0, {1, 1, 4});
  for(const Node node : {7u, 3u, 5u, 4u})
    queue.push(node, 1.5);
  queue.push(9, 2.5);
  const Fixed_queue::Batch batch = queue.extract_min();
  for(Node node = 100; node < 1000; ++node)
    queue.push(node, 1.25);
  EXPECT_EQ(nodes_of(batch), (std::vector<Node>{7, 3, 5, 4}));
  EXPECT_EQ(queue.extract_min().size(), Fixed_queue::LARGEST_BATCH);
}

TEST(Queue, is_copied_with_its_entries)
{
  Fixed_queue queue(0, {1, 1, 4});
  for(Node node = 0; node < 100; ++node)
    queue.push(node, 1.5);
  queue.extract_min();
  Fixed_queue copy(queue);
  const std::vector<Node> expected = nodes_of(queue.extract_min());
  queue = Fixed_queue(0, {1, 1, 4});
  EXPECT_EQ(nodes_of(copy.extract_min()), expected);
}

// One at a time, smallest key first, until it is cleared: then there are batches again.
TEST(Queue, keeps_order_until_it_is_cleared)
{
  Random random(test_seed());
  Fixed_queue queue(0, {1, 1, 4});
  for(int round = 0; round < 3; ++round)
  {
    queue.keep_order();
    std::multiset<double> expected;
    double last = 0;
    for(Node node = 0; node < 500; ++node)
    {
      const double key = last + random.between(0, 50), smaller = last + random.between(0, 1);
      queue.push(node, key);
      queue.push(node + 1000, smaller);
      expected.insert({key, smaller});
      const Fixed_queue::Batch batch = queue.extract_min();
      ASSERT_EQ(batch.size(), 1u);
      last = batch.begin()->key;
      EXPECT_EQ(last, *expected.begin());
      EXPECT_FALSE(queue.is_final(last));
      EXPECT_TRUE(queue.is_final(std::nextafter(last, 0.)));
      expected.erase(expected.begin());
    }
    EXPECT_FALSE(queue.is_empty());
    queue.clear();
    EXPECT_TRUE(queue.is_empty());
    for(const Node node : {7u, 3u, 5u, 4u})
      queue.push(node, 1.5);
    EXPECT_EQ(nodes_of(queue.extract_min()), (std::vector<Node>{7, 3, 5, 4}));
    queue.clear();
  }
}

// Buckets beside a long arc of 1e12 of the others: neither their number nor the steps explode.
TEST(Queue, has_a_limited_circle)
{
  Fixed_queue queue(0, {1, 1, 1e12});
  const std::size_t memory_when_empty = queue.memory();
  EXPECT_LT(memory_when_empty, 100000u); // 1024 buckets of three pointers are a quarter of that
  for(Node node = 0; node < 1000; ++node)
    queue.push(node, 1e9 * node);
  for(Node node = 0; node < 1000; ++node)
    ASSERT_EQ(queue.extract_min().begin()->node, node);
  EXPECT_LE(queue.statistics().visited_buckets, 1000u);
  // an array that grows by doubling takes up to twice its entries, and each bucket took one
  EXPECT_LT(queue.memory(), memory_when_empty + 3 * 1000 * sizeof(Fixed_queue::Entry));
}

// Every run fills another bucket of the circle; none keeps the memory of all of them.
TEST(Queue, takes_no_more_memory_from_run_to_run)
{
  Fixed_queue queue(2000, {1, 1, 60});
  const auto run = [&](const Node where) {
    for(Node node = 0; node < 2000; ++node)
      queue.push(node, 5.5);
    for(Node node = 0; node < 40; ++node)
      queue.push(node, 10.5 + (node + where) % 40);
    while(!queue.is_empty())
      queue.extract_min();
    queue.clear();
  };
  run(0);
  const std::size_t memory = queue.memory();
  for(Node i = 0; i < 300; ++i)
    run(i);
  EXPECT_LT(queue.memory(), 2 * memory);
}

} // namespace
