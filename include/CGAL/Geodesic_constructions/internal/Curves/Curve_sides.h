// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SIDES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SIDES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Which vertices lie to the left of directed curves, and which to the right, where the curves
 * separate these.
 *
 * In a face that a curve passes, a corner or the middle of a side lies on the side from which it
 * sees the nearest point of the curve, as nothing is between the two. Faces of a region are to the
 * left of its border. Vertices and all other faces take their side from their neighbors.
 */
class Curve_sides
{
public:
  enum Side : signed char
  {
    LEFT = -1,
    NONE = 0,
    RIGHT = 1
  };

  // The triangulation is referred to, not copied. Throws std::invalid_argument if a curve ends
  // inside the surface, or does not separate its left side from its right side.
  Curve_sides(const Intrinsic_triangulation& triangulation,
              const std::vector<Intrinsic_curve>& curves)
    : m_triangulation(triangulation),
      m_segments(triangulation, curves),
      m_sides(triangulation.number_of_vertices() + triangulation.number_of_halfedges(), NONE),
      m_is_passed(m_sides.size(), false),
      m_is_crossed(triangulation.number_of_halfedges(), false)
  {
    for(std::size_t i = 0; i < curves.size(); ++i)
      for(const auto& polyline : curves[i].polylines)
        add(polyline, i);
    for_each_face([&](const Index h) {
      m_segments.for_each_in_face(h, [&](std::size_t) { m_is_passed[face(h)] = true; });
    });
    for_each_face([&](const Index h) {
      if(m_is_passed[face(h)])
        look_around_face(h);
    });
    for(const Intrinsic_curve& curve : curves)
      for(const Index h : curve.faces)
        mark_region(h);
    spread();
    check_edges();
  }

  // The side of a vertex; none if it belongs to a curve, or is unknown.
  Side operator[](const Index v) const { return m_sides[v]; }

  // Whether a vertex is connected with no curve, unless faces are nearly degenerate.
  bool is_unknown(const Index v) const { return m_sides[v] == NONE && !m_is_passed[v]; }

private:
  // What is seen from a point of a face.
  struct View
  {
    double distance = infinity; // of the curve
    double sine = 0;            // of the angle between the curve and the line to the point

    Side side() const { return sine == 0 ? NONE : sine > 0 ? LEFT : RIGHT; }
  };

  static constexpr double ROUNDING = 1e-12; // in longest sides of a face

  // Vertices and faces are numbered together.
  std::size_t face(const Index h) const
  {
    return m_triangulation.number_of_vertices() + std::size_t(m_triangulation.first_of_face(h));
  }

  template <typename F>
  void for_each_face(F f) const
  {
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(!m_triangulation.is_border(h) && m_triangulation.first_of_face(h) == h)
        f(h);
  }

  void add(const std::vector<Intrinsic_point>& polyline, const std::size_t i)
  {
    const Intrinsic_point &first = polyline.front(), &last = polyline.back();
    const bool is_closed = polyline.size() > 1 && first.is_same(last, m_triangulation);
    if(polyline.size() == 1)
      reject("source " + std::to_string(i) + " has no sides, as it is a point");
    if(!is_closed && !(is_on_border(first) && is_on_border(last)))
      reject("source " + std::to_string(i) +
             " has no two sides: it is not closed, and ends inside the surface");
    for(const Intrinsic_point& p : polyline)
      if(p.is_vertex())
        m_is_passed[p.vertex] = true;
      else if(p.is_on_edge())
        m_is_crossed[p.halfedge] = m_is_crossed[m_triangulation.opposite(p.halfedge)] = true;
  }

  bool is_on_border(const Intrinsic_point& p) const
  {
    const auto is_border = [&](const Index h) {
      return m_triangulation.is_border(h) || m_triangulation.is_border(m_triangulation.opposite(h));
    };
    if(!p.is_vertex())
      return p.is_on_edge() && is_border(p.halfedge);
    bool result = false;
    for(Index h = m_triangulation.first_halfedge(p.vertex);
        h < m_triangulation.beyond_halfedge(p.vertex); ++h)
      result = result || is_border(h);
    return result;
  }

  // A region that is a whole component has no border.
  void mark_region(const Index face_of)
  {
    mark_face(face_of, LEFT);
    for(const Index h : m_triangulation.halfedges_of_face(face_of))
      mark(m_triangulation.source(h), LEFT);
  }

