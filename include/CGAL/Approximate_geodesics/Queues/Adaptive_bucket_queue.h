// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Balanced_bucket_width.h>
#include <CGAL/Approximate_geodesics/Queues/Bucket_statistics.h>
#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/Approximate_geodesics/Queues/internal/Indexed_heap.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A monotone priority queue that sorts its entries into buckets by their keys, and does not sort
 * them further. The bucket of the smallest keys is drained in rounds: a round is what the bucket
 * held when the round started, and comes out in batches; what enters the bucket meanwhile makes the
 * next round. A node whose key is lowered is entered again; the search skips the stale entry when
 * it comes out. After each run, its figures determine the width of the buckets for the next one.
 *
 * All keys in the queue lie within one longest arc of the current bucket, so a small circle of
 * buckets is enough. So few entries share a bucket that their order hardly matters: on scanned
 * models a node is expanded 1.00 to 1.04 times on average. Two fallbacks bound the cost where arc
 * lengths differ by many orders of magnitude:
 * - Keys beyond the circle, whose length is limited, wait in a heap until the circle reaches them.
 *   There, keys are lowered in place.
 * - A bucket that keeps growing while it is drained moves to the heap, and comes out smallest key
 *   first. So does every bucket once the number of entries extracted, or of those that wait, is
 *   several times the number of nodes. A run therefore expands \cgalBigO{n} nodes, for `n` of
 *   them, whatever the lengths.
 *
 * `push()` and `extract_min()` take constant time per entry, and \cgalBigO{\log m} for the `m`
 * entries on the heap. Each bucket of the circle keeps the memory of the largest number of entries
 * that it held, also from run to run. The heap takes 4 bytes per node from when it is first needed.
 *
 * Adapting the buckets to the mesh from run to run is an idea of Schwartz, de Rezende and Pedrini
 * \cgalCite{srp-fasgp-15}; the circle, draining in any order and the fallbacks are additions of
 * this package. Denardo and Fox introduced buckets drained in any order \cgalCite{df-spmrp-79}.
 *
 * \tparam WidthPolicy a model of `BucketWidthPolicy`
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
template <typename WidthPolicy = Balanced_bucket_width>
class Basic_adaptive_bucket_queue
{
public:
  /// the number of a node.
  using Node = std::uint32_t;

  /// a distance, in units of the graph.
  using Key = double;

  /// what comes out of the queue.
  using Entry = Queue_entry;

  /// a range of entries.
  using Batch = Iterator_range<const Entry*>;

  /// makes an empty queue for a graph with `number_of_nodes` nodes and the given arcs.
  explicit Basic_adaptive_bucket_queue(const std::size_t number_of_nodes = 0,
                                       const Arc_lengths& arcs = Arc_lengths())
    : m_heap(number_of_nodes),
      m_number_of_nodes(number_of_nodes),
      m_longest_arc(arcs.longest),
      m_policy(arcs)
  {
    set_up_circle();
  }

  /// returns whether no entry is left.
  bool is_empty() const { return m_size == 0; }

  /*!
   * enters `node` with `key`.
   * \pre `key` is not a NaN, and not below the bucket that is being drained.
   */
  void push(const Node node, const Key key)
  {
    CGAL_precondition(!is_final(key));
    const Index index = bucket_index(key);
    if(index - m_first_in_circle < m_number_in_circle)
    {
      bucket(index).push_back({key, node});
      ++m_size;
    }
    else
      push_onto_heap({key, node});
  }

  /*!
   * removes up to `LARGEST_BATCH` entries of the first bucket that is not empty, and returns them.
   * They may be stale: the node may have been entered with a smaller key since. The range is valid
   * until the next call of `extract_min()` or `clear()`.
   * \pre `!is_empty()`
   */
  Batch extract_min() { return extract(LARGEST_BATCH); }

  /// removes all entries of the first bucket that is not empty, but for those that enter it from
  /// now on, and returns them: a batch that keeps several threads busy. \pre `!is_empty()`
  Batch extract_round() { return extract((std::numeric_limits<std::size_t>::max)()); }

