// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSurface
 *
 * The straight lines from a point of the surface to others in the same face.
 *
 * This is how `Edge_graph` attaches a point, and how a graph may do so whose nodes are the vertices
 * and whose arcs do not leave a face: `attach(point)` returns `Lines_in_faces(triangulation(),
 * point)`.
 *
 * Lengths are in units of the triangulation, so that has to be the unit of the graph; costs, if the
 * triangulation has weights, are in units of lengths times weights.
 */
class Lines_in_faces
{
public:
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// the lines from `point`.
  /// \warning `triangulation` is referred to, not copied.
  Lines_in_faces(const Intrinsic_triangulation& triangulation, const Intrinsic_point& point)
    : m_triangulation(triangulation), m_point(point)
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
      const double weight = m_triangulation.weight(h);
      if(!(weight < std::numeric_limits<double>::infinity()))
        return;
      internal::for_each_face_point(m_triangulation, m_point, h, [&](const auto& p) {
        for(const Index side : m_triangulation.halfedges_of_face(h))
          f(m_triangulation.source(side),
            weight * distance(m_triangulation, p, internal::Face_point::at_source(side)));
      });
    });
  }

  /// calls `f(i, cost)` for each line to one of `points`. There may be several to the same point.
  /// \pre The point is not a vertex.
  template <typename F>
  void for_each_point(const Points_by_face& points, F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      points.for_each_in_face(h, [&](const std::size_t i) { for_each_line(h, points[i], i, f); });
    });
  }

  /// calls `f` for no edge, as a line in a face crosses none. Returns `length`.
  template <typename End, typename F>
  double for_each_crossing(const End& /* end */, const double length, F /* f */) const
  {
    return length;
  }

protected:
  /// returns the triangulation.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns the point.
  const Intrinsic_point& point() const { return m_point; }

private:
  // Along an edge, and across the face to the left of `h`.
  template <typename F>
  void for_each_line(const Index h, const Intrinsic_point& end, const std::size_t i, F& f) const
  {
    if(m_point.is_same(end, m_triangulation))
    {
      f(i, 0.);
      return;
    }
    f(i, cost_along_edge(end));
    const double weight = m_triangulation.weight(h);
    if(!(weight < std::numeric_limits<double>::infinity()))
      return;
    internal::for_each_face_point(m_triangulation, m_point, h, [&](const auto& p) {
      internal::for_each_face_point(m_triangulation, end, h, [&](const auto& q) {
        f(i, weight * distance(m_triangulation, p, q));
      });
    });
  }

  // infinity if there is no edge that both points lie on
  double cost_along_edge(const Intrinsic_point& end) const
  {
    const Index h = m_point.halfedge, opposite = m_triangulation.opposite(h);
    if(!m_point.is_on_edge() || !end.is_on_edge() ||
       (end.halfedge != h && end.halfedge != opposite))
      return std::numeric_limits<double>::infinity();
    const double difference = m_point.t - (end.halfedge == h ? end.t : 1 - end.t);
    const double weight =
        (std::min)(m_triangulation.weight_of_edge(h), m_triangulation.weight_of_edge(opposite));
    return weight * (std::abs(difference) * m_triangulation.length(h));
  }

  const Intrinsic_triangulation& m_triangulation;
  const Intrinsic_point m_point;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_LINES_IN_FACES_H
