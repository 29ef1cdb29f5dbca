// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FIXED_BUCKET_WIDTH_H
#define APPROXIMATE_GEODESICS_TEST_FIXED_BUCKET_WIDTH_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>

namespace geodesics_test {

// Nothing more than the concept of a policy for bucket widths asks for: buckets as wide as the mean
// arc is long, for ever. Such arcs describe the circle that a test wants.
class Fixed_bucket_width
{
public:
  explicit Fixed_bucket_width(const CGAL::Approximate_geodesics::Arc_lengths& arcs)
    : m_width(arcs.mean)
  {
  }

  double width() const { return m_width; }
  void update(const CGAL::Approximate_geodesics::Bucket_statistics&) {}

private:
  double m_width;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FIXED_BUCKET_WIDTH_H
