// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What points on edges give and what they cost: sizes, times and errors of Steiner graphs, without
// weights and with. See --help.

#include "measuring/Errors.h"
#include "measuring/Steiner_trial.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Weighted_terrain.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Dense_reference.h"
#include "peers/Exact_case.h"
#include "peers/searches_of_arrays.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

static constexpr std::size_t SOURCES_OF_ERRORS = 3;

// How long searches take, and how far off they are, on one mesh.
class Search_benchmark
{
public:
  Search_benchmark(std::string name, const AG::Intrinsic_triangulation& triangulation)
    : m_name(std::move(name)),
      m_triangulation(triangulation),
      m_priority_queue(triangulation),
      m_trials(steiner_trials(triangulation, {0, 1, 2, 3, 5, 8, 16}, {0.5, 0.2, 0.1, 0.05, 0.02}))
  {
  }

  void measure_times(const std::vector<Vertex>& sources)
  {
    for(const Steiner_trial& trial : m_trials)
    {
      trial.run(sources.front()); // which makes room in the workspace
      m_contest.add([&](const auto round) { trial.run(sources[round]); });
    }
    m_contest.add([&](const auto round) {
      m_priority_queue.run_from(m_triangulation.vertex(sources[round].idx()));
    });
    m_contest.run(sources.size(), 5);
  }

  template <typename Expected>
  void find_errors(const Expected& expected)
  {
    for(Steiner_trial& trial : m_trials)
      trial.find_errors(expected);
  }

  static Table empty_table()
  {
    return Table({"mesh", "points", "parameter", "points/edge", "nodes/vertex", "bytes/vertex",
                  "with workspace", "build s", "search ms", "search : std::priority_queue",
                  "mean %", "largest %", "least", "bound", "largest : bound"});
  }

  void add_to(Table& table) const
  {
    for(std::size_t i = 0; i < m_trials.size(); ++i)
      add_trial(table, m_trials[i], i);
  }

private:
  void add_trial(Table& table, const Steiner_trial& trial, const std::size_t contestant) const
  {
    const Errors& errors = trial.errors();
    table.add_row()
        .add(m_name)
        .add(trial.name())
        .add(trial.parameter(), trial.name() == SPACED ? 0 : 2)
        .add(trial.points_per_edge(), 2)
        .add(trial.nodes_per_vertex(), 2)
        .add(trial.bytes_per_vertex(), 1)
        .add(trial.bytes_per_vertex_with_workspace(), 1)
        .add(trial.build_seconds(), 3)
        .add(m_contest.median_seconds(contestant) * 1e3, 3)
        .add(m_contest.ratio(contestant, m_trials.size()), 2)
        .add(errors.mean() * 100, 4)
        .add(errors.largest() * 100, 3)
        .add(Table::scientific(errors.least()))
        .add_if(trial.has_bound(), trial.bound(), 3)
        .add_if(trial.has_bound(), errors.largest() / trial.bound(), 3);
  }

  std::string m_name;
  const AG::Intrinsic_triangulation& m_triangulation;
  Priority_queue_dijkstra m_priority_queue;
  std::vector<Steiner_trial> m_trials;
  Contest m_contest;
};

static void add_unweighted(Table& table, const std::string& name, const std::size_t rounds)
{
  const Exact_case expected = first_and_random_case(name, SOURCES_OF_ERRORS);
  const AG::Intrinsic_triangulation triangulation(expected.mesh());
  Search_benchmark benchmark(expected.name(), triangulation);
  benchmark.measure_times(random_sources(expected.mesh(), rounds));
  benchmark.find_errors(expected);
  benchmark.add_to(table);
}

static Table weighted_table(const Weighted_terrain& terrain, const std::size_t rounds)
{
  Search_benchmark benchmark("terrain", terrain.triangulation());
  benchmark.measure_times(terrain.sources(rounds));
  benchmark.find_errors(Dense_reference(terrain.mesh(), terrain.triangulation(),
                                        first_and_random(terrain.sources(SOURCES_OF_ERRORS))));
  Table result = Search_benchmark::empty_table();
  benchmark.add_to(result);
  return result;
}

static std::string description_of_rounds(const Options& options)
{
  return "medians of " + std::to_string(options.number_of_rounds) + " sources, errors of " +
         std::to_string(SOURCES_OF_ERRORS) + "; bytes without the triangulation";
}

int main(int argc, char* argv[])
{
  const auto measure_searches = [](const Options& options, const Report& report) {
    Table unweighted = Search_benchmark::empty_table();
    for(const std::string& name : options.meshes)
      add_unweighted(unweighted, name, options.number_of_rounds);
    report.print("steiner",
                 "Points on edges and exact distances (" + description_of_rounds(options) + ")",
                 unweighted);
    report.print("steiner_weighted",
                 "Points on edges of a weighted terrain and " + Dense_reference::description() +
                     " (" + description_of_rounds(options) + ")",
                 weighted_table(Weighted_terrain(options), options.number_of_rounds));
  };
  return run_benchmark(argc, argv, "bench_steiner", {{"bunny00"}, 11, ""}, measure_searches);
}
