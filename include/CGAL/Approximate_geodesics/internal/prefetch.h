// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_PREFETCH_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_PREFETCH_H

#include <CGAL/license/Approximate_geodesics.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// asks for the cache line at `address`, which need not be valid
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_PREFETCH_H
