// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SADDLE_RUN_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SADDLE_RUN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Deferred_sights.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Upper_bounds.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The run of a saddle vertex graph: upper bounds of all distances, which terminate lines of sight,
 * and the directions in which paths arrive at nodes. A search along edges finds the bounds first.
 *
 * `Observer` is the base of the visitor of sights.
 */
template <typename Graph, typename Observer = Sight_visitor_base>
class Saddle_run : public Geodesic_run_base<Graph>
{
  using Base = Geodesic_run_base<Graph>;
  using Base::graph;

public:
  using Node = Index;
  using Payload = Arrival;

  static constexpr bool attaches_by_labels = true;

  // Appends the arcs from a tip to a list, defers sights, and knows the labels and bounds that
  // `Sight_expansion` requires.
  template <typename Labels, typename Candidates>
  struct Arc_visitor : Observer
  {
    static constexpr bool knows_arrivals = true;
    static constexpr bool defers_sights = true;

    void on_vertex(const Node v,
                   const Sight_path& path,
                   const Sight& sight,
                   const Plane_vector apex,
                   const Plane_vector left_edge)
    {
      append(v, path.length, sight.arrival(path, apex, left_edge));
    }

    // Can be interrupted, as a source may have many arcs. Lowers the bound at once, for the sights
    // that follow, unless other threads read it.
    void append(const Node target, const double length, const Arrival& arrival)
    {
      constexpr unsigned arcs_between_checks = 256;
      if(++number_of_arcs % arcs_between_checks == 0)
        check_for_interruption();
      candidates.make_room(1);
      candidates.append(true, tip, label_of_tip, target, length, arrival);
      if(const double label = label_of_tip + length;
         !run.graph().is_parallel() && label < bound(target))
        run.m_bounds.lower(target, label);
    }

    double bound(const Node v) const { return run.bound(v); }
    double label(const Node v) const { return labels.distance(v); }
    const Arrival& arrival(const Node v) const { return run.m_arrival[v]; }
    bool has_predecessor(const Node v) const
    {
      return labels.predecessor(v) != Intrinsic_triangulation::null_index;
    }

    bool defer(const Sight& sight, const Crossing& milestone) const
    {
      const double smallest_label = label_of_tip + sight.smallest_distance();
      if(!(smallest_label > horizon))
        return false;
      deferred.list(smallest_label)
          .emplace_back(sight, milestone, tip, label_of_tip, smallest_label);
      return true;
    }

    Saddle_run& run;
    const Labels& labels;
    double horizon;
    Node tip;
    double label_of_tip;
    Candidates& candidates;
    const Deferred_sights::Sink& deferred;
    unsigned number_of_arcs = 0;
  };

  explicit Saddle_run(const Graph& searched)
    : Base(searched), m_bounds(searched.number_of_nodes()), m_arrival(searched.number_of_nodes())
  {
  }

  // Limits the next search to a corridor: to nodes whose labels, and lower bounds of their
  // distances to the goal, do not add up to more than the limit. These bounds are consistent: those
  // of two nodes do not differ by more than their distance.
  void limit_to(std::function<double(Node)> distance_to_goal)
  {
    m_distance_to_goal = std::move(distance_to_goal);
    m_has_corridor = true;
  }

  template <typename Search>
  void start(Search& search)
  {
    if(!m_has_corridor)
      m_distance_to_goal = search.heuristic();
    const Bends& bends = graph().m_tables.bends;
    m_bounds.start(Deferred_sights::is_rough(bends) && !has_heuristic());
    if(m_has_corridor)
      m_limit = search.limit(); // the bounds are those of the corridor
    else
      find_bounds(search);
    m_sights.start(has_heuristic() ? infinity
                                   : Deferred_sights::suitable_distance(
                                         bends, graph().arc_lengths().mean, graph().is_parallel()));
  }

  template <typename Search>
  void find_bounds(Search& search)
  {
    const double largest = LARGEST_LABEL * graph().arc_lengths().longest;
    search.find_upper_bounds(graph().m_edges, [&](const Node node, const double label) {
      if(label > largest && largest > 0)
        reject("an initial distance is so large that distances are " +
               text_of(label * graph().unit()) +
               "; exact searches need distances of at most 1e10 times the longest edge");
      m_limit = search.limit();
      m_bounds.start_with(node, (std::min)(label, largest_label(node)));
    });
    m_limit = search.limit();
  }

  // Continues the sights that the search has reached, and starts those of the nodes. Several
  // threads take part if there is enough to do for them.
  template <typename Labels, typename Candidates>
  void expand(const Node* const nodes,
              const std::size_t number,
              const Labels& labels,
              Candidates& candidates)
  {
    if(m_sights.advance(nodes, number, labels))
      m_bounds.spread(graph().triangulation(), m_sights.horizon(), m_sights.distance());
    const std::size_t number_of_blocks = m_sights.number_of_blocks();
    m_sights.append_all(
        graph().m_loop, number_of_blocks + number, candidates,
        [&](const std::size_t i, Candidates& part, const Deferred_sights::Sink& deferred) {
          if(i < number_of_blocks)
            append_resumed(i, labels, part, deferred);
          else
            append_arcs(nodes[i - number_of_blocks], labels, part, deferred);
        });
  }

