// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STRAIGHTENED_PATHS_H
#define APPROXIMATE_GEODESICS_TEST_STRAIGHTENED_PATHS_H

#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// What tests of locally shortest paths have in common.

namespace geodesics_test {

namespace AG = CGAL::Approximate_geodesics;
using AG::Intrinsic_point;
using AG::Path;
using AG::Path_straightener;
using Index = Triangulation::Index;
using Vector = Kernel::Vector_3;

inline const double pi = 4 * std::atan(1.);

inline double norm(const Vector& v) { return std::sqrt(v.squared_length()); }

// of the triangle with these corners, at `q`
inline double angle(const Point& p, const Point& q, const Point& r)
{
  const Vector a = p - q, b = r - q;
  return std::atan2(norm(CGAL::cross_product(a, b)), CGAL::scalar_product(a, b));
}

// A mesh and its triangulation.
class Surface
{
public:
  template <typename... NamedParameters>
  explicit Surface(const Mesh& mesh, const NamedParameters&... np)
    : m_mesh(mesh), m_triangulation(m_mesh, np...)
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  const Triangulation& triangulation() const { return m_triangulation; }

  Intrinsic_point place(const std::size_t v) const
  {
    return Intrinsic_point::at_vertex(m_triangulation.vertex(v));
  }

  Index halfedge(const std::size_t v, const std::size_t w) const
  {
    const Index a = m_triangulation.vertex(v), b = m_triangulation.vertex(w);
    for(Index h = m_triangulation.first_halfedge(a); h < m_triangulation.beyond_halfedge(a); ++h)
      if(m_triangulation.target(h) == b)
        return h;
    return Triangulation::null_index;
  }

  Point point(const Index v) const
  {
    return m_mesh.point(Vertex(static_cast<Mesh::size_type>(m_triangulation.index(v))));
  }

  Point point(const Intrinsic_point& p) const
  {
    if(p.is_vertex())
      return point(p.vertex);
    const Point a = point(m_triangulation.source(p.halfedge));
    const Point b = point(m_triangulation.target(p.halfedge));
    if(p.is_on_edge())
      return a + p.t * (b - a);
    const Point c = point(m_triangulation.target(m_triangulation.next(p.halfedge)));
    return a + p.t * (b - a) + p.s * (c - a);
  }

  double length(const std::vector<Intrinsic_point>& points) const
  {
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      result += norm(point(points[i]) - point(points[i - 1]));
    return result;
  }

  Path shortened(const std::vector<Intrinsic_point>& points) const
  {
    return Path_straightener(m_triangulation).shortened({points, length(points)});
  }

  Path shortened(const std::vector<std::size_t>& vertices) const
  {
    std::vector<Intrinsic_point> points;
    for(const std::size_t v : vertices)
      points.push_back(place(v));
    return shortened(points);
  }

private:
  const Mesh m_mesh;
  const Triangulation m_triangulation;
};

/*
 * Whether a path is locally shortest, from coordinates. There are no parallel edges, and points of
 * the path that follow each other are not at the same place.
 */
class Local_check
{
public:
  explicit Local_check(const Surface& surface)
    : m_surface(surface), m_triangulation(surface.triangulation())
  {
  }

  // How much is missing to an angle of pi, at most, on any side of a vertex that is open; and by
  // how much the angle at an edge differs from it.
  double largest_defect(const std::vector<Intrinsic_point>& points) const
  {
    double result = 0;
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      const auto &before = points[i - 1], &after = points[i + 1];
      const double defect = points[i].is_vertex() ? defect_at_vertex(before, points[i], after)
                                                  : defect_at_edge(before, points[i], after);
      result = (std::max)(result, defect);
    }
    return result;
  }

private:
  double defect_at_edge(const Intrinsic_point& before,
                        const Intrinsic_point& p,
                        const Intrinsic_point& after) const
  {
    const Point end = m_surface.point(m_triangulation.target(p.halfedge));
    const Point q = m_surface.point(p);
    return std::abs(pi - angle(m_surface.point(before), q, end) -
                    angle(end, q, m_surface.point(after)));
  }

  double defect_at_vertex(const Intrinsic_point& before,
                          const Intrinsic_point& p,
                          const Intrinsic_point& after) const
  {
    const Index v = p.vertex;
    const auto [first, first_angle] = direction(v, before);
    const auto [second, second_angle] = direction(v, after);
    const double one =
        first == second && first_angle <= second_angle
            ? second_angle - first_angle
            : sum_of_corners(v, first, second, second_angle > 0) - first_angle + second_angle;
    const double other =
        first == second && second_angle <= first_angle
            ? first_angle - second_angle
            : sum_of_corners(v, second, first, first_angle > 0) - second_angle + first_angle;
    return (std::max)(pi - one, pi - other);
  }

