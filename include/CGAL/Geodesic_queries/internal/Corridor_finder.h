// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_CORRIDOR_FINDER_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_CORRIDOR_FINDER_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_queries/Exact_landmarks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What is known of the shortest path to a goal before an exact search: an upper bound of its
 * length, and for each node, a lower bound of the distance to the goal. In the plane, nodes whose
 * distances from both ends add up to no more than the first are those in an ellipse.
 *
 * Lengths are in units of the graph. Lower bounds are consistent: those of two nodes do not differ
 * by more than their distance.
 */
struct Corridor
{
  using Node = std::uint32_t;

  double length = std::numeric_limits<double>::infinity(); // that the path does not exceed
  std::function<double(Node)> distance_to_goal = {};       // at least; empty if nothing is known

  bool is_known() const { return bool(distance_to_goal); }
};

/*
 * Finds corridors by a search of a graph with a small error bound, from the target to the source.
 * It is guided by landmarks, and continues until it has labeled all nodes of the corridor. The path
 * that it finds is straightened.
 *
 * With the error bound e, let r be the distance of a node from the target in this graph, k a key
 * up to which all are final, and h the lower bound of the distance to the source that guides the
 * search. Then min(r, k - h) / (1 + e) is a consistent lower bound of the exact distance to the
 * target: the report has the proof.
 *
 * An object is for one thread.
 */
template <typename Landmarks>
class Corridor_finder
{
  using Graph = typename Landmarks::Approximation;
  using Node = typename Graph::Node;
  using Search = Surface_search<Graph>;

  // All bounds are relaxed by this fraction of the length: it exceeds by far the rounding errors of
  // sums, and of arcs that are stored in single precision.
  static constexpr double SLACK = 1e-6;

  // The same for faces so thin that rounding makes distances too short: as a multiple of the
  // rounding error of landmarks, which is a fraction of the largest distance.
  static constexpr double SLACK_OF_ROUNDING = 100;

  // For pairs at a smaller distance, the search is faster without a corridor: a tenth of the
  // largest distance, in the same unit.
  static constexpr double NEAREST = 1e10;

public:
  // Landmarks are referred to, not copied.
  explicit Corridor_finder(const Landmarks& landmarks)
    : m_landmarks(landmarks.landmarks()), m_search(landmarks.approximation())
  {
  }

  // Returns the corridor of the paths from a source to a target, which refers to this object, and
  // is valid until the next call. It is not known if it is not worth it. Where the target cannot be
  // reached, its length is 0.
  Corridor find(const Intrinsic_point& source, const Intrinsic_point& target)
  {
    const auto to_source = m_landmarks.to(source);
    const double smallest = smallest_distance(target, to_source);
    if(smallest > 0 && smallest < NEAREST * to_source.rounding())
      return {};
    constexpr double usual_error = 1.1; // of the smallest distance
    const double final_key =
        run_beyond(source, target, to_source, usual_error * graph().epsilon() * smallest);
    const double unit = graph().unit(), distance = m_search.distance(source) / unit;
    if(!(distance < infinity))
      return final_key < infinity ? Corridor() : unreachable(); // too large a number, or none
    const Path path = m_search.find_path(source);
    const Path_straightener straightener(graph().triangulation());
    const double length = (std::min)(distance, straightener.shortened(path).length / unit);
    const double slack = SLACK * length + SLACK_OF_ROUNDING * to_source.rounding();
    return {length + slack, [this, to_source, final_key, slack](const Node node) {
              const double r = (std::min)(labels().distance(node), final_key - to_source(node));
              return (std::max)(r * m_exact_part - slack, 0.);
            }};
  }

  // Returns the number of bytes.
  std::size_t memory() const { return m_search.memory(); }

private:
  const Graph& graph() const { return m_search.graph(); }
  const auto& labels() const { return m_search.search().labels(); }

  // Runs to `goal` from `start`, guided by lower bounds, until all nodes are final whose keys
  // exceed the distance by up to `beyond`. Returns a key up to which all are final; in units of the
  // graph.
  template <typename Heuristic>
  double run_beyond(const Intrinsic_point& goal,
                    const Intrinsic_point& start,
                    const Heuristic& to_goal,
                    const double beyond)
  {
    double result = infinity;
    const double unit = graph().unit();
    m_search.run_by({{start}}, {infinity, {goal}},
                    [&](auto& search, const auto& seeds, auto rule, const auto& entries) {
                      for(const Node node : rule.targets)
                        rule.points.push_back({{node, 0}});
                      rule.targets.clear();
                      std::vector<Last_arc>& arcs = rule.points.front();
                      for(Last_arc& arc : arcs)
                        arc.length += beyond * unit;
                      search.run_toward(seeds, rule, to_goal, entries);
                      for(const Last_arc& arc : arcs)
                        result = (std::min)(result,
                                            search.labels().distance(arc.node) + arc.length / unit);
                    });
    return result;
  }

  static Corridor unreachable()
  {
    return {0, [](Node) { return 0.; }};
  }

  // A lower bound of the distance, often a few percent too small; 0 if nothing is known.
  template <typename Heuristic>
  double smallest_distance(const Intrinsic_point& target, const Heuristic& to_source) const
  {
    double result = infinity;
    attach_target(graph(), target).for_each_node([&](const Node node, const double length) {
      result = (std::min)(result, to_source(node) + length);
    });
    return result < infinity ? result : 0;
  }

  const Approximate_geodesics::Landmarks<Graph>& m_landmarks;
  Search m_search;
  double m_exact_part = 1 / (1 + graph().epsilon()); // of distances
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_CORRIDOR_FINDER_H
