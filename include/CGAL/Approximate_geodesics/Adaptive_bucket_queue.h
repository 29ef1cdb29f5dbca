// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_ADAPTIVE_BUCKET_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_ADAPTIVE_BUCKET_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Balanced_bucket_width.h>
#include <CGAL/Approximate_geodesics/Bucket_statistics.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * A monotone priority queue that sorts its entries into buckets by their keys, and does not sort
 * them further: the bucket of the smallest keys is drained first-in first-out. A node whose key is
 * lowered is entered again; the search skips the stale entry when it comes out. The width of the
 * buckets is chosen anew for every run from the figures of the last one.
 *
 * All keys in the queue lie within one longest arc of the current bucket, so a small circle of
 * buckets is enough, and few enough entries share a bucket for their order not to matter: on
 * scanned models a node comes out 1.00 to 1.04 times on average, stale entries aside. Two fallbacks
 * bound the cost where arc lengths differ by many orders of magnitude:
 * - keys beyond the circle, whose length is limited, wait in a heap until the circle reaches them;
 * - a bucket that keeps growing while it is drained is made a heap, and drained smallest first; so
 *   is every bucket after several times as many entries came out, or while several times as many
 *   wait, as there are nodes. A run therefore expands \cgalBigO{n} nodes, for `n` of them,
 *   whatever the lengths.
 *
 * `push()` and `extract_min()` take constant time, and \cgalBigO{\log m} for the entries in
 * either heap, of which there are `m`. Memory is that of the largest number of entries that each
 * bucket of the circle had at a time; it is kept from run to run.
 *
 * The idea of adapting the buckets to the mesh from run to run is that of Schwartz, de Rezende and
 * Pedrini \cgalCite{srp-fasgp-15}; the circle, draining in any order and the fallbacks are
 * additions of this package. Buckets drained in any order were introduced by Denardo and Fox
 * \cgalCite{df-spmrp-79}.
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

  /// what comes out of the queue: a node, and the key that it was entered with.
  struct Entry
  {
    /// the key.
    Key key;
    /// the node.
    Node node;
  };

  /// an empty queue for a graph with the given arcs.
  explicit Basic_adaptive_bucket_queue(const std::size_t number_of_nodes = 0,
                                       const Arc_lengths& arcs = Arc_lengths())
    : m_number_of_nodes(number_of_nodes), m_longest_arc(arcs.longest), m_policy(arcs)
  {
    set_up_circle();
  }

#ifndef DOXYGEN_RUNNING // the open bucket is pointed at: it moves along, but is not copied
  Basic_adaptive_bucket_queue(const Basic_adaptive_bucket_queue&) = delete;
  Basic_adaptive_bucket_queue& operator=(const Basic_adaptive_bucket_queue&) = delete;
  Basic_adaptive_bucket_queue(Basic_adaptive_bucket_queue&&) = default;
  Basic_adaptive_bucket_queue& operator=(Basic_adaptive_bucket_queue&&) = default;
  ~Basic_adaptive_bucket_queue() = default;
