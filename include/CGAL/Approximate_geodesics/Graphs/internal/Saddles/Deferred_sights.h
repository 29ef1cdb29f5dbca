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
  using List = std::vector<Deferred_sight>;

  // Starts a search. The horizon is this far away from the nodes that are expanded.
  void start(const double distance)
  {
    m_waiting.clear();
    m_resumed.clear();
    for(List& list : m_of_tasks) // a search may have ended while there were tasks
      list.clear();
    m_distance = m_horizon = distance;
  }

  double horizon() const { return m_horizon; }

  // The list that sights are deferred to.
  List& waiting() { return m_waiting; }

  // The lists that tasks defer sights to.
  std::vector<List>& start_tasks(const std::size_t number)
  {
    m_of_tasks.resize((std::max)(m_of_tasks.size(), number));
    return m_of_tasks;
  }

  // Must be called after these tasks. Results depend on the order of sights, and must not depend on
  // threads.
  void finish_tasks(const std::size_t number)
  {
    for(std::size_t i = 0; i < number; ++i)
    {
      m_waiting.insert(m_waiting.end(), m_of_tasks[i].begin(), m_of_tasks[i].end());
      m_of_tasks[i].clear();
    }
  }

  // Moves the horizon if the search has reached it with this label. Then `resumed()` are the
  // sights before it.
  void advance(const double label)
  {
    m_resumed.clear();
    if(!(label >= m_horizon))
      return;
    m_horizon = label + m_distance > label ? label + m_distance : infinity;
    // sights beyond the horizon are not copied: there may be many, for many calls
    const auto resumed =
        std::partition(m_waiting.begin(), m_waiting.end(),
                       [&](const Deferred_sight& s) { return s.smallest_label > m_horizon; });
    m_resumed.assign(resumed, m_waiting.end());
    m_waiting.erase(resumed, m_waiting.end());
  }

  const List& resumed() const { return m_resumed; }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_waiting, m_resumed, m_of_tasks);
    for(const List& list : m_of_tasks)
      result += memory_of(list);
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  List m_waiting, m_resumed;
  std::vector<List> m_of_tasks;
  double m_horizon = infinity, m_distance = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
