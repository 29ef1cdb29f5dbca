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
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
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
 * Sights are followed up to a horizon only, a few edges farther away than the nodes that are
 * expanded, and are continued when the search gets there. By then, labels are known around them,
 * and end those that are of no use. Farther away, only upper bounds are known, the lengths of paths
 * along edges, which are too large to end them. Where the surface is rough, most sights are of no
 * use there, and would be followed across a large part of it. Where it is smooth, most are of use;
 * there, the horizon is farther away, and keeps the working set of the search small enough for the
 * processor's caches.
 *
 * The order of sights by distance is that of continuous Dijkstra (J. Mitchell, D. Mount,
 * C. Papadimitriou, The discrete geodesic problem, 1987). Here, a rough order is enough: a sight
 * waits in the list of the step in which the search gets to it, and steps are a part of the
 * distance to the horizon.
 */
class Deferred_sights
{
public:
  using List = std::vector<Deferred_sight>;

  // Starts a search. The horizon is at least this far away from the nodes that are expanded.
  void start(const double distance)
  {
    for(List& list : m_steps)
      list.clear();
    for(List& list : m_of_tasks) // a search may have ended while there were tasks
      list.clear();
    m_beyond.clear();
    m_resumed.clear();
    m_first = 0;
    m_distance = distance;
    m_step = distance / steps_to_horizon;
    m_next_step = distance < infinity ? 0 : infinity;
  }

  // Sights of which nothing is nearer are deferred.
  double horizon() const { return m_next_step + m_distance; }

  bool is_any_waiting() const
  {
    return !m_beyond.empty() || std::any_of(m_steps.begin(), m_steps.end(),
                                            [](const List& list) { return !list.empty(); });
  }

  // The label with which the search gets to the next sights, and a tip, whose label is smaller.
  // \pre A sight is waiting.
  std::pair<double, Deferred_sight::Index> next_label_and_tip() const
  {
    for(std::size_t i = 0; i < number_of_steps; ++i)
      if(const List& list = m_steps[(m_first + i) % number_of_steps]; !list.empty())
        return {m_next_step + static_cast<double>(i) * m_step, list.front().tip};
    return {m_next_step + number_of_steps * m_step, m_beyond.front().tip};
  }

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
      for(const Deferred_sight& sight : m_of_tasks[i])
        list_of(sight).push_back(sight);
      m_of_tasks[i].clear();
    }
  }

  // Moves the horizon if the search has got to the next step with this label, and returns whether
  // it did. Then `resumed()` are the sights that are to be continued.
  bool advance(const double label)
  {
    m_resumed.clear();
    if(!(label >= m_next_step))
      return false;
    for(std::size_t i = 0; i < number_of_steps && label >= m_next_step; ++i)
      take_next_step();
    if(label >= m_next_step) // all sights near enough for a list are resumed
      m_next_step = label + m_step > label ? label + m_step : infinity;
    if(!m_beyond.empty())
      sort_beyond();
    return true;
  }

  const List& resumed() const { return m_resumed; }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_beyond, m_resumed, m_of_tasks);
    for(const List& list : m_steps)
      result += memory_of(list);
    for(const List& list : m_of_tasks)
      result += memory_of(list);
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t number_of_steps = 16, steps_to_horizon = 8;

  List& list_of(const Deferred_sight& sight)
  {
    const double step = (sight.smallest_label - m_next_step) / m_step;
    return step < number_of_steps
               ? m_steps[(m_first + static_cast<std::size_t>(step)) % number_of_steps]
               : m_beyond;
  }

  void take_next_step()
  {
    List& list = m_steps[m_first];
    m_resumed.insert(m_resumed.end(), list.begin(), list.end());
    list.clear();
    m_first = (m_first + 1) % number_of_steps;
    m_next_step += m_step;
  }

  // Moves sights that waited behind long edges to the lists of steps, or resumes them.
  void sort_beyond()
  {
    const double end = m_next_step + number_of_steps * m_step;
    const auto near =
        std::partition(m_beyond.begin(), m_beyond.end(),
                       [&](const Deferred_sight& s) { return s.smallest_label >= end; });
    for(auto s = near; s != m_beyond.end(); ++s)
    {
      const double step = (s->smallest_label - m_next_step) / m_step;
      const auto i = // not beyond the last list, by rounding
          (std::min)(static_cast<std::size_t>((std::max)(step, 0.)), number_of_steps - 1);
      (step > 0 ? m_steps[(m_first + i) % number_of_steps] : m_resumed).push_back(*s);
    }
    m_beyond.erase(near, m_beyond.end());
  }

  std::array<List, number_of_steps> m_steps; // a ring, from `m_first` on
  std::size_t m_first = 0;
  List m_beyond; // the last of these steps
  List m_resumed;
  std::vector<List> m_of_tasks;
  double m_next_step = infinity, m_step = infinity, m_distance = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
