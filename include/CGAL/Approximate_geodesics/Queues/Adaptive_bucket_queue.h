// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * An entry of a queue: a node and its key.
 */
struct Queue_entry
{
  /// the key: a distance, in units of the graph.
  double key;
  /// the number of the node.
  std::uint32_t node;
};
namespace internal {

/*
 * An implicit 4-ary heap with at most one entry per node, which supports decreasing keys. The array
 * of entry positions is allocated at the first push. Unlike `boost::d_ary_heap_indirect`, it lists
 * its entries, and clear() takes time in proportion to their number.
 */
class Indexed_heap
{
public:
  using Node = std::uint32_t;
  using Entry = Queue_entry;

  explicit Indexed_heap(const std::size_t number_of_nodes) : m_number_of_nodes(number_of_nodes) {}

  bool is_empty() const { return m_entries.empty(); }
  std::size_t size() const { return m_entries.size(); }

  // The entry with the smallest key.
  const Entry& top() const { return m_entries.front(); }

  // All entries, in heap order.
  const std::vector<Entry>& entries() const { return m_entries; }

  // The number of comparisons since the last call of `clear()`.
  std::size_t comparisons() const { return m_comparisons; }

  // Inserts a node, or decreases its key. Returns whether the node is new.
  bool push(const Entry& e)
  {
    if(e.node >= m_position.size())
      m_position.resize((std::max)(m_number_of_nodes, std::size_t(e.node) + 1), ABSENT);
    const Position position = m_position[e.node];
    if(position == ABSENT)
    {
      m_entries.push_back(e);
      move_up(m_entries.size() - 1, e);
      return true;
    }
    if(e.key < m_entries[position].key)
      move_up(position, e);
    return false;
  }

  // Removes the entry with the smallest key.
  void pop()
  {
    CGAL_precondition(!is_empty());
    m_position[top().node] = ABSENT;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!is_empty())
      move_down(last);
  }

  void clear()
  {
    for(const Entry& e : m_entries)
      m_position[e.node] = ABSENT;
    m_entries.clear();
    m_comparisons = 0;
  }

  std::size_t memory() const { return memory_of(m_entries, m_position); }

private:
  using Position = std::uint32_t; // entries do not outnumber nodes

  static constexpr Position ABSENT = (std::numeric_limits<Position>::max)();
  static constexpr std::size_t ARITY = 4;

  void place(const std::size_t position, const Entry& e)
  {
    m_entries[position] = e;
    m_position[e.node] = static_cast<Position>(position);
  }

  // Sifts `e` up from a position.
  void move_up(std::size_t position, const Entry& e)
  {
    while(position > 0)
    {
      const std::size_t parent = (position - 1) / ARITY;
      ++m_comparisons;
      if(!(e.key < m_entries[parent].key))
        break;
      place(position, m_entries[parent]);
      position = parent;
    }
    place(position, e);
  }

  // Sifts `e` down from the top.
  void move_down(const Entry& e)
  {
    std::size_t position = 0;
    for(;;)
    {
      const std::size_t first = ARITY * position + 1;
      if(first >= size())
        break;
      const std::size_t child = smallest(first, (std::min)(first + ARITY, size()));
      ++m_comparisons;
      if(!(m_entries[child].key < e.key))
        break;
      place(position, m_entries[child]);
      position = child;
    }
    place(position, e);
  }

  std::size_t smallest(const std::size_t first, const std::size_t beyond)
  {
    std::size_t result = first;
    for(std::size_t i = first + 1; i < beyond; ++i)
      result = m_entries[i].key < m_entries[result].key ? i : result;
    m_comparisons += beyond - first - 1;
    return result;
  }

  std::size_t m_number_of_nodes;
  std::vector<Entry> m_entries;
  std::vector<Position> m_position; // by node; empty until the first push
  std::size_t m_comparisons = 0;
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The statistics of a run of a bucket queue. They are updated per bucket, not per entry, so the
 * overhead is negligible.
 */
struct Bucket_statistics
{
  /// the width of the buckets, in units of the graph.
  double width = 0;
  /// the number of visited buckets, including empty ones.
  std::size_t visited_buckets = 0;
  /// the number of nonempty buckets.
  std::size_t used_buckets = 0;
  /// the number of extracted entries.
  std::size_t entries = 0;
  /// the number of extracted entries that entered a bucket while it was being drained.
  std::size_t late_entries = 0;
  /// the number of comparisons between entries.
  std::size_t comparisons = 0;
  /// the sum over all buckets of the squared number of entries.
  double sum_of_squared_occupancies = 0;

