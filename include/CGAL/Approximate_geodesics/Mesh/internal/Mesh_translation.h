// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRANSLATION_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRANSLATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_vertices.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

template <typename T>
constexpr bool is_pair = false;

template <typename T, typename U>
constexpr bool is_pair<std::pair<T, U>> = true;

// Whether points are those of a kernel, which computes others from them.
template <typename Point, typename = void>
constexpr bool is_point_of_kernel = false;

template <typename Point>
constexpr bool
    is_point_of_kernel<Point,
                       std::void_t<typename Kernel_traits<Point>::Kernel::Construct_barycenter_3>> =
        true;

// Whether `T` is a point on the surface of a mesh, and not a range of them.
template <typename TriangleMesh, typename T>
constexpr bool is_surface_point =
    std::is_convertible_v<T, typename boost::graph_traits<TriangleMesh>::vertex_descriptor> ||
    std::is_same_v<T, Surface_point<TriangleMesh>> || is_pair<T>;

/*
 * Translates between points on the surface of a mesh and places on its triangulation.
 */
template <typename TriangleMesh, typename VertexIndexMap>
class Mesh_translation : public Mesh_vertices<TriangleMesh, VertexIndexMap>
{
  using Base = Mesh_vertices<TriangleMesh, VertexIndexMap>;
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Index = Intrinsic_triangulation::Index;

public:
  using Triangle_mesh = TriangleMesh;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  Mesh_translation(const TriangleMesh& tmesh,
                   VertexIndexMap vertex_index_map,
                   const Intrinsic_triangulation& triangulation)
    : Base(tmesh, std::move(vertex_index_map), triangulation)
  {
  }

  // ----- from the mesh to its triangulation

  Intrinsic_point place(const vertex_descriptor v) const
  {
    return Intrinsic_point::at_vertex(this->node(v));
  }

  Intrinsic_point place(const halfedge_descriptor h, const double t) const
  {
    if(h == Graph_traits::null_halfedge() || !is_in_range(h, num_halfedges(this->mesh())))
      reject("the halfedge is not one of the mesh");
    if(!(t >= 0 && t <= 1))
      reject("the part of the way along a halfedge is " + text_of(t) +
             "; it must be a number from 0 to 1");
    if(t < rounding || 1 - t < rounding)
      return place(t < rounding ? source(h, this->mesh()) : target(h, this->mesh()));
    return Intrinsic_point::on_edge(number(h), t);
  }

  template <typename FT>
  Intrinsic_point place(const face_descriptor f, const std::array<FT, 3>& coordinates) const
  {
    check(f);
    const std::array<double, 3> weights = checked(coordinates);
    const halfedge_descriptor h = halfedge(f, this->mesh());
    const std::array<halfedge_descriptor, 3> sides{h, next(h, this->mesh()), prev(h, this->mesh())};
    for(std::size_t i = 0; i < 3; ++i)
      if(weights[i] == 1)
        return place(source(sides[i], this->mesh()));
    const Index first = number(h);
    const std::array<Index, 3> numbers = this->triangulation().halfedges_of_face(first);
    for(std::size_t i = 0; i < 3; ++i)
      if(weights[(i + 2) % 3] == 0)
        return Intrinsic_point::on_edge(numbers[i], weights[(i + 1) % 3]);
    return Intrinsic_point::in_face(first, weights[1], weights[2]);
  }

  template <typename FT>
  Intrinsic_point place(const std::pair<face_descriptor, std::array<FT, 3>>& location) const
  {
    return place(location.first, location.second);
  }

  Intrinsic_point place(const std::pair<halfedge_descriptor, double>& point) const
  {
    return place(point.first, point.second);
  }

  Intrinsic_point place(const Surface_point<TriangleMesh>& point) const
  {
    return std::visit([this](const auto& p) { return this->place(p); }, point);
  }

  // ----- from the triangulation to the mesh

  // The halfedge of the mesh that has number `h` in the triangulation, which keeps their order.
  halfedge_descriptor mesh_halfedge(const Index h) const
  {
    const Index source = this->triangulation().source(h);
    halfedge_descriptor result = first_halfedge_from(this->vertex(source), this->mesh());
    for(Index i = this->triangulation().first_halfedge(source); i < h; ++i)
      result = counterclockwise(result, this->mesh());
    return result;
  }

  Face_location<TriangleMesh> face_location(const Intrinsic_point& place) const
  {
    const halfedge_descriptor h = mesh_halfedge(place.halfedge);
    const face_descriptor f = face(h, this->mesh());
    const halfedge_descriptor first = halfedge(f, this->mesh());
    const double rest = 1 - place.t - place.s;
    if(h == first)
      return {f, {rest, place.t, place.s}};
    if(h == next(first, this->mesh()))
      return {f, {place.s, rest, place.t}};
    return {f, {place.t, place.s, rest}};
  }

