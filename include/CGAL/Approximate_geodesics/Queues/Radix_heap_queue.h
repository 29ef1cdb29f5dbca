// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_RADIX_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_RADIX_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/assertions.h>

#include <boost/integer/integer_log2.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {

// std::bit_width() of C++20.
inline std::size_t bit_width(const std::uint64_t i)
{
  if(i == 0)
    return 0;
#if defined(__GNUC__)
  return 64 - static_cast<std::size_t>(__builtin_clzll(i));
#else
  return 1 + static_cast<std::size_t>(boost::integer_log2(i));
#endif
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A monotone priority queue with 65 buckets. The bucket of an entry is the position of the first
 * bit in which its key differs from a lower bound of all keys \cgalCite{amot-faspp-90}. Nonnegative
 * doubles are ordered like their bit patterns, so neither a unit nor a range of keys is required.
 *
 * When the first bucket is empty, the entries of the first nonempty bucket are redistributed to the
 * buckets before it. An entry moves at most 64 times, and a few times in practice. A node whose key
 * decreases is pushed again; the search skips the stale entry.
 *
 * `push()` takes constant time, and `extract_min()` amortized time \cgalBigO{B} for keys of `B`
 * bits. Buckets retain the memory of their largest sizes.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
class Radix_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Ordered_queue_base
#endif
{
public:
  /// constructs an empty queue.
  explicit Radix_heap_queue(std::size_t /* number_of_nodes */ = 0,
                            const Arc_lengths& = Arc_lengths())
  {
  }

  /// returns whether the queue is empty.
  bool is_empty() const { return m_size == 0; }

  /// inserts `node` with `key`. \pre `key` is not smaller than the last extracted key.
  void push(const Node node, const Key key)
  {
    CGAL_precondition(!is_final(key));
    bucket_of(key).push_back({key, node});
    ++m_size;
  }

  /// removes and returns an entry with the smallest key, which may be stale.
  /// \pre `!is_empty()`
  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    if(m_buckets[0].empty())
      distribute(*std::find_if(m_buckets.begin(), m_buckets.end(),
                               [](const Bucket& b) { return !b.empty(); }));
    const Entry result = m_buckets[0].back();
    m_buckets[0].pop_back();
    --m_size;
    return hand_out(result);
  }

  /// calls `f(node)` for the nodes of all entries.
  template <typename F>
  void for_each_node(F f) const
  {
    for(const Bucket& b : m_buckets)
      for(const Entry& e : b)
        f(e.node);
  }

  /// removes all entries.
  void clear()
  {
    for(Bucket& b : m_buckets)
      b.clear();
    m_size = 0;
    m_least = 0;
    restart();
  }

  /// returns the size of the queue in bytes.
  std::size_t memory() const
  {
    std::size_t entries = 0;
    for(const Bucket& b : m_buckets)
      entries += b.capacity();
    return entries * sizeof(Entry);
  }

private:
  using Bucket = std::vector<Entry>;
  using Bits = std::uint64_t;

  static Bits bits_of(const Key key)
  {
    const Key positive = key + 0.0; // normalizes negative zero
    Bits result;
    static_assert(sizeof(result) == sizeof(positive));
    std::memcpy(&result, &positive, sizeof(result));
    return result;
  }

  Bucket& bucket_of(const Key key)
  {
    return m_buckets[internal::bit_width(bits_of(key) ^ m_least)];
  }

  // The keys of a bucket agree in its bit, so they differ from their minimum in a lower bit only.
  void distribute(Bucket& bucket)
  {
    const auto smallest = std::min_element(
        bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    m_least = bits_of(smallest->key);
    for(const Entry& e : bucket)
      bucket_of(e.key).push_back(e);
    bucket.clear();
  }

  std::array<Bucket, 65> m_buckets;
  std::size_t m_size = 0; // the number of entries
  Bits m_least = 0;       // a lower bound of the keys in the queue
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_RADIX_HEAP_QUEUE_H
