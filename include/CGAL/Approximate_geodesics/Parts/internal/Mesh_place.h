// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

// A point of the surface of a mesh that has not been read yet. Construction fails for points that
// may be invalid; reading the whole mesh then diagnoses the error.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

template <typename TriangleMesh>
struct Mesh_place
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;

  // The vertices, with weights that add up to 1: one, two on an edge, or three in a face.
  std::array<Vertex, 3> corner = {Vertex(), Vertex(), Vertex()};
  std::array<double, 3> weight{};
  std::size_t number_of_corners = 0;

  // A halfedge whose face contains the point; null for an isolated vertex.
  typename Graph_traits::halfedge_descriptor halfedge = Graph_traits::null_halfedge();
};

template <typename TriangleMesh, typename Descriptor, typename = void>
constexpr bool tells_what_is_removed = false;

template <typename TriangleMesh, typename Descriptor>
constexpr bool
    tells_what_is_removed<TriangleMesh,
                          Descriptor,
                          std::void_t<decltype(std::declval<const TriangleMesh&>().is_removed(
                              std::declval<Descriptor>()))>> = true;

// Whether a descriptor is in range and not marked as removed, as far as the mesh type can tell.
template <typename TriangleMesh, typename Descriptor, typename Size>
bool may_be_element(const Descriptor d, const Size size, const TriangleMesh& tmesh)
{
  if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
    if(static_cast<std::size_t>(d) >= static_cast<std::size_t>(size))
      return false;
  if constexpr(tells_what_is_removed<TriangleMesh, Descriptor>)
    return !tmesh.is_removed(d);
  else
    return true;
}

// Returns a halfedge of the edge of `h` with a face to its left, or a null halfedge.
template <typename TriangleMesh>
auto side_of_edge(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                  const TriangleMesh& tmesh)
{
  if(!is_border(h, tmesh))
    return h;
  const auto g = opposite(h, tmesh);
  return is_border(g, tmesh) ? boost::graph_traits<TriangleMesh>::null_halfedge() : g;
}

template <typename TriangleMesh>
std::optional<Mesh_place<TriangleMesh>>
mesh_place(const TriangleMesh& tmesh,
           const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  if(v == Graph_traits::null_vertex() || !may_be_element(v, num_vertices(tmesh), tmesh))
    return std::nullopt;
  Mesh_place<TriangleMesh> result;
  result.corner[0] = v;
  result.weight[0] = 1;
  result.number_of_corners = 1;
  const auto h = halfedge(v, tmesh);
  if(h != Graph_traits::null_halfedge())
  {
    result.halfedge = side_of_edge(h, tmesh);
    if(result.halfedge == Graph_traits::null_halfedge() || target(h, tmesh) != v)
      return std::nullopt;
  }
  return result;
}

template <typename TriangleMesh>
std::optional<Mesh_place<TriangleMesh>> mesh_place(
    const TriangleMesh& tmesh,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& point)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const auto [h, t] = point;
  if(h == Graph_traits::null_halfedge() || !may_be_element(h, num_halfedges(tmesh), tmesh) ||
     !(t >= 0 && t <= 1))
    return std::nullopt;
  Mesh_place<TriangleMesh> result;
  result.halfedge = side_of_edge(h, tmesh);
  if(result.halfedge == Graph_traits::null_halfedge())
    return std::nullopt;
  result.corner = {source(h, tmesh), target(h, tmesh), Graph_traits::null_vertex()};
  result.weight = {1 - t, t, 0};
  result.number_of_corners = 2;
  return result;
}

template <typename TriangleMesh, typename FT>
std::optional<Mesh_place<TriangleMesh>>
mesh_place(const TriangleMesh& tmesh,
           const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                           std::array<FT, 3>>& location)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const auto f = location.first;
  if(f == Graph_traits::null_face() || !may_be_element(f, num_faces(tmesh), tmesh))
    return std::nullopt;
  auto h = halfedge(f, tmesh);
  if(h == Graph_traits::null_halfedge() || face(h, tmesh) != f)
    return std::nullopt;
  Mesh_place<TriangleMesh> result;
  result.halfedge = h;
  result.number_of_corners = 3;
  double sum = 0;
  for(std::size_t i = 0; i < 3; ++i, h = next(h, tmesh))
  {
    result.corner[i] = source(h, tmesh);
    result.weight[i] = CGAL::to_double(location.second[i]);
    sum += result.weight[i];
    if(!(result.weight[i] >= 0))
      return std::nullopt;
  }
  constexpr double tolerance = 1e-9;
  if(!(std::abs(sum - 1) <= tolerance))
    return std::nullopt;
  for(double& weight : result.weight)
    weight /= sum;
  return result;
}

template <typename TriangleMesh>
std::optional<Mesh_place<TriangleMesh>> mesh_place(const TriangleMesh& tmesh,
                                                   const Surface_point<TriangleMesh>& point)
{
  return std::visit([&](const auto& p) { return mesh_place(tmesh, p); }, point);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H
