// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/Bucket_statistics.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>
#include <boost/type_traits/is_detected_convertible.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// What models of GeodesicGraph and GeodesicPriorityQueue may have, but need not.

template <typename Graph>
using Maximum_degree = decltype(std::declval<const Graph&>().maximum_degree());

template <typename Graph>
using Prefetch =
    decltype(std::declval<const Graph&>().prefetch(std::declval<typename Graph::Node>()));

template <typename Graph>
using Needs_expansion_history = std::bool_constant<Graph::needs_expansion_history>;

template <typename Graph>
using Arrival_at_node = typename Graph::Arrival;

template <typename Graph>
using Loop_of_threads = decltype(std::declval<const Graph&>().loop());

template <typename Graph>
using Nodes_at_a_time = std::integral_constant<std::size_t, Graph::nodes_at_a_time>;

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

// Whether a graph asks which nodes were expanded before.
template <typename Graph>
constexpr bool needs_expansion_history =
    boost::detected_or_t<std::false_type, Needs_expansion_history, Graph>::value;

// Whether a graph finds its arcs with the help of upper bounds.
template <typename Graph>
constexpr bool needs_bounds = boost::is_detected_v<Arrival_at_node, Graph>;

// How paths arrive, for graphs that do not tell.
struct No_arrival
{
};

template <typename Graph>
using Arrival_of = boost::detected_or_t<No_arrival, Arrival_at_node, Graph>;

// Whether a graph may have threads that look for arcs at the same time.
template <typename Graph>
constexpr bool may_have_threads = boost::is_detected_v<Loop_of_threads, Graph>;

// Whether a graph with threads may divide the arcs of a node among them.
template <typename Graph>
constexpr bool has_parts = may_have_threads<Graph>&& needs_bounds<Graph>;

// Whether a graph finds the arcs of several nodes together.
template <typename Graph>
constexpr bool expands_together = boost::is_detected_v<Nodes_at_a_time, Graph>;

// How many nodes are expanded one after the other, by one thread.
template <typename Graph>
constexpr std::size_t nodes_at_a_time =
    boost::detected_or_t<std::integral_constant<std::size_t, 8>, Nodes_at_a_time, Graph>::value;

// Whether a queue can hand out batches that are larger than usual.
template <typename Queue>
constexpr bool has_rounds = boost::is_detected_v<Extract_round, Queue>;

// Whether a queue counts comparisons.
template <typename Queue>
constexpr bool counts_comparisons =
    boost::is_detected_convertible_v<Bucket_statistics, Statistics, Queue>;

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_OPTIONAL_MEMBERS_H