  /// adds a visited bucket with its number of extracted entries, and the number of late ones among
  /// them.
  void add_bucket(const std::size_t occupancy, const std::size_t late = 0)
  {
    ++visited_buckets;
    if(occupancy == 0)
      return;
    ++used_buckets;
    entries += occupancy;
    late_entries += late;
    sum_of_squared_occupancies += static_cast<double>(occupancy) * static_cast<double>(occupancy);
  }

  /// returns the mean number of entries of the nonempty buckets.
  double mean_occupancy() const
  {
    return used_buckets == 0 ? 0 : static_cast<double>(entries) / static_cast<double>(used_buckets);
  }

  /// returns the standard deviation of the number of entries of the nonempty buckets.
  double standard_deviation_of_occupancy() const
  {
    if(used_buckets == 0)
      return 0;
    const double mean_square = sum_of_squared_occupancies / static_cast<double>(used_buckets);
    return std::sqrt((std::max)(0., mean_square - mean_occupancy() * mean_occupancy()));
  }
};

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The default policy for the width of the buckets of an adaptive bucket queue.
 *
 * Wide buckets cause late entries: nodes that enter a bucket while it is being drained may have to
 * be expanded again. Narrow buckets are many and often empty; visiting one costs as much as a few
 * late entries. After every run, the width changes by a factor of \f$\sqrt 2\f$ unless the two
 * overheads are balanced. The first width is half the mean arc length, which is nearly balanced on
 * scanned models.
 *
 * \cgalModels{BucketWidthPolicy}
 */
class Balanced_bucket_width
{
public:
  /// chooses the width for the first run.
  explicit Balanced_bucket_width(const Arc_lengths& arcs = Arc_lengths())
    : m_narrowest((std::max)(arcs.longest * NARROWEST_PART, SMALLEST_INVERTIBLE)),
      m_widest((std::max)(arcs.longest, m_narrowest)),
      m_width(arcs.longest > 0 ? (std::clamp)(arcs.mean / 2, m_narrowest, m_widest) : 1)
  {
  }

  /// returns the width of the buckets, in units of the graph.
  double width() const { return m_width; }

  /// chooses the width for the next run from the statistics of the last one.
  void update(const Bucket_statistics& last_run)
  {
    if(last_run.entries < SMALLEST_SAMPLE)
      return;
    if(last_run.late_entries > COST_OF_VISIT * last_run.visited_buckets)
      m_width = (std::max)(m_width / STEP, m_narrowest);
    else if(SLACK * last_run.late_entries < last_run.visited_buckets)
      m_width = (std::min)(m_width * STEP, m_widest);
  }

private:
  static constexpr double STEP = 1.4142135623730951;
  static constexpr std::size_t COST_OF_VISIT = 8; // upper bound, in late entries
  static constexpr std::size_t SLACK = 2;         // hysteresis: prevents oscillation
  static constexpr double NARROWEST_PART = 1e-9;  // of the longest arc: limits bucket indices
  static constexpr double SMALLEST_INVERTIBLE = 4 / (std::numeric_limits<double>::max)();
  static constexpr std::size_t SMALLEST_SAMPLE = 1000; // smaller runs are not representative

