// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_TRACE_GEODESIC_H
#define CGAL_GEODESIC_CONSTRUCTIONS_TRACE_GEODESIC_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_constructions/internal/Straight_walk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * A tangent vector at a point of the surface, in the unit of the mesh. It needs no coordinates of
 * vertices; `Geodesic_tracer` converts it from and to vectors in space.
 *
 * The frame of a point depends on what contains it. All angles are counterclockwise, seen from
 * where faces are.
 * - <b>Inside a face</b> `f`, the x axis points along `halfedge(f, tmesh)`.
 * - <b>Inside an edge</b>, it points along the halfedge that the point is given by, or along that
 *   halfedge of its face if it is given by a `Face_location`. The face on the other side is
 *   unfolded into the same plane.
 * - <b>At a vertex</b> `v`, it points along `opposite(halfedge(v, tmesh), tmesh)`. Angles are
 *   those on the surface, scaled so that they add up to \f$2\pi\f$ around the vertex, as in
 *   geometry-central.
 * - <b>At a border vertex</b>, it points along the first halfedge counterclockwise from the border.
 *   Angles are not scaled, unless they add up to more than \f$2\pi\f$.
 */
struct Tangent_vector
{
  double x = 0; ///< along the x axis
  double y = 0; ///< along the y axis, which is a quarter turn counterclockwise from it
};

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * What `trace_geodesic()` returns.
 */
template <typename TriangleMesh>
struct Geodesic_walk
{
  /// the start, the edges and vertices that the walk crosses, and the end. Two consecutive points
  /// lie in the same face.
  std::vector<Surface_point<TriangleMesh>> points;

  /// the direction at the end, of length `1`, in the frame of the last point.
  Tangent_vector direction;

  /// the length walked; equal to the required one unless the walk has ended early.
  double length = 0;

  /// whether the walk has ended early at the border. If it is `false` and the length is too small,
  /// the walk has visited the largest number of faces.
  bool meets_border = false;
};

namespace internal {

// Divides by the largest coordinate first, as squares may overflow or underflow.
inline Space_vector unit_vector(const Space_vector& v)
{
  const double size = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if(!(size > 0))
    return {0, 0, 0};
  const Space_vector w{v[0] / size, v[1] / size, v[2] / size};
  const double l = std::sqrt(dot(w, w));
  return {w[0] / l, w[1] / l, w[2] / l};
}

inline Space_vector cross_product(const Space_vector& a, const Space_vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Tangent_vector& v) { return std::hypot(v.x, v.y); }

inline double angle_of(const Tangent_vector& v) { return std::atan2(v.y, v.x); }

inline Tangent_vector tangent_vector(const double angle, const double length)
{
  return {length * std::cos(angle), length * std::sin(angle)};
}

inline void check_tangent_vector(const Tangent_vector& v, const char* const name)
{
  if(!std::isfinite(v.x) || !std::isfinite(v.y))
    reject(std::string(name) + " is " + text_of(v.x) + ", " + text_of(v.y) +
           "; its coordinates must be finite numbers");
}

// Reads a parameter that may be of a signed type.
template <typename NamedParameters>
std::size_t largest_number_of_iterations(const NamedParameters& np, const std::size_t otherwise)
{
  const auto number = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::number_of_iterations), otherwise);
  if constexpr(std::is_signed_v<std::decay_t<decltype(number)>>)
    if(!(number >= 0))
      reject("the number of iterations is " + std::to_string(number) + "; it must not be negative");
  return static_cast<std::size_t>(number);
}

// A face in space, laid out around the source of a halfedge.
struct Face_in_space
{
  // Unit vectors from the source to the target, and to the third vertex, which is to the right of
  // the halfedge if it is a border halfedge.
  Face_in_space(const Space_vector& to_target, const Space_vector& to_third, const bool is_to_right)
    : along(to_target), side(to_third)
  {
    left = unit_vector(linear_combination(side, -dot(along, side), along));
    if(is_to_right)
      left = {-left[0], -left[1], -left[2]};
  }

  Plane_vector projection(const Space_vector& v) const { return {dot(v, along), dot(v, left)}; }

  Space_vector vector(const double angle, const double length) const
  {
    const double x = length * std::cos(angle), y = length * std::sin(angle);
    return {x * along[0] + y * left[0], x * along[1] + y * left[1], x * along[2] + y * left[2]};
  }

  Space_vector along, left, side; // unit vectors
};

