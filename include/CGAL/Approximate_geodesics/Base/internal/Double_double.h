// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_DOUBLE_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_DOUBLE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cmath>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * A double-double number, with about 32 digits: the unevaluated sum of two `double`s, where `low`
 * is at most half an ulp of `high` (T. J. Dekker, A floating-point technique for extending the
 * available precision, 1971). Without overflow and underflow, sums and products have errors of
 * about 2^-104 relative to their largest term.
 */
struct Double_double
{
  double high, low;
};

// a + b, exactly
inline Double_double exact_sum(const double a, const double b)
{
  const double sum = a + b, part_of_b = sum - a;
  return {sum, (a - (sum - part_of_b)) + (b - part_of_b)};
}

// a * b, exactly
inline Double_double exact_product(const double a, const double b)
{
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline Double_double operator-(const Double_double a) { return {-a.high, -a.low}; }

inline Double_double operator+(const Double_double a, const Double_double b)
{
  const Double_double sum = exact_sum(a.high, b.high);
  return exact_sum(sum.high, sum.low + (a.low + b.low));
}

inline Double_double operator-(const Double_double a, const Double_double b) { return a + -b; }

inline Double_double operator*(const Double_double a, const Double_double b)
{
  const Double_double product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_DOUBLE_H
