// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How long it takes to repair a field of distances after weights or sources have changed,
// beside computing a fresh one. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Weighted_terrain.h"
#include "meshes/navigation_mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// One graph, and searches of it: one that is repaired after each change, and one that is not.
class Repair_benchmark
{
  using Graph = AG::Steiner_graph<>;
  using Search = AG::Propagation<Graph>;
  using Index = AG::Intrinsic_triangulation::Index;
  using Changes = std::vector<AG::Weight_change>;

public:
  Repair_benchmark(std::string mesh_name,
                   AG::Intrinsic_triangulation triangulation,
                   const std::size_t number_of_rounds)
    : m_mesh_name(std::move(mesh_name)),
      m_graph(std::move(triangulation), AG::Geometric_points(0.1, true)),
      m_repaired(m_graph),
      m_fresh(m_graph),
      m_number_of_rounds(number_of_rounds)
  {
    const AG::Intrinsic_triangulation& surface = m_graph.triangulation();
    for(Index h = 0; h < surface.number_of_halfedges(); ++h)
      if(!surface.is_border(h) && h == surface.first_of_face(h) && surface.is_open(h))
        m_faces.push_back(h);
  }

  void run(Table& table)
  {
    const std::size_t few = (std::max)(m_faces.size() / 100, std::size_t(1));
    const double closed = std::numeric_limits<double>::infinity();
    const auto near = [&](const std::size_t n) { return [=] { return faces_around(n); }; };
    measure("a face, times 1.5", near(1), 1.5, table);
    measure("8 faces in a row, closed", near(8), closed, table);
    measure("1 % of the faces, one region, times 1.1", near(few), 1.1, table);
    measure("1 % of the faces, one region, times 4", near(few), 4, table);
    measure("1 % of the faces, one region, closed", near(few), closed, table);
    measure(
        "1 % of the faces, scattered, times 1.5", [=] { return scattered(few); }, 1.5, table);
    for(const std::size_t number : {2u, 10u, 100u})
      measure_sources(number, table);
  }

  static Table empty_table()
  {
    return Table({"mesh", "faces", "nodes", "what changes", "fresh ms", "repair : fresh, median %",
                  "mean %", "then back, median %", "mean %", "nodes with other distances, median %",
                  "mean %", "different bits"});
  }

private:
  std::size_t below(const std::size_t n) { return m_random() % n; }

  AG::Seed random_seed()
  {
    const Index h = m_faces[below(m_faces.size())];
    return {m_graph.triangulation().target(h)};
  }

  std::vector<Index> scattered(const std::size_t number)
  {
    std::vector<Index> result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(m_faces[below(m_faces.size())]);
    return result;
  }

  // Faces around a random one, breadth first.
  std::vector<Index> faces_around(const std::size_t number)
  {
    const AG::Intrinsic_triangulation& surface = m_graph.triangulation();
    std::vector<Index> result{m_faces[below(m_faces.size())]};
    std::vector<bool> is_known(surface.number_of_halfedges());
    is_known[result[0]] = true;
    for(std::size_t i = 0; i < result.size() && result.size() < number; ++i)
      for(const Index side : surface.halfedges_of_face(result[i]))
        if(surface.is_crossable(side) && surface.is_open(surface.opposite(side)))
        {
          const Index f = surface.first_of_face(surface.opposite(side));
          if(!is_known[f])
            result.push_back(f);
          is_known[f] = true;
        }
    return result;
  }

  Changes changes(const std::vector<Index>& faces, const double factor) const
  {
    Changes result;
    const double unit = m_graph.triangulation().weight_unit();
    for(const Index f : faces)
      result.push_back({f, m_graph.triangulation().weight(f) * unit * factor});
    return result;
  }

  struct Times
  {
    std::vector<double> fresh, there, back, changed;
    std::size_t number_of_different = 0;
  };