  /// the largest number of entries in a batch.
  static constexpr std::size_t LARGEST_BATCH = 32;

  /// returns whether `key` is smaller than all keys in the queue and all that may still be pushed.
  bool is_final(const Key key) const { return bucket_index(key) < m_current; }

  /// calls `f(node)` for the nodes of all entries, for some of them more than once.
  template <typename F>
  void for_each_node(F f) const
  {
    for(const Bucket* entries : {&m_round, &m_heap.entries()})
      for(const Entry& e : *entries)
        f(e.node);
    for(const Bucket& b : m_buckets)
      for(const Entry& e : b)
        f(e.node);
  }

  /// removes all entries, and adapts the width of the buckets to the last run.
  void clear()
  {
    for(Bucket& b : m_buckets)
      b.clear();
    m_policy.update(statistics());
    m_heap.clear();
    set_up_circle();
  }

  /// returns the figures of the run since the last call of `clear()`.
  Bucket_statistics statistics() const
  {
    Bucket_statistics result = m_statistics;
    result.comparisons = m_heap.comparisons();
    if(number_drained() > 0)
      add_current_bucket(result);
    return result;
  }

  /// returns the number of bytes that the queue takes.
  std::size_t memory() const
  {
    std::size_t entries = m_round.capacity();
    for(const Bucket& b : m_buckets)
      entries += b.capacity();
    return m_buckets.capacity() * sizeof(Bucket) + entries * sizeof(Entry) + m_heap.memory();
  }

private:
  using Bucket = std::vector<Entry>;
  using Index = std::uint64_t; // of a bucket, counted from key 0 on

  static constexpr Index LARGEST_CIRCLE = 1024; // arcs longer than 1023 widths are rare
  static constexpr Index LARGEST_INDEX = Index(1) << 62;

  Batch extract(const std::size_t largest_batch)
  {
    CGAL_precondition(!is_empty());
    if(m_next == m_round.size())
      start_next_round();
    const Entry* const first = m_round.data() + m_next;
    const std::size_t size = (std::min)(m_round.size() - m_next, largest_batch);
    m_next += size;
    m_size -= size;
    return Batch(first, first + size);
  }

  // Monotone in `key`, which is all that correctness needs of it.
  Index bucket_index(const Key key) const
  {
    const double index = key * m_buckets_per_unit;
    return index < double(LARGEST_INDEX) ? static_cast<Index>(static_cast<std::int64_t>(index))
                                         : LARGEST_INDEX;
  }

  Bucket& bucket(const Index index) { return m_buckets[static_cast<std::size_t>(index & m_mask)]; }

  void set_up_circle()
  {
    const double width = m_policy.width();
    const double needed = m_longest_arc / width + 2;
    std::size_t size = 2;
    while(double(size) < needed && size < LARGEST_CIRCLE)
      size *= 2;
    m_buckets.resize(size);
    m_mask = size - 1;
    m_buckets_per_unit = 1 / width;
    m_size = 0;
    m_statistics = Bucket_statistics();
    m_statistics.width = width;
    m_unordered_budget = unordered_limit();
    m_round.clear();
    m_next = 0;
    open_bucket(0);
  }

  // Limit on unordered entries, in the queue and extracted; ordinary runs stay far below.
  std::size_t unordered_limit() const { return 8 * m_number_of_nodes + 1024; }

  void open_bucket(const Index index)
  {
    m_current = index;
    m_is_in_order = false;
    m_first_in_circle = index;
    m_number_in_circle = m_buckets.size();
    m_drained = 0;
    m_first_round = 0;
  }

  // Entries of the current bucket, none of which is in the last round.
  Bucket& current_bucket() { return bucket(m_current); }

