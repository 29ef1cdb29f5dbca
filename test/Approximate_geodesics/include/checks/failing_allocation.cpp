// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"

#include <cstddef>
#include <new>

// The operators that replace those of the standard library.

using geodesics_test::Allocations;

void* operator new(const std::size_t size) { return Allocations::allocate_or_throw(size, 1); }

void* operator new[](const std::size_t size) { return Allocations::allocate_or_throw(size, 1); }

void* operator new(const std::size_t size, const std::align_val_t alignment)
{
  return Allocations::allocate_or_throw(size, static_cast<std::size_t>(alignment));
}

void* operator new[](const std::size_t size, const std::align_val_t alignment)
{
  return Allocations::allocate_or_throw(size, static_cast<std::size_t>(alignment));
}

void* operator new(const std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocations::allocate(size, 1);
}

void* operator new[](const std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocations::allocate(size, 1);
}

void* operator new(const std::size_t size,
                   const std::align_val_t alignment,
                   const std::nothrow_t&) noexcept
{
  return Allocations::allocate(size, static_cast<std::size_t>(alignment));
}

void* operator new[](const std::size_t size,
                     const std::align_val_t alignment,
                     const std::nothrow_t&) noexcept
{
  return Allocations::allocate(size, static_cast<std::size_t>(alignment));
}

void operator delete(void* p) noexcept { Allocations::free(p); }
void operator delete[](void* p) noexcept { Allocations::free(p); }
void operator delete(void* p, std::size_t) noexcept { Allocations::free(p); }
void operator delete[](void* p, std::size_t) noexcept { Allocations::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { Allocations::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { Allocations::free(p); }

void operator delete(void* p, std::size_t, std::align_val_t) noexcept { Allocations::free(p); }

void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { Allocations::free(p); }

void operator delete(void* p, const std::nothrow_t&) noexcept { Allocations::free(p); }

void operator delete[](void* p, const std::nothrow_t&) noexcept { Allocations::free(p); }

void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept
{
  Allocations::free(p);
}

void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept
{
  Allocations::free(p);
}
