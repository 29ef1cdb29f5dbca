// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_WORKSPACES_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_WORKSPACES_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Geodesic_costs/internal/Repair.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A pool of search workspaces for one graph. A thread borrows a workspace for the duration of a
 * search, so there are at most as many as concurrent searches. Workspaces that are kept cost a
 * short list of pairs nothing: to make one takes time in proportion to the size of the graph. They
 * are made anew when all weights of the graph have been exchanged.
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
  using Borrowed = std::unique_ptr<Search, Return>;

  // The graph is referred to, not copied.
  explicit Workspaces(const Graph& graph) : m_graph(graph) {}

  // Calls `set_up(search)` for each workspace from now on, when it is made.
  void set_up(std::function<void(Search&)> set_up)
  {
    m_searches.clear();
    m_set_up = std::move(set_up);
  }

  Borrowed borrow() { return Borrowed(take().release(), Return{this}); }

  // Returns the sum of `f(search)` over all workspaces that are not borrowed.
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
    if(!are_changes_known(m_graph, m_number_of_changes))
      m_searches.clear();
    m_number_of_changes = number_of_changes(m_graph);
    if(m_searches.empty())
    {
      m_searches.reserve(++m_number); // so that put_back() cannot throw
      Pointer result = std::make_unique<Search>(m_graph);
      if(m_set_up)
        m_set_up(*result);
      return result;
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
  std::function<void(Search&)> m_set_up;
  std::vector<Pointer> m_searches;
  std::size_t m_number = 0;
  std::size_t m_number_of_changes = number_of_changes(m_graph); // when one was last borrowed
  mutable std::mutex m_mutex;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_WORKSPACES_H
