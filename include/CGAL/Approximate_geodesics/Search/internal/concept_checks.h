// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONCEPT_CHECKS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONCEPT_CHECKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <boost/type_traits/is_detected.hpp>
#include <boost/type_traits/is_detected_convertible.hpp>
#include <boost/type_traits/is_detected_exact.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Checks that report a missing member of a graph or a queue in one line.

// Arguments that convert only to integers, or only to floating-point numbers: a node is not a
// distance.
template <template <typename> class Is>
struct Some_number
{
  template <typename T, typename = std::enable_if_t<Is<T>::value>>
  operator T() const;
};

using Some_node = Some_number<std::is_integral>;
using Some_key = Some_number<std::is_floating_point>;

struct Some_function
{
  template <typename... Arguments>
  void operator()(const Arguments&...) const
  {
  }
};

template <typename Graph>
struct Check_graph
{
  template <typename G>
  using Node = typename G::Node;
  template <typename G>
  using Number_of_nodes = decltype(std::declval<const G&>().number_of_nodes());
  template <typename G>
  using Unit = decltype(std::declval<const G&>().unit());
  template <typename G>
  using Lengths = decltype(std::declval<const G&>().arc_lengths());
  template <typename G>
  using For_each_arc = decltype(std::declval<const G&>().for_each_arc(
      std::declval<Labels::Node>(), std::declval<const Labels&>(), std::declval<Some_function>()));

  static_assert(boost::is_detected_exact_v<Labels::Node, Node, Graph>,
                "A model of GeodesicGraph must have a type `Node`, which is `std::uint32_t`.");
  static_assert(boost::is_detected_convertible_v<std::size_t, Number_of_nodes, Graph>,
                "A model of GeodesicGraph must have `std::size_t number_of_nodes() const`.");
  static_assert(boost::is_detected_convertible_v<double, Unit, Graph>,
                "A model of GeodesicGraph must have `double unit() const`.");
  static_assert(boost::is_detected_convertible_v<Arc_lengths, Lengths, Graph>,
                "A model of GeodesicGraph must have `Arc_lengths arc_lengths() const`.");
  static_assert(
      boost::is_detected_v<Own_run, Graph> || boost::is_detected_v<For_each_arc, Graph>,
      "A model of GeodesicGraph must have `for_each_arc(Node node, const Labels& labels, F f) "
      "const`, for all types `Labels` and `F`.");

  static constexpr bool is_done = true;
};

// The types of the two parts of an entry, in the order in which the search unpacks it.
template <typename Entry>
auto parts_of(const Entry& entry)
{
  const auto& [key, node] = entry;
  return std::make_pair(key, node);
}

template <typename Queue>
struct Check_queue
{
  template <typename Q>
  using Push = decltype(std::declval<Q&>().push(Some_node(), Some_key()));
  template <typename Q>
  using Batch = decltype(std::declval<Q&>().extract_min());
  template <typename Q>
  using Size_of_batch = decltype(std::declval<const Batch<Q>&>().size());
  template <typename Q>
  using Begin_of_batch = decltype(*std::declval<const Batch<Q>&>().begin());
  template <typename Q>
  using End_of_batch = decltype(*std::declval<const Batch<Q>&>().end());
  template <typename Q>
  using Parts_of_entry = decltype(parts_of(std::declval<Begin_of_batch<Q>>()));
  template <typename Q>
  using Is_empty = decltype(std::declval<const Q&>().is_empty());
  template <typename Q>
  using Is_final = decltype(std::declval<const Q&>().is_final(Some_key()));
  template <typename Q>
  using For_each_node = decltype(std::declval<const Q&>().for_each_node(Some_function()));
  template <typename Q>
  using Clear = decltype(std::declval<Q&>().clear());
  template <typename Q>
  using Memory = decltype(std::declval<const Q&>().memory());