  double m_narrowest;
  double m_widest;
  double m_width;
};

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * A monotone priority queue that distributes its entries to buckets by their keys, and leaves each
 * bucket unsorted. The bucket of the smallest keys is drained in rounds: a round consists of the
 * entries that are in the bucket when the round starts, and is extracted in batches; entries that
 * are pushed into the bucket meanwhile form the next round. A node whose key decreases is pushed
 * again; the search skips the stale entry. The statistics of each run determine the bucket width of
 * the next run.
 *
 * All keys in the queue exceed those of the current bucket by at most the length of the longest
 * arc, so a small circular array of buckets suffices. Buckets hold so few entries that their order
 * hardly matters: on scanned models, a node is expanded 1.00 to 1.04 times on average. Two
 * fallbacks bound the cost if arc lengths differ by many orders of magnitude:
 * - The number of buckets is limited. Keys beyond the last bucket wait in a heap, which supports
 *   decreasing keys in place.
 * - A bucket that keeps growing while it is drained moves to the heap, and is extracted in
 *   increasing order. The same holds for every bucket once the number of extracted or of waiting
 *   entries is several times the number of nodes. Hence a run expands \cgalBigO{n} nodes, for `n`
 *   nodes in the graph, for any arc lengths.
 *
 * `push()` and `extract_min()` take constant time per entry, and \cgalBigO{\log m} for the `m`
 * entries on the heap. Buckets retain the memory of their largest sizes, also between runs. The
 * heap takes 4 bytes per node once it is used.
 *
 * Adapting the buckets to the mesh from run to run is an idea of Schwartz, de Rezende and Pedrini
 * \cgalCite{srp-fasgp-15}; the circular array, unordered draining and the fallbacks are additions
 * of this package. Denardo and Fox introduced buckets drained in any order \cgalCite{df-spmrp-79}.
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

  /// an entry of the queue.
  using Entry = Queue_entry;

  /// a range of entries.
  using Batch = Iterator_range<const Entry*>;

  /// constructs an empty queue for a graph with `number_of_nodes` nodes and the given arc lengths.
  explicit Basic_adaptive_bucket_queue(const std::size_t number_of_nodes = 0,
                                       const Arc_lengths& arcs = Arc_lengths())
    : m_heap(number_of_nodes),
      m_number_of_nodes(number_of_nodes),
      m_longest_arc(arcs.longest),
      m_policy(arcs)
  {
    set_up_circle();
  }

  /// returns whether the queue is empty.
  bool is_empty() const { return m_size == 0; }

  /*!
   * inserts `node` with `key`.
   * \pre `key` is not NaN, and not below the bucket that is being drained.
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
   * removes and returns up to `LARGEST_BATCH` entries of the first nonempty bucket. Entries are
   * stale if their node was pushed again with a smaller key. The range is valid until the next call
   * of `extract_min()` or `clear()`.
   * \pre `!is_empty()`
   */
  Batch extract_min() { return extract_round(LARGEST_BATCH); }

  /// removes and returns current entries of the first nonempty bucket, at most `largest_batch`: a
  /// batch that is large enough for several threads. Remaining entries are extracted next.
  /// \pre `!is_empty()`
  Batch extract_round(const std::size_t largest_batch)
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

  /// the largest number of entries in a batch.
  static constexpr std::size_t LARGEST_BATCH = 32;

  /// returns whether `key` is smaller than all keys in the queue and all that may still be pushed.
  bool is_final(const Key key) const
  {
    return m_keeps_order ? !m_round.empty() && key < m_round.back().key
                         : bucket_index(key) < m_current;
  }

  /// keeps entries in order until the next call of `clear()`: in a heap, from which they come one
  /// at a time, smallest key first. \pre `is_empty()`
  void keep_order()
  {
    CGAL_precondition(is_empty());
    m_keeps_order = m_is_in_order = true;
    m_number_in_circle = 0;
    m_buckets_per_unit = 0; // all keys belong to the first bucket
  }

  /// calls `f(node)` for the nodes of all entries; a node may be repeated.
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

  /// removes all entries, and adapts the bucket width to the last run.
  void clear()
  {
    for(Bucket& b : m_buckets)
      b.clear();
    if(!m_keeps_order)
      m_policy.update(statistics());
    m_heap.clear();
    set_up_circle();
  }

  /// returns the statistics since the last call of `clear()`.
  Bucket_statistics statistics() const
  {
    Bucket_statistics result = m_statistics;
    result.comparisons = m_heap.comparisons();
    if(number_drained() > 0)
      add_current_bucket(result);
    return result;
  }

  /// returns the size of the queue in bytes.
  std::size_t memory() const
  {
    std::size_t result = internal::memory_of(m_buckets, m_round, m_heap);
    for(const Bucket& b : m_buckets)
      result += internal::memory_of(b);
    return result;
  }

private:
  using Bucket = std::vector<Entry>;
  using Index = std::uint64_t; // of a bucket, starting at key 0