  void on_label(const Node node, const double distance, const Arrival& arrival)
  {
    m_arrival[node] = arrival;
    m_bounds.lower(node, distance);
  }

  // Where faces are numerically degenerate, computed lines may exceed the upper bounds, and are
  // discarded. Nodes that no line has reached, or only longer ones, are reached along edges, at
  // their upper bounds.
  template <typename Search>
  void finish(Search& search)
  {
    if(m_has_corridor)
      return;
    constexpr double factor = 1 + 1e-12; // for rounding
    for(const Node node : m_bounds.known_before())
    {
      const double old = search.labels().distance(node);
      if(!(old > m_bounds[node] * factor && m_bounds[node] < search.limit()))
        continue;
      const auto [from, label, arrival] = last_edge(node, search.labels());
      if(!(label < old))
        continue;
      search.lower(node, label, from);
      on_label(node, label, arrival);
    }
  }

  void discard(const Node node) { m_bounds.discard(node); }

  void forget(const std::vector<Node>& nodes)
  {
    m_bounds.forget(nodes);
    leave_corridor();
  }

  void forget_all()
  {
    m_bounds.forget_all();
    leave_corridor();
  }

  std::size_t largest_batch() const
  {
    return graph().is_parallel() ? (std::numeric_limits<std::size_t>::max)() : 0;
  }

  std::size_t memory() const { return memory_of(m_bounds, m_arrival, m_sights); }

  // How paths arrive at a node that has a label.
  const Arrival& arrival(const Node node) const { return m_arrival[node]; }

  // An upper bound of the label of a node, also during the start of a search.
  double bound(const Node node) const
  {
    const double result = m_bounds[node];
    return result < infinity ? result : largest_label(node);
  }

  const Sight_tables& tables() const { return graph().m_tables; }

  // Calls `f(node, length, arrival)` for the lines from a point where the search starts.
  template <typename F>
  void for_each_line_from(const Intrinsic_point& point, const double label, F f) const
  {
    if(point.is_vertex())
      return f(point.vertex, 0., Arrival());
    graph().attach(point).for_each_line(
        label, [&](const Node node) { return bound(node); }, Points_by_face(), f,
        [](std::size_t, double) {});
  }

  // Calls `on_node(node, length)` and `on_point(i, length)` for the lines from nodes and from
  // `points` to a point that is not a vertex: for those on paths not longer than `distance`. The
  // points may be others that `Lines_of_sight` supports.
  template <typename Labels, typename Points, typename OnNode, typename OnPoint>
  void for_each_line_to(const Intrinsic_point& point,
                        const double distance,
                        const Labels& labels,
                        const Points& points,
                        OnNode on_node,
                        OnPoint on_point) const
  {
    graph().attach(point).for_each_line(
        0, bound_before(distance, 0, labels), points,
        [&](const Node node, const double length, const Arrival&) { on_node(node, length); },
        on_point);
  }

  template <typename Labels, typename F>
  double
  for_each_crossing(const Node source, const Node target, const Labels& labels, const F& f) const
  {
    return for_each_crossing_from(Intrinsic_point::at_vertex(source), labels.distance(source),
                                  target, labels, f);
  }

  // Traces the line back from its end. If that fails, looks for it from its start, as the search
  // did, which can take as long as the search.
  template <typename Labels, typename F>
  double for_each_crossing_from(const Intrinsic_point& point,
                                const double distance,
                                const Node target,
                                const Labels& labels,
                                const F& f) const
  {
    const double label = labels.distance(target), length = label - distance;
    const double rounding = rounding_of_line(label);
    std::vector<std::pair<Node, double>> crossings;
    const double found = graph().attach(point).for_each_crossing_back(
        target, m_arrival[target], length, rounding,
        [&](const Node h, const double t) { crossings.emplace_back(h, t); });
    const auto bound = [&](const Node v, const double slack) {
      return (std::min)(label, labels.distance(v)) * (1 + slack) + rounding;
    };
    if(!(found >= 0))
      return graph().attach(point).for_each_crossing(
          distance, bound, Intrinsic_point::at_vertex(target), length, rounding, f);
    std::for_each(crossings.rbegin(), crossings.rend(),
                  [&](const auto& crossing) { f(crossing.first, crossing.second); });
    return found;
  }

