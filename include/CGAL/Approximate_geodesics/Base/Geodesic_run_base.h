// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_GEODESIC_RUN_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_GEODESIC_RUN_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/type_traits/detected_or.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The run of a graph that has no `Run` of its own. It stores no data, and reports arcs node by
 * node, as `for_each_arc()` and `for_each_crossing()` of the graph do.
 *
 * A `Run` of a graph can derive from this class, and replace the member functions that it needs.
 *
 * \tparam GeodesicGraph a model of `GeodesicGraph`; for the functions that trace lines, of
 *         `SurfaceGraph`
 *
 * \cgalModels{GeodesicRun}
 */
template <typename GeodesicGraph>
class Geodesic_run_base
{
public:
  /// the graph searched.
  using Graph = GeodesicGraph;

  /// the number of a node.
  using Node = typename Graph::Node;

  /// empty: no data is stored with labels.
  struct Payload
  {
  };

  /// the lines that `attach()` of the graph finds do not depend on labels.
  static constexpr bool attaches_by_labels = false;

  /// constructs the run of `graph`, which is referred to, not copied.
  explicit Geodesic_run_base(const Graph& graph) : m_graph(&graph) {}

  /// does nothing.
  template <typename Search>
  void start(Search& /* search */)
  {
  }

  /// appends the arcs that `for_each_arc()` of the graph reports.
  template <typename Labels, typename Candidates>
  void expand(const Node* const nodes,
              const std::size_t number,
              const Labels& labels,
              Candidates& candidates)
  {
    candidates.append_arcs(*m_graph, nodes, number, labels);
  }

  /// does nothing.
  void on_label(Node /* node */, double /* distance */, const Payload& /* payload */) {}

  /// does nothing.
  template <typename Search>
  void finish(Search& /* search */)
  {
  }

  /// \name Forgetting
  /// No data is stored, so these functions do nothing.
  /// @{

  /// does nothing.
  void discard(Node /* node */) {}

  /// does nothing.
  void forget(const std::vector<Node>& /* nodes */) {}

  /// does nothing.
  void forget_all() {}

  /// @}

  /// asks for no larger batches.
  static constexpr std::size_t largest_batch() { return 0; }

  /// returns `0`.
  std::size_t memory() const { return 0; }

  /// \name Lines
  /// @{

  /// calls `f(h, t)` for the edges that the arc from `source` to `target` crosses, as the graph
  /// does.
  template <typename Labels, typename F>
  double
  for_each_crossing(const Node source, const Node target, const Labels& labels, const F& f) const
  {
    return m_graph->for_each_crossing(source, target,
                                      labels.distance(target) - labels.distance(source), f);
  }

  /// does the same for the line from `point`, where a search has started with the label `distance`,
  /// to the node that it has reached from there.
  template <typename Point, typename Labels, typename F>
  double for_each_crossing_from(const Point& point,
                                const double distance,
                                const Node target,
                                const Labels& labels,
                                const F& f) const
  {
    return m_graph->attach(point).for_each_crossing(target, labels.distance(target) - distance, f);
  }

  /// does the same for a line of the given length from `point` to `end`, a node or a point.
  template <typename Point, typename End, typename Labels, typename F>
  double for_each_crossing_to(const Point& point,
                              double /* distance */,
                              const End& end,
                              const double length,
                              const Labels& /* labels */,
                              const F& f) const
  {
    return m_graph->attach(point).for_each_crossing(end, length, f);
  }

  /// @}

protected:
  /// returns the graph.
  const Graph& graph() const { return *m_graph; }

private:
  const Graph* m_graph;
};

namespace internal {

template <typename Graph>
using Own_run = typename Graph::Run;

// The run of a graph: its own, or the default.
template <typename Graph>
using Run_of = boost::detected_or_t<Geodesic_run_base<Graph>, Own_run, Graph>;

template <typename Graph>
constexpr bool has_own_run = !std::is_same_v<Run_of<Graph>, Geodesic_run_base<Graph>>;

// Whether an expression is valid for a `T`, with a value that converts to `Result`. It is the
// return type of a generic lambda, which has no body and is never called.
template <typename T, typename Result = void, typename F>
constexpr bool is_valid(const F& /* expression */)
{
  return std::is_invocable_r_v<Result, const F&, T>;
}

// Whether a class is defined, and not only declared. The core declares templates that the packages
// on it define; where it uses one, it checks that the header of the package is included.
template <typename T, typename = void>
constexpr bool is_defined = false;

template <typename T>
constexpr bool is_defined<T, std::void_t<decltype(sizeof(T))>> = true;

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_GEODESIC_RUN_BASE_H
