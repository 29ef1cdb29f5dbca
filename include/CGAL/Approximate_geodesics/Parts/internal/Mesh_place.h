// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

// A point of the surface of a mesh that has not been read yet. Construction fails for points that
// may be invalid; reading the whole mesh then diagnoses the error.

namespace CGAL::Approximate_geodesics::internal {

template <typename TriangleMesh>
struct Mesh_place
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;

  // The vertices, with weights that add up to 1: one, two on an edge, or three in a face; the last
  // one is repeated with weight 0.
  std::array<Vertex, 3> corner;
  std::array<double, 3> weight;
  std::size_t number_of_corners;

  // A halfedge whose face contains the point; null for an isolated vertex.
  typename Graph_traits::halfedge_descriptor halfedge;
};

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
checked_place(const TriangleMesh& tmesh,
              const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  if(!may_be_element(v, Graph_traits::null_vertex(), num_vertices(tmesh), tmesh))
    return std::nullopt;
  const auto h = halfedge(v, tmesh);
  const bool is_isolated = h == Graph_traits::null_halfedge();
  const auto side = is_isolated ? h : side_of_edge(h, tmesh);
  if(!is_isolated && (side == Graph_traits::null_halfedge() || target(h, tmesh) != v))
    return std::nullopt;
  return Mesh_place<TriangleMesh>{{v, v, v}, {1, 0, 0}, 1, side};
}

template <typename TriangleMesh>
std::optional<Mesh_place<TriangleMesh>> checked_place(
    const TriangleMesh& tmesh,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& point)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const auto [h, t] = point;
  check_point(h, t, tmesh);
  const auto side = side_of_edge(h, tmesh);
  if(side == Graph_traits::null_halfedge())
    return std::nullopt;
  const auto v = source(h, tmesh), w = target(h, tmesh);
  return Mesh_place<TriangleMesh>{{v, w, w}, {1 - t, t, 0}, 2, side};
}

template <typename TriangleMesh, typename FT>
std::optional<Mesh_place<TriangleMesh>>
checked_place(const TriangleMesh& tmesh,
              const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                              std::array<FT, 3>>& location)
{
  const auto& [f, coordinates] = location;
  const std::array<double, 3> weights = checked_weights(f, coordinates, tmesh);
  if(!is_linked_triangle(f, tmesh))
    return std::nullopt;
  const auto h = halfedge(f, tmesh), g = next(h, tmesh);
  return Mesh_place<TriangleMesh>{
      {source(h, tmesh), source(g, tmesh), source(next(g, tmesh), tmesh)}, weights, 3, h};
}

template <typename TriangleMesh>
std::optional<Mesh_place<TriangleMesh>> checked_place(const TriangleMesh& tmesh,
                                                      const Surface_point<TriangleMesh>& point)
{
  return std::visit([&](const auto& p) { return checked_place(tmesh, p); }, point);
}

template <typename TriangleMesh, typename Point>
std::optional<Mesh_place<TriangleMesh>> mesh_place(const TriangleMesh& tmesh, const Point& point)
{
  try
  {
    return checked_place(tmesh, point);
  }
  catch(const std::invalid_argument&)
  {
    return std::nullopt;
  }
}

/*
 * Positions of vertices and other points of a mesh, relative to one of the vertices, which avoids
 * cancellation if the origin is far away.
 */
template <typename TriangleMesh, typename NamedParameters>
class Mesh_positions
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point_map = decltype(vertex_point_map(std::declval<const TriangleMesh&>(),
                                              std::declval<const NamedParameters&>()));
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

public:
  Mesh_positions(const TriangleMesh& tmesh,
                 const NamedParameters& np,
                 const vertex_descriptor origin)
    : m_point_map(vertex_point_map(tmesh, np)),
      m_traits(parameters::choose_parameter<Traits>(
          parameters::get_parameter(np, internal_np::geom_traits))),
      m_origin(double_point(get(m_point_map, origin), m_traits))
  {
  }

  Space_vector operator()(const vertex_descriptor v) const
  {
    return difference(double_point(get(m_point_map, v), m_traits), m_origin);
  }

  Space_vector operator()(const Mesh_place<TriangleMesh>& place) const
  {
    const Space_vector first = (*this)(place.corner[0]);
    Space_vector result = first;
    for(std::size_t i = 1; i < place.number_of_corners; ++i)
      result =
          linear_combination(result, place.weight[i], difference((*this)(place.corner[i]), first));
    return result;
  }

private:
  Point_map m_point_map;
  Traits m_traits;
  Space_vector m_origin;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PLACE_H
