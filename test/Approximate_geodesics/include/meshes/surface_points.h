// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SURFACE_POINTS_H
#define APPROXIMATE_GEODESICS_TEST_SURFACE_POINTS_H

#include "oracles/straight_lines.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

// Points of a mesh, told apart and measured without the package.

namespace geodesics_test {

using Face_location = CGAL::Approximate_geodesics::Face_location<Mesh>;
using Edge_location = std::pair<Halfedge, double>;
using Surface_point = CGAL::Approximate_geodesics::Surface_point<Mesh>;

// ----- where they are

inline Point position(const Mesh& mesh, const Vertex v) { return mesh.point(v); }

inline Point position(const Mesh& mesh, const Edge_location& p)
{
  return CGAL::barycenter(mesh.point(mesh.target(p.first)), p.second, //
                          mesh.point(mesh.source(p.first)), 1 - p.second);
}

inline Point position(const Mesh& mesh, const Face_location& p)
{
  const Halfedge h = mesh.halfedge(p.first);
  return CGAL::barycenter(mesh.point(mesh.source(h)), p.second[0], //
                          mesh.point(mesh.target(h)), p.second[1],
                          mesh.point(mesh.target(mesh.next(h))), p.second[2]);
}

inline Point position(const Mesh& mesh, const Surface_point& p)
{
  return std::visit([&](const auto& point) { return position(mesh, point); }, p);
}

inline double length_of(const Mesh& mesh, const std::vector<Surface_point>& points)
{
  std::vector<Point> positions;
  for(const Surface_point& p : points)
    positions.push_back(position(mesh, p));
  return length_of(positions);
}

// The length of the diagonal of what the mesh is in.
inline double size(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// The location of a point that is on the mesh.
inline Face_location location_at(const Mesh& mesh, const Point& p)
{
  const auto area = [](const Point& a, const Point& b, const Point& c) {
    return std::sqrt(CGAL::squared_area(a, b, c));
  };
  for(const Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                &c = mesh.point(mesh.target(mesh.next(h)));
    const std::array<double, 3> parts = {area(p, b, c), area(p, c, a), area(p, a, b)};
    const double whole = area(a, b, c), sum = parts[0] + parts[1] + parts[2];
    if(sum <= whole * (1 + 1e-12))
      return {f, {parts[0] / sum, parts[1] / sum, parts[2] / sum}};
  }
  throw std::logic_error("the point is not on the mesh");
}

// ----- which faces they touch

inline std::set<Face> faces_of(const Mesh& mesh, const Vertex v)
{
  std::set<Face> result;
  if(!mesh.is_isolated(v))
    for(const Face f : mesh.faces_around_target(mesh.halfedge(v)))
      result.insert(f);
  result.erase(Mesh::null_face());
  return result;
}

inline std::set<Face> faces_of(const Mesh& mesh, const Edge_location& p)
{
  std::set<Face> result = {mesh.face(p.first), mesh.face(mesh.opposite(p.first))};
  result.erase(Mesh::null_face());
  return result;
}

inline std::set<Face> faces_of(const Mesh& /* mesh */, const Face_location& p) { return {p.first}; }

inline std::set<Face> faces_of(const Mesh& mesh, const Surface_point& p)
{
  return std::visit([&](const auto& point) { return faces_of(mesh, point); }, p);
}

inline bool share_a_face(const Mesh& mesh, const Surface_point& p, const Surface_point& q)
{
  const std::set<Face> faces = faces_of(mesh, p);
  for(const Face f : faces_of(mesh, q))
    if(faces.count(f) > 0)
      return true;
  return false;
}

// ----- at random

inline Halfedge random_halfedge(const Mesh& mesh, Random& random)
{
  const auto size = static_cast<Mesh::size_type>(mesh.number_of_halfedges());
  return Halfedge(static_cast<Mesh::size_type>(random.below(size)));
}

// One at the border, if there are any.
inline Halfedge random_border_halfedge(const Mesh& mesh, Random& random)
{
  std::vector<Halfedge> candidates;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
      candidates.push_back(h);
  return candidates.empty() ? random_halfedge(mesh, random)
                            : candidates[random.below(candidates.size())];
}

inline Face_location random_face_location(const Mesh& mesh, Random& random)
{
  const std::size_t f = random.below(mesh.number_of_faces());
  const double s = std::sqrt(random.between(0, 1)), t = random.between(0, 1);
  return {Face(static_cast<Mesh::size_type>(f)), {1 - s, s * (1 - t), s * t}};
}

// So close to a corner or a side of its face that rounding could take it for a point of that.
inline Face_location random_location_at_side(const Mesh& mesh, Random& random)
{
  Face_location result = random_face_location(mesh, random);
  const std::size_t i = random.below(3), j = (i + 1) % 3, k = (i + 2) % 3;
  const bool is_at_corner = random.below(2) == 0;
  result.second[i] = 1e-12;
  result.second[j] = is_at_corner ? 1e-12 : random.between(0.1, 0.9);
  result.second[k] = 1 - result.second[i] - result.second[j];
  return result;
}

inline Surface_point random_surface_point(const Mesh& mesh, Random& random)
{
  switch(random.below(6))
  {
  case 0:
    return random_vertex(mesh, random);
  case 1:
    return Edge_location(random_halfedge(mesh, random), random.between(0, 1));
  case 2:
    return Edge_location(random_border_halfedge(mesh, random), random.between(0, 1));
  case 3:
    return random_location_at_side(mesh, random);
  default:
    return random_face_location(mesh, random);
  }
}

inline std::vector<Surface_point>
random_surface_points(const Mesh& mesh, const std::size_t number, Random& random)
{
  std::vector<Surface_point> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(random_surface_point(mesh, random));
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SURFACE_POINTS_H
