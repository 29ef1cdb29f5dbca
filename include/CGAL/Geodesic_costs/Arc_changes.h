// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_ARC_CHANGES_H
#define CGAL_GEODESIC_COSTS_ARC_CHANGES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * What has changed in a graph since it was built. `Propagation::repair()` reads it.
 *
 * The nodes of the graph form groups, such that the two ends of each arc are in a common group, see
 * `GeodesicGraph`. A change says that arcs between nodes of a group have become shorter or longer,
 * have appeared, or have vanished. Changes are numbered from `0`; only the latest are kept.
 */
class Arc_changes
{
public:
  /// a change.
  struct Change
  {
    /// the number of the group.
    std::size_t group;
    /// whether arcs may have become shorter, or have appeared.
    bool is_shorter;
    /// whether arcs may have become longer, or have vanished.
    bool is_longer;
  };

  /// returns how many changes there were.
  std::size_t number() const { return m_number_of_dropped + m_latest.size(); }

  /// returns whether all changes from `number` on are known.
  bool are_known_since(const std::size_t number) const { return number >= m_number_of_dropped; }

  /// calls `f(change)` for the changes from `number` on. \pre They are known.
  template <typename F>
  void for_each_since(const std::size_t number, F f) const
  {
    for(std::size_t i = number - m_number_of_dropped; i < m_latest.size(); ++i)
      f(m_latest[i]);
  }

  /// allocates memory for `number` more changes.
  void reserve(const std::size_t number)
  {
    const std::size_t needed = m_latest.size() + number;
    if(needed > m_latest.capacity())
      m_latest.reserve((std::max)(needed, 2 * m_latest.capacity())); // for many small calls
  }

  /// adds a change. If there are more than `largest_number`, the earlier ones are dropped, as a
  /// search of the whole graph takes no longer then.
  void add(const Change& change, const std::size_t largest_number)
  {
    if(m_latest.size() > largest_number)
      drop();
    m_latest.push_back(change);
  }

  /// must be called when any arc may have changed.
  void add_unknown()
  {
    ++m_number_of_dropped;
    drop();
  }

  /// returns the number of bytes that are stored.
  std::size_t memory() const { return internal::memory_of(m_latest); }

private:
  void drop()
  {
    m_number_of_dropped += m_latest.size();
    m_latest.clear();
  }

  std::size_t m_number_of_dropped = 0;
  std::vector<Change> m_latest;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_ARC_CHANGES_H