  static_assert(
      std::is_constructible_v<Queue, std::size_t, const Arc_lengths&>,
      "A model of GeodesicPriorityQueue must have a constructor for arguments of the types "
      "`std::size_t` and `const Arc_lengths&`.");
  static_assert(boost::is_detected_v<Push, Queue>,
                "A model of GeodesicPriorityQueue must have `void push(Node node, Key key)`, where "
                "`Node` is `std::uint32_t`, and `Key` is `double`.");
  static_assert(boost::is_detected_v<Batch, Queue>,
                "A model of GeodesicPriorityQueue must have `Batch extract_min()`.");
  static_assert(boost::is_detected_convertible_v<std::size_t, Size_of_batch, Queue> &&
                    boost::is_detected_v<Begin_of_batch, Queue> &&
                    boost::is_detected_v<End_of_batch, Queue>,
                "The `Batch` of a model of GeodesicPriorityQueue must have `begin()`, `end()` and "
                "`size()`.");
  static_assert(
      boost::is_detected_exact_v<std::pair<double, Labels::Node>, Parts_of_entry, Queue>,
      "An `Entry` of a model of GeodesicPriorityQueue must have two parts: first the key, a "
      "`double`, then the node, a `std::uint32_t`.");
  static_assert(boost::is_detected_convertible_v<bool, Is_empty, Queue>,
                "A model of GeodesicPriorityQueue must have `bool is_empty() const`.");
  static_assert(
      boost::is_detected_convertible_v<bool, Is_final, Queue>,
      "A model of GeodesicPriorityQueue must have `bool is_final(Key key) const`, where `Key` "
      "is `double`.");
  static_assert(
      boost::is_detected_v<For_each_node, Queue>,
      "A model of GeodesicPriorityQueue must have `for_each_node(F f) const`, for all types "
      "`F`.");
  static_assert(boost::is_detected_v<Clear, Queue>,
                "A model of GeodesicPriorityQueue must have `void clear()`.");
  static_assert(boost::is_detected_convertible_v<std::size_t, Memory, Queue>,
                "A model of GeodesicPriorityQueue must have `std::size_t memory() const`.");

  static constexpr bool is_done = true;
};

// Optional members of models of GeodesicGraph and GeodesicPriorityQueue.

template <typename Graph>
using Maximum_degree = decltype(std::declval<const Graph&>().maximum_degree());

template <typename Graph>
using Prefetch =
    decltype(std::declval<const Graph&>().prefetch(std::declval<typename Graph::Node>()));

template <typename Queue>
using Statistics = decltype(std::declval<const Queue&>().statistics());

template <typename Queue>
using Extract_round = decltype(std::declval<Queue&>().extract_round(std::size_t(1)));

// Whether a graph has an upper bound of the number of arcs of a node.
template <typename Graph>
constexpr bool has_maximum_degree =
    boost::is_detected_convertible_v<std::size_t, Maximum_degree, Graph>;

// Whether a graph prefetches the data of nodes that will be expanded soon.
template <typename Graph>
constexpr bool has_prefetch = boost::is_detected_v<Prefetch, Graph>;

// Whether a queue can hand out batches that are larger than usual.
template <typename Queue>
constexpr bool has_rounds = boost::is_detected_v<Extract_round, Queue>;

// Whether a queue counts comparisons.
template <typename Queue>
constexpr bool counts_comparisons =
    boost::is_detected_convertible_v<Bucket_statistics, Statistics, Queue>;

// The heuristic of Dijkstra's algorithm: the lower bound of the remaining distance is zero.
struct No_heuristic
{
  template <typename Node>
  constexpr double operator()(Node /* node */) const
  {
    return 0;
  }
};

template <typename Heuristic>
constexpr bool is_heuristic = !std::is_same_v<Heuristic, No_heuristic>;

// Whether an entry is stale: its key is larger than the one that its node would be entered with
// now, at this distance. With a heuristic, both keys were rounded, and the first one may have been
// raised; then small differences do not count, as it does no harm to expand a stale entry.
template <typename Node, typename Heuristic>
bool is_stale(const double key, const double distance, const Node node, const Heuristic& heuristic)
{
  if constexpr(is_heuristic<Heuristic>)
  {
    constexpr double rounding = 1e-6;
    return distance + heuristic(node) < key * (1 - rounding);
  }
  else
    return distance < key;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONCEPT_CHECKS_H
