// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_ORDERED_QUEUES_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_ORDERED_QUEUES_H

#include <CGAL/license/Approximate_geodesics.h>

// Queues that extract single entries in order, for comparison with the default queue.

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/heap/d_ary_heap.hpp>
#include <boost/heap/fibonacci_heap.hpp>
#include <boost/heap/policies.hpp>
#include <boost/integer/integer_log2.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Common base of the queues that extract single entries in order.
class Ordered_queue_base
{
public:
  using Node = std::uint32_t;
  using Key = double;
  using Entry = Queue_entry;
  using Batch = Iterator_range<const Entry*>;

  bool is_final(const Key key) const { return key < m_extracted.key; }

protected:
  Batch hand_out(const Entry& entry)
  {
    m_extracted = entry;
    return Batch(&m_extracted, &m_extracted + 1);
  }

  void restart() { m_extracted = Entry{0, 0}; }

private:
  Entry m_extracted{0, 0}; // the last extracted entry
};

// Reverses the order, as for Boost's heaps, which are max-heaps: the largest entry has the smallest
// key.
struct Has_larger_key
{
  bool operator()(const Queue_entry& a, const Queue_entry& b) const { return a.key > b.key; }
};

// Deletes entries one by one: destructors of Boost's heaps are recursive and can overflow the
// stack.
template <typename Heap>
struct Delete_heap
{
  void operator()(Heap* const heap) const
  {
    while(!heap->empty())
      heap->pop();
    delete heap;
  }
};

/*
 * A priority queue that decreases keys in place by keeping a handle per node. It is movable, but
 * not copyable, because the handles would refer to the original heap.
 */
template <typename Heap>
class Boost_heap_queue : public Ordered_queue_base
{
public:
  explicit Boost_heap_queue(const std::size_t number_of_nodes = 0,
                            const Arc_lengths& = Arc_lengths())
    : m_heap(new Heap), m_handle(number_of_nodes), m_is_present(number_of_nodes)
  {
  }

  bool is_empty() const { return m_heap->empty(); }

  void push(const Node node, const Key key)
  {
    CGAL_precondition(node < m_handle.size() && !is_final(key));
    if(!m_is_present[node])
    {
      m_handle[node] = m_heap->push({key, node});
      m_is_present[node] = 1;
    }
    else if(key < (*m_handle[node]).key)
      m_heap->increase(m_handle[node], {key, node}); // a smaller key is larger in reversed order
  }

  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    const Entry result = m_heap->top();
    pop();
    return hand_out(result);
  }

  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : *m_heap)
      f(e.node);
  }

  void clear()
  {
    while(!is_empty())
      pop();
    restart();
  }

  // An estimate: a heap node holds an entry and about four pointers.
  std::size_t memory() const
  {
    return m_heap->size() * (sizeof(Entry) + 4 * sizeof(void*)) + memory_of(m_handle, m_is_present);
  }

private:
  void pop()
  {
    m_is_present[m_heap->top().node] = 0;
    m_heap->pop();
  }

  std::unique_ptr<Heap, Delete_heap<Heap>> m_heap;
  std::vector<typename Heap::handle_type> m_handle; // by node
  std::vector<char> m_is_present;
};

// A queue with one of Boost's heaps. Sizes are not stored: they are wrong after a failed
// allocation.
template <template <typename, typename...> class Heap, typename... Options>
using Queue_of_heap = Boost_heap_queue<Heap<Queue_entry,
                                            boost::heap::compare<Has_larger_key>,
                                            boost::heap::constant_time_size<false>,
                                            Options...>>;

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

/// \cond SKIP_IN_MANUAL

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * A priority queue that keeps its entries in an unordered array, and searches all of them for the
 * smallest key. This is the queue of Dijkstra's original algorithm \cgalCite{d-ntpcg-59}, provided
 * for comparison.
 *
 * `push()` takes constant time and decreases keys in place; `extract_min()` takes time \cgalBigO{m}
 * for `m` entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
