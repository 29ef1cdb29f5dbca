// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_ARRAYS_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_ARRAYS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL::Approximate_geodesics::internal {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns the number of bytes that the entries of a vector take, or that an object says it takes.
template <typename T, typename Allocator>
std::size_t memory_of_part(const std::vector<T, Allocator>& array)
{
  return std::is_same_v<T, bool> ? array.capacity() / 8 : array.capacity() * sizeof(T);
}

template <typename T>
std::size_t memory_of_part(const T& part)
{
  return part.memory();
}

// Returns the sum of these numbers.
template <typename... Parts>
std::size_t memory_of(const Parts&... parts)
{
  return (... + memory_of_part(parts));
}

// Sets the entries with these numbers to a value, or all if they are many: sequential access is
// faster.
template <typename T, typename Index>
void reset(std::vector<T>& array, const std::vector<Index>& numbers, const T value)
{
  if(numbers.size() > array.size() / 4)
    return std::fill(array.begin(), array.end(), value);
  for(const Index i : numbers)
    array[i] = value;
}

// Prefetches the cache line of entry `i` of an array. The entry may lie beyond the end, so the
// address is computed as an integer, because pointer arithmetic must stay in the array. WebAssembly
// has no such instruction; there, a load whose result is not used takes its place.
template <typename T>
void prefetch(const T* const array, const std::size_t i)
{
  [[maybe_unused]] const std::uintptr_t address =
      reinterpret_cast<std::uintptr_t>(array) + i * sizeof(T);
#if defined(__wasm__)
  constexpr int memory = 0;
  constexpr std::size_t size_of_page = 65536;
  if(address / size_of_page < __builtin_wasm_memory_size(memory))
    static_cast<void>(*reinterpret_cast<const volatile char*>(address));
#elif defined(__GNUC__)
  __builtin_prefetch(reinterpret_cast<const void*>(address));
  __asm__ volatile(""); // keeps g++ from removing calls as side-effect free
#endif
}

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

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_ARRAYS_H
