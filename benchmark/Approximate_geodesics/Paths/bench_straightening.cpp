// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What straightening makes of paths between random points of the surface: how often they become the
// shortest ones, by how much they are longer otherwise, and how long it takes. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Location = AG::Face_location<Mesh>;

static constexpr std::size_t TARGETS_PER_SOURCE = 100; // exact distances from a source take seconds

static Location random_location(const Mesh& mesh, std::mt19937_64& random)
{
  const auto number = [&random] { return std::uniform_real_distribution<>()(random); };
  const Mesh::Face_index f(static_cast<Mesh::size_type>(random() % mesh.number_of_faces()));
  double a = number(), b = number();
  if(a + b > 1)
  {
    a = 1 - a;
    b = 1 - b;
  }
  return {f, {1 - a - b, a, b}};
}

// The points that paths lead between, and the exact distances.
class Pairs
{
public:
  Pairs(const Mesh& mesh, const std::size_t number_of_sources)
  {
    std::mt19937_64 random(1);
    for(std::size_t i = 0; i < number_of_sources; ++i)
    {
      sources.push_back(random_location(mesh, random));
      targets.emplace_back();
      distances.emplace_back();
      Exact exact(mesh);
      exact.add_source_point(sources.back());
      while(targets.back().size() < TARGETS_PER_SOURCE)
      {
        const Location target = random_location(mesh, random);
        targets.back().push_back(target);
        distances.back().push_back(
            exact.shortest_distance_to_source_points(target.first, target.second).first);
      }
    }
  }

  std::vector<Location> sources;
  std::vector<std::vector<Location>> targets; // per source
  std::vector<std::vector<double>> distances; // likewise; negative if there is no path

private:
  using Exact =
      CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
};

// How much longer than the exact distance paths are.
class Excesses
{
public:
  void add(const double length, const double exact) { m_excesses.push_back(length / exact - 1); }

  std::size_t size() const { return m_excesses.size(); }

  double mean_percent() const
  {
    double sum = 0;
    for(const double e : m_excesses)
      sum += e;
    return 100 * sum / double(size());
  }

  double largest_percent() const
  {
    return 100 * *std::max_element(m_excesses.begin(), m_excesses.end());
  }

  // those above `least` and up to `most`
  double share_percent(const double least, const double most) const
  {
    const auto is_between = [=](const double e) { return e > least && e <= most; };
    return 100. * double(std::count_if(m_excesses.begin(), m_excesses.end(), is_between)) /
           double(size());
  }

  void add(const Excesses& other)
  {
    m_excesses.insert(m_excesses.end(), other.m_excesses.begin(), other.m_excesses.end());
  }

private:
  std::vector<double> m_excesses;
};

// Paths in one graph, before and after.
struct Result
{
  void add(const Result& other)
  {
    before.add(other.before);
    after.add(other.after);
    seconds.insert(seconds.end(), other.seconds.begin(), other.seconds.end());
    crossed_edges += other.crossed_edges;
  }

  Excesses before, after;
  std::vector<double> seconds; // of straightening
  std::size_t crossed_edges = 0;
};

template <typename Paths>
static Result straighten_paths(Paths& paths, const Pairs& pairs)
{
  Result result;
  for(std::size_t i = 0; i < pairs.sources.size(); ++i)
  {
    paths.remove_all_source_points();
    paths.add_source_point(pairs.sources[i]);
    paths.build_sequence_tree();
    for(std::size_t j = 0; j < pairs.targets[i].size(); ++j)
    {
      if(!(pairs.distances[i][j] > 0))
        continue;
      const auto [f, coordinates] = pairs.targets[i][j];
      double before = 0, after = 0;
      std::vector<Mesh::Point> points;
      const auto find_path = [&, f = f, coordinates = coordinates] {
        before =
            paths.shortest_path_points_to_source_points(f, coordinates, CGAL::Emptyset_iterator())
                .first;
      };
      find_path(); // and have what it needs at hand
      const double seconds_before = seconds_of(find_path);
      const double seconds_after = seconds_of([&, f = f, coordinates = coordinates] {
        after =
            paths
                .shortest_path_points_to_source_points(f, coordinates, std::back_inserter(points),
                                                       CGAL::parameters::straighten(true))
                .first;
      });
      result.before.add(before, pairs.distances[i][j]);
      result.after.add(after, pairs.distances[i][j]);
      result.seconds.push_back(seconds_after - seconds_before);
      result.crossed_edges += points.size() - 2;
    }
  }
  return result;
}

static constexpr double EXACT = 1e-9;

static Table empty_table()
{
  return Table({"mesh", "graph", "paths", "mean % before", "largest % before", "exact % after",
                "to 0.01 %", "to 0.1 %", "to 1 %", "more", "below", "mean % after",
                "largest % after", "us", "points"});
}

static void
add_row(Table& table, const std::string& mesh, const std::string& graph, const Result& result)
{
  const Excesses& after = result.after;
  table.add_row()
      .add(mesh)
      .add(graph)
      .add(double(after.size()), 0)
      .add(result.before.mean_percent(), 4)
      .add(result.before.largest_percent(), 2)
      .add(after.share_percent(-EXACT, EXACT), 2)
      .add(after.share_percent(EXACT, 1e-4), 2)
      .add(after.share_percent(1e-4, 1e-3), 2)
      .add(after.share_percent(1e-3, 1e-2), 2)
      .add(after.share_percent(1e-2, 1e300), 2)
      .add(after.share_percent(-1, -EXACT), 2)
      .add(after.mean_percent(), 5)
      .add(after.largest_percent(), 3)
      .add(median(result.seconds) * 1e6, 1)
      .add(double(result.crossed_edges) / double(after.size()), 1);
}

int main(int argc, char* argv[])
{
  const auto measure_straightening = [](const Options& options, const Report& report) {
    Table table = empty_table();
    Result all_along_edges, all_across_faces;
    for(const std::string& name : options.meshes)
    {
      const Mesh mesh = read_mesh(name);
      const Pairs pairs(mesh, options.number_of_rounds);
      AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph> along_edges(mesh);
      AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph> across_faces(
          mesh, CGAL::parameters::epsilon(0.1));
      const Result edges = straighten_paths(along_edges, pairs);
      const Result faces = straighten_paths(across_faces, pairs);
      add_row(table, short_name(name), "edges", edges);
      add_row(table, short_name(name), "epsilon 0.1", faces);
      all_along_edges.add(edges);
      all_across_faces.add(faces);
    }
    add_row(table, "all", "edges", all_along_edges);
    add_row(table, "all", "epsilon 0.1", all_across_faces);
    report.print("straightening",
                 "Paths between random points, before and after they were straightened: shares of "
                 "those that are exact to 1e-9, or longer by so much (medians of times)",
                 table);
  };
  return run_benchmark(argc, argv, "bench_straightening",
                       {{"bunny00",         "armadillo", "refined_elephant", "elephant", "camel",
                         "cactus",          "dino",      "fandisk",          "hand",     "homer",
                         "anchor",          "rotor",     "triceratops",      "pinion",   "knot1",
                         "mannequin-devil", "head",      "mushroom",         "retinal",  "helmet"},
                        5,
                        ""},
                       measure_straightening);
}
