// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Approximate_geodesics {

namespace internal {

// Calls `f(i, points[i])` for the points in the face to the left of `h`. For what has a nearest
// point to `from`, as segments of curves have, an overload calls `f(i, foot, t)` with that point,
// and where it is.
template <typename F>
void for_each_foot(const Points_by_face& points,
                   const Index h,
                   const Intrinsic_point& /* from */,
                   const F& f)
{
  points.for_each_in_face(h, [&](const std::size_t i) { f(i, points[i]); });
}

/*
 * Costs of straight lines that are lengths times the weights of faces.
 */
struct Line_weights
{
  // Returns the cost per unit of length along `h`, or against its direction on its left side.
  double along(const Index h, const bool /* is_forward */) const
  {
    return surface.weight_of_edge(h);
  }

  // Returns the cost of a line in the face to the left of `h`.
  double between(const Index h, const Face_point& p, const Face_point& q) const
  {
    return surface.weight(h) * distance(surface, p, q);
  }

  const Intrinsic_triangulation& surface;
};

/*
 * The straight lines from a point of the surface to other points in the same face. `Costs` is
 * `Line_weights`, or offers the same member functions.
 */
template <typename Costs>
class Lines_of_point
{
public:
  // Calls `f(i, cost)` for the lines to points in the same face, or `f(i, cost, t)` for those to
  // the nearest points, apart from the weights of faces, of what `for_each_foot()` is overloaded
  // for.
  template <typename Points, typename F>
  void for_each_point(const Points& points, F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      for_each_foot(points, h, m_point,
                    [&](const std::size_t i, const Intrinsic_point& foot, const auto... t) {
                      for_each_line(h, foot, [&](const double cost) { f(i, cost, t...); });
                    });
    });
  }

  // A line in a face crosses no edge.
  template <typename End, typename F>
  double for_each_crossing(const End& /* end */, const double cost, F /* f */) const
  {
    return cost;
  }

protected:
  Lines_of_point(const Intrinsic_triangulation& triangulation,
                 const Costs& costs,
                 const Intrinsic_point& point)
    : m_triangulation(triangulation), m_costs(costs), m_point(point)
  {
  }

  const Intrinsic_triangulation& m_triangulation;
  const Costs m_costs;
  const Intrinsic_point m_point;

private:
  // Calls `f(cost)` for the lines to `end` along an edge, and across the face to the left of `h`.
  template <typename F>
  void for_each_line(const Index h, const Intrinsic_point& end, const F& f) const
  {
    if(m_point.is_same(end, m_triangulation))
    {
      f(0.);
      return;
    }
    f(cost_along_edge(end));
    if(m_triangulation.is_open(h))
      for_each_face_point(m_triangulation, m_point, h, [&](const Face_point& p) {
        for_each_face_point(m_triangulation, end, h,
                            [&](const Face_point& q) { f(m_costs.between(h, p, q)); });
      });
  }

  // Returns infinity if there is no edge that both points lie on.
  double cost_along_edge(const Intrinsic_point& end) const
  {
    const Index h = m_point.halfedge, opposite = m_triangulation.opposite(h);
    if(!m_point.is_on_edge() || !end.is_on_edge() ||
       (end.halfedge != h && end.halfedge != opposite))
      return infinity;
    const double step = (end.halfedge == h ? end.t : 1 - end.t) - m_point.t; // along `h`
    const double cost = (std::min)(m_costs.along(h, step > 0), m_costs.along(opposite, step < 0));
    return cost < infinity ? cost * (std::abs(step) * m_triangulation.length(h)) : infinity;
  }
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The straight lines from a point of the surface to others in the same face.
 *
 * This is how `Edge_graph` attaches a point. Any graph whose nodes are the vertices, and whose arcs
 * do not leave a face, can return `Lines_in_faces(triangulation(), point)` from `attach(point)`: it
 * has the member functions that `SurfaceGraph::attach()` requires.
 *
 * Lengths are in units of the triangulation, which has to be the unit of the graph; if the
 * triangulation has weights, costs are in units of lengths times weights.
 */
class Lines_in_faces : public internal::Lines_of_point<internal::Line_weights>
{
public:
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// constructs the lines from `point`.
  /// \warning `triangulation` is referred to, not copied.
  Lines_in_faces(const Intrinsic_triangulation& triangulation, const Intrinsic_point& point)
    : Lines_of_point(triangulation, internal::Line_weights{triangulation}, point)
  {
  }

  /// calls `f(v, cost)` for each corner `v` of the faces that the point lies in; if it is a vertex,
  /// only for that, with cost `0`.
  template <typename F>
  void for_each_node(F f) const
  {
    if(m_point.is_vertex())
    {
      f(m_point.vertex, 0.);
      return;
    }
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      if(!m_triangulation.is_open(h))
        return;
      internal::for_each_face_point(m_triangulation, m_point, h, [&](const auto& p) {
        for(const Index side : m_triangulation.halfedges_of_face(h))
          f(m_triangulation.source(side),
            m_costs.between(h, p, internal::Face_point::at_source(side)));
      });
    });
  }

  /// \cond SKIP_IN_MANUAL
  // Calls `f(cost)` for the lines to a point, or to a vertex, that cross no edge.
  template <typename F>
  void for_each_line_to(const Intrinsic_point& end, F f) const
  {
    if(m_point.is_vertex())
      f(internal::shortest_segment(m_triangulation, m_point, end).length);
    else if(end.is_vertex())
      for_each_node([&](const Index corner, const double cost) {
        if(corner == end.vertex)
          f(cost);
      });
    else
      for_each_point(Points_by_face(m_triangulation, {end}),
                     [&](std::size_t, const double cost) { f(cost); });
  }
  /// \endcond

protected:
  /// returns the triangulation.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns the point.
  const Intrinsic_point& point() const { return m_point; }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H
