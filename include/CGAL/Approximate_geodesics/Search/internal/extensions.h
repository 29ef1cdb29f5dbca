// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_EXTENSIONS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_EXTENSIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>

#include <boost/type_traits/is_detected.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

// What the package of costs adds to `Propagation`: searches of graphs whose arcs change, or cost
// nothing. `Continued_run`, `Free_ways` and `Free_ends` are only declared here.

namespace CGAL::Approximate_geodesics::internal {

// Continues an earlier run of a `Propagation`.
template <typename Search>
class Continued_run;

// What it keeps in the workspace.
struct Kept_part
{
  virtual ~Kept_part() = default;
  virtual std::size_t memory() const = 0;
};

// Whether a search can be repaired: the header is included that defines how.
template <typename Search>
constexpr bool can_continue = is_defined<Continued_run<Search>>;

template <typename Graph>
using Changes_of_arcs = decltype(std::declval<const Graph&>().arc_changes());

// Whether the arcs of a graph may change.
template <typename Graph>
constexpr bool has_changes = boost::is_detected_v<Changes_of_arcs, Graph>;

// Returns how many changes there were.
template <typename Graph>
std::size_t number_of_changes([[maybe_unused]] const Graph& graph)
{
  if constexpr(has_changes<Graph>)
    return graph.arc_changes().number();
  else
    return 0;
}

// The shortest of the paths that cost the same.
template <typename Graph>
class Free_ways;

// How such paths end at points that are not nodes.
template <typename Graph>
class Free_ends;

// Whether a graph tells the lengths of arcs that cost nothing.
template <typename Graph>
constexpr bool
    tells_free_arcs = is_valid<const Graph&, bool>([](auto& g) -> decltype(g.has_free_arcs()) {});

// Stands for `Free_ways` if a graph does not tell free arcs.
struct No_free_ways
{
  void forget() {}
  void wait() {}
  static std::size_t memory() { return 0; }
};

template <typename Graph>
using Free_ways_of = std::conditional_t<tells_free_arcs<Graph> && is_defined<Free_ways<Graph>>,
                                        Free_ways<Graph>,
                                        No_free_ways>;

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_EXTENSIONS_H
