// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MAKE_SYMMETRIC_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MAKE_SYMMETRIC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

// Replaces each entry of a square matrix and its transpose by the smaller of the two, by tiles of
// `side` rows and columns. Two of the default size fit into the cache. The operation is idempotent.
template <typename T>
void make_symmetric(T* const distances, const std::size_t size, const std::size_t side = 64)
{
  for(std::size_t i = 0; i < size; i += side)
    for(std::size_t j = 0; j <= i; j += side)
      for(std::size_t k = i; k < (std::min)(i + side, size); ++k)
        for(std::size_t l = j; l < (std::min)(j + side, k); ++l)
        {
          T& below = distances[k * size + l];
          T& above = distances[l * size + k];
          below = above = (std::min)(below, above);
        }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MAKE_SYMMETRIC_H
