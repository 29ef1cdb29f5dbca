// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One call of the free function, with everything included, against Boost's Dijkstra on the mesh,
// including the computation of the edges' lengths. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Boost_dijkstra.h"

#include <CGAL/approximate_geodesic_distances.h>

#include <string>

void compare(Mesh& mesh, const std::string& name, const std::size_t rounds, Table& table)
{
  const auto sources = random_sources(mesh, rounds);
  Boost_dijkstra boost(mesh);
  const auto distances = mesh.add_property_map<Vertex, double>("v:ours").first;
  Contest contest;
  const auto ours = contest.add([&](const auto round) {
    CGAL::approximate_geodesic_distances(mesh, distances, sources[round]);
  });
  const auto theirs = contest.add([&](const auto round) {
    boost.compute_lengths();
    boost.run(sources[round]);
  });
  contest.run(rounds);

  table.add_row()
      .add(name)
      .add(double(mesh.number_of_vertices()), 0)
      .add(contest.median_seconds(ours) * 1e3, 3)
      .add(contest.median_seconds(theirs) * 1e3, 3)
      .add(contest.ratio(ours, theirs), 2);
}

int main(int argc, char* argv[])
{
  const auto compare_all = [](const Options& options, const Report& report) {
    Table table({"mesh", "vertices", "free function ms", "Boost ms", "ours : Boost"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      compare(mesh, short_name(name), options.number_of_rounds, table);
    }
    report.print("single_call",
                 "One call with everything included (medians of " +
                     std::to_string(options.number_of_rounds) + " sources)",
                 table);
  };
  return run_benchmark(argc, argv, "bench_single_call", {usual_meshes(), 31, ""}, compare_all);
}
