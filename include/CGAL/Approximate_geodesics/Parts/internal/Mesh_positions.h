// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_POSITIONS_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_POSITIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_place.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

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

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_POSITIONS_H
