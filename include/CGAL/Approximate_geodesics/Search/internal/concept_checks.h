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

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Checks that report a missing member of a graph or a queue in one line. Conditions have names, as
// compilers quote what they assert.

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

inline constexpr auto some_function = [](const auto&... /* arguments */) {};

template <typename Graph>
struct Check_graph
{
  static constexpr bool has_node = is_valid<const Graph&, Labels::Node*>(
      [](auto& g) -> typename std::decay_t<decltype(g)>::Node* {});
  static constexpr bool has_size =
      is_valid<const Graph&, std::size_t>([](auto& g) -> decltype(g.number_of_nodes()) {});
  static constexpr bool has_unit =
      is_valid<const Graph&, double>([](auto& g) -> decltype(g.unit()) {});
  static constexpr bool has_lengths =
      is_valid<const Graph&, Arc_lengths>([](auto& g) -> decltype(g.arc_lengths()) {});
  static constexpr bool has_arcs = is_valid<const Graph&>(
      [](auto& g) -> decltype(g.for_each_arc(
                      Labels::Node(), std::declval<const Labels&>(), some_function)) {});

  static_assert(has_node,
                "A model of GeodesicGraph must have a type `Node`, which is `std::uint32_t`.");
  static_assert(has_size,
                "A model of GeodesicGraph must have `std::size_t number_of_nodes() const`.");
  static_assert(has_unit, "A model of GeodesicGraph must have `double unit() const`.");
  static_assert(has_lengths,
                "A model of GeodesicGraph must have `Arc_lengths arc_lengths() const`.");
  static_assert(
      has_arcs || has_own_run<Graph>,
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
  using Part = std::pair<double, Labels::Node>;
  static constexpr bool can_push =
      is_valid<Queue&>([](auto& q) -> decltype(q.push(Some_node(), Some_key())) {});
  static constexpr bool can_extract = is_valid<Queue&>([](auto& q) -> decltype(q.extract_min()) {});
  static constexpr bool extracts_range =
      is_valid<Queue&, std::size_t>([](auto& q) -> decltype(q.extract_min().size()) {}) &&
      is_valid<Queue&>([](auto& q) -> decltype(*q.extract_min().begin()) {}) &&
      is_valid<Queue&>([](auto& q) -> decltype(*q.extract_min().end()) {});
  static constexpr bool extracts_entries =
      is_valid<Queue&, Part*>([](auto& q) -> decltype(parts_of(*q.extract_min().begin()))* {});
  static constexpr bool has_emptiness =
      is_valid<const Queue&, bool>([](auto& q) -> decltype(q.is_empty()) {});
  static constexpr bool has_finality =
      is_valid<const Queue&, bool>([](auto& q) -> decltype(q.is_final(Some_key())) {});
  static constexpr bool lists_nodes =
      is_valid<const Queue&>([](auto& q) -> decltype(q.for_each_node(some_function)) {});
  static constexpr bool can_clear = is_valid<Queue&>([](auto& q) -> decltype(q.clear()) {});
  static constexpr bool has_memory =
      is_valid<const Queue&, std::size_t>([](auto& q) -> decltype(q.memory()) {});

  static_assert(
      std::is_constructible_v<Queue, std::size_t, const Arc_lengths&>,
      "A model of GeodesicPriorityQueue must have a constructor for arguments of the types "
      "`std::size_t` and `const Arc_lengths&`.");
  static_assert(can_push,
                "A model of GeodesicPriorityQueue must have `void push(Node node, Key key)`, where "
                "`Node` is `std::uint32_t`, and `Key` is `double`.");
  static_assert(can_extract, "A model of GeodesicPriorityQueue must have `Batch extract_min()`.");
  static_assert(extracts_range,
                "The `Batch` of a model of GeodesicPriorityQueue must have `begin()`, `end()` and "
                "`size()`.");
  static_assert(
      extracts_entries,
      "An `Entry` of a model of GeodesicPriorityQueue must have two parts: first the key, a "
      "`double`, then the node, a `std::uint32_t`.");
  static_assert(has_emptiness,
                "A model of GeodesicPriorityQueue must have `bool is_empty() const`.");
  static_assert(
      has_finality,
      "A model of GeodesicPriorityQueue must have `bool is_final(Key key) const`, where `Key` "
      "is `double`.");
  static_assert(
      lists_nodes,
      "A model of GeodesicPriorityQueue must have `for_each_node(F f) const`, for all types "
      "`F`.");
  static_assert(can_clear, "A model of GeodesicPriorityQueue must have `void clear()`.");
  static_assert(has_memory,
                "A model of GeodesicPriorityQueue must have `std::size_t memory() const`.");
  static constexpr bool is_done = true;
};

// Optional members of models of GeodesicGraph and GeodesicPriorityQueue.

// Whether a graph has an upper bound of the number of arcs of a node.
template <typename Graph>
constexpr bool has_maximum_degree =
    is_valid<const Graph&, std::size_t>([](auto& g) -> decltype(g.maximum_degree()) {});

// Whether a graph prefetches the data of nodes that will be expanded soon.
template <typename Graph>
constexpr bool
    has_prefetch = is_valid<const Graph&>([](auto& g) -> decltype(g.prefetch(Labels::Node())) {});

// Whether a queue can hand out batches that are larger than usual.
template <typename Queue>
constexpr bool
    has_rounds = is_valid<Queue&>([](auto& q) -> decltype(q.extract_round(std::size_t(1))) {});

// Whether a queue, which does not order entries of similar keys, can do so on request.
template <typename Queue>
constexpr bool can_keep_order = is_valid<Queue&>([](auto& q) -> decltype(q.keep_order()) {});

// Whether a queue counts comparisons.
template <typename Queue>
constexpr bool counts_comparisons =
    is_valid<const Queue&, Bucket_statistics>([](auto& q) -> decltype(q.statistics()) {});

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

// Whether the keys with a heuristic are so nearly equal that their order matters.
template <typename Heuristic>
constexpr bool needs_order = is_valid<Heuristic&, std::true_type>(
    [](auto& h) -> std::bool_constant<std::decay_t<decltype(h)>::needs_order> {});

// Whether a key is larger than the one that its node would be entered with now, at this distance.
// With a heuristic, both were rounded; then small differences do not count, as it does no harm to
// expand a node again. The heuristic may tell how much keys may decrease along a path, apart from
// relative differences.
template <typename Node, typename Heuristic>
bool is_above(const double key, const double distance, const Node node, const Heuristic& heuristic)
{
  if constexpr(is_heuristic<Heuristic>)
  {
    constexpr double rounding = 1e-6;
    double smallest = key * (1 - rounding);
    if constexpr(is_valid<const Heuristic&, double>([](auto& h) -> decltype(h.rounding()) {}))
      smallest -= heuristic.rounding();
    return distance + heuristic(node) < smallest;
  }
  else
    return distance < key;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONCEPT_CHECKS_H