  bool is_wall(const Index h) const
  {
    return m_triangulation.is_border(h) || m_triangulation.is_border(m_triangulation.opposite(h)) ||
           m_triangulation.is_barrier(h);
  }

  double corner(const Index h) const
  {
    const Index g = m_triangulation.next(h);
    return angle(m_surface.point(m_triangulation.target(h)),
                 m_surface.point(m_triangulation.source(h)),
                 m_surface.point(m_triangulation.target(g)));
  }

  // counterclockwise; infinity if there is a wall in between
  double
  sum_of_corners(const Index v, const Index from, const Index to, const bool crosses_to) const
  {
    double result = 0;
    Index h = from;
    do
    {
      if(m_triangulation.is_border(h) || (h != from && is_wall(h)))
        return infinity;
      result += corner(h);
      h = m_triangulation.counterclockwise(v, h);
    } while(h != to);
    return crosses_to && is_wall(to) ? infinity : result;
  }

  // the halfedge from `v` to the right of a point, and the angle between them
  std::pair<Index, double> direction(const Index v, const Intrinsic_point& p) const
  {
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
      if(p.is_vertex() ? m_triangulation.target(h) == p.vertex
                       : p.is_on_edge() && is_edge(h, p.halfedge))
        return {h, 0};
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
      if(!m_triangulation.is_border(h) && is_in_face_of(h, p))
        return {h, angle(m_surface.point(m_triangulation.target(h)), m_surface.point(v),
                         m_surface.point(p))};
    ADD_FAILURE() << "the points do not share a face";
    return {m_triangulation.first_halfedge(v), 0};
  }

  bool is_edge(const Index h, const Index g) const
  {
    return h == g || h == m_triangulation.opposite(g);
  }

  bool is_in_face_of(const Index h, const Intrinsic_point& p) const
  {
    const Index g = m_triangulation.next(h), k = m_triangulation.next(g);
    if(p.is_in_face())
      return p.halfedge == h || p.halfedge == g || p.halfedge == k;
    return is_edge(g, p.halfedge);
  }

  const Surface& m_surface;
  const Triangulation& m_triangulation;
};

// The paths in a graph from one vertex to some others.
template <typename GeodesicGraph>
std::vector<Path> paths_from(const GeodesicGraph& graph, const Index source, const Index step)
{
  AG::Propagation<GeodesicGraph> search(graph);
  search.run_from(source);
  std::vector<Path> result;
  for(Index v = 0; v < graph.number_of_nodes(); v += step)
    if(v != source && search.is_reached(v))
      result.push_back(AG::internal::tree_path(search, v));
  return result;
}

inline void expect_same_ends(const Path& path, const Path& other)
{
  for(const auto& [p, q] : {std::pair{path.points.front(), other.points.front()},
                            std::pair{path.points.back(), other.points.back()}})
  {
    EXPECT_EQ(p.vertex, q.vertex);
    EXPECT_EQ(p.halfedge, q.halfedge);
    EXPECT_EQ(p.t, q.t);
    EXPECT_EQ(p.s, q.s);
  }
}

inline bool is_repeated(const Intrinsic_point& p, const Intrinsic_point& q)
{
  return p.is_vertex() ? p.vertex == q.vertex : p.halfedge == q.halfedge && p.t == q.t;
}

// What holds for all paths on all meshes.
inline void expect_sound(const Triangulation& t, const Path& path, const Path& shorter)
{
  const double length = AG::internal::length_of_segments(t, path.points) * t.unit();
  const double sum = AG::internal::length_of_segments(t, shorter.points) * t.unit();
  EXPECT_LE(shorter.length, length);
  EXPECT_NEAR(shorter.length, sum, sum * 1e-12);
  ASSERT_FALSE(shorter.points.empty());
  expect_same_ends(path, shorter);
  for(std::size_t i = 0; i < shorter.points.size(); ++i)
  {
    const Intrinsic_point& p = shorter.points[i];
    EXPECT_TRUE(p.is_vertex() || (p.t >= 0 && p.t <= 1));
    EXPECT_TRUE(i == 0 || !is_repeated(shorter.points[i - 1], p));
  }
}

inline void expect_idempotent(const Triangulation& t, const Path& path)
{
  const Path again = Path_straightener(t).shortened(path);
  EXPECT_NEAR(again.length, path.length, path.length * 1e-12);
  EXPECT_EQ(again.points.size(), path.points.size());
  for(std::size_t i = 0; i < (std::min)(again.points.size(), path.points.size()); ++i)
  {
    EXPECT_EQ(again.points[i].vertex, path.points[i].vertex);
    EXPECT_NEAR(again.points[i].t, path.points[i].t, 1e-9);
  }
}

inline Soup cube()
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 1),
           Point(1, 0, 1), Point(1, 1, 1), Point(0, 1, 1)},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_STRAIGHTENED_PATHS_H
