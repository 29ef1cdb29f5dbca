// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A sight, and all that it takes to follow it later.
struct Deferred_sight
{
  using Index = Intrinsic_triangulation::Index;

  Sight sight;
  Crossing milestone; // the last one on the way
  Index tip;
  double label_of_tip;
  double smallest_label; // of points that are seen
};

/*
 * Where the surface is rough, sights are followed up to a horizon only, a few edges farther away
 * than the nodes that are expanded, and are continued when the search gets there. By then, labels
 * are known around them, and end those that are of no use. Paths along edges, all that is known
 * farther away, would not: most sights are of no use there, and would be followed across a large
 * part of the surface.
 *
 * The order of sights by distance is that of continuous Dijkstra (J. Mitchell, D. Mount,
 * C. Papadimitriou, The discrete geodesic problem, 1987). Here, a rough order is enough: sights
 * wait in a list without any order.
 */
class Deferred_sights
{
public:
  // Starts a search. The horizon is this far away from the nodes that are expanded.
  void start(const double distance)
  {
    m_waiting.clear();
    m_resumed.clear();
    m_distance = m_horizon = distance;
  }

  double horizon() const { return m_horizon; }

  // The list that sights are deferred to.
  std::vector<Deferred_sight>& waiting() { return m_waiting; }

  // Moves the horizon if the search has reached it with this label. Then `resumed()` are the
  // sights before it.
  void advance(const double label)
  {
    m_resumed.clear();
    if(!(label >= m_horizon))
      return;
    m_horizon = label + m_distance > label ? label + m_distance : infinity;
    m_resumed.swap(m_waiting);
    const auto farther =
        std::partition(m_resumed.begin(), m_resumed.end(),
                       [&](const Deferred_sight& s) { return s.smallest_label <= m_horizon; });
    m_waiting.assign(farther, m_resumed.end());
    m_resumed.erase(farther, m_resumed.end());
  }

  const std::vector<Deferred_sight>& resumed() const { return m_resumed; }

  std::size_t memory() const
  {
    return (m_waiting.capacity() + m_resumed.capacity()) * sizeof(Deferred_sight);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<Deferred_sight> m_waiting, m_resumed;
  double m_horizon = infinity, m_distance = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