#endif

  /// returns whether no entry is left.
  bool is_empty() const
  {
    return m_next == m_pause && number_left() == 0 && m_size_but_drained == drained();
  }

  /*!
   * enters `node` with `key`.
   * \pre `key` is not below the start of the bucket of the entry extracted last, nor a NaN.
   */
  void push(const Node node, const Key key)
  {
    CGAL_precondition(!is_final(key));
    const Index index = bucket_index(key);
    if(index - (m_current + 1) < m_mask)
      bucket(index).push_back({key, node});
    else
      push_late_or_far({key, node}, index);
    ++m_size_but_drained;
  }

  /*!
   * removes an entry of the first bucket that is not empty, and returns it. It may be stale:
   * entered with a key larger than the node has by now.
   * \pre `!is_empty()`
   */
  Entry extract_min()
  {
    CGAL_precondition(!is_empty());
    if(m_next == m_pause)
    {
      go_on();
      if(m_open_is_heap)
        return extract_from_heap();
    }
    return *m_next++;
  }

  /// returns a node that will come out after `ahead` others, if that is known, and `no_node` else.
  Node upcoming(const std::size_t ahead) const
  {
    return static_cast<std::size_t>(m_pause - m_next) > ahead ? m_next[ahead].node : no_node;
  }

  /// what `upcoming()` returns if it does not know.
  static constexpr Node no_node = (std::numeric_limits<Node>::max)();

  /// returns whether `key` is smaller than any key in the queue and any that may still be pushed.
  bool is_final(const Key key) const { return bucket_index(key) < m_current; }

  /// calls `f(node)` for the nodes of all entries; for some of them more than once.
  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_far)
      f(e.node);
    for(const Bucket& b : m_buckets)
      for(const Entry& e : b)
        f(e.node);
  }

  /// removes all entries, and prepares for the next run with what was learnt from the last one.
  void clear()
  {
    for(Bucket& b : m_buckets)
      b.clear();
    m_far.clear();
    m_policy.update(statistics());
    set_up_circle();
  }

  /// returns the figures of the run since the last call of `clear()`.
  Bucket_statistics statistics() const
  {
    Bucket_statistics result = m_statistics;
    add_open_bucket(result);
    return result;
  }

  /// returns the number of bytes that the queue takes.
  std::size_t memory() const
  {
    std::size_t result = m_buckets.capacity() * sizeof(Bucket) + m_far.capacity() * sizeof(Entry);
    for(const Bucket& b : m_buckets)
      result += b.capacity() * sizeof(Entry);
    return result;
  }

