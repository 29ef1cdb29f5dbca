// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_HEAP_QUEUES_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_HEAP_QUEUES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/assertions.h>

#include <boost/heap/d_ary_heap.hpp>
#include <boost/heap/fibonacci_heap.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Reverses the order: Boost's heaps are max-heaps.
struct Has_larger_key
{
  bool operator()(const Queue_entry& a, const Queue_entry& b) const { return a.key > b.key; }
};

/*
 * A priority queue that decreases keys in place by keeping a handle per node. It is not copyable,
 * because the handles would refer to the original heap.
 */
template <typename Heap>
class Boost_heap_queue : public Ordered_queue_base
{
public:
  explicit Boost_heap_queue(const std::size_t number_of_nodes = 0,
                            const Arc_lengths& = Arc_lengths())
    : m_handle(number_of_nodes), m_is_present(number_of_nodes)
  {
  }

  Boost_heap_queue(Boost_heap_queue&& other)
    : Ordered_queue_base(other),
      m_heap(std::move(other.m_heap)),
      m_handle(std::move(other.m_handle)),
      m_is_present(std::move(other.m_is_present)),
      m_size(std::exchange(other.m_size, 0))
  {
  }

  Boost_heap_queue& operator=(Boost_heap_queue&& other)
  {
    swap(other);
    return *this;
  }

  ~Boost_heap_queue() { clear(); }

  bool is_empty() const { return m_size == 0; }

  void push(const Node node, const Key key)
  {
    CGAL_precondition(node < m_handle.size() && !is_final(key));
    if(!m_is_present[node])
    {
      m_handle[node] = m_heap.push({key, node});
      m_is_present[node] = 1;
      ++m_size;
    }
    else if(key < (*m_handle[node]).key)
      m_heap.increase(m_handle[node], {key, node}); // a smaller key is larger in reversed order
  }

  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    const Entry result = m_heap.top();
    pop();
    return hand_out(result);
  }

  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_heap)
      f(e.node);
  }

  // Pops entries one by one: clear() of Boost's heaps is recursive and can overflow the stack.
  void clear()
  {
    while(!is_empty())
      pop();
    m_heap.clear(); // resets the size of Boost's Fibonacci heap: see m_size
    restart();
  }

  // An estimate: a heap node holds an entry and about four pointers.
  std::size_t memory() const
  {
    return m_size * (sizeof(Entry) + 4 * sizeof(void*)) +
           m_handle.capacity() * sizeof(typename Heap::handle_type) + m_is_present.capacity();
  }

private:
  void pop()
  {
    m_is_present[m_heap.top().node] = 0;
    m_heap.pop();
    --m_size;
  }

  void swap(Boost_heap_queue& other)
  {
    std::swap(static_cast<Ordered_queue_base&>(*this), static_cast<Ordered_queue_base&>(other));
    m_heap.swap(other.m_heap);
    m_handle.swap(other.m_handle);
    m_is_present.swap(other.m_is_present);
    std::swap(m_size, other.m_size);
  }

  Heap m_heap;
  std::vector<typename Heap::handle_type> m_handle; // by node
  std::vector<char> m_is_present;
  std::size_t m_size = 0; // Boost's size is wrong after a failed allocation
};

template <unsigned D>
using Boost_d_ary_heap_queue =
    Boost_heap_queue<boost::heap::d_ary_heap<Queue_entry,
                                             boost::heap::arity<D>,
                                             boost::heap::mutable_<true>,
                                             boost::heap::compare<Has_larger_key>>>;

using Boost_fibonacci_heap_queue = Boost_heap_queue<
    boost::heap::fibonacci_heap<Queue_entry, boost::heap::compare<Has_larger_key>>>;

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueues
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
class D_ary_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Boost_d_ary_heap_queue<D>
#endif
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit D_ary_heap_queue(const std::size_t number_of_nodes = 0,
                            const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_d_ary_heap_queue<D>(number_of_nodes, arcs)
  {
  }
};

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue based on an implicit binary heap.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
using Binary_heap_queue = D_ary_heap_queue<2>;

/*!
 * \ingroup PkgApproximateGeodesicsQueues
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
class Fibonacci_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Boost_fibonacci_heap_queue
#endif
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit Fibonacci_heap_queue(const std::size_t number_of_nodes = 0,
                                const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_fibonacci_heap_queue(number_of_nodes, arcs)
  {
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_HEAP_QUEUES_H
