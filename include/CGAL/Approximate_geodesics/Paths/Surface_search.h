// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_SURFACE_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_SURFACE_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Exact_landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Point_pairs.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Curve_sources.h>
#include <CGAL/Approximate_geodesics/Paths/internal/free_ends.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Paths/internal/tree_paths.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A point where a search on a surface starts.
 */
struct Source_point
{
  /// the point.
  Intrinsic_point point;

  /// the initial distance, in the unit of the mesh: finite and not negative.
  double distance = 0;
};

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A workspace for searches from any points of a surface to any others. Sources and targets that are
 * not nodes of the graph are attached to it by straight lines.
 *
 * As with `Propagation`, an object is made once and used for any number of runs, whose cost is
 * proportional to what they reach. Several threads may search one graph at the same time, each with
 * an object of its own. They must not share an object, not even for `const` member functions, as
 * the first query of a nearest source or a path after a run fills a cache. Objects can be moved,
 * but not copied.
 *
 * Points are given by the numbers of the graph's triangulation: `Intrinsic_triangulation::vertex()`
 * and `index()` translate these from and to the indices of a mesh's vertices.
 * `Surface_mesh_shortest_path` does the same in terms of a mesh, for one thread.
 *
 * Input that is rejected leaves the object as it was. After any other exception, nothing is
 * reached. In both cases the object can be used again.
 *
 * \tparam SurfaceGraph a model of `SurfaceGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 */
template <typename SurfaceGraph, typename PriorityQueue = Adaptive_bucket_queue>
class Surface_search
{
  static_assert(internal::Check_surface_graph<SurfaceGraph>::is_done);

public:
  /// \name Types
  /// @{

  /// the graph searched.
  using Graph = SurfaceGraph;

  /// the search for distances of nodes.
  using Search = Propagation<Graph, PriorityQueue>;

  /// the number of a node.
  using Node = typename Search::Node;

  /// when a run may end early.
  struct Stop_rule
  {
    /// points farther than this, in the unit of the mesh, are not reached.
    double maximum_distance = std::numeric_limits<double>::infinity();

    /// the run ends as soon as the distances of all of these are final, if there are any.
    std::vector<Intrinsic_point> targets = {};
  };

  /// how a point is reached: along a straight line, from a node or from a source.
  struct Answer
  {
    /// the distance from the nearest source, in the unit of the mesh; infinity if unreachable.
    double distance = std::numeric_limits<double>::infinity();

    /// the index of that source, or `null_source`.
    std::size_t source = null_source;

    /// the last node on the path, or `Search::null_node`.
    Node node = Search::null_node;

    /// the length of the line from that node or source, in units of the graph.
    double last_length = 0;

    /// where the path from the source starts: the source itself, or the nearest point of a curve.
    Intrinsic_point start = Intrinsic_point::at_vertex(Intrinsic_triangulation::null_index);

    /// returns whether a source reaches the point.
    bool is_reached() const { return source != null_source; }
  };

  /// @}

  /// the index of no source.
  static constexpr std::size_t null_source = Search::null_source;

  /// \name Creation
  /// @{

  /// makes a workspace for `graph`. Run time and memory are \cgalBigO{n} for `n` nodes.
  /// \warning `graph` is referred to, not copied.
  explicit Surface_search(const Graph& graph);

  /// a workspace for a temporary graph would outlive it.
  explicit Surface_search(const Graph&& graph) = delete;

  /// @}

  /// \name Runs
  /// @{

  /*!
   * forgets the last run, and computes distances from the nearest of the sources.
   *
   * \param sources where to start; duplicates are allowed. Without sources, nothing is reached.
   * \param stop when the run may end early
   * \param visitor a model of `GeodesicVisitor` for vertices of type `Node`
   *
   * \throws std::invalid_argument if a source or a target is not a point of the surface, if the
   *         initial distance of a source is negative, infinite, or not a number, or if the maximum
   *         distance is negative or not a number. The results of the last run are kept.
   *
   * Run time is that of `Propagation::run()`.
   */
  template <typename Visitor = Geodesic_visitor_base>
  void run(std::vector<Source_point> sources,
           const Stop_rule& stop = Stop_rule(),
           Visitor&& visitor = Visitor());

  /*!
   * does the same for curves and sets of faces, whose indices are those of the sources. Distances
   * are those to the nearest point of a curve: exact in a `Saddle_vertex_graph`, and else with the
   * bound that the graph has for points.
   *
   * \throws std::invalid_argument as `run()` does; if two consecutive points of a polyline are not
   *         in the same face; if costs depend on the direction; or if `Graph` does not support
   *         curves, as `SurfaceGraph` says.
   *
   * Run time is that of `run()`, and for each point of a polyline that of attaching a few points.
   */
  template <typename Visitor = Geodesic_visitor_base>
  void run_from_curves(std::vector<Intrinsic_curve> curves,
                       const Stop_rule& stop = Stop_rule(),
                       Visitor&& visitor = Visitor());

  /*!
   * forgets the last run, and computes the distance from the nearest of the sources to `target`
   * only. Afterwards, only `target` may be queried.
   *
   * The run ends when that distance is final. If there are landmarks, or positions are known, it is
   * guided to the target by their lower bounds, or by straight-line distances (A* algorithm
   * \cgalCite{hnr-fbhdm-68}).
   *
   * \throws std::invalid_argument as `run()` does.
   */
  void run_to(const Intrinsic_point& target,
              std::vector<Source_point> sources,
              const Vertex_positions& positions = Vertex_positions(),
              double maximum_distance = std::numeric_limits<double>::infinity());

  /*!
   * does the same as `run(sources)`, and takes the time that the difference from the last run is
   * worth: the graph may have changed by `set_weights(changes)` since then, and sources may have
   * been added, removed or moved. See `Propagation::repair()`.
   *
   * \throws std::invalid_argument as `run()` does.
   */
  void repair(std::vector<Source_point> sources);

  /// guides runs to a single target from now on, and those for pairs, by the landmarks of the same
  /// graph, as long as its arcs do not change. Those of an exact graph are `Exact_landmarks`; they
  /// guide runs from a single source whose initial distance is `0`, by two searches of another
  /// graph. The last run is forgotten then. \warning `landmarks` are referred to, not copied.
  /// \throws std::invalid_argument if they are those of another graph.
  void use_landmarks(const internal::Landmarks_of<Graph>& landmarks);

  /// temporary landmarks would not live long enough.
  void use_landmarks(const internal::Landmarks_of<Graph>&& landmarks) = delete;

  /// returns whether runs to a single target are guided by landmarks.
  bool uses_landmarks() const
  {
    return m_corridors || (m_landmarks != nullptr && m_landmarks->are_valid());
  }

  /// must be called after all weights of the graph have been exchanged. Results are forgotten. Run
  /// time is \cgalBigO{n} for `n` nodes.
  void restart();

  /// enables or disables statistics for subsequent runs: see `search().statistics()`.
  void collect_statistics(const bool counts) { m_search.collect_statistics(counts); }

  /// @}

  /// \name Results of the Last Run
  /// @{

  /// returns how `point` is reached. If all paths to it are longer than `longest`, in the unit of
  /// the mesh, the one that is found need not be shortest, which takes less time in an exact graph.
  /// \throws std::invalid_argument if `point` is not a point of the surface.
  /// Run time is \cgalBigO{1} for a vertex, amortized over the nodes that were reached, and that of
  /// attaching the point to the graph otherwise.
  Answer nearest(const Intrinsic_point& point,
                 double longest = std::numeric_limits<double>::infinity()) const;

  /// returns the index of the source nearest to a node, or `null_source` if it was not reached.
  /// Like `Propagation::source()`, it fills a cache.
  std::size_t source(const Node node) const
  {
    const std::size_t result = m_search.source(node);
    return m_curves.is_empty() || result == null_source ? result : m_curves.foot(result).curve;
  }

  /// returns the distance from the nearest source to `point`, in the unit of the mesh; infinity if
  /// unreachable.
  double distance(const Intrinsic_point& point) const
  {
    const double result = nearest_end(point, std::numeric_limits<double>::infinity()).distance;
    return is_known(result) ? result : std::numeric_limits<double>::infinity();
  }

  /*!
   * returns a shortest path from `point` to the nearest source; it has no points if there is none.
   *
   * Its length is that of the polyline, up to rounding. It includes neither the initial distance of
   * the source nor the rounding of arcs stored in single precision. Where arcs are edges and the
   * initial distance is `0`, it equals the distance, to the last bit.
   *
   * \throws std::invalid_argument if `point` is not a point of the surface, or an arc cannot be
   *         traced: one of a graph file that was changed, or an exact one across nearly degenerate
   *         faces, whose length has large rounding errors.
   *
   * Run time is linear in the number of arcs on the path, times the cost of tracing one.
   */
  Path find_path(const Intrinsic_point& point) const;

  /// returns whether a point at this distance is reached and its distance final: it does not exceed
  /// the maximum distance, and the run did not end before it.
  bool is_known(const double distance) const
  {
    return distance <= m_maximum_distance && m_search.is_final(distance);
  }

  /// returns the sources; none if they are curves.
  const std::vector<Source_point>& sources() const { return m_sources; }

  /// returns the sources that are curves.
  const std::vector<Intrinsic_curve>& curves() const { return m_curves.curves(); }

  /// @}

  /*!
   * \name Pairs
   *
   * These functions find each pair by a search from its source that ends at its target, or the
   * other way around if distances are those to the sources. One search serves all pairs with the
   * same start; with landmarks, which guide to single targets, each pair has its own, unless
   * distances are exact and there are more than eight such pairs. So results do not depend on other
   * pairs. They have the order of the pairs; those of the last run are lost.
   *
   * They throw `std::invalid_argument` if a point is not a point of the surface.
   * `approximate_geodesic_pair_distances()` does the same by several threads.
   */
  /// @{

  /// returns the distance from the source to the target of each pair, infinity if there is no path.
  std::vector<double> distances(const std::vector<Point_pair>& pairs,
                                double maximum_distance = std::numeric_limits<double>::infinity());

  /// returns an interval that contains the distance on the surface, for each pair. Its margins are
  /// those of `distance_intervals()`, and a relative 2.4e-7 if the error bound is not `0`, as arcs
  /// may be stored in single precision. Without an error bound, it begins with `0`.
  std::vector<std::pair<double, double>>
  distance_intervals(const std::vector<Point_pair>& pairs,
                     double maximum_distance = std::numeric_limits<double>::infinity());

  /// returns a shortest path from the source to the target of each pair; it has no points if there
  /// is none.
  std::vector<Path> paths(const std::vector<Point_pair>& pairs,
                          double maximum_distance = std::numeric_limits<double>::infinity());

  /// @}

  /// \name Access
  /// @{

  /// returns the graph.
  const Graph& graph() const { return *m_graph; }

  /// returns the search for distances of nodes, with its results and statistics.
  const Search& search() const { return m_search; }

  /// returns the number of bytes of that search, and of the one that guides it to single targets.
  std::size_t memory() const;

  /// @}

private:
  template <typename Landmarks>
  friend class internal::Corridors_by_approximation;

  // Checks the sources, and sorts them by face.
  Points_by_face sorted(const std::vector<Source_point>& sources) const
  {
    std::vector<Intrinsic_point> points;
    points.reserve(sources.size());
    for(const Source_point& s : sources)
    {
      check(s.point);
      internal::check_initial_distance(s.distance, points.size());
      points.push_back(s.point);
    }
    return Points_by_face(m_graph->triangulation(), std::move(points));
  }

  using Run = typename Search::Run;

  // Finds the ends of the lines from the sources if lines are found from labels. Otherwise, it is
  // empty, and the search starts at the seeds.
  typename Search::Find_entries
  find_entries([[maybe_unused]] const std::vector<Source_point>& sources) const
  {
    if constexpr(!Run::attaches_by_labels)
      return {};
    else
      return [&] {
        std::vector<typename Search::Entry> result;
        const double unit = m_graph->unit();
        for(std::size_t i = 0; i < sources.size(); ++i)
          m_search.graph_run().for_each_line_from(
              sources[i].point, sources[i].distance / unit,
              [&](const Node node, const double length, const typename Run::Payload& payload) {
                result.push_back({{node, sources[i].distance + length * unit, i}, payload});
              });
        return result;
      };
  }

  // As `nearest()`, without the source.
  Answer nearest_end(const Intrinsic_point& point, double longest) const;

  // Considers lines from nodes and sources in other faces, on paths not longer than `longest`.
  void consider_lines([[maybe_unused]] const Intrinsic_point& point,
                      [[maybe_unused]] const double longest,
                      [[maybe_unused]] Answer& best) const
  {
    if constexpr(Run::attaches_by_labels)
    {
      const double largest = (std::min)({best.distance, m_maximum_distance, longest});
      if(point.is_vertex() || std::isinf(largest))
        return;
      const auto look = [&](const auto& points, const auto& on_point) {
        m_search.graph_run().for_each_line_to(
            point, largest / m_graph->unit(), m_search.labels(), points,
            [&](const Node node, const double length) { consider(node, length, best); }, on_point);
      };
      if(m_curves.is_empty())
        look(m_points, [&](const std::size_t i, const double length) {
          consider(m_sources, i, length, best);
        });
      else if constexpr(internal::has_curves<Graph>)
        look(m_curves.segments(), [&](const std::size_t i, const double length, const double t) {
          m_curves.consider(*m_graph, i, length, t, best);
        });
    }
  }

  // Calls `run(seeds, rule, entries)`. Sources and results are consistent, even if the run
  // fails: if the search rejects its input, nothing changes; after other exceptions, nothing is
  // reached, and there are no sources.
  template <typename F>
  void run_and_adopt(std::vector<Source_point> sources,
                     Points_by_face points,
                     const Stop_rule& stop,
                     F run)
  {
    const auto seeds = this->seeds(sources);
    const auto rule = rule_for_nodes(stop);
    check(seeds, rule);
    try
    {
      run(seeds, rule, find_entries(sources));
    }
    catch(...)
    {
      if(m_search.reached_nodes().empty())
        forget();
      throw;
    }
    m_sources = std::move(sources);
    m_curves = internal::Curve_sources();
    m_points = std::move(points);
    m_maximum_distance = stop.maximum_distance;
  }

  bool run_in_corridor(const Intrinsic_point& target,
                       const Intrinsic_point& source,
                       double maximum_distance);

  void forget()
  {
    m_sources.clear();
    m_curves = internal::Curve_sources();
    m_points = Points_by_face();
    m_maximum_distance = std::numeric_limits<double>::infinity();
  }

  void check(const Intrinsic_point& p) const { internal::check_point(p, m_graph->triangulation()); }

  // The search does the same; but if it throws, and nothing is reached, it may have started.
  void check(const std::vector<typename Search::Seed>& seeds,
             const typename Search::Stop_rule& rule) const
  {
    internal::check_input(seeds, rule, m_graph->number_of_nodes(), m_graph->unit());
  }

  std::vector<typename Search::Seed> seeds(const std::vector<Source_point>& sources) const
  {
    std::vector<typename Search::Seed> result;
    for(std::size_t i = 0; i < sources.size(); ++i)
      for(const auto& [node, length] : lines(m_graph->attach(sources[i].point)))
        if(length < std::numeric_limits<double>::infinity())
          result.push_back({node, sources[i].distance + length * m_graph->unit(), i});
    internal::add_free_seeds(*m_graph, sources, result);
    return result;
  }

  typename Search::Stop_rule rule_for_nodes(const Stop_rule& stop) const
  {
    typename Search::Stop_rule result;
    result.maximum_distance = stop.maximum_distance;
    for(const Intrinsic_point& target : stop.targets)
    {
      check(target);
      if(target.is_vertex())
        result.targets.push_back(target.vertex);
      else
      {
        result.points.emplace_back();
        for(const auto& [node, length] : lines(internal::attach_target(*m_graph, target)))
          result.points.back().push_back({node, length * m_graph->unit()});
      }
    }
    return result;
  }

  // The lines between an attached point and nodes, in units of the graph. They are listed, so that
  // one instantiation of a graph's functions is enough.
  template <typename Attachment>
  const std::vector<Last_arc>& lines(const Attachment& attachment) const
  {
    m_lines.clear();
    attachment.for_each_node([this](const Node node, const double length) {
      m_lines.push_back({node, length});
    });
    return m_lines;
  }

  Answer nearest_by_line(const Intrinsic_point& point,
                         const std::vector<Source_point>& sources,
                         const Points_by_face& points) const
  {
    Answer result;
    if(!points.is_empty() && !point.is_vertex())
      internal::attach_target(*m_graph, point)
          .for_each_point(points, [&](const std::size_t i, const double length) {
            consider(sources, i, length, result);
          });
    return result;
  }

  void consider(const std::vector<Source_point>& sources,
                const std::size_t i,
                const double length,
                Answer& best) const
  {
    const double distance = sources[i].distance + length * m_graph->unit();
    if(distance < best.distance)
      best = {distance, i, Search::null_node, length, sources[i].point};
  }

  void consider(const Node node, const double length, Answer& best) const
  {
    const double distance = m_search.distance(node) + length * m_graph->unit();
    if(distance < best.distance)
      best = {distance, null_source, node, length,
              Intrinsic_point::at_vertex(Intrinsic_triangulation::null_index)};
  }

  // Appends the line from the last point of the path to a node or point `to`, located at `end`.
  template <typename End>
  void append_line(const Intrinsic_point& from,
                   const End& to,
                   const Intrinsic_point& end,
                   const Answer& answer,
                   Path& path) const
  {
    path.length += m_search.graph_run().for_each_crossing_to(
        from, answer.distance / m_graph->unit(), to, answer.last_length, m_search.labels(),
        internal::Append_crossing{path.points});
    internal::append(end, m_graph->triangulation(), path);
  }

  // Appends the line from the node where the search has started to the source.
  void append_line_to_source(const Node first, const Source_point& source, Path& path) const
  {
    if(source.point.vertex == first)
      return;
    internal::append_backward(
        [&](auto f) {
          return m_search.graph_run().for_each_crossing_from(
              source.point, source.distance / m_graph->unit(), first, m_search.labels(), f);
        },
        path);
    internal::append(source.point, m_graph->triangulation(), path);
  }

  const Graph* m_graph;
  const Landmarks<Graph>* m_landmarks = nullptr;
  std::unique_ptr<internal::Corridor_finder> m_corridors; // if there are exact landmarks
  Search m_search;
  std::vector<Source_point> m_sources;
  Points_by_face m_points;          // of the sources
  internal::Curve_sources m_curves; // sources of another kind; there are no others then
  double m_maximum_distance = std::numeric_limits<double>::infinity();
  mutable std::vector<Last_arc> m_lines; // of the last point that was attached
};

// Not in the class, where they would be inline: so `extern template` keeps them from being
// compiled.

template <typename SurfaceGraph, typename PriorityQueue>
Surface_search<SurfaceGraph, PriorityQueue>::Surface_search(const Graph& graph)
  : m_graph(&graph), m_search(graph)
{
}

template <typename SurfaceGraph, typename PriorityQueue>
template <typename Visitor>
void Surface_search<SurfaceGraph, PriorityQueue>::run(std::vector<Source_point> sources,
                                                      const Stop_rule& stop,
                                                      Visitor&& visitor)
{
  Points_by_face points = sorted(sources);
  run_and_adopt(std::move(sources), std::move(points), stop,
                [&](const auto& seeds, const auto& rule, const auto& entries) {
                  m_search.run(seeds, rule, visitor, entries);
                });
}

template <typename SurfaceGraph, typename PriorityQueue>
void Surface_search<SurfaceGraph, PriorityQueue>::repair(std::vector<Source_point> sources)
{
  Points_by_face points = sorted(sources);
  Geodesic_visitor_base visitor;
  run_and_adopt(std::move(sources), std::move(points), Stop_rule(),
                [&](const auto& seeds, const auto& rule, const auto& entries) {
                  entries ? m_search.run(seeds, rule, visitor, entries) : m_search.repair(seeds);
                });
}

template <typename SurfaceGraph, typename PriorityQueue>
void Surface_search<SurfaceGraph, PriorityQueue>::run_to(const Intrinsic_point& target,
                                                         std::vector<Source_point> sources,
                                                         const Vertex_positions& positions,
                                                         const double maximum_distance)
{
  check(target);
  Points_by_face points = sorted(sources);
  if(m_corridors && sources.size() == 1 && sources.front().distance == 0 &&
     run_in_corridor(target, sources.front().point, maximum_distance))
    return;
  const double limit =
      (std::min)(maximum_distance, nearest_by_line(target, sources, points).distance);
  // Lines to a point that is not a vertex may be found from labels. All labels below its distance
  // must be final then, which A* does not guarantee.
  // Weights may be smaller than 1 since they have changed.
  const bool is_guided = positions.are_known() && !m_graph->triangulation().has_weights() &&
                         (!Run::attaches_by_labels || target.is_vertex());
  run_and_adopt(std::move(sources), std::move(points), {limit, {target}},
                [&](const auto& seeds, const auto& rule, const auto& entries) {
                  if constexpr(internal::has_asymmetry<Graph>)
                    if(uses_landmarks())
                      return m_search.run_toward(seeds, rule, m_landmarks->to(target), entries);
                  if(is_guided)
                    m_search.run_toward(
                        seeds, rule,
                        internal::Euclidean_heuristic<Graph>(*m_graph, positions, target), entries);
                  else
                    m_search.run_toward(seeds, rule, internal::No_heuristic(), entries);
                });
}

template <typename SurfaceGraph, typename PriorityQueue>
void Surface_search<SurfaceGraph, PriorityQueue>::restart()
{
  Search search(*m_graph);
  search.collect_statistics(m_search.collects_statistics());
  m_search = std::move(search);
  forget();
}

template <typename SurfaceGraph, typename PriorityQueue>
auto Surface_search<SurfaceGraph, PriorityQueue>::nearest_end(const Intrinsic_point& point,
                                                              const double longest) const -> Answer
{
  check(point);
  Answer result = nearest_by_line(point, m_sources, m_points);
  if(!m_curves.is_empty())
    m_curves.consider(*m_graph, point, result);
  if(point.is_vertex())
    consider(point.vertex, 0, result);
  else
    for(const auto& [node, length] : lines(internal::attach_target(*m_graph, point)))
      consider(node, length, result);
  consider_lines(point, longest, result);
  return result;
}

template <typename SurfaceGraph, typename PriorityQueue>
auto Surface_search<SurfaceGraph, PriorityQueue>::nearest(const Intrinsic_point& point,
                                                          const double longest) const -> Answer
{
  Answer result = nearest_end(point, longest);
  if(result.node != Search::null_node)
  {
    internal::shorten_free_end(m_search, point, result);
    result.source = source(result.node);
    const std::size_t number = m_search.source(result.node);
    if(number != null_source)
      result.start = m_curves.is_empty() ? m_sources[number].point : m_curves.foot(number).point;
  }
  return is_known(result.distance) ? result : Answer();
}

template <typename SurfaceGraph, typename PriorityQueue>
Path Surface_search<SurfaceGraph, PriorityQueue>::find_path(const Intrinsic_point& point) const
{
  Path result;
  const Answer answer = nearest(point);
  if(!answer.is_reached())
    return result;
  result.points.push_back(point);
  const Source_point source{answer.start, m_curves.is_empty() ? m_sources[answer.source].distance
                                                              : curves()[answer.source].distance};
  if(answer.node == Search::null_node && source.point.is_same(point, m_graph->triangulation()))
    return result;
  if(answer.node == Search::null_node)
    append_line(point, source.point, source.point, answer, result);
  else
  {
    if(!point.is_vertex())
      append_line(point, answer.node, internal::position(*m_graph, answer.node), answer, result);
    append_line_to_source(internal::append_tree_path(m_search, answer.node, result), source,
                          result);
  }
  result.length *= m_graph->unit();
  if(!internal::has_crossing_arcs<Graph> && source.distance == 0)
    result.length = answer.distance;
  return result;
}

} // namespace CGAL::Approximate_geodesics

#include <CGAL/Approximate_geodesics/Paths/internal/find_corridors.h>
#include <CGAL/Approximate_geodesics/Paths/internal/search_from_curves.h>
#include <CGAL/Approximate_geodesics/Paths/internal/search_pairs.h>

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_SURFACE_SEARCH_H
