// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Ray_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/version.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#if CGAL_VERSION_NR < 1060001000
#include <boost/variant.hpp>
#endif

namespace CGAL {

// Forward declaration: only programs that call `locate()` need the header, which takes a quarter of
// the compile time.
template <typename AABBTraits>
class AABB_tree;

namespace Approximate_geodesics {
namespace internal {

// Returns the alternative of type `T` of the result of an intersection, or a null pointer. CGAL 6
// replaced `boost::variant` by `std::variant`.
#if CGAL_VERSION_NR < 1060001000
template <typename T, typename... Types>
const T* alternative(const boost::variant<Types...>& variant)
{
  return boost::get<T>(&variant);
}
#endif

template <typename T, typename... Types>
const T* alternative(const std::variant<Types...>& variant)
{
  return std::get_if<T>(&variant);
}

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

// Detects the traits of CGAL's exact class, passed by mistake in place of the mesh.
template <typename T, typename = void>
constexpr bool is_traits_of_exact_class = false;

template <typename T>
constexpr bool
    is_traits_of_exact_class<T,
                             std::void_t<typename T::Triangle_mesh,
                                         typename T::Compute_parametric_distance_along_segment_2>> =
        true;

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

} // namespace internal

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

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_LOCATIONS_H