  template <typename End, typename Labels, typename F>
  double for_each_crossing_to(const Intrinsic_point& point,
                              const double distance,
                              const End& end,
                              const double length,
                              const Labels& labels,
                              const F& f) const
  {
    const double rounding = rounding_of_line(0);
    const auto bound = [&](const Node v, const double slack) {
      return bound_before(distance * (1 + slack), rounding, labels)(v);
    };
    return graph().attach(point).for_each_crossing(0, bound, point_at(end), length, rounding, f);
  }

private:
  // In longest edges: paths are shorter, but for initial distances. To larger labels, lengths of
  // lines add nothing, or no more than rounding errors, so that no line would be too long.
  static constexpr double LARGEST_LABEL = 1e10;

  double largest_label(const Node node) const
  {
    return m_distance_to_goal ? m_limit - m_distance_to_goal(node) : m_limit;
  }

  void leave_corridor()
  {
    m_distance_to_goal = {};
    m_has_corridor = false;
  }

  // Whether nodes are not expanded in the order of their labels.
  bool has_heuristic() const { return m_distance_to_goal && !m_has_corridor; }

  // Continues a part of the sights that the search has reached.
  template <typename Labels, typename Candidates>
  void append_resumed(const std::size_t block,
                      const Labels& labels,
                      Candidates& candidates,
                      const Deferred_sights::Sink& deferred)
  {
    check_for_interruption();
    Arc_visitor<Labels, Candidates> visitor{{},         *this,    labels,     m_sights.horizon(),
                                            null_index, infinity, candidates, deferred};
    Sight_expansion sights_ahead(graph().m_tables, infinity, visitor);
    const auto prefetch_for = [&](const Deferred_sight& s) {
      prefetch(labels.distances(), s.tip);
      graph().m_tables.steps.prefetch(s.sight.halfedge);
      m_bounds.prefetch(s.sight.left_end);
      m_bounds.prefetch(s.sight.right_end);
    };
    m_sights.for_each_in_block(block, labels, prefetch_for, [&](const Deferred_sight& s) {
      visitor.tip = s.tip;
      visitor.label_of_tip = s.label_of_tip;
      sights_ahead.resume(s.sight, s.label_of_tip, s.milestone);
    });
  }

  template <typename Labels, typename Candidates>
  void append_arcs(const Node node,
                   const Labels& labels,
                   Candidates& candidates,
                   const Deferred_sights::Sink& deferred)
  {
    const Intrinsic_triangulation& t = graph().triangulation();
    const double label_of_node = labels.distance(node);
    Arc_visitor<Labels, Candidates> visitor{{},   *this,         labels,     m_sights.horizon(),
                                            node, label_of_node, candidates, deferred};
    Sight_expansion sights(graph().m_tables, label_of_node, visitor);
    Vertex_sights(t, graph().m_tables)
        .for_each(
            node, m_arrival[node],
            [&](const Node h) {
              const double label = label_of_node + t.length(h);
              if(!m_has_corridor || label <= bound(t.target(h)) * (1 + Sight::ROUNDING))
                visitor.append(t.target(h), t.length(h), Arrival::along(h));
            },
            [&](const Sight& sight, const Node left_end, const Node right_end) {
              sights.look(sight, left_end, right_end);
            });
  }

  struct Last_edge
  {
    Node from;
    double label; // over this edge
    Arrival arrival;
  };

  // The last edge of the shortest path along edges. The path may stand for a line next to it, so
  // its direction is unknown.
  template <typename Labels>
  Last_edge last_edge(const Node node, const Labels& labels) const
  {
    const Intrinsic_triangulation& t = graph().triangulation();
    Last_edge result{null_index, infinity, {}};
    for(Node h = t.first_halfedge(node); h < t.beyond_halfedge(node); ++h)
    {
      const double label = labels.distance(t.target(h)) + t.length(h);
      if(label < result.label)
        result = {t.target(h), label, Arrival::in_unknown_direction(t.opposite(h))};
    }
    return result;
  }

  // A bound on the error of the length of a line: it is a difference of labels, and distances in
  // the unit of the mesh may be multiples of the smallest `double`.
  double rounding_of_line(const double label) const
  {
    constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();
    return epsilon * label + 4 * (std::numeric_limits<double>::denorm_min() / graph().unit());
  }

  // A bound on the length of a line from each node, on paths over the node that are not longer than
  // `distance`. Nodes that were not reached are farther away.
  template <typename Labels>
  auto bound_before(const double distance, const double rounding, const Labels& labels) const
  {
    return [this, &labels, largest = distance * (1 + 1e-12), rounding](const Node node) {
      double smallest = (std::min)(largest, labels.distance(node));
      if(m_has_corridor) // there may be shorter paths outside
        smallest = (std::min)(smallest, largest_label(node));
      return largest - smallest + rounding;
    };
  }

  Upper_bounds m_bounds;
  std::vector<Arrival> m_arrival;                 // meaningful where there is a label
  double m_limit = 0;                             // of labels
  std::function<double(Node)> m_distance_to_goal; // at least; empty if nothing is known
  bool m_has_corridor = false;                    // which these lower bounds limit
  Deferred_sights m_sights;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_SADDLE_RUN_H
