// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BIT_WIDTH_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BIT_WIDTH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/integer/integer_log2.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// std::bit_width() of C++20.
inline std::size_t bit_width(const std::uint64_t i)
{
  if(i == 0)
    return 0;
#if defined(__GNUC__)
  return 64 - static_cast<std::size_t>(__builtin_clzll(i));
#else
  return 1 + static_cast<std::size_t>(boost::integer_log2(i));
#endif
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_BIT_WIDTH_H
