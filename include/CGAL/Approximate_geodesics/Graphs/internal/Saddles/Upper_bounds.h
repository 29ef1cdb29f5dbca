// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * For each node of an exact search, a number that its distance does not exceed, or above which the
 * distance is of no interest; infinity if there is none.
 *
 * At first, these are lengths of paths along edges from the sources: some percent too large, which
 * are many edges where the sources are far away. Labels are lengths of better paths. `spread()`
 * continues these along edges, beyond the nodes that the search has reached: the error is then some
 * percent of the way from there.
 */
class Upper_bounds
{
public:
  explicit Upper_bounds(const std::size_t number_of_nodes) : m_bounds(number_of_nodes, infinity) {}

  double operator[](const Index node) const { return m_bounds[node]; }
  void prefetch(const Index node) const { internal::prefetch(m_bounds.data(), node); }

  // Takes a bound that is known before the search.
  void start_with(const Index node, const double bound)
  {
    m_bounds[node] = (std::min)(m_bounds[node], bound);
    m_known_before.push_back(node);
  }

  const std::vector<Index>& known_before() const { return m_known_before; }

  // Takes a label.
  void lower(const Index node, const double label)
  {
    if(!(label < m_bounds[node]))
      return;
    m_bounds[node] = label;
    if(m_spreads)
      m_lowered.push_back(node);
  }

  // If labels are spread, continues them along edges whenever the horizon of the search has moved
  // by this distance: from nodes with bounds up to where sights are followed until the next time,
  // to other nodes that have bounds. Nodes whose bounds fall several times are rare.
  void
  spread(const Intrinsic_triangulation& triangulation, const double horizon, const double distance)
  {
    if(!m_spreads || horizon < m_last_horizon + distance)
      return;
    const double largest = horizon + distance;
    m_last_horizon = horizon;
    for(std::size_t i = 0; i < m_lowered.size(); ++i)
    {
      const Index v = m_lowered[i];
      if(!(m_bounds[v] <= largest))
        continue;
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
        if(const Index target = triangulation.target(h); m_bounds[target] < infinity)
          lower(target, m_bounds[v] + triangulation.length(h));
    }
    m_lowered.clear();
  }

  // Starts a search. Only if labels are spread, those that are lowered are remembered.
  void start(const bool spreads)
  {
    m_spreads = spreads;
    m_last_horizon = 0;
    m_lowered.clear();
  }

  void discard(const Index node) { m_bounds[node] = infinity; }

  // Forgets the bounds of these nodes, and those known before the search.
  void forget(const std::vector<Index>& nodes)
  {
    reset(m_bounds, nodes, infinity);
    reset(m_bounds, m_known_before, infinity);
    m_known_before.clear();
  }

  void forget_all()
  {
    std::fill(m_bounds.begin(), m_bounds.end(), infinity);
    m_known_before.clear();
  }

  std::size_t memory() const { return memory_of(m_bounds, m_known_before, m_lowered); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<double> m_bounds;
  std::vector<Index> m_known_before;
  bool m_spreads = false;
  double m_last_horizon = 0;    // when bounds were spread
  std::vector<Index> m_lowered; // since bounds were spread; nodes may occur more than once
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H
