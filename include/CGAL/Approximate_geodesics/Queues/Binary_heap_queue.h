// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_BINARY_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_BINARY_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/D_ary_heap_queue.h>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * The heap of textbooks: an implicit one, whose nodes have two children each.
 */
using Binary_heap_queue = D_ary_heap_queue<2>;

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_BINARY_HEAP_QUEUE_H