  // In a face that is nearly degenerate, rounding would decide.
  void look_around_face(const Index face_of)
  {
    constexpr double smallest_height = 1e-10; // as a part of the longest side
    const Face_layout layout(m_triangulation, face_of);
    double size = 0;
    for(std::size_t i = 0; i < 3; ++i)
      size = (std::max)(size, length(layout.edge(i, (i + 1) % 3)));
    if(!(size > 0 && cross(layout.edge(0, 1), layout.edge(0, 2)) / size > smallest_height * size))
      return;
    for(const Index h : m_triangulation.halfedges_of_face(face_of))
    {
      mark(m_triangulation.source(h), nearest(h, 0, size).side());
      mark_face(m_triangulation.opposite(h), nearest(h, 0.5, size).side());
    }
  }

  // What is seen of the nearest point of the curves in the face to the left of `h`, from the point
  // of the edge at the part `t` of the way; without an angle if that is uncertain. Where segments
  // meet, the one counts that is closer to a right angle with the line from there.
  View nearest(const Index h, const double t, const double size) const
  {
    constexpr double smallest_sine = 1e-9;
    const auto is_as_near = [&](const View& v, const View& best) {
      return v.distance < best.distance + ROUNDING * size;
    };
    View best;
    for_each_view(h, t, [&](const View& v) {
      if(v.distance < best.distance - ROUNDING * size ||
         (is_as_near(v, best) && std::abs(v.sine) > std::abs(best.sine)))
        best = v;
    });
    if(!(best.distance > ROUNDING * size && std::abs(best.sine) > smallest_sine))
      return {best.distance, 0};
    for_each_view(h, t, [&](const View& v) { // where a curve runs back on itself
      if(is_as_near(v, best) && std::abs(v.sine + best.sine) < smallest_sine)
        reject_at(m_triangulation.source(h));
    });
    return best;
  }

  template <typename F>
  void for_each_view(const Index h, const double t, F f) const
  {
    m_segments.for_each_in_face(h,
                                [&](const std::size_t i) { f(this->view(m_segments[i], h, t)); });
  }

  View view(const Curve_segment& segment, const Index h, const double t) const
  {
    const Segment_layout layout(m_triangulation, segment);
    std::size_t i = 0;
    while(i < 2 && layout.halfedge(i) != h)
      ++i;
    const Plane_vector p = layout.corner(i) + t * layout.edge(i, (i + 1) % 3);
    const double x = (std::clamp)(p.x, 0., layout.length());
    const double distance = length(Plane_vector{p.x - x, p.y});
    return {distance, distance > 0 ? p.y / distance : 0};
  }

  void mark(const std::size_t item, const Side side)
  {
    if(side == NONE || m_sides[item] == side || m_is_passed[item])
      return;
    if(m_sides[item] != NONE)
      reject_at(vertex_of(item));
    m_sides[item] = side;
    m_stack.push_back(item);
  }

  [[noreturn]] void reject_at(const Index v) const
  {
    reject("the sources have no two sides: their left side is connected with their right side, at "
           "vertex " +
           std::to_string(m_triangulation.index(v)));
  }

  Index vertex_of(const std::size_t item) const
  {
    const std::size_t n = m_triangulation.number_of_vertices();
    return item < n ? Index(item) : m_triangulation.source(Index(item - n));
  }

  void spread()
  {
    while(!m_stack.empty())
    {
      const std::size_t item = m_stack.back(), n = m_triangulation.number_of_vertices();
      const Side side = m_sides[item];
      m_stack.pop_back();
      if(item < n)
        for(Index h = m_triangulation.first_halfedge(Index(item));
            h < m_triangulation.beyond_halfedge(Index(item)); ++h)
          mark_face(h, side);
      else
        for(const Index h : m_triangulation.halfedges_of_face(Index(item - n)))
        {
          mark(m_triangulation.source(h), side);
          mark_face(m_triangulation.opposite(h), side);
        }
    }
  }

  // Finds what faces do not show: curves that cross themselves there.
  void check_edges() const
  {
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(!m_is_crossed[h] &&
         m_sides[m_triangulation.source(h)] * m_sides[m_triangulation.target(h)] < 0)
        reject_at(m_triangulation.source(h));
  }

  void mark_face(const Index h, const Side side)
  {
    if(!m_triangulation.is_border(h))
      mark(face(h), side);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Segments_by_face m_segments;
  std::vector<Side> m_sides;
  std::vector<bool> m_is_passed;  // by a curve
  std::vector<bool> m_is_crossed; // halfedges whose edge has a point of a curve inside
  std::vector<std::size_t> m_stack;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SIDES_H
