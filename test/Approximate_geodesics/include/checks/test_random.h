// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_RANDOM_H
#define APPROXIMATE_GEODESICS_TEST_RANDOM_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace geodesics_test {

// Random numbers that are the same everywhere: the standard fixes the engine, but not the
// distributions.
class Random
{
public:
  explicit Random(const std::uint64_t seed) : m_engine(seed) {}

  // in [0, size)
  std::size_t below(const std::size_t size)
  {
    return static_cast<std::size_t>(m_engine() % std::uint64_t(size));
  }

  // in [low, high)
  double between(const double low, const double high)
  {
    return low + (high - low) * (static_cast<double>(m_engine() >> 11) * 0x1p-53);
  }

  std::vector<std::size_t> permutation(const std::size_t size)
  {
    std::vector<std::size_t> result(size);
    std::iota(result.begin(), result.end(), std::size_t(0));
    shuffle(result);
    return result;
  }

  template <typename T>
  void shuffle(std::vector<T>& values)
  {
    for(std::size_t i = values.size(); i > 1; --i)
    {
      using std::swap;
      swap(values[i - 1], values[below(i)]);
    }
  }

private:
  std::mt19937_64 m_engine;
};

// The seed of a random test: a fixed one, unless the environment asks for another.
inline std::uint64_t test_seed()
{
  const char* wanted = std::getenv("APPROXIMATE_GEODESICS_TEST_SEED");
  const std::uint64_t seed = wanted == nullptr ? 20260 : std::strtoull(wanted, nullptr, 10);
  std::cout << "APPROXIMATE_GEODESICS_TEST_SEED=" << seed << std::endl;
  return seed;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_RANDOM_H
