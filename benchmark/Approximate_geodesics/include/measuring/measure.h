// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_MEASURE_H
#define BENCHMARK_MEASURE_H

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename F>
double seconds_of(F f)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  f();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Measures several contestants in interleaved rounds, so that a temporary slowdown of the machine
// affects all of them. In each round, all contestants get the same task.
class Contest
{
public:
  using Contestant = std::function<void(std::size_t round)>;

  // Returns the index of the contestant in results.
  std::size_t add(Contestant contestant)
  {
    m_contestants.push_back({std::move(contestant), {}});
    return m_contestants.size() - 1;
  }

  void run(const std::size_t number_of_rounds, const std::size_t batch = 1)
  {
    for(std::size_t first = 0; first < number_of_rounds; first += batch)
      for(Entry& entry : m_contestants)
        for(std::size_t i = first; i < (std::min)(first + batch, number_of_rounds); ++i)
          entry.seconds.push_back(seconds_of([&] { entry.contestant(i); }));
  }

  double median_seconds(const std::size_t number) const
  {
    return median(m_contestants[number].seconds);
  }

  double mean_seconds(const std::size_t number) const
  {
    const std::vector<double>& seconds = m_contestants[number].seconds;
    return std::accumulate(seconds.begin(), seconds.end(), 0.) / double(seconds.size());
  }

  // The ratio of the time of the first contestant to that of the second.
  double ratio(const std::size_t first, const std::size_t second) const
  {
    return median_seconds(first) / median_seconds(second);
  }

private:
  struct Entry
  {
    Contestant contestant;
    std::vector<double> seconds;
  };

  std::vector<Entry> m_contestants;
};

#endif // BENCHMARK_MEASURE_H
