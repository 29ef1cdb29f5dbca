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

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMesh
 *
 * Between points in space, points of the surface of a mesh, and locations in its faces: what
 * `Surface_mesh_shortest_path` has from CGAL's exact class beside shortest paths.
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

  /// the weights of a face's vertices, in the order in which `source(halfedge(f, tmesh), tmesh)` is
  /// the first one.
  using Barycentric_coordinates = std::array<FT, 3>;

  /// a location on the surface: a face, and barycentric coordinates in it.
  using Face_location = Approximate_geodesics::Face_location<TriangleMesh>;

  /// a point of the surface: a vertex, a point on an edge, or a point in a face.
  using Surface_point = Approximate_geodesics::Surface_point<TriangleMesh>;

  /// the property map of the mesh's own points.
  using Vertex_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;

  /// @}

#ifndef DOXYGEN_RUNNING
  // the static versions of the functions that follow
  using Base::build_aabb_tree;
  using Base::face_location;
  using Base::locate;
  using Base::point;
#endif

  /*!
   * \name Points
   *
   * There are static versions of these functions, which take the mesh as a further argument, and
   * may be given a vertex point map after that.
   */
  /// @{

  /// returns the point with the given barycentric coordinates in the face `f`.
  Point_3 point(const face_descriptor f, const Barycentric_coordinates& location) const
  {
    return point(f, location, m_mesh, m_point_map);
  }

  /// returns the point at the part `t` of the way along `h`, from its source.
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
   * There are static versions of these functions, too.
   */
  /// @{

  /// returns a location of `v` in one of its faces. If it has none, the face is
  /// `boost::graph_traits<Triangle_mesh>::%null_face()`.
  Face_location face_location(const vertex_descriptor v) const { return face_location(v, m_mesh); }

  /// returns the location at the part `t` of the way along `h` in the face to its left, or, at the
  /// border, to its right.
  Face_location face_location(const halfedge_descriptor h, const FT t) const
  {
    return face_location(h, t, m_mesh);
  }

  /// returns a location of a point of the surface in one of its faces.
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
   * A location next to a corner or a side of its face is moved onto that: barycentric coordinates
   * of at most `tolerance` are set to zero. What is returned is where paths from there start, to
   * the last bit. The face is `boost::graph_traits<Triangle_mesh>::%null_face()` if the mesh has
   * no faces, or the ray does not meet any.
   *
   * Those functions that are given no tree build one, of the mesh's own points. There are static
   * versions, which take the mesh and a vertex point map as arguments before the tolerance. Where
   * faces have no area, \cgal's tree may refuse a ray; and where squared coordinates do not fit a
   * `double`, it cannot find nearest points.
   *
   * Programs that call these functions include `CGAL/AABB_tree.h`, which this header does not.
   *
   * \tparam AABBTraits a model of `AABBTraits` for the faces of the mesh
   */
  /// @{

  /// returns the location on the mesh that is nearest to `p`.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p, const FT tolerance = default_tolerance) const
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tree);
    return locate(p, tree, tolerance);
  }

  /// does the same with a tree that was built before.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p,
                       const AABB_tree<AABBTraits>& tree,
                       const FT tolerance = default_tolerance) const
  {
    return locate(p, tree, m_mesh, m_point_map, tolerance);
  }

  /// returns the location on the mesh where `ray` meets it first.
  template <typename AABBTraits, typename Kernel>
  Face_location locate(const Ray_3<Kernel>& ray, const FT tolerance = default_tolerance) const
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tree);
    return locate(ray, tree, tolerance);
  }

  /// does the same with a tree that was built before.
  template <typename AABBTraits, typename Kernel>
  Face_location locate(const Ray_3<Kernel>& ray,
                       const AABB_tree<AABBTraits>& tree,
                       const FT tolerance = default_tolerance) const
  {
    return locate(ray, tree, m_mesh, m_point_map, tolerance);
  }

  /// builds a tree of the mesh's faces for `locate()`, with the mesh's own points.
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree) const
  {
    build_aabb_tree(m_mesh, tree);
  }

  /// builds a tree with other points.
  template <typename AABBTraits, typename VertexPointMap>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree, const VertexPointMap& point_map) const
  {
    build_aabb_tree(m_mesh, tree, point_map);
  }

  /// the weight in barycentric coordinates that a location may be moved by.
  static constexpr FT default_tolerance = Base::default_tolerance;

  /// @}

protected:
  /// the property map of the points that were chosen, of a type that does not tell which it is.
  using Point_function = internal::Function_property_map<vertex_descriptor, Point_3>;

  /// refers to a mesh, and to the points that `vertex_point_map` has for its vertices.
  template <typename VertexPointMap>
  Surface_locations(const Triangle_mesh& tmesh, const VertexPointMap& vertex_point_map)
    : m_mesh(tmesh),
      m_point_map(internal::function_property_map<vertex_descriptor, Point_3>(vertex_point_map))
  {
  }

  /// returns the mesh.
  const Triangle_mesh& mesh() const { return m_mesh; }

  /// returns the points.
  const Point_function& point_map() const { return m_point_map; }

private:
  const Triangle_mesh& m_mesh;
  const Point_function m_point_map;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
