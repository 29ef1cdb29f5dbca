// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_BLOCKED_RANGE_H
#define APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_BLOCKED_RANGE_H

// Stands in for TBB's: see parallel_for.h.

namespace tbb {

template <typename T>
class blocked_range
{
public:
  blocked_range(const T begin, const T end) : m_begin(begin), m_end(end) {}

  T begin() const { return m_begin; }
  T end() const { return m_end; }

private:
  T m_begin, m_end;
};

} // namespace tbb

#endif // APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_BLOCKED_RANGE_H