class Array_queue : public internal::Ordered_queue_base
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit Array_queue(const std::size_t number_of_nodes = 0, const Arc_lengths& = Arc_lengths())
    : m_position(number_of_nodes, absent)
  {
  }

  /// returns whether the queue is empty.
  bool is_empty() const { return m_entries.empty(); }

  /// inserts `node` with `key`, or decreases its key.
  /// \pre The node exists, and `key` is not smaller than the last extracted key.
  void push(const Node node, const Key key)
  {
    CGAL_precondition(node < m_position.size() && !is_final(key));
    Node& position = m_position[node];
    if(position != absent)
    {
      m_entries[position].key = (std::min)(m_entries[position].key, key);
      return;
    }
    m_entries.push_back({key, node});
    position = static_cast<Node>(m_entries.size() - 1);
  }

  /// removes and returns the entry with the smallest key. \pre `!is_empty()`
  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    const auto smallest =
        std::max_element(m_entries.begin(), m_entries.end(), internal::Has_larger_key());
    const Entry result = *smallest;
    *smallest = m_entries.back();
    m_position[smallest->node] = static_cast<Node>(smallest - m_entries.begin());
    m_position[result.node] = absent;
    m_entries.pop_back();
    return hand_out(result);
  }

  /// calls `f(node)` for the nodes of all entries.
  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_entries)
      f(e.node);
  }

  /// removes all entries.
  void clear()
  {
    for(const Entry& e : m_entries)
      m_position[e.node] = absent;
    m_entries.clear();
    restart();
  }

  /// returns the size of the queue in bytes.
  std::size_t memory() const { return internal::memory_of(m_entries, m_position); }

private:
  static constexpr Node absent = (std::numeric_limits<Node>::max)();

  std::vector<Entry> m_entries;
  std::vector<Node> m_position; // of the entry, by node
};

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * A priority queue based on the implicit `D`-ary heap of Boost.Heap. Keys are decreased in place.
 *
 * `push()` takes time \cgalBigO{\log_D m}, `extract_min()` takes \cgalBigO{D \log_D m} for `m`
 * entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * The class is movable, but not copyable.
 *
 * \tparam D the number of children, at least 2
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
template <unsigned D = 4>
using D_ary_heap_queue = internal::
    Queue_of_heap<boost::heap::d_ary_heap, boost::heap::arity<D>, boost::heap::mutable_<true>>;

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * A priority queue based on an implicit binary heap.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
using Binary_heap_queue = D_ary_heap_queue<2>;

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * A priority queue based on the Fibonacci heap \cgalCite{ft-fhtui-87} of Boost.Heap. It has the
 * best asymptotic bounds of all practical heaps, but large constants. Keys are decreased in place.
 *
 * `push()` takes amortized constant time, `extract_min()` amortized time \cgalBigO{\log m} for `m`
 * entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * The class is movable, but not copyable.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
using Fibonacci_heap_queue = internal::Queue_of_heap<boost::heap::fibonacci_heap>;

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
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
class Radix_heap_queue : public internal::Ordered_queue_base
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
    {
      Bucket& bucket = *std::find_if(m_buckets.begin(), m_buckets.end(),
                                     [](const Bucket& b) { return !b.empty(); });
      // its keys agree in its bit, so they differ from their minimum in a lower bit only
      m_least =
          bits_of(std::max_element(bucket.begin(), bucket.end(), internal::Has_larger_key())->key);
      for(const Entry& e : bucket)
        bucket_of(e.key).push_back(e);
      bucket.clear();
    }
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
    std::size_t result = 0;
    for(const Bucket& b : m_buckets)
      result += internal::memory_of(b);
    return result;
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

  std::array<Bucket, 65> m_buckets;
  std::size_t m_size = 0; // the number of entries
  Bits m_least = 0;       // a lower bound of the keys in the queue
};

/// \endcond

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_ORDERED_QUEUES_H
