// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_PART_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_PART_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Geodesic_queries/internal/Portals/Separators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Distances are stored in single precision, relative to the longest arc, so that none overflows.
// They are rounded up.
class Portal_scale
{
public:
  explicit Portal_scale(const double longest_arc = 1)
  {
    constexpr int largest = 1000; // the factors are finite numbers
    if(longest_arc > 0)
      m_exponent = (std::max)(-largest, (std::min)(largest, std::ilogb(longest_arc)));
    m_factor = std::scalbn(1., -m_exponent);
  }

  float stored(const double label) const
  {
    const double exact = label * m_factor;
    const auto result = static_cast<float>(exact);
    return result < exact ? std::nextafter(result, std::numeric_limits<float>::infinity()) : result;
  }

  double label(const double stored) const { return std::scalbn(stored, m_exponent); }

private:
  int m_exponent = 0;
  double m_factor = 1;
};

// A portal of a vertex, by its place in the separator, and its distance.
struct Portal_label
{
  std::uint32_t portal;
  float distance;
};

/*
 * A part of the graph, in which all distances are those along paths that do not leave it. Its
 * vertices have labels at the portals on its separator, by increasing distances, and there are the
 * distances between these portals; or it is a last part, and there are the distances between its
 * vertices.
 */
struct Portal_part
{
  static constexpr std::uint32_t no_parent = (std::numeric_limits<std::uint32_t>::max)();

  std::uint32_t parent = no_parent, depth = 0;
  bool is_last = true;
  Part_nodes vertices;
  std::vector<std::vector<Portal_label>> labels; // of each vertex
  std::size_t size = 0;                          // the number of portals, or of vertices
  std::vector<float> table;                      // row by row; of a last part, below the diagonal
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_PART_H
