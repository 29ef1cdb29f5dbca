// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_WRITE_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_WRITE_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Writes the points of a path, from its end to its start. If there are only vertices among them,
// they can be of any type.
template <bool HasPointsBetweenVertices,
          typename MeshPlaces,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters>
void write_points(const Path& path,
                  const MeshPlaces& places,
                  const TriangleMesh& tmesh,
                  OutputIterator points,
                  const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto point_map = vertex_point_map(tmesh, np);
  for(auto it = path.points.rbegin(); it != path.points.rend(); ++it)
    if constexpr(HasPointsBetweenVertices)
    {
      using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
      *points++ = places.point(
          *it, point_map, choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits)));
    }
    else
      *points++ = places.point_of_vertex(*it, point_map);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_WRITE_POINTS_H
