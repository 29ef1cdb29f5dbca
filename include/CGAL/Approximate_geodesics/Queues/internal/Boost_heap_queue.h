// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BOOST_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BOOST_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/internal/Ordered_queue_base.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BOOST_HEAP_QUEUE_H
