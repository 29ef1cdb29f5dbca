// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LARGE_ARRAYS_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LARGE_ARRAYS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL::Approximate_geodesics::internal {

// Leaves new entries of a `std::vector` uninitialized, for large arrays of plain data that are
// written right away.
template <typename T>
struct Uninitialized_allocator : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = Uninitialized_allocator<U>;
  };

  Uninitialized_allocator() = default;

  template <typename U>
  Uninitialized_allocator(const Uninitialized_allocator<U>& /* other */)
  {
  }

  template <typename U>
  void construct(U* const entry)
  {
    ::new(static_cast<void*>(entry)) U;
  }
};

// Reserves memory for entries that are written right away. Large arrays request huge pages where
// the system supports this: page faults, one per small page, would take longer than writing the
// entries.
template <typename T, typename Allocator>
void reserve_huge_pages(std::vector<T, Allocator>& array, const std::size_t size)
{
  array.reserve(size);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t size_of_page = 4096, smallest = std::uintptr_t(1) << 22;
  const auto begin = reinterpret_cast<std::uintptr_t>(array.data());
  const std::uintptr_t first = (begin + size_of_page - 1) / size_of_page * size_of_page;
  const std::uintptr_t beyond = (begin + size * sizeof(T)) / size_of_page * size_of_page;
  if(size * sizeof(T) >= smallest) // it is advice: nothing depends on its success
    static_cast<void>(madvise(reinterpret_cast<void*>(first), beyond - first, MADV_HUGEPAGE));
#endif
}

template <typename T, typename Allocator>
void resize_in_huge_pages(std::vector<T, Allocator>& array, const std::size_t size)
{
  reserve_huge_pages(array, size);
  array.resize(size);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LARGE_ARRAYS_H
