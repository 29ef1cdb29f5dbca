// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WORKSPACES_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WORKSPACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Workspaces for searches of one graph. A thread borrows one for the time of a search, so that
 * there are never more than threads that search at the same time.
 */
template <typename Search>
class Workspaces
{
  using Graph = typename Search::Graph;
  using Pointer = std::unique_ptr<Search>;

  struct Return
  {
    Workspaces* owner;
    void operator()(Search* const search) const { owner->put_back(Pointer(search)); }
  };

public:
  // The graph is referred to, not copied.
  explicit Workspaces(const Graph& graph) : m_graph(graph) {}

  std::unique_ptr<Search, Return> borrow()
  {
    return std::unique_ptr<Search, Return>(take().release(), Return{this});
  }

  // The sum of `f(search)` for all that nobody has borrowed.
  template <typename F>
  std::size_t sum(const F& f) const
  {
    const std::lock_guard lock(m_mutex);
    std::size_t result = 0;
    for(const Pointer& search : m_searches)
      result += f(*search);
    return result;
  }

private:
  Pointer take()
  {
    const std::lock_guard lock(m_mutex);
    if(m_searches.empty())
    {
      m_searches.reserve(++m_number); // so that putting back cannot fail
      return std::make_unique<Search>(m_graph);
    }
    Pointer result = std::move(m_searches.back());
    m_searches.pop_back();
    return result;
  }

  void put_back(Pointer search)
  {
    const std::lock_guard lock(m_mutex);
    m_searches.push_back(std::move(search));
  }

  const Graph& m_graph;
  std::vector<Pointer> m_searches;
  std::size_t m_number = 0;
  mutable std::mutex m_mutex;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WORKSPACES_H
