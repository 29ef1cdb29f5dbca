// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One call of a function for near points on a large mesh, against one that reads the whole mesh.
// See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

// What a call is asked for: from one vertex to another, or up to its distance.
struct Task
{
  Vertex source, target;
  double distance;
};

// Tasks whose distance is about so large a part of the largest one from the source.
class Tasks
{
public:
  Tasks(Mesh& mesh, const std::size_t number) : m_sources(random_sources(mesh, number))
  {
    const auto distances = mesh.add_property_map<Vertex, double>("v:all").first;
    for(const Vertex source : m_sources)
    {
      CGAL::approximate_geodesic_distances(mesh, distances, source);
      m_distances.emplace_back(mesh.num_vertices());
      for(const Vertex v : mesh.vertices())
        m_distances.back()[v.idx()] = distances[v];
    }
  }

  std::vector<Task> at(const double part) const
  {
    std::vector<Task> result;
    for(std::size_t i = 0; i < m_sources.size(); ++i)
    {
      const std::vector<double>& distances = m_distances[i];
      const double wanted = part * *std::max_element(distances.begin(), distances.end());
      const auto is_better = [&](const double a, const double b) {
        return std::abs(a - wanted) < std::abs(b - wanted);
      };
      const auto best = std::min_element(distances.begin(), distances.end(), is_better);
      result.push_back({m_sources[i], Vertex(Mesh::size_type(best - distances.begin())), *best});
    }
    return result;
  }

private:
  std::vector<Vertex> m_sources;
  std::vector<std::vector<double>> m_distances;
};

// Sums over the rounds.
struct Counts
{
  std::size_t number_of_parts = 0, number_of_read = 0, number_of_reached = 0;

  template <typename Part>
  void add_part(const Mesh& mesh, const Part& part)
  {
    number_of_parts += part ? 1 : 0;
    number_of_read += part ? num_vertices(*part) : mesh.number_of_vertices();
  }
};

void add_row(const std::string& name,
             const std::string& kind,
             const double part,
             const Contest& contest,
             const Counts& counts,
             const std::size_t rounds,
             Table& table)
{
  table.add_row()
      .add(name)
      .add(kind)
      .add(part, 3)
      .add(contest.median_seconds(0) * 1e3, 3)
      .add(contest.median_seconds(1) * 1e3, 3)
      .add(contest.ratio(0, 1), 1)
      .add(100. * double(counts.number_of_parts) / double(rounds), 0)
      .add(double(counts.number_of_read) / double(rounds), 0)
      .add(double(counts.number_of_read) / double(counts.number_of_reached), 2);
}

// The part of the mesh that has the path, if there is one.
template <typename NamedParameters>
auto part_between(const Mesh& mesh, const Task& task, const NamedParameters& np)
{
  std::optional<AG::internal::Mesh_part<Mesh>> result;
  const auto search_part = [&](const auto& part, double) {
    result = part;
    std::optional<double> distance;
    AG::internal::search_once(part, np, true, [&](auto& search) {
      search.run_to(task.source, task.target, AG::internal::positions_for_one_run(search, np), np);
      distance = search.search().distance(search.translation().intrinsic_point(task.target));
    });
    return distance;
  };
  if(!AG::internal::Part_to_read(mesh, np).between(task.source, task.target, search_part))
    result.reset();
  return result;
}

template <typename NamedParameters>
void compare_paths(const Mesh& mesh,
                   const std::vector<Task>& tasks,
                   const NamedParameters& np,
                   Contest& contest,
                   Counts& counts)
{
  contest.add([&](const auto round) {
    const Task& task = tasks[round];
    AG::internal::search_once(mesh, np, true, [&](auto& search) {
      search.run_to(task.source, task.target, AG::internal::positions_for_one_run(search, np), np);
      AG::internal::find_path(search, search.translation().intrinsic_point(task.target), np);
      counts.number_of_reached += search.search().search().reached_nodes().size();
    });
  });
  contest.add([&](const auto round) {
    const Task& task = tasks[round];
    CGAL::approximate_geodesic_path(mesh, CGAL::Emptyset_iterator(), task.source, task.target, np);
  });
  contest.run(tasks.size());
  for(const Task& task : tasks)
    counts.add_part(mesh, part_between(mesh, task, np));
}

template <typename NamedParametersOf>
void compare_distances(Mesh& mesh,
                       const std::vector<Task>& tasks,
                       const NamedParametersOf& np_of,
                       Contest& contest,
                       Counts& counts)
{
  const auto distances = mesh.add_property_map<Vertex, double>("v:some").first;
  contest.add([&](const auto round) {
    const auto np = np_of(tasks[round].distance);
    AG::internal::search_once(mesh, np, false, [&](auto& search) {
      search.run_from(tasks[round].source, np);
      search.write_results(distances, np);
      counts.number_of_reached += search.search().search().reached_nodes().size();
    });
  });
  contest.add([&](const auto round) {
    CGAL::approximate_geodesic_distances(mesh, distances, tasks[round].source,
                                         np_of(tasks[round].distance));
  });
  contest.run(tasks.size());
  for(const Task& task : tasks)
  {
    const auto np = np_of(task.distance);
    counts.add_part(mesh, AG::internal::Part_to_read(mesh, np).around(task.source));
  }
}

void compare(Mesh& mesh, const std::string& name, const std::size_t rounds, Table& table)
{
  const Tasks all_tasks(mesh, rounds);
  const auto up_to = [](const double distance) {
    return parameters::epsilon(0.1).maximum_distance(distance);
  };
  for(const double part : {0.003, 0.01, 0.03, 0.1, 0.3, 1.})
  {
    const std::vector<Task> tasks = all_tasks.at(part);
    const auto add = [&](const std::string& kind, const auto& run) {
      Contest contest;
      Counts counts;
      run(contest, counts);
      add_row(name, kind, part, contest, counts, rounds, table);
    };
    add("path, epsilon 0.1", [&](Contest& contest, Counts& counts) {
      compare_paths(mesh, tasks, parameters::epsilon(0.1), contest, counts);
    });
    add("path, epsilon 0", [&](Contest& contest, Counts& counts) {
      compare_paths(mesh, tasks, parameters::epsilon(0), contest, counts);
    });
    add("distances, epsilon 0.1", [&](Contest& contest, Counts& counts) {
      compare_distances(mesh, tasks, up_to, contest, counts);
    });
  }
}

int main(int argc, char* argv[])
{
  const auto compare_all = [](const Options& options, const Report& report) {
    const std::size_t rounds = options.number_of_rounds;
    Table table({"mesh", "call", "part of largest distance", "whole read ms", "ms", "whole : ours",
                 "parts found %", "vertices read", "read : reached"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      compare(mesh, short_name(name), rounds, table);
    }
    report.print("near_pairs",
                 "Near points on a large mesh, one call with everything included (medians of " +
                     std::to_string(rounds) + " pairs)",
                 table);
  };
  return run_benchmark(argc, argv, "bench_near_pairs",
                       {{"bunny00", "armadillo", "bunny00+1", "armadillo+2"}, 11, ""}, compare_all);
}
