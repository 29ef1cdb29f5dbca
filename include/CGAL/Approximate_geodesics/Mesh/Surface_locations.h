// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Object.h>
#include <CGAL/Ray_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {

// Forward declaration: only programs that call `locate()` need the header, which takes a quarter of
// the compile time.
template <typename AABBTraits>
class AABB_tree;

namespace Approximate_geodesics {
namespace internal {

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

// Returns the barycentric coordinates of a point in a triangle. Vectors are scaled to about unit
// size, because squares could overflow or underflow.
template <typename Point_3>
std::array<double, 3> barycentric_coordinates(const std::array<Point_3, 3>& corners,
                                              const Point_3& p)
{
  double size = 0;
  for(std::size_t i = 0; i < 3; ++i)
    for(const double x : space_vector(corners[(i + 1) % 3] - corners[i]))
      size = (std::max)(size, std::abs(x));
  if(!(size > 0))
    return {1, 0, 0};

  const auto scaled_way = [&](const std::size_t i, const Point_3& q) {
    const Space_vector way = space_vector(q - corners[i]);
    return Space_vector{way[0] / size, way[1] / size, way[2] / size};
  };
  Space_vector base{};
  std::size_t first = 0; // corner of the longest side
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Space_vector side = scaled_way(i, corners[(i + 1) % 3]);
    if(dot(side, side) > dot(base, base))
    {
      base = side;
      first = i;
    }
  }
  const std::size_t third = (first + 2) % 3;
  const std::array<double, 3> weights =
      weights_over_base(base, scaled_way(first, corners[third]), scaled_way(first, p));
  std::array<double, 3> result{};
  for(std::size_t i = 0; i < 3; ++i)
    result[(first + i) % 3] = weights[i];
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

// Returns the location of the point of the mesh nearest to `p`. The face is null if there is none.
template <typename Point_3, typename AABBTree, typename TriangleMesh, typename VertexPointMap>
Face_location<TriangleMesh> locate(const Point_3& p,
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
template <typename Kernel, typename AABBTree, typename TriangleMesh, typename VertexPointMap>
Face_location<TriangleMesh> locate(const Ray_3<Kernel>& ray,
                                   const AABBTree& tree,
                                   const TriangleMesh& tmesh,
                                   const VertexPointMap& point_map,
                                   const double tolerance)
{
  Face_location<TriangleMesh> result(boost::graph_traits<TriangleMesh>::null_face(), {0, 0, 0});
  double smallest = infinity;
  const auto consider = [&](const auto& p, const auto f) {
    const Space_vector way = space_vector(p - ray.source());
    if(dot(way, way) < smallest)
    {
      smallest = dot(way, way);
      result = face_location(f, p, tmesh, point_map, tolerance);
    }
  };
  const auto consider_ends = [&](const auto& intersection) {
    const auto f = intersection.second;
    const Object where(intersection.first);
    if(const auto* p = object_cast<typename Kernel::Point_3>(&where))
      consider(*p, f);
    else if(const auto* s = object_cast<typename Kernel::Segment_3>(&where)) // in the plane of `f`
    {
      consider(s->source(), f);
      consider(s->target(), f);
    }
  };
  tree.all_intersections(ray, boost::make_function_output_iterator(consider_ends));
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * Conversions between points in space, points of the surface of a mesh, and locations in its faces:
 * the functions of CGAL's exact class that do not compute shortest paths.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal vertex
 *         point map
 */
template <typename TriangleMesh>
class Surface_locations
{
  static constexpr bool is_mesh = !internal::is_valid<const TriangleMesh&>(
      [](auto& t) ->
      typename std::decay_t<decltype(t)>::Compute_parametric_distance_along_segment_2 {});
  static_assert(is_mesh,
                "the first template argument is the mesh, not the traits of the exact class");

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

  /// the internal vertex point map of the mesh.
  using Vertex_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;

  /// the type of the mesh's points.
  using Point_3 = typename boost::property_traits<Vertex_point_map>::value_type;

  /// the weights of the vertices of a face `f`, starting with `source(halfedge(f, tmesh), tmesh)`.
  using Barycentric_coordinates = std::array<FT, 3>;

  /// a location on the surface: a face, and barycentric coordinates in it.
  using Face_location = Approximate_geodesics::Face_location<TriangleMesh>;

  /// a point of the surface: a vertex, a point on an edge, or a point in a face.
  using Surface_point = Approximate_geodesics::Surface_point<TriangleMesh>;

  /// @}

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
   * The query is a point in space, for the nearest location on the mesh, or a `CGAL::Ray_3`, for
   * its first intersection with the mesh. The face is
   * `boost::graph_traits<Triangle_mesh>::%null_face()` if the mesh has no faces, or the ray does
   * not intersect it.
   *
   * Locations are snapped to close vertices and edges: barycentric coordinates of at most
   * `tolerance` are set to zero. A path from a returned location starts there exactly.
   *
   * Overloads without a tree build one from the internal points of the mesh. Static overloads take
   * the mesh and a vertex point map as additional arguments before the tolerance. \cgal's tree may
   * throw for rays if faces are degenerate, and cannot find nearest points if squared coordinates
   * overflow a `double`.
   *
   * These functions require the header `CGAL/AABB_tree.h`, which this header does not include.
   *
   * \tparam AABBTraits a model of `AABBTraits` for the faces of the mesh
   * \tparam Query `Point_3`, or a `CGAL::Ray_3`
   */
  /// @{

  /// returns the location on the mesh nearest to a point, or the first one on a ray.
  template <typename AABBTraits, typename Query = Point_3>
  Face_location locate(const Query& query, const FT tolerance = default_tolerance) const
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tree);
    return locate(query, tree, tolerance);
  }

  /// uses a given tree.
  template <typename AABBTraits, typename Query = Point_3>
  Face_location locate(const Query& query,
                       const AABB_tree<AABBTraits>& tree,
                       const FT tolerance = default_tolerance) const
  {
    return locate(query, tree, m_mesh, m_point_map, tolerance);
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
  static constexpr FT default_tolerance = 1e-10;

  /// @}

  /// \cond SKIP_IN_MANUAL
  // Static overloads. Unlike `construct_point()` and `locate_vertex()` of CGAL, they accept
  // isolated vertices, and do not require the header of the AABB tree.

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

  static Point_3 point(const face_descriptor f,
                       const Barycentric_coordinates& location,
                       const Triangle_mesh& tmesh)
  {
    return point(f, location, tmesh, get(vertex_point, tmesh));
  }

  static Point_3 point(const halfedge_descriptor h, const FT t, const Triangle_mesh& tmesh)
  {
    return point(h, t, tmesh, get(vertex_point, tmesh));
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
    return internal::location_in_face(h, t, 0, tmesh);
  }

  template <typename AABBTraits, typename Query = Point_3, typename VertexPointMap>
  static Face_location locate(const Query& query,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tmesh, tree, point_map);
    return locate(query, tree, tmesh, point_map, tolerance);
  }

  template <typename AABBTraits, typename Query = Point_3, typename VertexPointMap>
  static Face_location locate(const Query& query,
                              const AABB_tree<AABBTraits>& tree,
                              const Triangle_mesh& tmesh,
                              const VertexPointMap& point_map,
                              const FT tolerance = default_tolerance)
  {
    return internal::locate(query, tree, tmesh, point_map, tolerance);
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
  /// \endcond

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

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
