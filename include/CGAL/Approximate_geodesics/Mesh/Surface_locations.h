// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Location_functions.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Ray_3.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <utility>
#include <variant>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMesh
 *
 * Conversions between points in space, points of the surface of a mesh, and locations in its faces:
 * the functions of CGAL's exact class that do not compute shortest paths.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal vertex
 *         point map
 */
template <typename TriangleMesh>
class Surface_locations
#ifndef DOXYGEN_RUNNING
  : private internal::Location_functions<TriangleMesh>
#endif
{
  using Base = internal::Location_functions<TriangleMesh>;
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  /// \name Types
  /// @{

  /// the type of the mesh.
  using Triangle_mesh = TriangleMesh;

  /// a vertex of the mesh.
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  /// a halfedge of the mesh.
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  /// a face of the mesh.
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// the number type of distances.
  using FT = double;

  /// the type of the mesh's points.
  using Point_3 = typename boost::property_traits<
      typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

  /// the weights of the vertices of a face `f`, starting with `source(halfedge(f, tmesh), tmesh)`.
  using Barycentric_coordinates = std::array<FT, 3>;

  /// a location on the surface: a face, and barycentric coordinates in it.
  using Face_location = Approximate_geodesics::Face_location<TriangleMesh>;

  /// a point of the surface: a vertex, a point on an edge, or a point in a face.
  using Surface_point = Approximate_geodesics::Surface_point<TriangleMesh>;

  /// the internal vertex point map of the mesh.
  using Vertex_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;

  /// @}

#ifndef DOXYGEN_RUNNING
  // Static overloads of the following functions.
  using Base::build_aabb_tree;
  using Base::face_location;
  using Base::locate;
  using Base::point;
#endif

  /*!
   * \name Points
   *
   * Static overloads take the mesh, and optionally a vertex point map, as additional arguments.
   */
  /// @{

  /// returns the point with the given barycentric coordinates in the face `f`.
  Point_3 point(const face_descriptor f, const Barycentric_coordinates& location) const
  {
    return point(f, location, m_mesh, m_point_map);
  }

  /// returns the point at the parameter `t` along `h`: `0` is its source, `1` is its target.
  Point_3 point(const halfedge_descriptor h, const FT t) const
  {
    return point(h, t, m_mesh, m_point_map);
  }

  /// returns the point of `v`.
  Point_3 point(const vertex_descriptor v) const { return get(m_point_map, v); }

  /// @}

  /*!
   * \name Face Locations
   *
   * Static overloads take the mesh as an additional argument.
   */
  /// @{

  /// returns a location of `v` in an incident face. If `v` is isolated, the face is
  /// `boost::graph_traits<Triangle_mesh>::%null_face()`.
  Face_location face_location(const vertex_descriptor v) const { return face_location(v, m_mesh); }

  /// returns the location at the parameter `t` along `h` in the face to its left, or, if `h` is a
  /// border halfedge, to its right.
  Face_location face_location(const halfedge_descriptor h, const FT t) const
  {
    return face_location(h, t, m_mesh);
  }

  /// returns a location of a point of the surface in an incident face.
  Face_location face_location(const Surface_point& point) const
  {
    if(const auto* v = std::get_if<vertex_descriptor>(&point))
      return face_location(*v);
    if(const auto* p = std::get_if<std::pair<halfedge_descriptor, double>>(&point))
      return face_location(p->first, p->second);
    return std::get<Face_location>(point);
  }

  /// @}

  /*!
   * \name Nearest Face Locations
   *
   * Locations are snapped to close vertices and edges: barycentric coordinates of at most
   * `tolerance` are set to zero. A path from a returned location starts there exactly. The face is
   * `boost::graph_traits<Triangle_mesh>::%null_face()` if the mesh has no faces, or the ray does
   * not intersect it.
   *
   * Overloads without a tree build one from the internal points of the mesh. Static overloads take
   * the mesh and a vertex point map as additional arguments before the tolerance. \cgal's tree may
   * throw for rays if faces are degenerate, and cannot find nearest points if squared coordinates
   * overflow a `double`.
   *
   * These functions require the header `CGAL/AABB_tree.h`, which this header does not include.
   *
   * \tparam AABBTraits a model of `AABBTraits` for the faces of the mesh
   */
  /// @{

  /// returns the location on the mesh nearest to `p`.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p, const FT tolerance = default_tolerance) const
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tree);
    return locate(p, tree, tolerance);
  }

  /// uses a given tree.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p,
                       const AABB_tree<AABBTraits>& tree,
                       const FT tolerance = default_tolerance) const
  {
    return locate(p, tree, m_mesh, m_point_map, tolerance);
  }

  /// returns the location of the first intersection of `ray` with the mesh.
  template <typename AABBTraits, typename Kernel>
  Face_location locate(const Ray_3<Kernel>& ray, const FT tolerance = default_tolerance) const
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tree);
    return locate(ray, tree, tolerance);
  }

  /// uses a given tree.
  template <typename AABBTraits, typename Kernel>
  Face_location locate(const Ray_3<Kernel>& ray,
                       const AABB_tree<AABBTraits>& tree,
                       const FT tolerance = default_tolerance) const
  {
    return locate(ray, tree, m_mesh, m_point_map, tolerance);
  }

  /// builds a tree of the faces for `locate()`, with the internal points of the mesh.
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree) const
  {
    build_aabb_tree(m_mesh, tree);
  }

  /// builds a tree of the faces with the points of `point_map`.
  template <typename AABBTraits, typename VertexPointMap>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree, const VertexPointMap& point_map) const
  {
    build_aabb_tree(m_mesh, tree, point_map);
  }

  /// the default tolerance of barycentric coordinates.
  static constexpr FT default_tolerance = Base::default_tolerance;

  /// @}

protected:
  /// a type-erased vertex point map.
  using Point_function = internal::Function_property_map<vertex_descriptor, Point_3>;

  /// constructs the conversions for a mesh and a vertex point map. Both are referred to, not
  /// copied.
  template <typename VertexPointMap>
  Surface_locations(const Triangle_mesh& tmesh, const VertexPointMap& vertex_point_map)
    : m_mesh(tmesh),
      m_point_map(internal::function_property_map<vertex_descriptor, Point_3>(vertex_point_map))
  {
  }

  /// returns the mesh.
  const Triangle_mesh& mesh() const { return m_mesh; }

  /// returns the vertex point map.
  const Point_function& point_map() const { return m_point_map; }

private:
  const Triangle_mesh& m_mesh;
  const Point_function m_point_map;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
