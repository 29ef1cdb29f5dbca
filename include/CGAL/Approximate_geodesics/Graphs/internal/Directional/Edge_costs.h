// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_EDGE_COSTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_EDGE_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * What paths along edges cost per unit of length, in either direction, where costs depend on it:
 * the smaller of what both faces say. A barrier is an edge on either side, which has one face.
 */
class Edge_costs
{
public:
  using Index = Intrinsic_triangulation::Index;

  Edge_costs() = default;

  explicit Edge_costs(const Intrinsic_triangulation& triangulation)
    : m_cost(triangulation.number_of_halfedges()),
      m_cost_back(triangulation.has_barriers() ? m_cost.size() : 0)
  {
    for(Index h = 0; h < m_cost.size(); ++h)
    {
      const double there = in_face(triangulation, h, 1);
      if(triangulation.is_barrier(h))
      {
        m_cost[h] = there;
        m_cost_back[h] = in_face(triangulation, h, -1);
      }
      else
        m_cost[h] = (std::min)(there, in_face(triangulation, triangulation.opposite(h), -1));
    }
  }

  // in the direction of `h`
  double along(const Index h) const { return m_cost[h]; }

  // against the direction of `h`, on its left side
  double against(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return triangulation.is_barrier(h) ? m_cost_back[h] : m_cost[triangulation.opposite(h)];
  }

  std::size_t memory() const
  {
    return sizeof(double) * (m_cost.capacity() + m_cost_back.capacity());
  }

private:
  // what the face to the left of `h` says of its direction, or of the opposite one
  static double
  in_face(const Intrinsic_triangulation& triangulation, const Index h, const double sign)
  {
    if(triangulation.is_border(h))
      return std::numeric_limits<double>::infinity();
    const auto& gauges = triangulation.gauges();
    return gauges.cost(gauges.face(h), sign * gauges.side(h));
  }

  std::vector<double> m_cost;      // per halfedge
  std::vector<double> m_cost_back; // likewise, if there are barriers
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_EDGE_COSTS_H
