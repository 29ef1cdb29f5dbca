// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_CLOSED_CURVES_H
#define APPROXIMATE_GEODESICS_TEST_CLOSED_CURVES_H

#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <variant>
#include <vector>

// Closed curves on meshes, and surfaces with handles.

namespace geodesics_test {

// ----- surfaces

// `around` rings of `across` vertices each, at `point(i, j)`, closed in both directions.
template <typename F>
Soup closed_rings(const std::size_t around, const std::size_t across, F point)
{
  Soup result;
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < across; ++j)
    {
      result.points.push_back(point(static_cast<double>(i), static_cast<double>(j)));
      const std::size_t k = (i + 1) % around, l = (j + 1) % across;
      const std::size_t a = i * across + j, b = k * across + j, c = k * across + l,
                        d = i * across + l;
      result.triangles.push_back({a, b, c});
      result.triangles.push_back({a, c, d});
    }
  return result;
}

// The first vertex of each ring is on the outside.
inline Soup torus(const std::size_t around,
                  const std::size_t across,
                  const double radius,
                  const double thickness)
{
  const double full = 8 * std::atan(1.);
  return closed_rings(around, across, [=](const double i, const double j) {
    const double u = full * i / static_cast<double>(around),
                 v = full * j / static_cast<double>(across), r = radius + thickness * std::cos(v);
    return Point(r * std::cos(u), r * std::sin(u), thickness * std::sin(v));
  });
}

// A tube around a trefoil.
inline Soup torus_knot(const std::size_t around, const std::size_t across)
{
  using Space_vector = Kernel::Vector_3;
  const double full = 8 * std::atan(1.);
  const auto center = [](const double u) {
    const double r = 2 + std::cos(3 * u);
    return Point(r * std::cos(2 * u), r * std::sin(2 * u), std::sin(3 * u));
  };
  return closed_rings(around, across, [=](const double i, const double j) {
    const double u = full * i / static_cast<double>(around),
                 v = full * j / static_cast<double>(across);
    const Space_vector along = center(u + 1e-3) - center(u - 1e-3);
    Space_vector side = CGAL::cross_product(along, Space_vector(0, 0, 1));
    side = side / std::sqrt(side.squared_length());
    Space_vector up = CGAL::cross_product(side, along);
    up = up / std::sqrt(up.squared_length());
    return center(u) + 0.3 * (std::cos(v) * side + std::sin(v) * up);
  });
}

// ----- curves

// A random walk along edges, and a path with the smallest number of edges back to its start.
inline std::vector<Halfedge>
random_closed_curve(const Mesh& mesh, Random& random, const std::size_t number_of_steps)
{
  const std::vector<Halfedge> all(mesh.halfedges_begin(), mesh.halfedges_end());
  std::vector<Halfedge> result(1, all[random.below(all.size())]);
  std::map<Vertex, std::vector<Halfedge>> leaving;
  for(const Halfedge h : mesh.halfedges())
    leaving[mesh.source(h)].push_back(h);
  const Vertex start = mesh.source(result.front());
  for(std::size_t i = 1; i < number_of_steps; ++i)
  {
    const std::vector<Halfedge>& next = leaving[mesh.target(result.back())];
    result.push_back(next[random.below(next.size())]);
  }
  std::map<Vertex, Halfedge> to_start;
  std::deque<Vertex> queue(1, start);
  while(!queue.empty())
  {
    for(const Halfedge h : leaving[queue.front()])
      if(mesh.target(h) != start && to_start.emplace(mesh.target(h), mesh.opposite(h)).second)
        queue.push_back(mesh.target(h));
    queue.pop_front();
  }
  for(Vertex v = mesh.target(result.back()); v != start; v = mesh.target(result.back()))
    result.push_back(to_start.at(v));
  return result;
}

// ----- angles of curves

// By how much two segments of these lengths that enclose an angle can be shortened at most.
inline double slack(const double a, const double b, const double angle)
{
  const double pi = 4 * std::atan(1.);
  return angle >= pi ? 0 : a + b - std::sqrt(a * a + b * b - 2 * a * b * std::cos(angle));
}

inline double angle_between(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  const Kernel::Vector_3 normal = CGAL::cross_product(a, b);
  return std::atan2(std::sqrt(normal.squared_length()), CGAL::scalar_product(a, b));
}

inline bool is_in_face(const Mesh& mesh, const Surface_point& p, const Face f)
{
  return faces_of(mesh, p).count(f) > 0;
}

// The directions of two points in the faces around a vertex, and the sum of all angles.
inline std::array<double, 3>
directions_around(const Mesh& mesh, const Vertex v, const Surface_point& a, const Surface_point& b)
{
  Halfedge first = mesh.opposite(mesh.halfedge(v)); // that starts from `v`
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if(mesh.is_border(h)) // then its opposite is the first one of the faces, counterclockwise
      first = mesh.opposite(h);
  std::array<double, 3> result{-1, -1, 0};
  Halfedge h = first;
  do
  {
    if(mesh.is_border(h))
      break;
    const Kernel::Vector_3 side = mesh.point(mesh.target(h)) - mesh.point(v);
    for(const std::size_t i : {std::size_t(0), std::size_t(1)})
    {
      const Surface_point& p = i == 0 ? a : b;
      if(result[i] < 0 && is_in_face(mesh, p, mesh.face(h)))
        result[i] = result[2] + angle_between(side, position(mesh, p) - mesh.point(v));
    }
    result[2] += angle_between(side, mesh.point(mesh.source(mesh.prev(h))) - mesh.point(v));
    h = mesh.opposite(mesh.prev(h));
  } while(h != first);
  return result;
}

// By how much the curve from `a` over `p` to `b` can be shortened.
inline double
slack_at(const Mesh& mesh, const Surface_point& a, const Surface_point& p, const Surface_point& b)
{
  const Point center = position(mesh, p);
  const Kernel::Vector_3 back = position(mesh, a) - center, ahead = position(mesh, b) - center;
  const auto result = [&](const double angle) {
    return slack(std::sqrt(back.squared_length()), std::sqrt(ahead.squared_length()), angle);
  };
  if(const auto* const v = std::get_if<Vertex>(&p))
  {
    const auto [from, to, all] = directions_around(mesh, *v, a, b);
    const double inside = std::abs(to - from);
    return mesh.is_border(*v) ? result(inside) : (std::max)(result(inside), result(all - inside));
  }
  const Halfedge h = std::get<Edge_location>(p).first;
  const Kernel::Vector_3 edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
  return result(angle_between(back, edge) + angle_between(edge, ahead)) +
         result(angle_between(back, -edge) + angle_between(-edge, ahead));
}

// By how much a closed curve can be shortened at one of its points.
inline double largest_slack(const Mesh& mesh, std::vector<Surface_point> points)
{
  double result = 0;
  points.push_back(points[1]);
  for(std::size_t i = 2; i < points.size(); ++i)
    result = (std::max)(result, slack_at(mesh, points[i - 2], points[i - 1], points[i]));
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_CLOSED_CURVES_H
