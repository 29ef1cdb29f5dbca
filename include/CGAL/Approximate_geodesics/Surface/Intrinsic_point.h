// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A point of a triangulated surface: a vertex, a point inside an edge, or a point inside a face.
 *
 * It is given by the numbers that an `Intrinsic_triangulation` has for vertices and halfedges.
 * Where the halfedge has the source \f$a\f$ and the target \f$b\f$, and the third vertex of the
 * face to its left is \f$c\f$, the point is \f$(1 - t - s)\, a + t\, b + s\, c\f$.
 */
struct Intrinsic_point
{
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// \name Creation
  /// @{

  /// the point at a vertex.
  static Intrinsic_point at_vertex(const Index v)
  {
    return {v, Intrinsic_triangulation::null_index, 0, 0};
  }

  /// the point on the edge of `h`, at the part `t` of the way from its source to its target.
  static Intrinsic_point on_edge(const Index h, const double t)
  {
    return {Intrinsic_triangulation::null_index, h, t, 0};
  }

  /// the point inside the face to the left of `h`, where `t` and `s` are the weights of the target
  /// of `h` and of the third vertex.
  static Intrinsic_point in_face(const Index h, const double t, const double s)
  {
    return {Intrinsic_triangulation::null_index, h, t, s};
  }

  /// @}

  /// \name Kind
  /// @{

  /// returns whether the point is a vertex.
  bool is_vertex() const { return vertex != Intrinsic_triangulation::null_index; }

  /// returns whether the point lies inside a face.
  bool is_in_face() const { return !is_vertex() && s > 0; }

  /// returns whether the point lies on an edge, and is not a vertex.
  bool is_on_edge() const { return !is_vertex() && !is_in_face(); }

  /// @}

  /// \name Position
  /// @{

  /// returns whether this is a point of the triangulated surface.
  bool is_valid(const Intrinsic_triangulation& triangulation) const
  {
    if(is_vertex())
      return vertex < triangulation.number_of_vertices();
    const bool has_edge = halfedge < triangulation.number_of_halfedges() && t >= 0 && t <= 1;
    return has_edge && (s == 0 || (s > 0 && t + s <= 1 && !triangulation.is_border(halfedge)));
  }

  /// returns whether the point lies on the edge of `h`, or is one of its ends.
  bool is_on_edge_of(const Index h, const Intrinsic_triangulation& triangulation) const
  {
    if(is_vertex())
      return vertex == triangulation.source(h) || vertex == triangulation.target(h);
    return is_on_edge() && (halfedge == h || halfedge == triangulation.opposite(h));
  }

  /// returns whether this and `p` are the same vertex, or the same point of the same edge or face.
  bool is_same(const Intrinsic_point& p, const Intrinsic_triangulation& triangulation) const
  {
    if(is_vertex() || p.is_vertex())
      return vertex == p.vertex;
    if(halfedge == p.halfedge)
      return t == p.t && s == p.s;
    return is_on_edge() && p.is_on_edge() && halfedge == triangulation.opposite(p.halfedge) &&
           t == 1 - p.t;
  }

  /// returns the end of its edge if the point is there up to rounding, and the point otherwise.
  Intrinsic_point reduced(const Intrinsic_triangulation& triangulation) const
  {
    constexpr double rounding = 1e-14;
    if(!is_on_edge() || (t > rounding && t < 1 - rounding))
      return *this;
    return at_vertex(t > 0.5 ? triangulation.target(halfedge) : triangulation.source(halfedge));
  }

  /// calls `f(h)` for a halfedge of each face that contains the point, in its interior or on its
  /// boundary.
  template <typename F>
  void for_each_face(const Intrinsic_triangulation& triangulation, F f) const
  {
    const auto call = [&](const Index h) {
      if(!triangulation.is_border(h))
        f(h);
    };
    if(is_vertex())
      for(Index h = triangulation.first_halfedge(vertex); h < triangulation.beyond_halfedge(vertex);
          ++h)
        call(h);
    else
      call(halfedge);
    if(is_on_edge())
      call(triangulation.opposite(halfedge));
  }

  /// @}

  Index vertex;   ///< the vertex, or `Intrinsic_triangulation::null_index`
  Index halfedge; ///< a halfedge of the edge or the face, or `Intrinsic_triangulation::null_index`
  double t;       ///< the weight of the halfedge's target
  double s;       ///< the weight of the third vertex of its face
};

namespace internal {

inline void check_point(const Intrinsic_point& p, const Intrinsic_triangulation& triangulation)
{
  if(!p.is_valid(triangulation))
    reject("a point is not one of the triangulated surface: vertex " + std::to_string(p.vertex) +
           ", halfedge " + std::to_string(p.halfedge) + ", weights " + text_of(p.t) + " and " +
           text_of(p.s));
}

// Numbers of points or segments, sorted by the faces that contain them.
class Numbers_by_face
{
  using Index = Intrinsic_triangulation::Index;
  using Entry = std::pair<Index, std::size_t>; // the first halfedge of a face, and a number

public:
  bool is_empty() const { return m_entries.empty(); }

  // Adds a number to the face to the left of `h`. `sort()` follows.
  void add(const Intrinsic_triangulation& triangulation, const Index h, const std::size_t number)
  {
    m_entries.emplace_back(triangulation.first_of_face(h), number);
  }

  void sort() { std::sort(m_entries.begin(), m_entries.end()); }

  // Calls `f(number)` for those in the face to the left of `h`.
  template <typename F>
  void for_each(const Intrinsic_triangulation& triangulation, const Index h, F f) const
  {
    const Index wanted = triangulation.first_of_face(h);
    for(auto it = std::lower_bound(m_entries.begin(), m_entries.end(), Entry(wanted, 0));
        it != m_entries.end() && it->first == wanted; ++it)
      f(it->second);
  }

private:
  std::vector<Entry> m_entries;
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * Points of a triangulated surface, sorted by the faces that contain them. Vertices may be among
 * the points, but are not listed by face.
 */
class Points_by_face
{
public:
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// no points.
  Points_by_face() = default;

  /// sorts `points` by face. Run time is \cgalBigO{n \log n} for `n` points.
  /// \warning `triangulation` is referred to, not copied.
  Points_by_face(const Intrinsic_triangulation& triangulation, std::vector<Intrinsic_point> points)
    : m_triangulation(&triangulation), m_points(std::move(points))
  {
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(!m_points[i].is_vertex())
        m_points[i].for_each_face(triangulation,
                                  [&](const Index h) { m_numbers.add(triangulation, h, i); });
    m_numbers.sort();
  }

  /// returns whether there are no points other than vertices.
  bool is_empty() const { return m_numbers.is_empty(); }

  /// returns the point with number `i`.
  const Intrinsic_point& operator[](const std::size_t i) const { return m_points[i]; }

  /// calls `f(i)` for each point in the face to the left of `h`, or on its sides.
  /// \pre `h` is not a border halfedge.
  template <typename F>
  void for_each_in_face(const Index h, F f) const
  {
    if(!is_empty())
      m_numbers.for_each(*m_triangulation, h, f);
  }

private:
  const Intrinsic_triangulation* m_triangulation = nullptr;
  std::vector<Intrinsic_point> m_points;
  internal::Numbers_by_face m_numbers;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H
