// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Shortens a path, if the named parameters ask for it. Returns whether they do.
template <typename NamedParameters>
bool straighten_if_wanted([[maybe_unused]] const Intrinsic_triangulation& triangulation,
                          [[maybe_unused]] const NamedParameters& np,
                          [[maybe_unused]] Path& path)
{
  if constexpr(is_given<NamedParameters, internal_np::straighten_t>)
    if(parameters::get_parameter(np, internal_np::straighten))
    {
      if(triangulation.has_weights())
        reject("paths on weighted faces cannot be straightened: cheapest ones are not straight");
      Path straight = Path_straightener(triangulation).shortened(path);
      if(straight.length < path.length)
        path = std::move(straight);
      return true;
    }
  return false;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_STRAIGHTEN_H
