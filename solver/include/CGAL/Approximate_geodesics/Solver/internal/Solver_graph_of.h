// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_OF_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_OF_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Workspaces.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A graph with a pool of search workspaces.
 */
template <typename Graph>
class Solver_graph_of final : public Solver_graph
{
  using Search = Surface_search<Graph>;
  using Index = Intrinsic_triangulation::Index;

public:
  explicit Solver_graph_of(Graph graph) : m_graph(std::move(graph)), m_workspaces(m_graph) {}

  const Intrinsic_triangulation& triangulation() const override { return m_graph.triangulation(); }

  double error_bound() const override
  {
    if constexpr(has_crossing_arcs<Graph>)
      return m_graph.epsilon();
    else
      return std::numeric_limits<double>::infinity();
  }

  std::size_t memory() const override
  {
    return m_graph.memory() + m_workspaces.sum([](const Search& s) { return s.search().memory(); });
  }

  void find_distances(std::vector<Source_point> sources,
                      const double maximum_distance,
                      double* const distances,
                      std::int64_t* const nearest_sources,
                      Solver_visitor& visitor) const override
  {
    const auto search = m_workspaces.borrow();
    visitor.set_progress(0, m_graph.number_of_nodes());
    search->run(std::move(sources), {maximum_distance, {}},
                Solver_visitor::Of_search(visitor, true));
    visitor.finish();
    const auto& labels = search->search();
    for(Index i = 0; i < triangulation().number_of_vertices(); ++i)
      distances[i] = labels.distance(triangulation().vertex(i));
    if(nearest_sources == nullptr)
      return;
    for(Index i = 0; i < triangulation().number_of_vertices(); ++i)
      nearest_sources[i] = static_cast<std::int64_t>(labels.source(triangulation().vertex(i)));
  }

  // Uses A* search with straight-line distances. Exact searches can take long, so they call the
  // visitor instead.
  Path find_path(const Intrinsic_point& source,
                 const Intrinsic_point& target,
                 const Vertex_positions& positions,
                 Solver_visitor& visitor) const override
  {
    const auto search = m_workspaces.borrow();
    if constexpr(Run_of<Graph>::attaches_by_labels)
      search->run({{source}}, {std::numeric_limits<double>::infinity(), {target}},
                  Solver_visitor::Of_search(visitor, true));
    else
      search->run_to(target, {{source}}, positions);
    visitor.finish();
    return search->find_path(target);
  }

  void compute_rows(Any_rows& rows,
                    const Points& sources,
                    const Points* const targets,
                    const double maximum_distance,
                    const bool is_symmetric,
                    Solver_visitor& visitor) const override
  {
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
    Propagation<Graph> search(m_graph);
    std::vector<Seed> seeds;
    for(const Intrinsic_point& p : sources)
      seeds.push_back({p.vertex});
    search.run(seeds);
    const auto distance = [&](const std::size_t i) {
      return search.distance(triangulation().vertex(i));
    };
    const std::size_t number_of_vertices = triangulation().number_of_vertices();
    Farthest_first farthest_first(number_of_vertices);
    auto farthest = farthest_first.find(distance);
    for(std::size_t i = 0; i < number && farthest.distance > 0 && visitor.go_further(); ++i)
    {
      search.run_further({{triangulation().vertex(farthest.number)}});
      vertices.push_back(static_cast<std::int64_t>(farthest.number));
      farthest = farthest_first.find(distance);
      visitor.set_progress(i + 1, (std::min)(number, number_of_vertices));
    }
    visitor.finish();
    return farthest.distance;
  }

  std::unique_ptr<Solver_graph> reversed() const override
  {
    if constexpr(is_directed<Graph>)
      return std::make_unique<Solver_graph_of>(m_graph.reversed());
    else
      return nullptr;
  }

  void save([[maybe_unused]] std::ostream& out) const override
  {
    if constexpr(std::is_same_v<Graph, Discrete_geodesic_graph>)
      m_graph.save(out);
  }

private:
  Graph m_graph;
  mutable Workspaces<Search> m_workspaces;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_GRAPH_OF_H
