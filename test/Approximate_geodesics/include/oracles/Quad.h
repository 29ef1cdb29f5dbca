// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_QUAD_H
#define APPROXIMATE_GEODESICS_TEST_QUAD_H

#include <cmath>

namespace geodesics_test {

// A number with 113 bits, where the compiler has one: with 34 digits, the shape of a needle of
// width 1e-9 is known to 25. Elsewhere `long double`, which may be such a number as well.
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
#endif

// No function of a library: that for `__float128` would have to be linked.
inline Quad quad_root(const Quad x)
{
  const Quad root = std::sqrt(static_cast<long double>(x)); // has 64 bits
  return root > 0 ? (root + x / root) / 2 : root;           // doubles them, by Newton's method
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_QUAD_H
