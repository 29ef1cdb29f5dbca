// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_PREFETCH_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_PREFETCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// Prefetches the cache line of entry `i` of an array. The entry may lie beyond the end, so the
// address is computed as an integer, because pointer arithmetic must stay in the array.
template <typename T>
void prefetch(const T* const array, const std::size_t i)
{
#if defined(__GNUC__)
  __builtin_prefetch(
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(array) + i * sizeof(T)));
  __asm__ volatile(""); // keeps g++ from removing calls as side-effect free
#else
  static_cast<void>(array), static_cast<void>(i);
#endif
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_PREFETCH_H
