// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_ERRORS_H
#define BENCHMARK_ERRORS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

// The relative errors of distances.
class Errors
{
public:
  // Skips sources, where the relative error is undefined. Returns the error.
  double add(const double distance, const double exact)
  {
    if(exact == 0)
      return 0;
    const double error = (distance - exact) / exact;
    ++m_count;
    m_sum += std::abs(error);
    m_least = (std::min)(m_least, error);
    m_largest = (std::max)(m_largest, error);
    return error;
  }

  std::size_t count() const { return m_count; }

  // Absolute values.
  double mean() const { return m_count == 0 ? 0 : m_sum / double(m_count); }

  double least() const { return m_least; }
  double largest() const { return m_largest; }

private:
  std::size_t m_count = 0;
  double m_sum = 0;
  double m_least = std::numeric_limits<double>::infinity();
  double m_largest = -std::numeric_limits<double>::infinity();
};

#endif // BENCHMARK_ERRORS_H
