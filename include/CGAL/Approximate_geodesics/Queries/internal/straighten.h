// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Straightens a path if the named parameters request it.
template <typename NamedParameters>
void straighten_if_wanted([[maybe_unused]] const Intrinsic_triangulation& triangulation,
                          [[maybe_unused]] const NamedParameters& np,
                          [[maybe_unused]] Path& path)
{
  if constexpr(is_given<NamedParameters, internal_np::straighten_t>)
    if(parameters::get_parameter(np, internal_np::straighten))
    {
      if(triangulation.has_weights() || triangulation.has_directional_costs())
        reject("paths on weighted faces cannot be straightened: cheapest paths are not straight");
      Path straight = Path_straightener(triangulation).shortened(path);
      if(straight.length < path.length)
        path = std::move(straight);
    }
}

// Returns the path from `point` to its nearest source in a `Mesh_search`.
template <typename MeshSearch, typename NamedParameters>
Path find_path(const MeshSearch& search, const Intrinsic_point& point, const NamedParameters& np)
{
  Path result = search.search().find_path(point);
  straighten_if_wanted(search.search().graph().triangulation(), np, result);
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H
