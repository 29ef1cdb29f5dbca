// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PUBLISHED_BUCKET_QUEUE_H
#define BENCHMARK_PUBLISHED_BUCKET_QUEUE_H

#include "peers/Published_bucket_width.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*
 * The adaptive bucket queue as Schwartz, de Rezende and Pedrini published it (2015), provided for
 * comparison with `Basic_adaptive_bucket_queue`. The buckets cover all keys from 0 to the largest
 * one. `extract_min()` searches the first nonempty bucket for its smallest key. A node whose key
 * decreases moves to another bucket.
 *
 * The queue starts with 5000 buckets, and grows when a key lies beyond the last one. Unlike in the
 * publication, their number is limited to 5000 plus 16 times the number of nodes; the last bucket
 * takes all larger keys, so that a huge key costs time, not memory.
 *
 * `push()` takes constant time; `extract_min()` takes time proportional to the number of entries of
 * the bucket and of skipped empty buckets. Buckets retain the memory of their largest sizes; there
 * is a slot per node.
 *
 * \tparam WidthPolicy a model of `BucketWidthPolicy`
 */
template <typename WidthPolicy = Published_bucket_width>
class Basic_published_bucket_queue : public internal::Ordered_queue_base
{
public:
  // Constructs an empty queue for a graph with `number_of_nodes` nodes and the given arc lengths.
  explicit Basic_published_bucket_queue(const std::size_t number_of_nodes = 0,
                                        const Arc_lengths& arcs = Arc_lengths())
    : m_largest_number((std::min)(16 * number_of_nodes + FIRST_NUMBER, LARGEST_NUMBER)),
      m_policy(arcs),
      m_buckets(FIRST_NUMBER),
      m_slot(number_of_nodes)
  {
    start();
  }

  // Returns whether the queue is empty.
  bool is_empty() const { return m_size == 0; }

  // Inserts `node` with `key`, or decreases its key.
  // \pre The node exists, and `key` is not smaller than the last extracted key.
  void push(const Node node, const Key key)
  {
    CGAL_precondition(node < m_slot.size() && !is_final(key));
    const Slot old = m_slot[node];
    if(old.bucket == nowhere)
      enter(node, key);
    else if(key < m_buckets[old.bucket][old.position].key)
    {
      enter(node, key); // first, because it may throw
      remove(old);
      --m_size;
    }
  }

  // Removes and returns the entry with the smallest key. \pre `!is_empty()`
  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    while(m_buckets[m_current].empty())
      go_to_next_bucket();
    const Bucket& bucket = m_buckets[m_current];
    const auto smallest = std::min_element(
        bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    m_statistics.comparisons += bucket.size() - 1;
    const Entry result = *smallest;
    const Slot slot = m_slot[result.node];
    m_slot[result.node] = Slot();
    remove(slot);
    --m_size;
    ++m_extracted_here;
    return hand_out(result);
  }

  // Calls `f(node)` for the nodes of all entries.
  template <typename F>
  void for_each_node(F f) const
  {
    for(std::size_t i = m_current; i < m_beyond_used; ++i)
      for(const Entry& e : m_buckets[i])
        f(e.node);
  }

  // Removes all entries, and adapts the bucket width to the last run.
  void clear()
  {
    for(std::size_t i = m_current; i < m_beyond_used; ++i)
    {
      for(const Entry& e : m_buckets[i])
        m_slot[e.node] = Slot();
      m_buckets[i].clear();
    }
    m_policy.update(statistics());
    start();
  }

  // Returns the statistics since the last call of `clear()`. The occupancy of a bucket is the
  // number of entries extracted from it.
  Bucket_statistics statistics() const
  {
    Bucket_statistics result = m_statistics;
    if(m_extracted_here > 0)
      result.add_bucket(m_extracted_here);
    return result;
  }

  // Returns the size of the queue in bytes.
  std::size_t memory() const
  {
    std::size_t entries = 0;
    for(const Bucket& b : m_buckets)
      entries += b.capacity();
    return m_buckets.capacity() * sizeof(Bucket) + entries * sizeof(Entry) +
           m_slot.capacity() * sizeof(Slot);
  }

private:
  using Bucket = std::vector<Entry>;

  static constexpr std::size_t FIRST_NUMBER = 5000;                   // of buckets
  static constexpr std::size_t LARGEST_NUMBER = std::size_t(1) << 31; // fits 32 bits
  static constexpr std::uint32_t nowhere = (std::numeric_limits<std::uint32_t>::max)();

  struct Slot
  {
    std::uint32_t bucket = nowhere;
    std::uint32_t position = 0;
  };

  void start()
  {
    m_statistics = Bucket_statistics();
    m_statistics.width = m_policy.width();
    m_buckets_per_unit = m_statistics.width > 0 ? 1 / m_statistics.width : 0;
    m_current = 0;
    m_beyond_used = 0;
    m_size = 0;
    m_extracted_here = 0;
    restart();
  }

  std::size_t index(const Key key) const
  {
    const double result = key * m_buckets_per_unit;
    return result < double(m_largest_number) ? static_cast<std::size_t>(result)
                                             : m_largest_number - 1;
  }

  void enter(const Node node, const Key key)
  {
    const std::size_t i = index(key);
    if(i >= m_buckets.size())
      m_buckets.resize((std::min)(2 * i, m_largest_number));
    m_beyond_used = (std::max)(m_beyond_used, i + 1);
    m_buckets[i].push_back({key, node});
    m_slot[node] = {static_cast<std::uint32_t>(i),
                    static_cast<std::uint32_t>(m_buckets[i].size() - 1)};
    ++m_size;
  }

  // Replaces the entry by the last one of the bucket.
  void remove(const Slot slot)
  {
    Bucket& bucket = m_buckets[slot.bucket];
    if(slot.position + 1 < bucket.size())
    {
      bucket[slot.position] = bucket.back();
      m_slot[bucket.back().node].position = slot.position;
    }
    bucket.pop_back();
  }

  void go_to_next_bucket()
  {
    m_statistics.add_bucket(m_extracted_here);
    m_extracted_here = 0;
    ++m_current;
  }

  std::size_t m_largest_number; // of buckets
  WidthPolicy m_policy;
  std::vector<Bucket> m_buckets;
  std::vector<Slot> m_slot; // by node
  double m_buckets_per_unit = 1;
  std::size_t m_current = 0;        // the current bucket
  std::size_t m_beyond_used = 0;    // all buckets from here on are empty
  std::size_t m_size = 0;           // the number of entries
  std::size_t m_extracted_here = 0; // the number of entries extracted from the current bucket
  Bucket_statistics m_statistics;
};

/*
 * The published adaptive bucket queue with the published widths.
 */
using Published_bucket_queue = Basic_published_bucket_queue<Published_bucket_width>;

} // namespace CGAL::Approximate_geodesics

#endif // BENCHMARK_PUBLISHED_BUCKET_QUEUE_H
