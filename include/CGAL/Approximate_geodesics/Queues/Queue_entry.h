// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Iterator_range.h>

#include <cstdint>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * An entry of a queue: a node and its key.
 */
struct Queue_entry
{
  /// the key: a distance, in units of the graph.
  double key;
  /// the number of the node.
  std::uint32_t node;
};

namespace internal {

// Common base of the queues that extract single entries in order.
class Ordered_queue_base
{
public:
  using Node = std::uint32_t;
  using Key = double;
  using Entry = Queue_entry;
  using Batch = Iterator_range<const Entry*>;

  bool is_final(const Key key) const { return key < m_extracted.key; }

protected:
  Batch hand_out(const Entry& entry)
  {
    m_extracted = entry;
    return Batch(&m_extracted, &m_extracted + 1);
  }

  void restart() { m_extracted = Entry{0, 0}; }

private:
  Entry m_extracted{0, 0}; // the last extracted entry
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H
