// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/Geodesic_queries/Portal_labels.h>
#include <CGAL/Geodesic_queries/internal/Workspaces.h>
#include <CGAL/Geodesic_queries/internal/compiled_pairs.h>
#include <CGAL/Geodesic_queries/internal/find_pairs.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A point placement that may be empty, so that graphs with a bound and graphs along edges share one
 * type and one instantiation. Placement can be interrupted.
 */
template <typename Placement>
class Optional_points
{
public:
  using Index = Intrinsic_triangulation::Index;

  static constexpr bool makes_equal_parts = false;

  explicit Optional_points(std::optional<Placement> points) : m_points(std::move(points)) {}

  void prepare(const Intrinsic_triangulation& triangulation,
               const std::size_t maximum_number_of_points)
  {
    if(m_points)
      m_points->prepare(triangulation, maximum_number_of_points);
  }

  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    check_for_interruption_at(h);
    return m_points ? m_points->number_of_points(triangulation, h) : 0;
  }

  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* const positions,
             const std::size_t number_of_points) const
  {
    check_for_interruption_at(h);
    if(m_points)
      m_points->place(triangulation, h, positions, number_of_points);
  }

  double epsilon(const Intrinsic_triangulation& triangulation) const
  {
    return m_points ? m_points->epsilon(triangulation) : infinity;
  }

  std::size_t memory() const { return m_points ? m_points->memory() : 0; }

private:
  std::optional<Placement> m_points;
};

// Whether the weights and barriers of a graph can change.
template <typename Graph>
using Set_barriers =
    decltype(std::declval<Graph&>().set_barriers(std::declval<std::vector<Barrier_change>>()));

// The labels of a graph that can have some.
template <typename Graph>
using Labels_of = std::conditional_t<has_asymmetry<Graph>, Portal_labels<Graph>, std::monostate>;

/*
 * A graph with a pool of search workspaces.
 */
template <typename Graph>
class Solver_graph_of final : public Solver_graph
{
  using Search = Guided_search<Graph>;
  using Landmarks = typename Search::Landmarks;
  using Index = Intrinsic_triangulation::Index;

public:
  explicit Solver_graph_of(Graph graph) : m_graph(std::move(graph)), m_workspaces(m_graph) {}

  const Intrinsic_triangulation& triangulation() const override { return m_graph.triangulation(); }

  double error_bound() const override { return internal::error_bound(m_graph); }

  void set_weights(const std::vector<Weight_change>& changes) override
  {
    change([&](auto& graph) { graph.set_weights(changes); });
  }

  void set_barriers(const std::vector<Barrier_change>& changes) override
  {
    change([&](auto& graph) { graph.set_barriers(changes); });
  }

  void prepare_pairs(const std::size_t number_of_landmarks) override
  {
    auto landmarks = std::make_unique<const Landmarks>(m_graph, number_of_landmarks);
    m_workspaces.set_up([l = landmarks.get()](Search& search) { search.use_landmarks(*l); });
    m_landmarks = std::move(landmarks);
  }

  void prepare_intervals([[maybe_unused]] const double epsilon) override
  {
    if constexpr(has_asymmetry<Graph>)
      m_labels = Labels_of<Graph>(
          m_graph, parameters::epsilon(epsilon).concurrency_tag(Parallel_if_available_tag()));
    else
      reject("the distances of the solver are exact; only intervals of others can be prepared");
  }

  void find_distances(std::vector<Source_point> sources,
                      const double maximum_distance,
                      double* const distances,
                      std::int64_t* const nearest_sources,
                      std::int64_t* const predecessors,
                      Solver_visitor& visitor) const override
  {
    const auto search = m_workspaces.borrow();
    visitor.set_progress(0, m_graph.number_of_nodes());
    if(m_has_changed && std::isinf(maximum_distance))
      search->repair(std::move(sources));
    else
      search->run(std::move(sources), {maximum_distance, {}});
    visitor.finish();
    const auto& labels = search->search();
    for(Index i = 0; i < triangulation().number_of_vertices(); ++i)
      distances[i] = labels.distance(triangulation().vertex(i));
    if(nearest_sources != nullptr)
      for(Index i = 0; i < triangulation().number_of_vertices(); ++i)
        nearest_sources[i] = static_cast<std::int64_t>(labels.source(triangulation().vertex(i)));
    if(predecessors != nullptr)
      write_predecessors(labels, predecessors);
  }

  // Uses A* search with straight-line distances.
  Path find_path(const Intrinsic_point& source,
                 const Intrinsic_point& target,
                 const Vertex_positions& positions,
                 Solver_visitor& visitor) const override
  {
    const auto search = m_workspaces.borrow();
    search->run_to(target, {{source}}, positions);
    visitor.finish();
    return search->find_path(target);
  }

