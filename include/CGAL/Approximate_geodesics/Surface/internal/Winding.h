// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Decides when to give up a straight line that comes back to faces which it has crossed.
 *
 * In space, a segment in a face is a shortest path. So a shortest path meets a face only once,
 * while straight lines may wind round a spike for long. To notice that they have come round again,
 * they remember one halfedge that they met, a later one each time that the way is twice as long, as
 * Brent does to find a cycle (R. P. Brent, An improved Monte Carlo factorization algorithm, 1980).
 *
 * If only lengths are given, the edges themselves can wind round the surface, as on a spring, and a
 * shortest path crosses them again and again. Then a line is given up when it has crossed as many
 * faces as the mesh has, and ten thousand: round a spike, it may go on for long. Faces that are
 * thinner than their lengths can tell are met once in any case.
 */
class Winding
{
  using Index = Intrinsic_triangulation::Index;

public:
  explicit Winding(const Intrinsic_triangulation& triangulation)
    : m_may_return(triangulation.lines_may_return()),
      m_longest_way(m_may_return
                        ? 10000 + static_cast<std::uint32_t>(triangulation.number_of_faces())
                        : (std::numeric_limits<std::uint32_t>::max)())
  {
  }

  // Whether a shortest path may come back to a face.
  bool may_return() const { return m_may_return; }

  // Whether a line is given up at the halfedge `h`, when it has crossed `depth` faces and remembers
  // `checkpoint`. The face ahead is `height` times as high above `h` as that is long.
  bool is_too_long(const Index h,
                   const double height,
                   const std::uint32_t depth,
                   const Index checkpoint) const
  {
    constexpr double smallest_height = 1e-8;
    return m_may_return && height > smallest_height ? depth > m_longest_way : h == checkpoint;
  }

  // Whether the halfedge that is met after `depth` faces is one to remember.
  static bool is_milestone(const std::uint32_t depth) { return (depth & (depth + 1)) == 0; }

  // The same; if it is not given up, it goes on.
  bool ends_at(const Index h, const double height, std::uint32_t& depth, Index& checkpoint) const
  {
    if(is_too_long(h, height, depth, checkpoint))
      return true;
    if(is_milestone(depth))
      checkpoint = h;
    ++depth;
    return false;
  }

private:
  bool m_may_return;
  std::uint32_t m_longest_way; // in faces
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H