private:
  using Bucket = std::vector<Entry>;
  using Index = std::uint64_t; // of a bucket, counted from key 0 on

  static constexpr Index LARGEST_CIRCLE = 1024; // arcs longer than 1023 widths are rare
  static constexpr Index LARGEST_INDEX = Index(1) << 62;

  struct Later // puts the smallest key on top of a heap
  {
    bool operator()(const Entry& a, const Entry& b) const
    {
      ++comparisons;
      return a.key > b.key;
    }
    std::size_t& comparisons;
  };

  // Monotone in `key`, which is all that correctness needs of it.
  Index bucket_index(const Key key) const
  {
    const double index = key * m_buckets_per_unit;
    return index < double(LARGEST_INDEX) ? static_cast<Index>(static_cast<std::int64_t>(index))
                                         : LARGEST_INDEX;
  }

  Bucket& bucket(const Index index) { return m_buckets[index & m_mask]; }

  void set_up_circle()
  {
    const double width = m_policy.width();
    const double needed = m_longest_arc / width + 2;
    Index size = 2;
    while(double(size) < needed && size < LARGEST_CIRCLE)
      size *= 2;
    m_buckets.resize(size);
    m_mask = size - 1;
    m_buckets_per_unit = 1 / width;
    m_size_but_drained = 0;
    m_statistics = Bucket_statistics();
    m_statistics.width = width;
    m_trust = 8 * m_number_of_nodes + 1024;
    open_bucket(0);
  }

  void open_bucket(const Index index)
  {
    m_current = index;
    m_open = &bucket(index);
    m_open_is_heap = false;
    m_size_when_opened = 0;
    forget_open_bucket();
  }

  void forget_open_bucket()
  {
    m_drained_before = 0;
    m_next = m_open->data();
    m_pause = m_next; // the first extraction looks at what is there by then
  }

  // The entries up to the pause are through. Newer ones may have come, if only so many that
  // draining them first-in first-out can be hoped to end soon.
  BOOST_NOINLINE void go_on()
  {
    while(number_left() == 0)
      open_next_bucket();
    if(m_open_is_heap)
      return;
    if(drained() == 0)
    {
      m_size_when_opened = m_open->size();
      m_patience = (std::min)(4 * m_size_when_opened + 256, m_trust);
    }
    const bool few_wait = m_size_but_drained <= 8 * m_number_of_nodes + 1024;
    if(drained() < m_patience && few_wait)
      m_pause = m_open->data() + (std::min)(m_open->size(), m_patience);
    else
      make_open_bucket_a_heap();
  }

  // Goes on to the next bucket, which may be empty.
  void open_next_bucket()
  {
    add_open_bucket(m_statistics);
    m_statistics.visited_buckets += drained() == 0 ? 1 : 0;
    m_size_but_drained -= drained();
    m_trust -= (std::min)(m_trust, drained());
    m_open->clear();
    forget_open_bucket(); // should an allocation fail below

    const bool circle_is_empty = m_size_but_drained == m_far.size();
    const Index next = circle_is_empty ? bucket_index(m_far.front().key) : m_current + 1;
    while(!m_far.empty() && bucket_index(m_far.front().key) - next <= m_mask)
      move_nearest_into_circle();
    open_bucket(next);
  }

  void add_open_bucket(Bucket_statistics& statistics) const
  {
    if(drained() == 0)
      return;
    const double occupancy = static_cast<double>(drained());
    statistics.visited_buckets += 1;
    statistics.entries += drained();
    statistics.late_entries += drained() - (std::min)(drained(), m_size_when_opened);
    statistics.used_buckets += 1;
    statistics.sum_of_squared_occupancies += occupancy * occupancy;
  }

  // the number of entries of the open bucket that came out, and that did not yet
  std::size_t number_passed() const { return static_cast<std::size_t>(m_next - m_open->data()); }
  std::size_t number_left() const { return m_open->size() - number_passed(); }
  std::size_t drained() const { return m_drained_before + number_passed(); }

  BOOST_NOINLINE void push_late_or_far(const Entry& e, const Index index)
  {
    if(index != m_current)
      return push_onto_heap(m_far, e);
    const std::size_t passed = number_passed();
    const auto until_pause = m_pause - m_next;
    if(m_open_is_heap)
      push_onto_heap(*m_open, e);
    else
      m_open->push_back(e);
    m_next = m_open->data() + passed; // the bucket may have moved
    m_pause = m_next + until_pause;
  }

  void push_onto_heap(Bucket& heap, const Entry& e)
  {
    heap.push_back(e);
    std::push_heap(heap.begin(), heap.end(), Later{m_statistics.comparisons});
  }

  void move_nearest_into_circle()
  {
    std::pop_heap(m_far.begin(), m_far.end(), Later{m_statistics.comparisons});
    bucket(bucket_index(m_far.back().key)).push_back(m_far.back());
    m_far.pop_back();
  }

  void make_open_bucket_a_heap()
  {
    m_drained_before = number_passed();
    m_open->erase(m_open->begin(), m_open->begin() + (m_next - m_open->data()));
    std::make_heap(m_open->begin(), m_open->end(), Later{m_statistics.comparisons});
    m_open_is_heap = true;
    m_next = m_open->data();
    m_pause = m_next; // every extraction is special
  }

  BOOST_NOINLINE Entry extract_from_heap()
  {
    ++m_drained_before;
    std::pop_heap(m_open->begin(), m_open->end(), Later{m_statistics.comparisons});
    const Entry result = m_open->back();
    m_open->pop_back();
    return result;
  }

  std::vector<Bucket> m_buckets; // a circle; their number is a power of two
  Bucket m_far;                  // a heap of the entries beyond the circle
  Index m_mask = 0;              // reduces an index to the circle
  double m_buckets_per_unit = 1;

  // the bucket that is being drained
  Index m_current = 0;
  Bucket* m_open = nullptr;
  bool m_open_is_heap = false;
  const Entry* m_next = nullptr;  // the entry that comes out next, if it is no heap
  const Entry* m_pause = nullptr; // where draining stops to think
  std::size_t m_drained_before =
      0; // the number of entries that came out and are not in it any more
  std::size_t m_size_when_opened = 0;
  std::size_t m_size_but_drained = 0; // the number of entries, not reduced by those

  // how many entries may come out before order is imposed: of the open bucket, and of all others
  std::size_t m_patience = 0;
  std::size_t m_trust = 0;

  std::size_t m_number_of_nodes;
  double m_longest_arc;
  WidthPolicy m_policy;
  Bucket_statistics m_statistics;
};

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * The package's default queue: an adaptive bucket queue with balanced widths.
 */
using Adaptive_bucket_queue = Basic_adaptive_bucket_queue<Balanced_bucket_width>;

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_ADAPTIVE_BUCKET_QUEUE_H
