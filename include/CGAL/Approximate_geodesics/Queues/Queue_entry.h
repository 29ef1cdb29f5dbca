// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstdint>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
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

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_QUEUE_ENTRY_H
