// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The logarithmic map against the exact search that it needs, walks that lead back, and loops
// against cycles of edges. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Geodesic_constructions/logarithmic_map.h>
#include <CGAL/Geodesic_constructions/shorten_loop.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Tracer = AG::Geodesic_tracer<Mesh>;

// What has become of walks along all vectors of a logarithmic map.
struct Returns
{
  std::size_t number_of_walks = 0, number_of_returns = 0, number_of_steps = 0;
  double largest_error = 0; // relative, of those that return
};

template <typename Vectors>
void walk_back(const Mesh& mesh,
               const Tracer& tracer,
               const Vertex source,
               const Vectors& vectors,
               Returns& result)
{
  constexpr double tolerance = 1e-9;
  for(const Vertex v : mesh.vertices())
  {
    const double length = std::hypot(vectors[v].x, vectors[v].y);
    if(!(length > 0 && std::isfinite(length)))
      continue;
    const Tracer::Walk walk = tracer.trace(source, vectors[v], length);
    const double error =
        std::sqrt(CGAL::squared_distance(tracer.point_3(walk.points.back()), mesh.point(v))) /
        length;
    ++result.number_of_walks;
    result.number_of_steps += walk.points.size() - 1;
    if(error > tolerance) // the path bends at a vertex
      continue;
    ++result.number_of_returns;
    result.largest_error = (std::max)(result.largest_error, error);
  }
}

void measure_walks(Mesh& mesh, const std::string& name, const std::size_t rounds, Table& table)
{
  const auto sources = random_sources(mesh, rounds);
  const auto vectors = mesh.add_property_map<Vertex, AG::Tangent_vector>("v:logarithm").first;
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  const Tracer tracer(mesh);
  Returns returns;
  double seconds = 0;
  Contest contest;
  contest.add([&](const auto round) {
    CGAL::approximate_geodesic_distances(mesh, distances, sources[round],
                                         CGAL::parameters::epsilon(0));
  });
  contest.add([&](const auto round) { AG::logarithmic_map(mesh, vectors, sources[round]); });
  contest.run(rounds);
  for(const Vertex source : sources)
  {
    AG::logarithmic_map(mesh, vectors, source);
    seconds += seconds_of([&] { walk_back(mesh, tracer, source, vectors, returns); });
  }
  table.add_row()
      .add(name)
      .add(double(mesh.number_of_vertices()), 0)
      .add(contest.median_seconds(0) * 1e3, 1)
      .add(contest.ratio(1, 0), 2)
      .add(100. * double(returns.number_of_returns) / double(returns.number_of_walks), 1)
      .add(Table::scientific(returns.largest_error))
      .add(double(returns.number_of_steps) / seconds * 1e-6, 1);
}

struct Length_of_edge
{
  using Weight_t = double;

  double operator()(const Mesh::Halfedge_index h) const
  {
    return std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }

  const Mesh& mesh;
};

void measure_loops(const Mesh& mesh,
                   const std::string& name,
                   const std::size_t rounds,
                   Table& table)
{
  const auto sources = random_sources(mesh, rounds);
  const Length_of_edge length{mesh};
  std::vector<std::vector<Mesh::Halfedge_index>> cycles(rounds);
  double of_cycles = 0, of_loops = 0, of_shortened = 0;
  Contest contest;
  contest.add([&](const auto round) {
    const CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh> topology(mesh);
    const auto cycle = topology.compute_shortest_non_contractible_cycle_with_base_point(
        mesh.opposite(mesh.halfedge(sources[round])), length);
    for(std::size_t i = 0; i < cycle.length(); ++i)
      cycles[round].push_back(cycle.get_ith_real_dart(i));
  });
  contest.add([&](const auto round) {
    of_loops += AG::shortest_loop_through(mesh, sources[round]).length;
  });
  contest.run(rounds);
  for(const auto& cycle : cycles)
  {
    for(const Mesh::Halfedge_index h : cycle)
      of_cycles += length(h);
    of_shortened += AG::shorten_loop(mesh, cycle).length;
  }
  table.add_row()
      .add(name)
      .add(double(mesh.number_of_vertices()), 0)
      .add(contest.median_seconds(1) * 1e3, 1)
      .add(contest.ratio(0, 1), 1)
      .add(of_loops / of_cycles, 3)
      .add(of_shortened / of_cycles, 3);
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    const std::size_t rounds = options.number_of_rounds;
    Table walks({"mesh", "vertices", "exact search ms", "logarithmic map : search", "return %",
                 "largest error", "million steps a second"});
    Table loops({"mesh", "vertices", "loop through a vertex ms", "cycle : loop, time",
                 "loop : cycle, length", "shortened cycle : cycle"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      measure_walks(mesh, short_name(name), rounds, walks);
    }
    for(const char* const name : {"eight", "rotor", "helmet", "knot", "holes", "knot2"})
      measure_loops(read_mesh(name), name, rounds, loops);
    report.print("walks",
                 "The logarithmic map beside the exact search, and walks along its vectors (" +
                     std::to_string(rounds) + " sources)",
                 walks);
    report.print("loops",
                 "Shortest loops through vertices beside CGAL's shortest cycles of edges, which "
                 "are shortened then (" +
                     std::to_string(rounds) + " vertices)",
                 loops);
  };
  return run_benchmark(argc, argv, "bench_walks",
                       {{"bunny00", "armadillo", "refined_elephant"}, 5, ""}, measure);
}
