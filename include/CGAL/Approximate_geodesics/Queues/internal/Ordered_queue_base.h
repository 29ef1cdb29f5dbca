// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_ORDERED_QUEUE_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_ORDERED_QUEUE_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/Iterator_range.h>

#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_ORDERED_QUEUE_BASE_H
