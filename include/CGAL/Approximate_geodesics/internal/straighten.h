// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_STRAIGHTEN_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_STRAIGHTEN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/Path.h>
#include <CGAL/Approximate_geodesics/internal/Straightening.h>
#include <CGAL/Approximate_geodesics/internal/messages.h>
#include <CGAL/Approximate_geodesics/internal/named_parameters.h>

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
      Path straight = Straightening(triangulation).shortened(path);
      if(straight.length < path.length)
        path = std::move(straight);
      return true;
    }
  return false;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_STRAIGHTEN_H
