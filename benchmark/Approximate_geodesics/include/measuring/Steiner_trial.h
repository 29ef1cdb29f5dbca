// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_STEINER_TRIAL_H
#define BENCHMARK_STEINER_TRIAL_H

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Names of placements.
inline const std::string SPACED = "equally spaced";
inline const std::string GEOMETRIC = "geometric";

// A measurement of one placement on one mesh.
class Steiner_trial
{
public:
  template <typename Placement>
  Steiner_trial(std::string name,
                const double parameter,
                const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
                const Placement& placement)
    : m_name(std::move(name)), m_parameter(parameter)
  {
    using Graph = CGAL::Approximate_geodesics::Steiner_graph<Placement>;
    const std::shared_ptr<const Graph> graph = build<Graph>(triangulation, placement);
    const auto search = std::make_shared<CGAL::Approximate_geodesics::Propagation<Graph>>(*graph);
    const auto node = [graph](const Vertex v) { return graph->triangulation().vertex(v.idx()); };
    m_run = [=](const Vertex source) { search->run_from(node(source)); };
    m_distance = [=](const Vertex v) { return search->distance(node(v)); };
    m_bytes_of_graph = graph->memory() - graph->triangulation().memory();
    m_bytes_of_workspace = [=] { return search->memory(); };
    m_number_of_vertices = triangulation.number_of_vertices();
    m_number_of_edges = triangulation.number_of_edges();
    m_number_of_points = graph->number_of_points();
    m_number_of_nodes = graph->number_of_nodes();
    m_bound = graph->epsilon();
  }

  const std::string& name() const { return m_name; }
  double parameter() const { return m_parameter; }
  const Errors& errors() const { return m_errors; }

  double points_per_edge() const { return double(m_number_of_points) / m_number_of_edges; }
  double nodes_per_vertex() const { return double(m_number_of_nodes) / m_number_of_vertices; }
  double build_seconds() const { return m_build_seconds; }

  bool has_bound() const { return std::isfinite(m_bound); }
  double bound() const { return m_bound; }

  // Excludes the triangulation.
  double bytes_per_vertex() const { return double(m_bytes_of_graph) / m_number_of_vertices; }

  // Call it after the runs.
  double bytes_per_vertex_with_workspace() const
  {
    return double(m_bytes_of_graph + m_bytes_of_workspace()) / m_number_of_vertices;
  }

  void run(const Vertex source) const { m_run(source); }

  // Expected costs come from an `Exact_case` or a similar class.
  template <typename Expected>
  void find_errors(const Expected& expected)
  {
    for(std::size_t i = 0; i < expected.sources().size(); ++i)
    {
      run(expected.sources()[i]);
      for(const Vertex v : expected.mesh().vertices())
        if(!(std::isinf(expected.distance(i, v)) && std::isinf(m_distance(v))))
          m_errors.add(m_distance(v), expected.distance(i, v));
    }
  }

private:
  template <typename Graph, typename Placement>
  std::shared_ptr<const Graph>
  build(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
        const Placement& placement)
  {
    constexpr std::size_t number_of_builds = 3;
    std::shared_ptr<const Graph> result;
    std::vector<double> seconds;
    while(seconds.size() < number_of_builds)
    {
      result.reset();
      CGAL::Approximate_geodesics::Intrinsic_triangulation copy =
          triangulation; // excluded from the time
      seconds.push_back(
          seconds_of([&] { result = std::make_shared<const Graph>(std::move(copy), placement); }));
    }
    m_build_seconds = median(seconds);
    return result;
  }

  std::string m_name;
  double m_parameter; // epsilon or the number of points
  std::function<void(Vertex)> m_run;
  std::function<double(Vertex)> m_distance; // of the last run
  std::function<std::size_t()> m_bytes_of_workspace;
  std::size_t m_bytes_of_graph = 0;
  double m_number_of_vertices = 0;
  double m_number_of_edges = 0;
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_nodes = 0;
  double m_build_seconds = 0;
  double m_bound = 0;
  Errors m_errors;
};

inline std::vector<Steiner_trial>
steiner_trials(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
               const std::vector<std::size_t>& numbers_of_points,
               const std::vector<double>& epsilons)
{
  std::vector<Steiner_trial> result;
  for(const std::size_t m : numbers_of_points)
    result.emplace_back(SPACED, double(m), triangulation,
                        CGAL::Approximate_geodesics::Fixed_number_of_points(m));
  for(const double epsilon : epsilons)
    result.emplace_back(GEOMETRIC, epsilon, triangulation,
                        CGAL::Approximate_geodesics::Geometric_points(epsilon));
  return result;
}

#endif // BENCHMARK_STEINER_TRIAL_H
