// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FUZZED_DATA_H
#define APPROXIMATE_GEODESICS_TEST_FUZZED_DATA_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace geodesics_test {

// The bytes that a fuzzer thinks up, read as choices and numbers. After the last byte come zeros.
class Fuzzed_data
{
public:
  Fuzzed_data(const std::uint8_t* data, const std::size_t size) : m_next(data), m_end(data + size)
  {
  }

  bool is_empty() const { return m_next == m_end; }

  std::uint8_t byte() { return is_empty() ? std::uint8_t(0) : *m_next++; }

  bool coin() { return byte() % 2 == 1; }

  // in [0, size)
  std::size_t below(const std::size_t size)
  {
    const std::size_t high = size > 256 ? byte() : 0u;
    return (high * 256 + byte()) % size;
  }

  template <typename T, std::size_t size>
  const T& one_of(const std::array<T, size>& values)
  {
    return values[below(size)];
  }

  // Mostly a number that a mesh could have, now and then one that breaks programs, or any bits.
  double number()
  {
    const std::uint8_t kind = byte();
    if(kind < 128)
      return static_cast<double>(byte()) / 16;
    if(kind < 192)
      return one_of(special_numbers);
    if(kind < 224)
      return one_of(special_numbers) * (1 + static_cast<double>(byte()) / 256);
    return any_bits();
  }

  // in [0, 1], close to its ends now and then
  double part()
  {
    const std::uint8_t kind = byte();
    const double part = static_cast<double>(byte()) / 255;
    if(kind < 192)
      return part;
    const double close = part * one_of(small_numbers);
    return kind < 224 ? close : 1 - close;
  }

  std::string rest()
  {
    const std::string result(m_next, m_end);
    m_next = m_end;
    return result;
  }

private:
  using Limits = std::numeric_limits<double>;

  static constexpr std::array<double, 20> special_numbers = {0,
                                                             -0.0,
                                                             1,
                                                             -1,
                                                             3,
                                                             1e-9,
                                                             1e-12,
                                                             1e-160,
                                                             1e-310,
                                                             1e8,
                                                             1e12,
                                                             1e15,
                                                             1e160,
                                                             1e300,
                                                             -1e160,
                                                             -1e-310,
                                                             1e-20,
                                                             Limits::max(),
                                                             Limits::infinity(),
                                                             Limits::quiet_NaN()};

  static constexpr std::array<double, 6> small_numbers = {1e-3, 1e-8, 1e-12, 1e-15, 1e-17, 1e-300};

  double any_bits()
  {
    std::array<std::uint8_t, sizeof(double)> bytes;
    for(std::uint8_t& b : bytes)
      b = byte();
    double result;
    std::memcpy(&result, bytes.data(), sizeof(double));
    return result;
  }

  const std::uint8_t* m_next;
  const std::uint8_t* m_end;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FUZZED_DATA_H