  template <typename Faces>
  void measure(const std::string& name, const Faces& faces, const double factor, Table& table)
  {
    Times times;
    for(std::size_t i = 0; i < m_number_of_rounds; ++i)
    {
      const std::vector<AG::Seed> seeds = {random_seed()};
      const std::vector<Index> changed = faces();
      const Changes there = changes(changed, factor), back = changes(changed, 1);
      m_repaired.run(seeds);
      const std::vector<double> before = labels();
      times.there.push_back(seconds_of([&] {
        m_graph.set_weights(there);
        m_repaired.repair(seeds);
      }));
      compare(seeds, before, times);
      times.back.push_back(seconds_of([&] {
        m_graph.set_weights(back);
        m_repaired.repair(seeds);
      }));
      times.number_of_different += labels() == before ? 0 : 1;
    }
    add_row(name, times, table);
  }

  // Moves one of several sources there and back.
  void measure_sources(const std::size_t number, Table& table)
  {
    Times times;
    for(std::size_t i = 0; i < m_number_of_rounds; ++i)
    {
      std::vector<AG::Seed> seeds, others;
      for(std::size_t k = 0; k < number; ++k)
        seeds.push_back(random_seed());
      others = seeds;
      others.front() = random_seed();
      m_repaired.run(seeds);
      const std::vector<double> before = labels();
      times.there.push_back(seconds_of([&] { m_repaired.repair(others); }));
      compare(others, before, times);
      times.back.push_back(seconds_of([&] { m_repaired.repair(seeds); }));
      times.number_of_different += labels() == before ? 0 : 1;
    }
    add_row("1 of " + std::to_string(number) + " sources", times, table);
  }

  std::vector<double> labels() const
  {
    const double* const first = m_repaired.labels().distances();
    return {first, first + m_graph.number_of_nodes()};
  }

  void compare(const std::vector<AG::Seed>& seeds, const std::vector<double>& before, Times& times)
  {
    times.fresh.push_back(seconds_of([&] { m_fresh.run(seeds); }));
    std::size_t number_of_changed = 0;
    for(std::uint32_t n = 0; n < m_graph.number_of_nodes(); ++n)
    {
      number_of_changed += before[n] == m_fresh.labels().distance(n) ? 0 : 1;
      times.number_of_different +=
          m_repaired.labels().distance(n) == m_fresh.labels().distance(n) ? 0 : 1;
    }
    times.changed.push_back(double(number_of_changed) / double(m_graph.number_of_nodes()));
  }

  static double mean(const std::vector<double>& v)
  {
    return std::accumulate(v.begin(), v.end(), 0.) / double(v.size());
  }

  void add_row(const std::string& name, const Times& times, Table& table) const
  {
    const double fresh = mean(times.fresh);
    table.add_row()
        .add(m_mesh_name)
        .add(std::to_string(m_graph.triangulation().number_of_faces()))
        .add(std::to_string(m_graph.number_of_nodes()))
        .add(name)
        .add(fresh * 1e3, 2)
        .add(median(times.there) / fresh * 100, 2)
        .add(mean(times.there) / fresh * 100, 2)
        .add(median(times.back) / fresh * 100, 2)
        .add(mean(times.back) / fresh * 100, 2)
        .add(median(times.changed) * 100, 2)
        .add(mean(times.changed) * 100, 2)
        .add(std::to_string(times.number_of_different));
  }

  std::string m_mesh_name;
  Graph m_graph;
  Search m_repaired, m_fresh;
  std::size_t m_number_of_rounds;
  std::vector<Index> m_faces; // those that can be entered, by their smallest halfedge
  std::mt19937_64 m_random{1};
};

static void measure_repairs(const Options& options, const Report& report)
{
  const auto print = [&](const std::string& name, const AG::Intrinsic_triangulation& surface) {
    Table table = Repair_benchmark::empty_table();
    Repair_benchmark(name, surface, options.number_of_rounds).run(table);
    report.print("repair_" + name,
                 "Repaired fields for epsilon 0.1, and fresh ones (" +
                     std::to_string(options.number_of_rounds) + " random changes and sources)",
                 table);
  };
  Mesh mesh = navigation_mesh(options.is_quick ? 8 : 26);
  print("navigation",
        AG::Intrinsic_triangulation(mesh, CGAL::parameters::face_weight_map(region_weights(mesh))));
  print("terrain", Weighted_terrain(options.is_quick ? 20 : 80).triangulation());
}

int main(int argc, char* argv[])
{
  return run_benchmark(argc, argv, "bench_repair", {{}, 11, ""}, measure_repairs);
}
