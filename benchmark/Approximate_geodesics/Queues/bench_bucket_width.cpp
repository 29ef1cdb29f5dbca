// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the width of the buckets does to a search, how the adaptive bucket queue changes it from run
// to run, and what a fixed width would have cost. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using AG::Arc_lengths;
using AG::Balanced_bucket_width;

// in the mean arc length; policies are made by the queue, which cannot be told
static double first_width = 0;

// The package's policy, but for the width it starts with.
class Balanced_from_elsewhere : public Balanced_bucket_width
{
public:
  explicit Balanced_from_elsewhere(const Arc_lengths& arcs)
    : Balanced_bucket_width({arcs.shortest, 2 * first_width * arcs.mean, arcs.longest})
  {
  }
};

class Fixed_bucket_width
{
public:
  explicit Fixed_bucket_width(const Arc_lengths& arcs) : m_width(first_width * arcs.mean) {}
  double width() const { return m_width; }
  void update(const AG::Bucket_statistics&) {}

private:
  double m_width;
};

template <typename Policy>
using Search = AG::Propagation<AG::Edge_graph, AG::Basic_adaptive_bucket_queue<Policy>>;

class Width_benchmark
{
public:
  Width_benchmark(std::string name, const Mesh& mesh, const std::size_t number_of_rounds)
    : m_name(std::move(name)),
      m_graph(AG::Intrinsic_triangulation(mesh)),
      m_number_of_rounds(number_of_rounds)
  {
    for(const Vertex v : random_sources(mesh, (std::max)(number_of_rounds, NUMBER_OF_STEPS)))
      m_sources.push_back(m_graph.triangulation().vertex(v));
  }

  // Some of the first runs with the package's policy, from a good and from two bad widths.
  void follow_adaptation(Table& table) const
  {
    for(const double width : {1. / 64, 0.5, 16.})
    {
      first_width = width;
      Search<Balanced_from_elsewhere> search(m_graph);
      for(std::size_t i = 0; i < (std::min)(NUMBER_OF_STEPS, m_sources.size()); ++i)
      {
        const double seconds = seconds_of([&] { search.run_from(m_sources[i]); });
        if((i & (i + 1)) == 0) // the first, second, fourth and so on
          add_step(table, i, search, seconds);
      }
    }
  }

  // Fixed widths beside the adaptive one, all in the same contest.
  void compare_widths(Table& table) const
  {
    std::vector<double> widths;
    for(double width = 16; width >= 1. / 64; width /= 2)
      widths.push_back(width);

    std::vector<Search<Fixed_bucket_width>> fixed;
    for(const double width : widths)
    {
      first_width = width;
      fixed.emplace_back(m_graph);
    }
    Search<Balanced_bucket_width> adaptive(m_graph);
    Contest contest;
    for(auto& search : fixed)
      contest.add([&](const auto round) { search.run_from(m_sources[round]); });
    // not beside the slowest ones, which leave little in the caches
    const auto number = contest.add([&](const auto round) { adaptive.run_from(m_sources[round]); });
    contest.run(m_number_of_rounds, 5);

    const double reference = contest.median_seconds(number);
    add_width(table, "adaptive", adaptive, reference, reference);
    for(std::size_t i = fixed.size(); i > 0; --i)
      add_width(table, "fixed", fixed[i - 1], contest.median_seconds(i - 1), reference);
  }

private:
  static constexpr std::size_t NUMBER_OF_STEPS = 16;

  double in_mean_arcs(const double width) const { return width / m_graph.arc_lengths().mean; }

  template <typename Policy>
  void add_step(Table& table,
                const std::size_t run,
                const Search<Policy>& search,
                const double seconds) const
  {
    const AG::Bucket_statistics s = search.queue().statistics();
    table.add_row()
        .add(m_name)
        .add(first_width, 4)
        .add(double(run + 1), 0)
        .add(in_mean_arcs(s.width), 4)
        .add(double(s.visited_buckets), 0)
        .add(double(s.late_entries), 0)
        .add(s.mean_occupancy(), 1)
        .add(seconds * 1e3, 3);
  }

  template <typename Policy>
  void add_width(Table& table,
                 const std::string& kind,
                 const Search<Policy>& search,
                 const double seconds,
                 const double reference) const
  {
    const AG::Bucket_statistics s = search.queue().statistics();
    table.add_row()
        .add(m_name)
        .add(kind)
        .add(in_mean_arcs(s.width), 4)
        .add(double(s.visited_buckets), 0)
        .add(double(s.late_entries), 0)
        .add(seconds * 1e3, 3)
        .add(seconds / reference, 2);
  }

  std::string m_name;
  AG::Edge_graph m_graph;
  std::size_t m_number_of_rounds;
  std::vector<AG::Edge_graph::Node> m_sources;
};

int main(int argc, char* argv[])
{
  const auto vary_width = [](const Options& options, const Report& report) {
    Table steps({"mesh", "first width", "run", "width", "visited buckets", "late entries",
                 "mean occupancy", "ms"});
    Table widths(
        {"mesh", "kind", "width", "visited buckets", "late entries", "ms", "this : adaptive"});
    const auto run = [&](const std::string& name, const Mesh& mesh) {
      const Width_benchmark benchmark(name, mesh, options.number_of_rounds);
      benchmark.follow_adaptation(steps);
      benchmark.compare_widths(widths);
    };
    for(const std::string& name : options.meshes)
      run(short_name(name), read_mesh(name));
    run("graded terrain", terrain(options.is_quick ? 50 : 300, 4));
    report.print("widths",
                 "Widths in mean arc lengths, and time for one source (medians of " +
                     std::to_string(options.number_of_rounds) + " sources)",
                 widths);
    report.print("adaptation", "Successive runs, each from another source", steps);
  };
  return run_benchmark(argc, argv, "bench_bucket_width", {usual_meshes(), 51, ""}, vary_width);
}