  // A round is what the current bucket holds. What is pushed into it meanwhile makes the next
  // round.
  BOOST_NOINLINE void start_next_round()
  {
    m_round.clear();
    m_next = 0;
    while(m_round.empty())
    {
      if(m_is_in_order && nearest_index() == m_current)
        take_out_in_order();
      else if(m_is_in_order || current_bucket().empty())
        open_next_bucket();
      else if(shall_be_put_in_order())
        put_in_order();
      else
        std::swap(m_round, current_bucket());
    }
    m_drained += m_round.size();
    if(m_first_round == 0)
      m_first_round = m_drained;
  }

  // Goes on to the next bucket, which may be empty.
  void open_next_bucket()
  {
    add_current_bucket(m_statistics);
    if(m_round.capacity() > current_bucket().capacity())
      std::swap(m_round, current_bucket()); // or each bucket would get the memory of the largest
    m_unordered_budget -= (std::min)(m_unordered_budget, m_drained);

    const bool circle_is_empty = m_size == m_heap.size();
    open_bucket(circle_is_empty ? nearest_index() : m_current + 1);
    while(nearest_index() - m_first_in_circle < m_number_in_circle)
      move_nearest_into_circle();
  }

  // the number of entries of the current bucket that were extracted
  std::size_t number_drained() const { return m_drained - (m_round.size() - m_next); }

  void add_current_bucket(Bucket_statistics& statistics) const
  {
    const std::size_t drained = number_drained();
    statistics.add_bucket(drained, drained - (std::min)(drained, m_first_round));
  }

  // Whether the bucket refills faster than it drains, and is to be emptied in order.
  bool shall_be_put_in_order() const
  {
    const std::size_t limit = (std::min)(3 * m_first_round / 2 + 64, m_unordered_budget);
    return m_drained >= limit || m_size > unordered_limit();
  }

  // From now on, entries of the current bucket wait in the heap.
  void put_in_order()
  {
    m_is_in_order = true;
    if(m_drained == 0)
      m_first_round = current_bucket().size();
    ++m_first_in_circle;
    --m_number_in_circle;
    m_size -= current_bucket().size();
    for(const Entry& e : current_bucket())
      push_onto_heap(e);
    current_bucket().clear();
  }

  void take_out_in_order()
  {
    m_round.push_back(m_heap.top());
    m_heap.pop();
  }

  void move_nearest_into_circle()
  {
    bucket(nearest_index()).push_back(m_heap.top());
    m_heap.pop();
  }

  // the index of the smallest key on the heap
  Index nearest_index() const
  {
    return m_heap.is_empty() ? (std::numeric_limits<Index>::max)() : bucket_index(m_heap.top().key);
  }

  BOOST_NOINLINE void push_onto_heap(const Entry& e)
  {
    m_size += static_cast<std::size_t>(m_heap.push(e));
  }

  std::vector<Bucket> m_buckets; // a circle; their number is a power of two
  internal::Indexed_heap m_heap; // entries beyond the circle, or to be extracted in order
  Bucket m_round;                // entries of the current bucket
  std::size_t m_next = 0;        // the first of the round that is left
  std::size_t m_size = 0;        // the number of entries left
  Index m_mask = 0;              // reduces an index to the circle
  double m_buckets_per_unit = 1;

  // the buckets in the circle; entries of all others go to the heap
  Index m_first_in_circle = 0;
  Index m_number_in_circle = 0;

  // the bucket that is being drained
  Index m_current = 0;
  bool m_is_in_order = false;
  std::size_t m_drained = 0;     // the number of entries of its rounds
  std::size_t m_first_round = 0; // that of the first round; entries of further rounds are late

  std::size_t m_unordered_budget = 0; // how many more entries may be extracted in any order

  std::size_t m_number_of_nodes;
  double m_longest_arc;
  WidthPolicy m_policy;
  Bucket_statistics m_statistics;
};

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * The default queue of this package: an adaptive bucket queue with balanced widths.
 */
using Adaptive_bucket_queue = Basic_adaptive_bucket_queue<Balanced_bucket_width>;

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H
