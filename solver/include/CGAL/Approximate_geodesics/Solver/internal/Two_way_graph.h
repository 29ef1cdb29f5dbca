// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_TWO_WAY_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_TWO_WAY_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A graph for distances from the sources, and its reversal for distances to the sources, which is
 * built on demand. Undirected graphs are not duplicated.
 */
class Two_way_graph
{
public:
  void set(std::unique_ptr<Solver_graph> graph) { m_there = std::move(graph); }

  const Solver_graph& operator*() const { return *m_there; }
  const Solver_graph* operator->() const { return m_there.get(); }

  const Solver_graph& in_direction(const bool to_source) const
  {
    if(!to_source)
      return *m_there;
    const std::lock_guard lock(m_mutex);
    if(m_back == nullptr)
      m_back = m_there->reversed();
    return m_back == nullptr ? *m_there : *m_back;
  }

  std::size_t memory() const
  {
    const std::lock_guard lock(m_mutex);
    return m_there->memory() + (m_back == nullptr ? 0 : m_back->memory());
  }

private:
  std::unique_ptr<Solver_graph> m_there;
  mutable std::unique_ptr<Solver_graph> m_back;
  mutable std::mutex m_mutex;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_TWO_WAY_GRAPH_H
