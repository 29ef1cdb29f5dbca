// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_INTERRUPTION_AT_H
#define APPROXIMATE_GEODESICS_TEST_INTERRUPTION_AT_H

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>

namespace geodesics_test {

// Interrupts this thread, and those that work for it, at a certain check.
class Interruption_at final : public CGAL::Approximate_geodesics::internal::Interruption
{
public:
  explicit Interruption_at(const int number) : m_number(number) { of_this_thread() = this; }
  ~Interruption_at() { of_this_thread() = nullptr; }
  Interruption_at(const Interruption_at&) = delete;
  Interruption_at& operator=(const Interruption_at&) = delete;

  void check() override
  {
    if(--m_number < 0)
      throw std::runtime_error("interrupted");
  }
  void set_progress(std::size_t, std::size_t) override {}

private:
  std::atomic<int> m_number;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_INTERRUPTION_AT_H
