// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OTHER_SOURCES_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OTHER_SOURCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>

#include <type_traits>

namespace CGAL::Approximate_geodesics {

// Sources that the package Geodesic_constructions defines.

template <typename TriangleMesh>
struct Source_curve;

template <typename TriangleMesh>
struct Source_region;

namespace internal {

/*
 * How searches start from sources of a mesh that are not points. The header of a type of such
 * sources defines it for the type. It has the members
 * - `Read`, what a source is translated to; its member `distance` is the initial distance;
 * - `read(graph, translation, source)` and `read_all(graph, translation, sources)`, which translate
 *   a source, and one or a range of them to a `std::vector<Read>`;
 * - `of_point(source_point)`, which does so for a `Source_point`, to search from both kinds;
 * - `first_point(triangulation, read)`, an `Intrinsic_point` of the source;
 * - `attach<SurfaceSearch>(graph, all)`, which makes `Attached_sources` of a `std::vector<Read>`.
 */
template <typename TriangleMesh, typename Source>
struct Other_source;

template <typename TriangleMesh, typename Source>
constexpr bool is_other_source = is_defined<Other_source<TriangleMesh, Source>>;

// Whether `T` is such a source, or a range of them.
template <typename TriangleMesh, typename T>
constexpr bool are_other_sources =
    is_other_source<TriangleMesh, T> || is_other_source<TriangleMesh, Element_of_range<T>>;

template <typename TriangleMesh, typename T>
using Other_source_of =
    Other_source<TriangleMesh,
                 std::conditional_t<is_other_source<TriangleMesh, T>, T, Element_of_range<T>>>;

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OTHER_SOURCES_H