  std::vector<double> find_distances(const std::vector<Point_pair>& pairs,
                                     const double maximum_distance,
                                     Solver_visitor& visitor) const override
  {
    return find_all(
        pairs, maximum_distance, visitor,
        [](const Search& search, const Intrinsic_point& p) { return search.distance(p); });
  }

  std::vector<Path> find_paths(const std::vector<Point_pair>& pairs,
                               const double maximum_distance,
                               const bool straighten,
                               Solver_visitor& visitor) const override
  {
    return find_all(
        pairs, maximum_distance, visitor, [&](const auto& search, const Intrinsic_point& end) {
          Path path = search.find_path(end);
          if(!path.points.empty())
            straighten_if_wanted(triangulation(), parameters::straighten(straighten), path);
          return from_source_to_target(m_graph, std::move(path));
        });
  }

  std::vector<std::pair<double, double>> find_intervals(const std::vector<Point_pair>& pairs,
                                                        const double maximum_distance,
                                                        Solver_visitor& visitor) const override
  {
    const auto find = [&](const Search& search, const Intrinsic_point& p) {
      return distance_interval(search, p, maximum_distance);
    };
    if constexpr(has_asymmetry<Graph>)
      if(m_labels && m_labels->are_valid())
      {
        std::vector<Point_pair> others;
        std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(others),
                     [](const Point_pair& pair) { return !is_of_vertices(pair); });
        return read_intervals(pairs, maximum_distance,
                              find_all(others, maximum_distance, visitor, find));
      }
    return find_all(pairs, maximum_distance, visitor, find);
  }

  void compute_rows(Any_rows& rows,
                    const Points& sources,
                    const Points* const targets,
                    const double maximum_distance,
                    const bool is_symmetric,
                    Solver_visitor& visitor) const override
  {
    visitor.set_parts_done(0, sources.size());
    // starts with a parameter of this package: chains that start with one of CGAL 6 lack ours
    const auto np = parameters::symmetric(is_symmetric)
                        .maximum_distance(maximum_distance)
                        .visitor(std::ref(visitor))
                        .concurrency_tag(Parallel_if_available_tag());
    if(targets == nullptr)
      approximate_geodesic_distance_matrix(m_graph, rows, sources, np);
    else
      approximate_geodesic_distance_matrix(m_graph, rows, sources, np.targets(*targets));
    visitor.finish();
  }

  double find_farthest_vertices(const Points& sources,
                                const std::size_t number,
                                std::vector<std::int64_t>& vertices,
                                Solver_visitor& visitor) const override
  {
    const std::size_t number_of_vertices = triangulation().number_of_vertices();
    visitor.set_parts_done(0, (std::min)(number, number_of_vertices));
    std::size_t number_done = 0;
    const double result = sample_farthest(
        m_graph, sources, number_of_vertices, number,
        [&](const std::size_t i) { return triangulation().vertex(i); },
        [&](const std::size_t i) {
          visitor.check();
          vertices.push_back(static_cast<std::int64_t>(i));
          visitor.set_parts_done(++number_done, (std::min)(number, number_of_vertices));
        });
    visitor.finish();
    return result;
  }

  void save([[maybe_unused]] const Put_bytes& put) const override
  {
    if constexpr(std::is_same_v<Graph, Discrete_geodesic_graph>)
      m_graph.save(put);
  }

