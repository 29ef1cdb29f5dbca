// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::internal::Indexed_heap;
using Node = Indexed_heap::Node;

double smallest_key(const std::map<Node, double>& key_of_node)
{
  return std::min_element(key_of_node.begin(), key_of_node.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->second;
}

TEST(Indexed_heap, agrees_with_a_map)
{
  Random random(test_seed());
  Indexed_heap heap(50); // and nodes beyond
  std::map<Node, double> expected;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    ASSERT_EQ(heap.size(), expected.size());
    if(random.below(3) > 0 || heap.is_empty())
    {
      const Node node = Node(random.below(200));
      const double key = random.between(0, 1);
      const auto [position, is_new] = expected.emplace(node, key);
      EXPECT_EQ(heap.push({key, node}), is_new);
      position->second = (std::min)(position->second, key);
    }
    else
    {
      const auto top = heap.top();
      EXPECT_EQ(top.key, smallest_key(expected));
      EXPECT_EQ(top.key, expected.at(top.node));
      heap.pop();
      expected.erase(top.node);
    }
  }
  EXPECT_GT(heap.comparisons(), 0u);
}

TEST(Indexed_heap, holds_a_node_once)
{
  Indexed_heap heap(3);
  EXPECT_TRUE(heap.push({2, 1}));
  EXPECT_FALSE(heap.push({3, 1}));
  EXPECT_EQ(heap.top().key, 2);
  EXPECT_FALSE(heap.push({1, 1}));
  EXPECT_EQ(heap.top().key, 1);
  heap.clear();
  EXPECT_TRUE(heap.is_empty());
  EXPECT_EQ(heap.comparisons(), 0u);
  EXPECT_TRUE(heap.push({5, 1}));
}

} // namespace
