// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_PAIR_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_PAIR_H

#include <CGAL/license/Approximate_geodesics.h>

#if defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#else
#include <cstdint>
#include <cstring>
#endif

namespace CGAL::Approximate_geodesics::internal {

#if defined(__GNUC__) && defined(__SSE2__)

/*
 * Two numbers, one for the left and one for the right, and the same operation on both: one
 * instruction with SSE2, and two elsewhere.
 */
class Double_pair
{
  // Not `__m128d`: a write of that type may alias everything.
  using Vector = double __attribute__((vector_size(16)));

public:
  // The results of two comparisons.
  class Mask
  {
  public:
    Mask(const Vector vector) : m_vector(vector) {}
    explicit Mask(const bool both) : m_vector(_mm_castsi128_pd(_mm_set1_epi32(both ? -1 : 0))) {}

    // 1 if it is true on the left, plus 2 if it is true on the right.
    int bits() const { return _mm_movemask_pd(m_vector); }

    // `a` where the mask is true, and `b` elsewhere.
    Double_pair choose(const Double_pair a, const Double_pair b) const
    {
      return _mm_or_pd(_mm_and_pd(m_vector, a.m_vector), _mm_andnot_pd(m_vector, b.m_vector));
    }

    friend Mask operator&(const Mask a, const Mask b) { return _mm_and_pd(a.m_vector, b.m_vector); }
    friend Mask operator|(const Mask a, const Mask b) { return _mm_or_pd(a.m_vector, b.m_vector); }

  private:
    Vector m_vector;
  };

  Double_pair() = default; // uninitialized
  explicit Double_pair(const double both) : m_vector{both, both} {}
  Double_pair(const double left, const double right) : m_vector{left, right} {}

  double left() const { return m_vector[0]; }
  double right() const { return m_vector[1]; }

  Double_pair swapped() const { return _mm_shuffle_pd(m_vector, m_vector, 1); }
  Double_pair with_right(const Double_pair other) const
  {
    return _mm_shuffle_pd(m_vector, other.m_vector, 2);
  }

  friend Double_pair operator+(const Double_pair a, const Double_pair b)
  {
    return a.m_vector + b.m_vector;
  }
  friend Double_pair operator-(const Double_pair a, const Double_pair b)
  {
    return a.m_vector - b.m_vector;
  }
  friend Double_pair operator*(const Double_pair a, const Double_pair b)
  {
    return a.m_vector * b.m_vector;
  }
  friend Mask operator<(const Double_pair a, const Double_pair b)
  {
    return _mm_cmplt_pd(a.m_vector, b.m_vector);
  }
  friend Mask operator<=(const Double_pair a, const Double_pair b)
  {
    return _mm_cmple_pd(a.m_vector, b.m_vector);
  }

private:
  Double_pair(const Vector vector) : m_vector(vector) {}

  Vector m_vector;
};

#else

class Double_pair
{
public:
  class Mask
  {
  public:
    Mask(const bool left, const bool right) : m_left(left), m_right(right) {}
    explicit Mask(const bool both) : Mask(both, both) {}

    int bits() const { return int(m_left) + 2 * int(m_right); }

    Double_pair choose(const Double_pair a, const Double_pair b) const
    {
      return {choose(m_left, a.m_left, b.m_left), choose(m_right, a.m_right, b.m_right)};
    }

    friend Mask operator&(const Mask a, const Mask b)
    {
      return {(a.m_left & b.m_left) != 0, (a.m_right & b.m_right) != 0};
    }
    friend Mask operator|(const Mask a, const Mask b)
    {
      return {(a.m_left | b.m_left) != 0, (a.m_right | b.m_right) != 0};
    }

  private:
    // no branch depends on a comparison
    static double choose(const bool is_first, const double a, const double b)
    {
      std::uint64_t bits, other_bits;
      std::memcpy(&bits, &a, sizeof(a));
      std::memcpy(&other_bits, &b, sizeof(b));
      bits ^= (bits ^ other_bits) & (std::uint64_t(is_first) - 1);
      double result;
      std::memcpy(&result, &bits, sizeof(result));
      return result;
    }

    bool m_left, m_right;
  };

  Double_pair() = default; // uninitialized
  explicit Double_pair(const double both) : Double_pair(both, both) {}
  Double_pair(const double left, const double right) : m_left(left), m_right(right) {}

  double left() const { return m_left; }
  double right() const { return m_right; }

  Double_pair swapped() const { return {m_right, m_left}; }
  Double_pair with_right(const Double_pair other) const { return {m_left, other.m_right}; }

  friend Double_pair operator+(const Double_pair a, const Double_pair b)
  {
    return {a.m_left + b.m_left, a.m_right + b.m_right};
  }
  friend Double_pair operator-(const Double_pair a, const Double_pair b)
  {
    return {a.m_left - b.m_left, a.m_right - b.m_right};
  }
  friend Double_pair operator*(const Double_pair a, const Double_pair b)
  {
    return {a.m_left * b.m_left, a.m_right * b.m_right};
  }
  friend Mask operator<(const Double_pair a, const Double_pair b)
  {
    return {a.m_left < b.m_left, a.m_right < b.m_right};
  }
  friend Mask operator<=(const Double_pair a, const Double_pair b)
  {
    return {a.m_left <= b.m_left, a.m_right <= b.m_right};
  }

private:
  double m_left, m_right;
};

#endif

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_DOUBLE_PAIR_H
