// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_VICINITIES_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_VICINITIES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_costs.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_polygon.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * How near to the vertices the first points on edges have to be, for costs that depend on the
 * direction. They are all at the same cost from the vertex, the radius. A crossing that is nearer
 * is rounded to the vertex or to the first point. What paths lose there is in proportion to the
 * radius, and to how far gauges are from being linear; at most, it is the way to the vertex and
 * back. Coming to the vertex and leaving it costs at least the heights of the faces.
 */
class Gauge_vicinities
{
public:
  // the radius is not larger, relative to the height, so that points around two vertices are apart
  static constexpr double LARGEST_PART = 0.49;

  explicit Gauge_vicinities(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation),
      m_edges(triangulation, &Face_gauges::gauge),
      m_vertices(triangulation.number_of_vertices())
  {
  }

  // Adds the face to the left of `first`. Its gauge is at most `1 + error` times below the polygon,
  // which is bounded.
  void add(const Index first, const Gauge_polygon& polygon, const double error)
  {
    const auto halfedges = m_triangulation.halfedges_of_face(first);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index h = halfedges[i], g = halfedges[(i + 2) % 3];
      Vertex& v = m_vertices[m_triangulation.source(h)];
      const Plane_vector a = side(h), b = -1 * side(g);
      v.height = (std::min)(v.height, cross(a, b) > 0 ? polygon.height(a, b) / (1 + error) : 0);
      const double cost_a = cost(h), cost_b = cost(g);
      if(!(cost_a > 0 && cost_b > 0))
        continue;
      const auto bend = polygon.bend(1 / cost_a * a, 1 / cost_b * b);
      v.turn = (std::max)(v.turn, bend.turn);
      v.excess = (std::max)(v.excess, (1 + bend.excess) * (1 + error) - 1);
    }
  }

  // ... whose directions cost nothing.
  void add_free(const Index first)
  {
    for(const Index h : m_triangulation.halfedges_of_face(first))
      m_vertices[m_triangulation.source(h)].is_at_free_face = true;
  }

  // Returns the cost between the vertex and the first points on its edges, so that paths cost at
  // most `1 + epsilon` times more. `largest_if_rounded` is a bound if the points next to a crossing
  // may be the vertex and a first point.
  double radius(const Index v, const double epsilon, const double largest_if_rounded) const
  {
    const double height = m_vertices[v].height, loss = m_vertices[v].loss();
    const auto radius = [&](const double part) {
      return height * (std::min)(0.5 * epsilon / (part + epsilon), LARGEST_PART);
    };
    return loss < 1 ? (std::max)(radius(1), (std::min)(radius(loss), largest_if_rounded))
                    : radius(1);
  }

  // Returns what coming to the vertex or leaving it costs at least; infinity if nothing has to be
  // paid.
  double height(const Index v) const { return m_vertices[v].height; }

  // Returns the cost of the edge of `h`, or that of the way back, whichever is larger.
  double cost(const Index h) const
  {
    const double per_length = (std::max)(m_edges.along(h), m_edges.against(m_triangulation, h));
    return m_triangulation.length(h) * per_length;
  }

private:
  struct Vertex
  {
    double height = infinity;
    double turn = 0;
    double excess = 0;
    bool is_at_free_face = false;

    // What a path loses at most on its way to the vertex, relative to the radius: for a crossing at
    // the part `x` of the radius, `x * (1 - x) * turn + x * excess`.
    double loss() const
    {
      if(is_at_free_face)
        return 1;
      return excess < turn ? (turn + excess) * ((turn + excess) / (4 * turn)) : excess;
    }
  };

  Plane_vector side(const Index h) const
  {
    return m_triangulation.length(h) * m_triangulation.gauges().side(h);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Edge_costs m_edges; // whether or not they are too steep
  std::vector<Vertex> m_vertices;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_VICINITIES_H
