// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATION_FUNCTIONS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATION_FUNCTIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/locate.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Ray_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>

namespace CGAL {

// Forward declaration: only programs that call `locate()` need the header, which takes a quarter of
// the compile time.
template <typename AABBTraits>
class AABB_tree;

namespace Approximate_geodesics::internal {

/*
 * Converts between points in space, locations in faces, and descriptors, like the static functions
 * of the exact class. Unlike CGAL's `construct_point()` and `locate_vertex()`, these functions
 * accept isolated vertices, and do not require the header of the AABB tree.
 */
template <typename TriangleMesh>
class Location_functions
{
  static_assert(!is_traits_of_exact_class<TriangleMesh>,
                "the first template argument is the mesh, not the traits of the exact class");

  using Triangle_mesh = TriangleMesh;
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using FT = double;
  using Barycentric_coordinates = std::array<FT, 3>;
  using Face_location = Approximate_geodesics::Face_location<TriangleMesh>;
  using Point_3 = typename boost::property_traits<
      typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

public:
  static constexpr FT default_tolerance = 1e-10; // of barycentric coordinates

  static Point_3 point(const face_descriptor f,
                       const Barycentric_coordinates& location,
                       const Triangle_mesh& tmesh)
  {
    return point(f, location, tmesh, get(vertex_point, tmesh));
  }

  template <typename VertexPointMap>
  static Point_3 point(const face_descriptor f,
                       const Barycentric_coordinates& location,
                       const Triangle_mesh& tmesh,
                       const VertexPointMap& point_map)
  {
    using Kernel = typename Kernel_traits<Point_3>::Kernel;
    const halfedge_descriptor h = halfedge(f, tmesh);
    return Kernel().construct_barycenter_3_object()(
        get(point_map, source(h, tmesh)), typename Kernel::FT(location[0]),
        get(point_map, target(h, tmesh)), typename Kernel::FT(location[1]),
        get(point_map, target(next(h, tmesh), tmesh)), typename Kernel::FT(location[2]));
  }

  static Point_3 point(const halfedge_descriptor h, const FT t, const Triangle_mesh& tmesh)
  {
    return point(h, t, tmesh, get(vertex_point, tmesh));
  }

  template <typename VertexPointMap>
  static Point_3 point(const halfedge_descriptor h,
                       const FT t,
                       const Triangle_mesh& tmesh,
                       const VertexPointMap& point_map)
  {
    using Kernel = typename Kernel_traits<Point_3>::Kernel;
    return Kernel().construct_barycenter_3_object()(
        get(point_map, target(h, tmesh)), typename Kernel::FT(t), get(point_map, source(h, tmesh)));
  }

  static Point_3 point(const vertex_descriptor v, const Triangle_mesh& tmesh)
  {
    return get(vertex_point, tmesh, v);
  }

  static Face_location face_location(const vertex_descriptor v, const Triangle_mesh& tmesh)
  {
    if(halfedge(v, tmesh) != Graph_traits::null_halfedge())
      for(const halfedge_descriptor h : halfedges_around_target(v, tmesh))
        if(!is_border(h, tmesh))
          return face_location(h, 1, tmesh);
    return {Graph_traits::null_face(), {0, 0, 0}};
  }

  static Face_location
  face_location(const halfedge_descriptor h, const FT t, const Triangle_mesh& tmesh)
  {
    if(is_border(h, tmesh))
      return face_location(opposite(h, tmesh), 1 - t, tmesh);
    Face_location result(face(h, tmesh), {0, 0, 0});
    std::size_t i = 0;
    for(halfedge_descriptor g = halfedge(result.first, tmesh); g != h; g = next(g, tmesh))
      ++i;
    result.second[i] = 1 - t;
    result.second[(i + 1) % 3] = t;
    return result;
  }

  template <typename AABBTraits, typename VertexPointMap>
  static Face_location locate(const Point_3& p,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tmesh, tree, point_map);
    return locate(p, tree, tmesh, point_map, tolerance);
  }

  template <typename AABBTraits, typename VertexPointMap>
  static Face_location locate(const Point_3& p,
                              const AABB_tree<AABBTraits>& tree,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    return internal::locate_nearest(p, tree, tmesh, point_map, tolerance);
  }

  template <typename AABBTraits, typename Kernel, typename VertexPointMap>
  static Face_location locate(const Ray_3<Kernel>& ray,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tmesh, tree, point_map);
    return locate(ray, tree, tmesh, point_map, tolerance);
  }

  template <typename AABBTraits, typename Kernel, typename VertexPointMap>
  static Face_location locate(const Ray_3<Kernel>& ray,
                              const AABB_tree<AABBTraits>& tree,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    return internal::locate_first(ray, tree, tmesh, point_map, tolerance);
  }

  template <typename AABBTraits>
  static void build_aabb_tree(const Triangle_mesh& tmesh, AABB_tree<AABBTraits>& tree)
  {
    build_aabb_tree(tmesh, tree, get(vertex_point, tmesh));
  }

  template <typename AABBTraits, typename VertexPointMap>
  static void build_aabb_tree(const Triangle_mesh& tmesh,
                              AABB_tree<AABBTraits>& tree,
                              const VertexPointMap& point_map)
  {
    tree.rebuild(faces(tmesh).begin(), faces(tmesh).end(), tmesh, point_map);
    tree.build();
  }
};

} // namespace Approximate_geodesics::internal
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_LOCATION_FUNCTIONS_H