// Points and directions in terms of the mesh.
template <typename Translation>
Geodesic_walk<typename Translation::Triangle_mesh>
walk_on_mesh(const Translation& translation,
             const Intrinsic_triangulation& triangulation,
             const Straight_walk& walk)
{
  Geodesic_walk<typename Translation::Triangle_mesh> result;
  for(const Intrinsic_point& p : walk.points())
    result.points.push_back(translation.surface_point(p));
  double angle = walk.angle();
  const Intrinsic_point& end = walk.points().back();
  if(end.is_in_face()) // the walk may lay out the face from another halfedge
    angle = Tangent_frames(triangulation)
                .angle(translation.intrinsic_point(result.points.back()), {end.halfedge, angle});
  result.direction = tangent_vector(angle, 1);
  result.meets_border = walk.meets_border();
  result.length = walk.length() * triangulation.unit();
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * Walks straight ahead, and transports vectors, on one mesh. It reads the mesh once, in
 * \cgalBigO{n}; each query then takes time in proportion to the faces that it crosses.
 *
 * Points are of type `vertex_descriptor`, `Face_location` or `Surface_point`; directions and
 * vectors are of type `Tangent_vector` or `%Vector_3`. A vector in space stands for its tangent
 * part: the vector of length at most its own, in a face at the point, that is nearest to it.
 *
 * All member functions are `const` and may be called by several threads.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 */
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
class Geodesic_tracer
{
  static_assert(!internal::ignores_any<NamedParameters, internal_np::edge_length_t>,
                "walks read edge_length_map, and no parameter of distances: they do not depend on "
                "costs");
  using Index_map = decltype(internal::vertex_index_map(std::declval<const TriangleMesh&>(),
                                                        std::declval<const NamedParameters&>()));
  using Index = Intrinsic_triangulation::Index;

public:
  /// what a walk returns.
  using Walk = Geodesic_walk<TriangleMesh>;

  /*!
   * reads `tmesh`.
   *
   * \param tmesh the triangle mesh
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
   *        `trace_geodesic()`
   *
   * \warning `tmesh` is referred to, and must neither be changed nor destroyed during the lifetime
   * of this object.
   *
   * \throws std::invalid_argument and std::length_error as `Intrinsic_triangulation` does, and if a
   * face breaks the triangle inequality, or the number of iterations is negative.
   */
  explicit Geodesic_tracer(const TriangleMesh& tmesh,
                           const NamedParameters& np = parameters::default_values())
    : m_np(np),
      m_largest_number_of_faces(internal::largest_number_of_iterations(np, 1000000)),
      m_triangulation(tmesh, np),
      m_translation(tmesh, internal::vertex_index_map(tmesh, np), m_triangulation),
      m_frames(m_triangulation)
  {
    m_triangulation.check_triangle_inequality();
    m_translation.list_vertices();
  }

  /// not copyable.
  Geodesic_tracer(const Geodesic_tracer&) = delete;
  Geodesic_tracer& operator=(const Geodesic_tracer&) = delete;

  /// walks straight ahead, as `trace_geodesic()` does.
  template <typename Point, typename Vector>
  Walk trace(const Point& start, const Vector& direction, const double length) const
  {
    const Intrinsic_point p = internal::intrinsic_point(m_translation, start, "start");
    if(!(length >= 0) || std::isinf(length))
      internal::reject("the length is " + internal::text_of(length) +
                       "; it must be a finite number that is not negative");
    const Tangent_vector way = tangent_vector_at(p, direction, "the direction");
    if(!(internal::length(way) > 0))
      internal::reject("the direction has no part along the surface, or length 0");
    const double steps =
        (std::min)(length / m_triangulation.unit(), (std::numeric_limits<double>::max)());
    const internal::Straight_walk walk(m_triangulation, p, internal::angle_of(way), steps,
                                       m_largest_number_of_faces);
    return internal::walk_on_mesh(m_translation, m_triangulation, walk);
  }

  /// transports a vector along a path, as `parallel_transport()` does.
  template <typename PointRange, typename Vector>
  Tangent_vector transport(const PointRange& path, const Vector& vector) const
  {
    const std::vector<Intrinsic_point> points =
        internal::intrinsic_points(m_translation, path, "point of the path");
    if(points.empty())
      internal::reject("the path has no points");
    const Tangent_vector start = tangent_vector_at(points.front(), vector, "the vector");
    double angle = internal::angle_of(start);
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      const std::optional<double> turn = m_frames.turn(points[i - 1], points[i]);
      if(!turn)
        internal::reject("points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                         " of the path, counted from 0, lie in no common face");
      angle += *turn;
    }
    return internal::tangent_vector(angle, internal::length(start));
  }

  /// returns the tangent part of a vector in space: the zero vector if it points away from all
  /// faces at the point.
  template <typename Point, typename Vector_3>
  Tangent_vector tangent_vector(const Point& point, const Vector_3& vector) const
  {
    return tangent_vector_at(internal::intrinsic_point(m_translation, point, "point"), vector,
                             "the vector");
  }

  /// returns the position of a point, for example of a `Walk`, in space.
#ifdef DOXYGEN_RUNNING
  template <typename Point>
  Point_3 point_3(const Point& point) const;
#else
  template <typename Point>
  auto point_3(const Point& point) const
  {
    return internal::point(m_translation, internal::intrinsic_point(m_translation, point, "point"),
                           internal::vertex_point_map(m_translation.mesh(), m_np), m_np);
  }
#endif

  /// returns the vector in space that a tangent vector stands for: in the face that it points into,
  /// or in the plane of the face that it leaves at a border.
  /// \throws std::invalid_argument if the point is a vertex without faces.
#ifdef DOXYGEN_RUNNING
  template <typename Point>
  Vector_3 vector_3(const Point& point, const Tangent_vector& vector) const;
#else
  template <typename Point, typename Vector>
  auto vector_3(const Point& point, const Vector& vector) const
  {
    using Kernel = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
    const Intrinsic_point p = internal::intrinsic_point(m_translation, point, "point");
    internal::check_tangent_vector(vector, "the vector");
    const double angle = internal::angle_of(vector);
    auto direction = m_frames.direction(p, angle);
    if(!direction && p.is_vertex())
      direction = m_frames.direction_beyond_border(p.vertex, angle);
    else if(!direction) // out of the surface at a border edge
      direction = m_triangulation.is_border(p.halfedge)
                      ? internal::Direction{m_triangulation.opposite(p.halfedge),
                                            angle + internal::straight_angle}
                      : internal::Direction{p.halfedge, angle};
    if(!direction)
      internal::reject("the point is a vertex without faces, which has no tangent vectors");
    return internal::vector_3<Kernel>(
        face_in_space(direction->halfedge).vector(direction->angle, internal::length(vector)));
  }
#endif

private:
  template <typename Vector>
  Tangent_vector
  tangent_vector_at(const Intrinsic_point& p, const Vector& vector, const char* const name) const
  {
    if constexpr(std::is_same_v<Vector, Tangent_vector>)
    {
      internal::check_tangent_vector(vector, name);
      return vector;
    }
    else
    {
      const internal::Space_vector v = internal::space_vector(vector);
      if(!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
        internal::reject(std::string(name) + " is " + internal::text_of(v) +
                         "; its coordinates must be finite numbers");
      return tangent_part(p, v);
    }
  }

  // Of the vectors in the faces at `p`, the one with the largest part in the direction of `v`.
  Tangent_vector tangent_part(const Intrinsic_point& p, const internal::Space_vector& v) const
  {
    internal::Direction best;
    double length = 0;
    const auto consider = [&](const Index h, const double angle, const double part) {
      if(part > length)
      {
        length = part;
        best = {h, angle};
      }
    };
    p.for_each_face(m_triangulation, [&](const Index h) {
      const internal::Face_in_space face = face_in_space(h);
      const internal::Plane_vector part = face.projection(v);
      const double angle = internal::angle_of(part);
      const double corner = p.is_vertex() ? m_frames.corner(h) : internal::straight_angle;
      if(p.is_in_face() || (angle >= 0 && angle <= corner))
        return consider(h, angle, std::hypot(part.x, part.y));
      consider(h, 0, part.x);
      consider(h, corner, p.is_vertex() ? internal::dot(v, face.side) : -part.x);
    });
    return length > 0 ? internal::tangent_vector(m_frames.angle(p, best), length)
                      : Tangent_vector();
  }

  // The face to the left of a halfedge, or that to its right, unfolded, if there is none.
  internal::Face_in_space face_in_space(const Index h) const
  {
    const auto point_map = internal::vertex_point_map(m_translation.mesh(), m_np);
    const auto way = [&](const Index from, const Index to) {
      return internal::unit_vector(internal::space_vector(
          get(point_map, m_translation.vertex(to)) - get(point_map, m_translation.vertex(from))));
    };
    const bool is_border = m_triangulation.is_border(h);
    const Index face = is_border ? m_triangulation.opposite(h) : h;
    const Index a = m_triangulation.source(h), b = m_triangulation.target(h);
    const Index c =
        m_triangulation.is_border(face) ? b : m_triangulation.target(m_triangulation.next(face));
    return {way(a, b), way(a, c), is_border};
  }

  const NamedParameters m_np;
  const std::size_t m_largest_number_of_faces; // that a walk visits
  const Intrinsic_triangulation m_triangulation;
  Mesh_translation<TriangleMesh, Index_map> m_translation;
  const internal::Tangent_frames m_frames;
};

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * walks straight ahead on the surface, from a point in a direction: a straightest geodesic
 * \cgalCite{ps-sgps-98}, which is the exponential map.
 *
 * The walk is straight across faces and edges. Through a vertex, it leaves the same angle on both
 * sides, half the angle of the vertex. It may cross itself, and is not a shortest path in general:
 * shortest paths pass around vertices with an angle less than \f$2\pi\f$, and bend at vertices with
 * a larger one.
 *
 * At the border, the walk ends, with one exception: through a border vertex where the angle on one
 * side is at least \f$\pi\f$, it goes on and leaves an angle of \f$\pi\f$ on the side with the
 * larger angle. So a walk along a straight border goes on along it.
 *
 * A walk that would miss a vertex ahead by less than \f$10^{-12}\f$ of the length of an edge goes
 * through the vertex. Through vertices on both sides of which it could go on, the end is
 * not a continuous function of the direction; elsewhere, it is accurate up to rounding, and the
 * same walk backward, from the end, in the direction opposite to that at the end, returns to the
 * start.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Point `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location`, or
 *         `Surface_point`
 * \tparam Vector `Tangent_vector`, or `%Vector_3` of the traits class
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param start the start
 * \param direction the direction, of any length but `0`. A vector in space is projected, see
 *        `Geodesic_tracer`; this needs points of vertices.
 * \param length the length of the walk, in the unit of the mesh
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `vertex_index_map`, `halfedge_index_map` and
 *           `geom_traits`, as for `approximate_geodesic_distances()`, and the one listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of faces that are visited. It ends walks that go
 *                           around a thin spike, or among edges of length zero, for too long.}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{`1000000`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the points, the direction at the end, the length, and whether the walk has met the
 *         border.
 *
 * \throws std::invalid_argument if the length is negative, infinite or NaN, if the direction has
 *         length `0` or is not finite, if `start` is not a point of the mesh, if the number of
 *         iterations is negative, if a face breaks the triangle inequality, and as
 *         `Intrinsic_triangulation` does.
 * \throws std::length_error if `tmesh` has too many halfedges for 32-bit indices.
 *
 * Reading the mesh takes \cgalBigO{n} time, and the walk time in proportion to the number of faces
 * that it crosses. For several walks, use `Geodesic_tracer`.
 *
 * \sa `logarithmic_map()`
 */
template <typename TriangleMesh,
          typename Point,
          typename Vector,
          typename NamedParameters = parameters::Default_named_parameters>
Geodesic_walk<TriangleMesh> trace_geodesic(const TriangleMesh& tmesh,
                                           const Point& start,
                                           const Vector& direction,
                                           const double length,
                                           const NamedParameters& np = parameters::default_values())
{
  return Geodesic_tracer<TriangleMesh, NamedParameters>(tmesh, np).trace(start, direction, length);
}

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * returns a vector after parallel transport along a path: its length, and its angle to the path,
 * stay the same in each face. Where the path turns, the vector does not.
 *
 * Around a vertex whose angles add up to \f$\theta\f$, it turns by \f$2\pi - \theta\f$ to the left.
 * Through a vertex, angles to the path are kept in the frame of the vertex, so that the direction
 * of a straightest geodesic is parallel along it.
 *
 * \tparam PointRange a model of `ConstRange` with one of the types of `start` in
 *         `trace_geodesic()` as value type
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param path the path: two consecutive points must lie in the same face, or on the same edge. It
 *        can be the points of a `Geodesic_walk`, or those of
 *        `Surface_mesh_shortest_path::shortest_path_surface_points_to_source_points()`.
 * \param vector the vector at the first point of the path: a `Tangent_vector`, or a `%Vector_3`
 * \param np named parameters as for `trace_geodesic()`
 *
 * \return the vector at the last point of the path, in its frame.
 *
 * \throws std::invalid_argument if the path has no points, if consecutive points have no face in
 *         common, if the vector is not finite, and as `trace_geodesic()` does.
 *
 * Reading the mesh takes \cgalBigO{n} time. For several paths, use `Geodesic_tracer`.
 */
template <typename TriangleMesh,
          typename PointRange,
          typename Vector,
          typename NamedParameters = parameters::Default_named_parameters>
Tangent_vector parallel_transport(const TriangleMesh& tmesh,
                                  const PointRange& path,
                                  const Vector& vector,
                                  const NamedParameters& np = parameters::default_values())
{
  return Geodesic_tracer<TriangleMesh, NamedParameters>(tmesh, np).transport(path, vector);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_TRACE_GEODESIC_H
