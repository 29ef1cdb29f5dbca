// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_TRAVEL_COSTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_TRAVEL_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Directional/Edge_costs.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * What a search pays for a straight step, which starts where the search comes from. The traveler
 * goes the same way, or, to a source that the search has started from, the opposite one.
 */
class Travel_costs
{
  using Index = Intrinsic_triangulation::Index;

public:
  // Both are referred to, not copied.
  Travel_costs(const Intrinsic_triangulation& triangulation,
               const Edge_costs& edges,
               const bool is_backward)
    : m_triangulation(triangulation), m_edges(edges), m_is_backward(is_backward)
  {
  }

  // The same with the traveler going the other way.
  Travel_costs reversed() const { return {m_triangulation, m_edges, !m_is_backward}; }

  // across the face to the left of `h`, whose frame the vector is in
  double across(const Index h, const Plane_vector step) const
  {
    const Face_gauges& gauges = m_triangulation.gauges();
    return gauges.cost(gauges.face(h), m_is_backward ? -1 * step : step);
  }

  // along `h`, per unit of length, or against it on its left side
  double along(const Index h) const
  {
    return m_is_backward ? m_edges.against(m_triangulation, h) : m_edges.along(h);
  }
  double against(const Index h) const
  {
    return m_is_backward ? m_edges.along(h) : m_edges.against(m_triangulation, h);
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  const Edge_costs& m_edges;
  bool m_is_backward;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_TRAVEL_COSTS_H
