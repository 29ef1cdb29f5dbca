// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATE_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/cgal_compatibility.h>
#include <CGAL/Ray_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Location of points on a mesh with CGAL's AABB tree.

namespace CGAL::Approximate_geodesics::internal {

// Returns the vector from `p` to `q`.
template <typename Point_3>
Space_vector vector_between(const Point_3& p, const Point_3& q)
{
  const auto v = q - p;
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

// Sets weights that do not exceed the tolerance to zero, and normalizes the others.
inline std::array<double, 3> snapped(std::array<double, 3> weights, const double tolerance)
{
  const double largest = *std::max_element(weights.begin(), weights.end());
  double sum = 0;
  for(double& weight : weights)
  {
    weight = weight > tolerance || weight == largest ? weight : 0;
    sum += weight;
  }
  for(double& weight : weights)
    weight /= sum;
  return weights;
}

// Returns the barycentric coordinates of the point `way` in the triangle with vertices at the
// origin, `base` and `apex`. The first side is the longest one. In a nearly degenerate triangle,
// the height is inaccurate; it is clamped so that the point stays inside.
inline std::array<double, 3>
weights_over_base(const Space_vector& base, const Space_vector& apex, const Space_vector& way)
{
  const double foot = dot(base, apex) / dot(base, base);
  const double along = (std::clamp)(dot(base, way) / dot(base, base), 0., 1.);
  const Space_vector height = linear_combination(apex, -foot, base);
  const double squared_height = dot(height, height);
  double s =
      squared_height > 0 ? dot(linear_combination(way, -along, base), height) / squared_height : 0;
  if(foot > 0)
    s = (std::min)(s, along / foot);
  if(foot < 1)
    s = (std::min)(s, (1 - along) / (1 - foot));
  s = (std::max)(s, 0.);
  return {1 - along - s * (1 - foot), along - s * foot, s};
}

// Returns the barycentric coordinates of a point in a triangle.
template <typename Point_3>
std::array<double, 3> barycentric_coordinates(const std::array<Point_3, 3>& corners,
                                              const Point_3& p)
{
  std::array<Space_vector, 3> sides;
  double size = 0;
  for(std::size_t i = 0; i < 3; ++i)
  {
    sides[i] = vector_between(corners[i], corners[(i + 1) % 3]);
    for(const double x : sides[i])
      size = (std::max)(size, std::abs(x));
  }
  if(!(size > 0))
    return {1, 0, 0};

  const auto scaled = [size](const Space_vector& v) {
    return Space_vector{v[0] / size, v[1] / size, v[2] / size};
  };
  const auto squared_length = [&](const std::size_t i) {
    return dot(scaled(sides[i]), scaled(sides[i]));
  };
  std::size_t first = 0;
  for(std::size_t i = 1; i < 3; ++i)
    if(squared_length(i) > squared_length(first))
      first = i;
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const std::array<double, 3> weights = weights_over_base(
      scaled(sides[first]), scaled(vector_between(corners[first], corners[third])),
      scaled(vector_between(corners[first], p)));
  std::array<double, 3> result{};
  result[first] = weights[0];
  result[second] = weights[1];
  result[third] = weights[2];
  return result;
}

template <typename TriangleMesh, typename VertexPointMap, typename Point_3>
Face_location<TriangleMesh>
face_location(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
              const Point_3& p,
              const TriangleMesh& tmesh,
              const VertexPointMap& point_map,
              const double tolerance)
{
  const auto h = halfedge(f, tmesh);
  const std::array<Point_3, 3> corners{get(point_map, source(h, tmesh)),
                                       get(point_map, target(h, tmesh)),
                                       get(point_map, target(next(h, tmesh), tmesh))};
  return {f, snapped(barycentric_coordinates(corners, p), tolerance)};
}

// Returns the location of the point of the mesh nearest to `p`.
template <typename AABBTree, typename Point_3, typename TriangleMesh, typename VertexPointMap>
Face_location<TriangleMesh> locate_nearest(const Point_3& p,
                                           const AABBTree& tree,
                                           const TriangleMesh& tmesh,
                                           const VertexPointMap& point_map,
                                           const double tolerance)
{
  if(tree.empty())
    return {boost::graph_traits<TriangleMesh>::null_face(), {0, 0, 0}};
  const auto nearest = tree.closest_point_and_primitive(p);
  return face_location(nearest.second, nearest.first, tmesh, point_map, tolerance);
}

// Returns the location of the first intersection of a ray with the mesh. The face is null if there
// is none.
template <typename AABBTree, typename Kernel, typename TriangleMesh, typename VertexPointMap>
Face_location<TriangleMesh> locate_first(const Ray_3<Kernel>& ray,
                                         const AABBTree& tree,
                                         const TriangleMesh& tmesh,
                                         const VertexPointMap& point_map,
                                         const double tolerance)
{
  using Point_3 = typename Kernel::Point_3;
  using Segment_3 = typename Kernel::Segment_3;
  using Intersection =
      typename AABBTree::template Intersection_and_primitive_id<CGAL::Ray_3<Kernel>>::Type;

  Face_location<TriangleMesh> result(boost::graph_traits<TriangleMesh>::null_face(), {0, 0, 0});
  double smallest = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Point_3& p, const auto f) {
    const Space_vector way = vector_between(Point_3(ray.source()), p);
    if(dot(way, way) < smallest)
    {
      smallest = dot(way, way);
      result = face_location(f, p, tmesh, point_map, tolerance);
    }
  };
  std::vector<Intersection> intersections;
  tree.all_intersections(ray, boost::make_function_output_iterator([&](const auto& intersection) {
                           intersections.push_back(intersection);
                         }));
  for(const auto& [where, f] : intersections)
    if(const Point_3* p = alternative<Point_3>(where))
      consider(*p, f);
    else if(const Segment_3* s = alternative<Segment_3>(where)) // the ray lies in the plane of `f`
    {
      consider(s->source(), f);
      consider(s->target(), f);
    }
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATE_H
