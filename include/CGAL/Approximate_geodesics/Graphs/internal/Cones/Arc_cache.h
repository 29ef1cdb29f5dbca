// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_CACHE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_CACHE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/stored_arcs.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs of those nodes that were asked for. Several threads may ask at a time: the
 * first one that has computed the arcs of a node leaves them for the others.
 */
class Arc_cache
{
public:
  using Arcs = std::vector<Stored_arc>;

  Arc_cache() = default;

  explicit Arc_cache(const std::size_t number_of_nodes)
    : m_number_of_nodes(number_of_nodes), m_arcs(new std::atomic<const Arcs*>[number_of_nodes])
  {
    for(std::size_t i = 0; i < number_of_nodes; ++i)
      m_arcs[i].store(nullptr, std::memory_order_relaxed);
  }

  Arc_cache(Arc_cache&& other) noexcept { swap(other); }

  Arc_cache& operator=(Arc_cache&& other) noexcept
  {
    swap(other);
    return *this;
  }

  ~Arc_cache()
  {
    for(std::size_t i = 0; i < m_number_of_nodes; ++i)
      delete m_arcs[i].load(std::memory_order_relaxed);
  }

  // Whether there is room for any.
  bool is_enabled() const { return m_arcs != nullptr; }

  // The arcs of `node`, found by `find(arcs)` when first asked for.
  template <typename F>
  const Arcs& arcs(const std::size_t node, F find)
  {
    std::atomic<const Arcs*>& slot = m_arcs[node];
    if(const Arcs* const known = slot.load(std::memory_order_acquire))
      return *known;
    auto mine = std::make_unique<Arcs>();
    find(*mine);
    mine->shrink_to_fit();
    const Arcs* expected = nullptr;
    if(slot.compare_exchange_strong(expected, mine.get(), std::memory_order_acq_rel,
                                    std::memory_order_acquire))
      return *mine.release();
    return *expected;
  }

  std::size_t memory() const
  {
    std::size_t result = m_number_of_nodes * sizeof(std::atomic<const Arcs*>);
    for(std::size_t i = 0; i < m_number_of_nodes; ++i)
      if(const Arcs* const arcs = m_arcs[i].load(std::memory_order_acquire))
        result += sizeof(Arcs) + arcs->capacity() * sizeof(Stored_arc);
    return result;
  }

private:
  void swap(Arc_cache& other) noexcept
  {
    std::swap(m_number_of_nodes, other.m_number_of_nodes);
    std::swap(m_arcs, other.m_arcs);
  }

  std::size_t m_number_of_nodes = 0;
  std::unique_ptr<std::atomic<const Arcs*>[]> m_arcs;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_CACHE_H
