// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HAS_MAXIMUM_DEGREE_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HAS_MAXIMUM_DEGREE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Whether a graph knows how many arcs a node has at most.
template <typename Graph, typename = void>
constexpr bool has_maximum_degree = false;

template <typename Graph>
constexpr bool has_maximum_degree<
    Graph,
    std::enable_if_t<std::is_convertible_v<decltype(std::declval<const Graph&>().maximum_degree()),
                                           std::size_t>>> = true;

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HAS_MAXIMUM_DEGREE_H