  static constexpr Index LARGEST_CIRCLE = 1024; // arcs longer than 1023 widths are rare
  static constexpr Index LARGEST_INDEX = Index(1) << 62;

  // Monotone in `key`, which suffices for correctness.
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
    m_keeps_order = false;
    m_size = 0;
    m_statistics = Bucket_statistics();
    m_statistics.width = width;
    m_unordered_budget = unordered_limit();
    m_round.clear();
    m_next = 0;
    open_bucket(0);
  }

  // Limit on unordered entries, both queued and extracted; ordinary runs stay far below it.
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

  // The entries of the current bucket that are not in the last round.
  Bucket& current_bucket() { return bucket(m_current); }

  // Takes the entries of the current bucket as the next round.
  BOOST_NOINLINE void start_next_round()
  {
    m_round.clear();
    m_next = 0;
    while(m_round.empty())
    {
      if(m_is_in_order && nearest_index() == m_current)
        move_nearest_to(m_round);
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

  // Advances to the next bucket, which may be empty.
  void open_next_bucket()
  {
    add_current_bucket(m_statistics);
    if(m_round.capacity() > current_bucket().capacity())
      std::swap(m_round, current_bucket()); // gives the larger buffer back to its bucket
    m_unordered_budget -= (std::min)(m_unordered_budget, m_drained);

    const bool circle_is_empty = m_size == m_heap.size();
    open_bucket(circle_is_empty ? nearest_index() : m_current + 1);
    while(nearest_index() - m_first_in_circle < m_number_in_circle)
      move_nearest_to(bucket(nearest_index()));
  }

  // The number of entries extracted from the current bucket.
  std::size_t number_drained() const { return m_drained - (m_round.size() - m_next); }

  void add_current_bucket(Bucket_statistics& statistics) const
  {
    const std::size_t drained = number_drained();
    statistics.add_bucket(drained, drained - (std::min)(drained, m_first_round));
  }

  // Whether the bucket refills faster than it drains, and must be drained in order.
  bool shall_be_put_in_order() const
  {
    const std::size_t limit = (std::min)(3 * m_first_round / 2 + 64, m_unordered_budget);
    return m_drained >= limit || m_size > unordered_limit();
  }

  // Moves the current bucket to the heap, including entries that are pushed later.
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

  // Moves the entry with the smallest key from the heap.
  void move_nearest_to(Bucket& entries)
  {
    entries.push_back(m_heap.top());
    m_heap.pop();
  }

  // The bucket index of the smallest key on the heap.
  Index nearest_index() const
  {
    return m_heap.is_empty() ? (std::numeric_limits<Index>::max)() : bucket_index(m_heap.top().key);
  }

  BOOST_NOINLINE void push_onto_heap(const Entry& e)
  {
    m_size += static_cast<std::size_t>(m_heap.push(e));
  }

  std::vector<Bucket> m_buckets; // circular; the size is a power of two
  internal::Indexed_heap m_heap; // entries beyond the circle, or to be extracted in order
  Bucket m_round;                // entries of the current bucket
  std::size_t m_next = 0;        // the next entry of the round
  std::size_t m_size = 0;        // the number of entries
  Index m_mask = 0;              // maps an index to a bucket
  double m_buckets_per_unit = 1;

  // The range of buckets in the circle; entries of all others go to the heap.
  Index m_first_in_circle = 0;
  Index m_number_in_circle = 0;

  // The bucket that is being drained.
  Index m_current = 0;
  bool m_is_in_order = false;
  bool m_keeps_order = false;    // whether it has all entries, in order
  std::size_t m_drained = 0;     // entries in its rounds so far
  std::size_t m_first_round = 0; // entries in the first round; later entries are late

  std::size_t m_unordered_budget = 0; // entries left to extract unordered

  std::size_t m_number_of_nodes;
  double m_longest_arc;
  WidthPolicy m_policy;
  Bucket_statistics m_statistics;
};

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The default queue of this package: an adaptive bucket queue with balanced widths.
 */
using Adaptive_bucket_queue = Basic_adaptive_bucket_queue<Balanced_bucket_width>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_ADAPTIVE_BUCKET_QUEUE_H