  Surface_point<TriangleMesh> surface_point(const Intrinsic_point& place) const
  {
    if(place.is_vertex())
      return this->vertex(place.vertex);
    if(place.is_on_edge())
      return std::make_pair(mesh_halfedge(place.halfedge), place.t);
    return face_location(place);
  }

  template <typename VertexPointMap>
  auto point_of_vertex(const Intrinsic_point& p, const VertexPointMap& point_map) const
  {
    return get(point_map, this->vertex(p.vertex));
  }

  template <typename VertexPointMap, typename Traits>
  auto point(const Intrinsic_point& p, const VertexPointMap& point_map, const Traits& traits) const
  {
    using Result = std::decay_t<decltype(point_of_vertex(p, point_map))>;
    using FT = typename Traits::FT;
    if(p.is_vertex())
      return Result(point_of_vertex(p, point_map));
    const auto barycenter = traits.construct_barycenter_3_object();
    const Intrinsic_triangulation& t = this->triangulation();
    const auto& source = get(point_map, this->vertex(t.source(p.halfedge)));
    const auto& target = get(point_map, this->vertex(t.target(p.halfedge)));
    if(p.is_on_edge())
      return Result(barycenter(target, FT(p.t), source));
    const auto& third = get(point_map, this->vertex(t.target(t.next(p.halfedge))));
    return Result(barycenter(target, FT(p.t), third, FT(p.s), source));
  }

  // A function that gives the positions of vertices relative to the first one: the origin may be
  // far away from all of them.
  template <typename VertexPointMap>
  auto position_of_vertex(const VertexPointMap& point_map) const
  {
    return [this, &point_map](const Index v) -> std::array<double, 3> {
      const auto way = get(point_map, this->vertex(v)) - get(point_map, this->vertex(0));
      return {CGAL::to_double(way.x()), CGAL::to_double(way.y()), CGAL::to_double(way.z())};
    };
  }

private:
  static constexpr double rounding = 1e-15; // of barycentric coordinates

  void check(const face_descriptor f) const
  {
    const bool may_be_face =
        f != Graph_traits::null_face() && is_in_range(f, num_faces(this->mesh()));
    const halfedge_descriptor h =
        may_be_face ? halfedge(f, this->mesh()) : Graph_traits::null_halfedge();
    if(h == Graph_traits::null_halfedge() || face(h, this->mesh()) != f) // or was removed
      reject("the face is not one of the mesh");
  }

  // Whether a descriptor can be one of so many, if it is a number.
  template <typename Descriptor, typename Size>
  static bool is_in_range([[maybe_unused]] const Descriptor d, [[maybe_unused]] const Size size)
  {
    if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
      return static_cast<std::size_t>(d) < static_cast<std::size_t>(size);
    else
      return true;
  }

  // Barycentric coordinates, without what can only be rounding errors.
  template <typename FT>
  static std::array<double, 3> checked(const std::array<FT, 3>& coordinates)
  {
    constexpr double tolerance = 1e-9;
    std::array<double, 3> result{CGAL::to_double(coordinates[0]), CGAL::to_double(coordinates[1]),
                                 CGAL::to_double(coordinates[2])};
    const bool are_valid = result[0] >= -tolerance && result[1] >= -tolerance &&
                           result[2] >= -tolerance &&
                           std::abs(result[0] + result[1] + result[2] - 1) <= tolerance;
    if(!are_valid)
      reject("barycentric coordinates are " + text_of(result[0]) + ", " + text_of(result[1]) +
             ", " + text_of(result[2]) + "; they must not be negative, and their sum must be 1");
    for(double& weight : result)
      weight = weight < rounding ? 0 : weight;
    const double sum = result[0] + result[1] + result[2];
    for(double& weight : result)
      weight /= sum;
    return result;
  }

  // The number of a halfedge in the triangulation. It is counted around the vertex of its face that
  // has the fewest neighbors.
  Index number(const halfedge_descriptor h) const
  {
    const Intrinsic_triangulation& t = this->triangulation();
    if(is_border(h, this->mesh()))
      return number_around_source(h);
    std::array<halfedge_descriptor, 3> sides{h, prev(h, this->mesh()), next(h, this->mesh())};
    std::size_t best = 0;
    for(const std::size_t i : {std::size_t(1), std::size_t(2)})
      if(degree(sides[i]) < degree(sides[best]))
        best = i;
    Index result = number_around_source(sides[best]);
    for(; best > 0; --best)
      result = t.next(result);
    return result;
  }

  Index degree(const halfedge_descriptor h) const
  {
    return this->triangulation().degree(this->node(source(h, this->mesh())));
  }

  Index number_around_source(const halfedge_descriptor h) const
  {
    const vertex_descriptor v = source(h, this->mesh());
    Index result = this->triangulation().first_halfedge(this->node(v));
    for(halfedge_descriptor g = first_halfedge_from(v, this->mesh()); g != h;
        g = counterclockwise(g, this->mesh()))
      ++result;
    return result;
  }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRANSLATION_H