private:
  template <typename F>
  void change([[maybe_unused]] const F& f)
  {
    if constexpr(boost::is_detected_v<Set_barriers, Graph>)
    {
      f(m_graph);
      m_has_changed = true;
    }
    else
      reject("the solver was made without face weights and barriers, or with directional costs or "
             "max_slope; then nothing of these can change");
  }

  template <typename Find>
  auto find_all(const std::vector<Point_pair>& pairs,
                const double maximum_distance,
                Solver_visitor& visitor,
                const Find& find) const
  {
    // starts with a parameter of this package, for the same reason
    auto found = find_pairs(m_graph, m_workspaces, pairs,
                            parameters::straighten(false)
                                .maximum_distance(maximum_distance)
                                .visitor(std::ref(visitor))
                                .concurrency_tag(Parallel_if_available_tag()),
                            find);
    visitor.finish();
    return *std::move(found);
  }

  static bool is_of_vertices(const Point_pair& pair)
  {
    return pair.first.is_vertex() && pair.second.is_vertex();
  }

  // From the labels; those of other pairs than of vertices are `found`. What is beyond the maximum
  // distance for certain gets the interval of a search that ends there.
  std::vector<std::pair<double, double>>
  read_intervals(const std::vector<Point_pair>& pairs,
                 const double maximum_distance,
                 const std::vector<std::pair<double, double>>& found) const
  {
    std::vector<std::pair<double, double>> result(pairs.size());
    const auto read = [&](const std::size_t first, const std::size_t beyond) {
      for(std::size_t i = first; i < beyond; ++i)
      {
        check_for_interruption_at(i);
        const auto& [source, target] = pairs[i];
        if(!is_of_vertices(pairs[i]))
          continue;
        const auto [lower, upper] = m_labels->distance_interval(source.vertex, target.vertex);
        result[i] =
            interval_on_surface(m_graph, source, target, (std::min)(lower, maximum_distance),
                                lower > maximum_distance ? infinity : upper);
      }
    };
    Loop::with_tag<Parallel_if_available_tag>().run_blocks(pairs.size(), read);
    auto next = found.begin();
    for(std::size_t i = 0; i < pairs.size(); ++i)
      if(!is_of_vertices(pairs[i]))
        result[i] = *next++;
    return result;
  }

  template <typename Labels>
  void write_predecessors(const Labels& labels, std::int64_t* const predecessors) const
  {
    Vertex_predecessors<Labels> node_before(labels);
    for(Index i = 0; i < triangulation().number_of_vertices(); ++i)
    {
      const auto node = triangulation().vertex(i);
      predecessors[i] = -1;
      if(!labels.is_reached(node))
        continue;
      const auto before = node_before(node);
      predecessors[i] = static_cast<std::int64_t>(before == Labels::null_node ? node : before);
    }
  }

  std::size_t own_memory() const override
  {
    std::size_t memory_of_labels = 0;
    if constexpr(has_asymmetry<Graph>)
      memory_of_labels = m_labels ? m_labels->memory() : 0;
    return m_graph.memory() + (m_landmarks ? m_landmarks->memory() : 0) + memory_of_labels +
           m_workspaces.sum([](const Search& s) { return s.memory(); });
  }

  std::unique_ptr<Solver_graph> reversed() const override
  {
    if constexpr(is_directed<Graph>)
      return std::make_unique<Solver_graph_of>(m_graph.reversed());
    else
      return nullptr;
  }

  Graph m_graph;
  bool m_has_changed = false;
  std::unique_ptr<const Landmarks> m_landmarks; // if pairs are prepared
  std::optional<Labels_of<Graph>> m_labels;     // if intervals are prepared
  mutable Workspaces<Search> m_workspaces;
};

template <typename Graph>
std::unique_ptr<Solver_graph> solver_graph(Graph graph)
{
  return std::make_unique<Solver_graph_of<Graph>>(std::move(graph));
}

// The requested error bound.
struct Bound_of_graph
{
  std::optional<double> epsilon;
  bool accepts_weaker = false;
  std::size_t maximum_number_of_points = 0; // selects the default
  bool may_change = false;                  // weights and barriers
};

// The Steiner points for a bound, or none.
template <typename Placement, typename... Options>
Optional_points<Placement> optional_points(const Bound_of_graph& bound, const Options... options)
{
  if(!bound.epsilon)
    return Optional_points<Placement>(std::nullopt);
  if(*bound.epsilon == 0)
    reject("epsilon is 0, but there are no exact distances with face weights, directional costs, "
           "max_slope or barriers; give a number above 0");
  return Optional_points<Placement>(Placement(
      parameters::epsilon(*bound.epsilon).accept_weaker_bound(bound.accepts_weaker), options...));
}

// Returns the graph for a bound, or the edge graph if there is no bound. A saved graph is read.
inline std::unique_ptr<Solver_graph> make_solver_graph(Intrinsic_triangulation triangulation,
                                                       const Bound_of_graph& bound,
                                                       const Get_bytes* const saved)
{
  if(triangulation.has_directional_costs())
  {
    using Points = Optional_points<Directional_points>;
    return solver_graph(Directional_graph<Points>(std::move(triangulation),
                                                  optional_points<Directional_points>(bound), false,
                                                  bound.maximum_number_of_points));
  }
  if(triangulation.has_weights() || triangulation.has_barriers())
  {
    using Points = Optional_points<Geometric_points>;
    return solver_graph(Steiner_graph<Points>(
        std::move(triangulation), optional_points<Geometric_points>(bound, bound.may_change),
        bound.maximum_number_of_points));
  }
  if(!bound.epsilon)
    return solver_graph(Edge_graph(std::move(triangulation)));
  if(*bound.epsilon == 0)
    return solver_graph(Saddle_vertex_graph(std::move(triangulation)));
  if(saved != nullptr)
    return solver_graph(Discrete_geodesic_graph::load(*saved, std::move(triangulation)));
  return solver_graph(Discrete_geodesic_graph(
      std::move(triangulation),
      parameters::epsilon(*bound.epsilon).concurrency_tag(Parallel_if_available_tag())));
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H
