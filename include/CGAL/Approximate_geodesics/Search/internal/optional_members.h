// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/Bucket_statistics.h>

#include <boost/type_traits/is_detected.hpp>
#include <boost/type_traits/is_detected_convertible.hpp>

#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// What models of GeodesicGraph and GeodesicPriorityQueue may have, but need not.

template <typename Graph>
using Maximum_degree = decltype(std::declval<const Graph&>().maximum_degree());

template <typename Graph>
using Prefetch =
    decltype(std::declval<const Graph&>().prefetch(std::declval<typename Graph::Node>()));

template <typename Queue>
using Statistics = decltype(std::declval<const Queue&>().statistics());

template <typename Queue>
using Extract_round = decltype(std::declval<Queue&>().extract_round(std::size_t(1)));

// Whether a graph knows how many arcs a node has at most.
template <typename Graph>
constexpr bool has_maximum_degree =
    boost::is_detected_convertible_v<std::size_t, Maximum_degree, Graph>;

// Whether a graph wants to be told which nodes will be expanded soon.
template <typename Graph>
constexpr bool has_prefetch = boost::is_detected_v<Prefetch, Graph>;

// Whether a queue can hand out batches that are larger than usual.
template <typename Queue>
constexpr bool has_rounds = boost::is_detected_v<Extract_round, Queue>;

// Whether a queue counts comparisons.
template <typename Queue>
constexpr bool counts_comparisons =
    boost::is_detected_convertible_v<Bucket_statistics, Statistics, Queue>;

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H
