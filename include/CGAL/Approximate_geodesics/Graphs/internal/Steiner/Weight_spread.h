// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHT_SPREAD_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHT_SPREAD_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Whether the weights of the faces around a vertex differ. Forbidden faces do not count.
 */
class Weight_spread
{
public:
  using Index = Intrinsic_triangulation::Index;

  Weight_spread(const Intrinsic_triangulation& triangulation, const Index v)
  {
    if(triangulation.has_weights())
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
        add(triangulation.weight(h));
  }

  // whether paths near the vertex are straight
  bool are_uniform() const { return m_largest == 0 || (!m_has_free && m_smallest == m_largest); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void add(const double weight)
  {
    if(weight == infinity)
      return;
    m_largest = (std::max)(m_largest, weight);
    if(weight > 0)
      m_smallest = (std::min)(m_smallest, weight);
    else
      m_has_free = true;
  }

  double m_smallest = infinity; // of those that are not zero
  double m_largest = 0;
  bool m_has_free = false;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHT_SPREAD_H
