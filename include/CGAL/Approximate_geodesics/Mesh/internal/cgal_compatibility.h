// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CGAL_COMPATIBILITY_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CGAL_COMPATIBILITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/version.h>

#include <variant>

#if CGAL_VERSION_NR < 1060001000
#include <boost/variant.hpp>
#endif

// Differences between the supported versions of CGAL, 5.5 to 6.1, except for named parameters: see
// named_parameters.h.

namespace CGAL::Approximate_geodesics::internal {

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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CGAL_COMPATIBILITY_H
