// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_AABB_TRAITS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_AABB_TRAITS_H

#include <CGAL/license/Approximate_geodesics.h>

// The traits of CGAL's AABB tree, by the name that they have since CGAL 6, which deprecates the old
// name and its header. Inside CGAL, this file would be unnecessary.

#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>

namespace CGAL {

template <typename GeomTraits, typename AABBPrimitive, typename BboxMap = Default>
using AABB_traits_3 = AABB_traits<GeomTraits, AABBPrimitive, BboxMap>;

} // namespace CGAL

#endif

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_AABB_TRAITS_H
